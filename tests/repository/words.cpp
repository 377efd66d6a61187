// Words that have no place in comments, messages and pages, and sentences that are too long to be read once.
#include "headers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;
using repository::errors;

constexpr long max_words = 40;  // of a sentence

// A paragraph, a cell of a table, a comment or the text of a string, and the line on which it begins.
struct passage {
  int line;
  std::string text;
};
using passages = std::vector<passage>;

// Collects lines to passages.
class passage_list {
 public:
  void add(int line, const std::string& text) {
    if (open_.text.empty()) open_.line = line;
    else open_.text += ' ';
    open_.text += text;
  }
  void close() {
    if (!open_.text.empty()) all_.push_back(std::exchange(open_, {}));
  }
  void add_alone(int line, const std::string& text) {
    close();
    add(line, text);
    close();
  }
  passages all() {
    close();
    return all_;
  }

 private:
  passage open_ = {};
  passages all_;
};

// Of a page in Markdown; its code is left out.
passages passages_of_page(const std::string& text) {
  static const std::regex item(R"(^\s*([-*]|\d+\.) .*)"), other(R"(^(#|<!--|    ).*)");
  static const std::regex address(R"(\]\([^)]*\))");
  passage_list found;
  std::istringstream in(text);
  int number = 0;
  bool is_code = false;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.find("```") != std::string::npos) is_code = !is_code, found.close();
    else if (is_code || line.empty() || std::regex_match(line, other)) found.close();
    else {
      line = std::regex_replace(line, address, "]");
      if (line.front() == '|') {
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, '|');) found.add_alone(number, cell);
        continue;
      }
      if (std::regex_match(line, item)) found.close();
      found.add(number, line);
    }
  }
  return found.all();
}

// Comments of a source, and the texts of its strings.
passages passages_of_source(const std::string& text) {
  static const std::regex comment(R"re((^|\s)//[/<]*[ ]?(.*)$)re");
  static const std::regex string(R"re("((?:[^"\\]|\\.)*)")re");
  static const std::regex include(R"(^\s*#\s*include.*)");
  passage_list found;
  passages strings;
  std::istringstream in(text);
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::smatch match;
    std::string code = line;
    if (std::regex_search(line, match, comment)) {
      code = match.prefix();
      const std::string words = match[2];
      const bool is_alone = code.find_first_not_of(' ') == std::string::npos;
      if (!is_alone) found.add_alone(number, words);
      else if (words.empty() || words.starts_with("    ") || words.starts_with("@file")) found.close();
      else found.add(number, words);
    } else {
      found.close();
    }
    if (std::regex_match(line, include)) continue;
    for (std::sregex_iterator i(code.begin(), code.end(), string), end; i != end; ++i)
      strings.push_back({number, (*i)[1]});
  }
  passages all = found.all();
  std::move(strings.begin(), strings.end(), std::back_inserter(all));
  return all;
}

long count_words(const std::string& text) {
  std::istringstream in(text);
  return std::count_if(std::istream_iterator<std::string>(in), {}, [](const std::string& word) {
    return std::any_of(word.begin(), word.end(), [](unsigned char c) { return std::isalpha(c) != 0; });
  });
}

errors check(const std::string& path, const passages& all) {
  static const std::regex tic(
      R"((^|[^\w'_])(told|tells?|telling|asks?|asked|asking|answers|answered|likewise)([^\w'_]|$))",
      std::regex::icase);
  static const std::regex sentence_end(R"([.!?:;]\s)");
  errors found;
  static const std::regex code("`[^`]*`");
  for (const auto& [line, whole] : all) {
    const std::string text = std::regex_replace(whole, code, "code");
    const std::string where = path + ":" + std::to_string(line) + ": ";
    if (std::smatch word; std::regex_search(text, word, tic))
      found.push_back(where + "'" + word.str(2) + "'");
    if (text.starts_with("The same")) found.push_back(where + "opens with 'The same'");
    for (std::sregex_token_iterator i(text.begin(), text.end(), sentence_end, -1), end; i != end; ++i)
      if (const long words = count_words(*i); words > max_words)
        found.push_back(where + "a sentence of " + std::to_string(words) + " words");
  }
  return found;
}

errors check_file(const fs::path& path, const std::string& name) {
  const std::string text = repository::read(path);
  return check(name, path.extension() == ".md" ? passages_of_page(text) : passages_of_source(text));
}

TEST(words, of_comments_messages_and_pages_can_be_read_once) {
  const fs::path root = PASSIVE_HAPTICS_SOURCE_DIR;
  std::vector<fs::path> files{root / "README.md"};
  for (const char* folder : {"include", "docs", "examples", "benchmarks"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (const auto kind = entry.path().extension(); kind == ".md" || kind == ".hpp" || kind == ".cpp")
        files.push_back(entry.path());
  EXPECT_GT(files.size(), 400u);
  std::string all;
  for (const fs::path& file : files)
    for (const std::string& error : check_file(file, fs::relative(file, root).generic_string()))
      all += error + "\n";
  EXPECT_EQ(all, "");
}

// ---- the checks themselves

TEST(words_check, notices_words_in_comments_strings_and_pages) {
  const auto source = [](const std::string& text) { return check("a.hpp", passages_of_source(text)); };
  const auto page = [](const std::string& text) { return check("a.md", passages_of_page(text)); };
  EXPECT_EQ(source("int told = 1;  // a number\n"), errors());
  EXPECT_EQ(source("int a;  // What it tells.\n"), errors{"a.hpp:1: 'tells'"});
  EXPECT_EQ(source("\n  /// A wall\n  /// asks for it.\n"), errors{"a.hpp:2: 'asks'"});
  EXPECT_EQ(source("f(\"nobody answers\");\n"), errors{"a.hpp:1: 'answers'"});
  EXPECT_EQ(source("/// The same of all.\n"), errors{"a.hpp:1: opens with 'The same'"});
  EXPECT_EQ(source("/// Of all the same.\n"), errors());
  EXPECT_EQ(page("# Told\n\nA wall\nis told.\n"), errors{"a.md:3: 'told'"});
  EXPECT_EQ(page("```cpp\nint told;\n```\n`told` is a name.\n"), errors());
  EXPECT_EQ(page("| a | tells |\n"), errors{"a.md:1: 'tells'"});
}

TEST(words_check, notices_sentences_that_are_too_long) {
  std::string forty;
  for (long k = 0; k < max_words; ++k) forty += "word ";
  EXPECT_EQ(check("a.md", passages_of_page(forty + ". " + forty + "\n")), errors());
  EXPECT_EQ(check("a.md", passages_of_page(forty + "\nword\n")), errors{"a.md:1: a sentence of 41 words"});
  EXPECT_EQ(check("a.hpp", passages_of_source("/// " + forty + "\n/// 12 = 12 word.\n")),
            errors{"a.hpp:1: a sentence of 41 words"});
}

}  // namespace
