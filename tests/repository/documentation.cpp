// Every C++ snippet in the documentation, and any other that names a file, is part of that file, every
// relative link leads somewhere, and the messages that the guide explains are those of the programs.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using lines = std::vector<std::string>;
using errors = std::vector<std::string>;

lines split(const std::string& text) {
  lines all;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    line.erase(line.find_last_not_of(" \r\t") + 1);
    all.push_back(line);
  }
  return all;
}

// Without the indentation that all lines share.
lines flush_left(lines text) {
  std::size_t indent = std::string::npos;
  for (const std::string& line : text) {
    if (!line.empty()) indent = std::min(indent, line.find_first_not_of(' '));
  }
  for (std::string& line : text) line = line.substr(std::min(indent, line.size()));
  return text;
}

// Snippet as contiguous lines of the file.
bool contains(const lines& file, const lines& snippet) {
  const lines wanted = flush_left(snippet);
  for (std::size_t i = 0; i + wanted.size() <= file.size(); ++i) {
    const auto first = file.begin() + static_cast<std::ptrdiff_t>(i);
    if (flush_left(lines(first, first + static_cast<std::ptrdiff_t>(wanted.size()))) == wanted) return true;
  }
  return false;
}

// read(path) gives the text of a file of the repository, empty if there is none.
errors check_snippets(const std::string& page, const std::function<std::string(const std::string&)>& read) {
  static const std::regex source(R"(^<!-- file: (\S+) -->$)");
  errors all;
  const lines text = split(page);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!text[i].starts_with("```")) continue;
    const std::size_t opening = i;
    lines snippet;
    for (++i; i < text.size() && !text[i].starts_with("```"); ++i) snippet.push_back(text[i]);
    const std::string where = "line " + std::to_string(opening + 1) + ": ";
    if (i == text.size()) all.push_back(where + "``` without an end");
    std::smatch match;
    const bool named = opening > 0 && std::regex_match(text[opening - 1], match, source);
    if (!named) {
      if (text[opening] == "```cpp" || text[opening] == "```c++")
        all.push_back(where + "no `<!-- file: path -->` above the snippet");
    } else if (const std::string file = read(match[1]); file.empty()) {
      all.push_back(where + "no such file: " + match[1].str());
    } else if (snippet.empty() || !contains(split(file), snippet)) {
      all.push_back(where + "not in " + match[1].str() + " as it stands");
    }
  }
  return all;
}

// exists(target) tells whether a path relative to the page leads to a file or folder.
errors check_links(const std::string& page, const std::function<bool(const std::string&)>& exists) {
  static const std::regex link(
      R"(\]\(\s*<?([^)\s>]+)>?[^)]*\)|(?:src|href)="([^"]+)\"|^\[[^\]]+\]:\s+(\S+))");
  static const std::regex elsewhere(R"(^([a-zA-Z][a-zA-Z0-9+.-]*:|#).*)");
  errors all;
  bool code = false;
  int number = 0;
  for (const std::string& line : split(page)) {
    ++number;
    if (line.starts_with("```")) code = !code;
    if (code) continue;
    for (std::sregex_iterator i(line.begin(), line.end(), link), end; i != end; ++i) {
      const std::string target = i->str(1) + i->str(2) + i->str(3);  // one of the three
      if (std::regex_match(target, elsewhere)) continue;
      if (!exists(target.substr(0, target.find('#')))) {
        all.push_back("line " + std::to_string(number) + ": broken link: " + target);
      }
    }
  }
  return all;
}

std::string read_file(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

const fs::path root = PASSIVE_HAPTICS_SOURCE_DIR;

// All pages of the repository, not of build folders or hidden ones.
std::vector<fs::path> pages() {
  std::vector<fs::path> all;
  for (auto i = fs::recursive_directory_iterator(root); i != fs::recursive_directory_iterator(); ++i) {
    const std::string name = i->path().filename().string();
    if (i->is_directory() && (name.starts_with(".") || name.starts_with("build")))
      i.disable_recursion_pending();
    else if (name.ends_with(".md")) all.push_back(i->path());
  }
  return all;
}

TEST(documentation, snippets_are_parts_of_compiled_files) {
  for (const fs::path& page : pages()) {
    const auto read = [](const std::string& path) { return read_file(root / path); };
    EXPECT_EQ(check_snippets(read_file(page), read), errors()) << page;
  }
}

TEST(documentation, relative_links_lead_somewhere) {
  for (const fs::path& page : pages()) {
    const auto exists = [&](const std::string& target) { return fs::exists(page.parent_path() / target); };
    EXPECT_EQ(check_links(read_file(page), exists), errors()) << page;
  }
}

TEST(documentation, explains_messages_that_programs_have) {
  std::string sources;
  for (const char* folder : {"include", "examples", ".ci"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.is_regular_file()) sources += read_file(entry.path());
  static const std::regex row(R"(^\| `([^`]+)` \|.*$)");
  int explained = 0;
  for (const char* page : {"docs/guide/troubleshooting.md", "docs/guide/brake_identification.md"})
    for (const std::string& line : split(read_file(root / page))) {
      std::smatch match;
      if (!std::regex_match(line, match, row)) continue;
      ++explained;
      EXPECT_NE(sources.find(match[1]), std::string::npos) << match[1];
    }
  EXPECT_GT(explained, 10);
}

// ---- the checks themselves

std::size_t snippet_errors(const std::string& page) {
  return check_snippets(page,
                        [](const std::string& path) {
                          return path == "a.cpp" ? "int main() {\n  int x = 1;\n\n  return x;\n}\n" : "";
                        })
      .size();
}

TEST(documentation_check, accepts_parts_of_files_at_any_indentation) {
  EXPECT_EQ(snippet_errors("<!-- file: a.cpp -->\n```cpp\nint main() {\n  int x = 1;\n```\n"), 0u);
  EXPECT_EQ(snippet_errors("<!-- file: a.cpp -->\n```cpp\nint x = 1;\n\nreturn x;\n```\n"), 0u);
  EXPECT_EQ(snippet_errors("```sh\n./tests/run\n```\n"), 0u);
}

TEST(documentation_check, notices_snippets_that_no_file_has) {
  EXPECT_EQ(snippet_errors("<!-- file: a.cpp -->\n```cpp\nint x = 2;\n```\n"), 1u);
  EXPECT_EQ(snippet_errors("<!-- file: a.cpp -->\n```cpp\nint x = 1;\nreturn x;\n```\n"), 1u)
      << "not contiguous";
  EXPECT_EQ(snippet_errors("<!-- file: a.cpp -->\n```cpp\nint main() {\nint x = 1;\n```\n"), 1u)
      << "indented otherwise";
  EXPECT_EQ(snippet_errors("<!-- file: b.cpp -->\n```cpp\nint x = 1;\n```\n"), 1u);
  EXPECT_EQ(snippet_errors("text\n```cpp\nint x = 1;\n```\n"), 1u);
  EXPECT_EQ(snippet_errors("```cpp\nint x = 1;\n```\n"), 1u);
  EXPECT_EQ(snippet_errors("<!-- file: a.cpp -->\n```cpp\n```\n"), 1u) << "empty";
  EXPECT_EQ(snippet_errors("```sh\nls\n"), 1u) << "without an end";
  EXPECT_EQ(snippet_errors("<!-- file: a.cpp -->\n```cmake\nint x = 2;\n```\n"), 1u) << "in any language";
}

TEST(documentation_check, notices_broken_links) {
  const auto check = [](const std::string& page) {
    return check_links(page, [](const std::string& target) { return target == "docs/a.md"; }).size();
  };
  EXPECT_EQ(check("[a](docs/a.md), [b](docs/a.md#part \"title\"), ![c](docs/a.md) and [d](https://x.org/y), "
                  "[e](#here)"),
            0u);
  EXPECT_EQ(check("```\n[a](b.md)\n```\n"), 0u);
  EXPECT_EQ(check("[a]: docs/a.md\n[b]: https://x.org\n"), 0u);
  EXPECT_EQ(check("[a](b.md)"), 1u);
  EXPECT_EQ(check("[a]: b.md\n"), 1u);
  EXPECT_EQ(check("![a](b.svg) [c](d.md#e)"), 2u);
  EXPECT_EQ(check("<img src=\"b.svg\">"), 1u);
}

}  // namespace
