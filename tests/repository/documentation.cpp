// Every C++ snippet in the documentation, and any other that names a file, is part of that file, every
// relative link leads somewhere, and the messages that the guide explains are those of the programs.
#include "texts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

namespace {

using namespace repository;

// Without the indentation that all lines share, and without white space at their ends.
strings flush_left(strings text) {
  std::size_t indent = std::string::npos;
  for (std::string& line : text) {
    line.erase(line.find_last_not_of(" \r\t") + 1);
    if (!line.empty()) indent = std::min(indent, line.find_first_not_of(' '));
  }
  for (std::string& line : text) line = line.substr(std::min(indent, line.size()));
  return text;
}

// Snippet as contiguous lines of the file.
bool contains(const strings& file, const strings& snippet) {
  const strings expected = flush_left(snippet);
  for (std::size_t i = 0; i + expected.size() <= file.size(); ++i) {
    const auto first = file.begin() + static_cast<std::ptrdiff_t>(i);
    if (flush_left(strings(first, first + static_cast<std::ptrdiff_t>(expected.size()))) == expected)
      return true;
  }
  return false;
}

// read(path) gives the text of a file of the repository, empty if there is none.
errors check_snippets(const std::string& page, const std::function<std::string(const std::string&)>& read) {
  errors all;
  const strings text = lines_of(page);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!text[i].starts_with("```")) continue;
    const std::size_t opening = i;
    strings snippet;
    for (++i; i < text.size() && !text[i].starts_with("```"); ++i) snippet.push_back(text[i]);
    const std::string where = "line " + std::to_string(opening + 1) + ": ";
    if (i == text.size()) all.push_back(where + "``` without an end");
    const auto source = matches("^<!-- file: ([^ ]+) -->", opening > 0 ? text[opening - 1] : "");
    if (source.empty()) {
      if (text[opening].starts_with("```cpp") || text[opening].starts_with("```c++"))
        all.push_back(where + "no `<!-- file: path -->` above the snippet");
    } else if (const std::string file = read(source[0][1]);
               file.empty() || snippet.empty() || !contains(lines_of(file), snippet)) {
      all.push_back(where + "not in " + source[0][1] + " as it stands");
    }
  }
  return all;
}

// exists(target) is true if a path relative to the page leads to a file or folder.
errors check_links(const std::string& page, const std::function<bool(const std::string&)>& exists) {
  errors all;
  bool code = false;
  for (const std::string& line : lines_of(page)) {
    if (line.starts_with("```")) code = !code;
    if (code) continue;
    for (const auto& link :
         matches("\\]\\([ ]*<?([^) >]+)>?[^)]*\\)|(src|href)=\"([^\"]+)\"|^\\[[^]]+\\]:[ ]+([^ ]+)", line)) {
      const std::string target = link[1] + link[3] + link[4];  // one of the three
      const bool elsewhere = !matches("^([a-zA-Z][a-zA-Z0-9+.-]*:|#)", target).empty();
      if (!elsewhere && !exists(target.substr(0, target.find('#')))) all.push_back("broken link: " + line);
    }
  }
  return all;
}

// Calls visit(path) for all pages of the repository, not those of build folders or hidden ones.
template <class Visit>
void for_each_page(const Visit& visit) {
  for (auto i = fs::recursive_directory_iterator(root); i != fs::recursive_directory_iterator(); ++i) {
    const std::string name = i->path().filename().string();
    if (i->is_directory() && (name.starts_with(".") || name.starts_with("build")))
      i.disable_recursion_pending();
    else if (name.ends_with(".md")) visit(i->path());
  }
}

TEST(documentation, snippets_are_parts_of_compiled_files_and_links_lead_somewhere) {
  for_each_page([](const fs::path& page) {
    const auto text_of = [](const std::string& path) { return read(root / path); };
    EXPECT_EQ(check_snippets(read(page), text_of), errors()) << page;
    const auto exists = [&](const std::string& target) { return fs::exists(page.parent_path() / target); };
    EXPECT_EQ(check_links(read(page), exists), errors()) << page;
  });
}

TEST(documentation, explains_messages_that_programs_have) {
  std::string sources;
  for (const char* folder : {"include", "examples", ".ci"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.is_regular_file()) sources += read(entry.path());
  int explained = 0;
  for (const char* page : {"docs/guide/troubleshooting.md", "docs/guide/brake.md"})
    for (const auto& row : matches("^\\| `([^`]+)` \\|.*$", read(root / page))) {
      ++explained;
      EXPECT_NE(sources.find(row[1]), std::string::npos) << row[1];
    }
  EXPECT_GT(explained, 10);
}

TEST(documentation_check, notices_snippets_that_no_file_has) {
  const auto check = [](const std::string& snippet) {
    const auto text_of = [](const std::string& path) {
      return path == "a.cpp" ? "int main() {\n  int x = 1;\n\n  return x;\n}\n" : "";
    };
    return check_snippets(snippet, text_of).size();
  };
  const std::string of_a = "<!-- file: a.cpp -->\n```cpp\n";
  EXPECT_EQ(check(of_a + "int main() {\n  int x = 1;\n```\n"), 0u);
  EXPECT_EQ(check(of_a + "int x = 1;\n\nreturn x;\n```\n"), 0u) << "at any indentation";
  EXPECT_EQ(check("```sh\n./tests/run\n```\n"), 0u);
  for (const std::string& wrong :
       {of_a + "int x = 2;\n```\n", of_a + "int x = 1;\nreturn x;\n```\n",
        of_a + "int main() {\nint x = 1;\n```\n", of_a + "```\n",
        std::string("<!-- file: b.cpp -->\n```cpp\nint x = 1;\n```\n"),
        std::string("<!-- file: a.cpp -->\n```cmake\nint x = 2;\n```\n"),
        std::string("text\n```cpp\nint x = 1;\n```\n"), std::string("```sh\nls\n")})
    EXPECT_EQ(check(wrong), 1u) << wrong;
}

TEST(documentation_check, notices_broken_links) {
  const auto check = [](const std::string& page) {
    return check_links(page, [](const std::string& target) { return target == "docs/a.md"; }).size();
  };
  EXPECT_EQ(check("[a](docs/a.md), [b](docs/a.md#part \"title\"), ![c](docs/a.md) and [d](https://x.org/y), "
                  "[e](#here)"),
            0u);
  EXPECT_EQ(check("```\n[a](b.md)\n```\n[a]: docs/a.md\n[b]: https://x.org\n"), 0u);
  for (const char* wrong : {"[a](b.md)", "[a]: b.md\n", "<img src=\"b.svg\">"})
    EXPECT_EQ(check(wrong), 1u) << wrong;
  EXPECT_EQ(check("![a](b.svg) [c](d.md#e)"), 2u);
}

}  // namespace
