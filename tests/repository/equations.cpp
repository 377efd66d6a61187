// Each equation of the paper is at one place in include/, by its tag, which docs/equations.md lists.
#include "texts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

namespace {

using namespace repository;

constexpr int equations = 12;
using places = std::map<int, strings>;  // of each equation: headers

places tags_of(const texts& headers) {
  places all;
  for (const auto& [path, text] : headers)
    for (const auto& tag : matches("[@\\]equation\\{([0-9]+)\\}", text))
      all[std::stoi(tag[1])].push_back(path);
  return all;
}

// By the rows "| (3) | ... | [`file`](../include/passive_haptics/file) |" of a page.
places listed_in(const std::string& page) {
  places all;
  for (const auto& row : matches(
           "^\\| \\(([0-9]+)\\) \\|.*\\| \\[`([^]`]*)`\\]\\(\\.\\./include/passive_haptics/([^)]*)\\) \\|$",
           page)) {
    strings& files = all[std::stoi(row[1])];
    files.push_back(row[3]);
    if (row[2] != row[3]) files.push_back(row[2]);  // shows one, leads to another
  }
  return all;
}

// One tag for each equation, none of another number, and the page says where.
errors check_equations(const std::string& page, const texts& headers) {
  errors all;
  places tags = tags_of(headers), listed = listed_in(page);
  for (int number = 1; number <= equations; ++number) {
    const auto name = [number](const char* what) { return "(" + std::to_string(number) + ") " + what; };
    if (tags[number].size() != 1) all.push_back(name("does not stand at one place"));
    else if (listed[number] != tags[number]) all.push_back(name("is listed elsewhere"));
    tags.erase(number);
  }
  for (const auto& [number, files] : tags)
    all.push_back("(" + std::to_string(number) + ") is not in the paper: " + files[0]);
  return all;
}

bool has_word(const std::string& text, const std::string& word) {
  return !matches("(^|[^A-Za-z0-9_])" + word + "($|[^A-Za-z0-9_])", text).empty();
}

// Rows of a table with a column File: each leads to a file, which has one of the names of the row.
errors check_symbols(const std::string& page, const texts& headers) {
  errors all;
  bool has_files = false;
  for (const std::string& line : lines_of(page)) {
    if (!line.starts_with("|")) has_files = false;
    if (line.ends_with("| File |")) has_files = true;
    else if (has_files && !line.starts_with("| ---")) {
      const auto row = matches("^(\\|.*\\|) [^|]*\\]\\(([^)]*)\\) \\|$", line);
      if (row.empty()) {
        all.push_back("no file: " + line);
        continue;
      }
      const auto names = matches("`([A-Za-z0-9_]+(\\.|::))?([A-Za-z0-9_]+)[^`]*`", row[0][1]);
      const auto file = matches("^\\.\\./include/passive_haptics/(.*)$", row[0][2]);
      if (names.empty() || file.empty()) continue;
      const auto header = headers.find(file[0][1]);
      const auto is_there = [&](const strings& name) { return has_word(header->second, name[3]); };
      if (header == headers.end() || std::none_of(names.begin(), names.end(), is_there))
        all.push_back("nothing of this in the file: " + line);
    }
  }
  return all;
}

TEST(equations, stand_at_one_place_each_where_the_page_says) {
  EXPECT_EQ(check_equations(read(root / "docs/equations.md"), headers()), errors());
}

TEST(equations, symbols_are_in_their_files) {
  const std::string page = read(root / "docs/notation.md");
  EXPECT_EQ(check_symbols(page, headers()), errors());
  EXPECT_NE(page.find("| File |\n"), std::string::npos);
}

std::string equation_row(int number, const std::string& path) {
  return "| (" + std::to_string(number) + ") | a \\| b | [`" + path + "`](../include/passive_haptics/" +
         path + ") |\n";
}

TEST(equations_check, notices_tags_and_rows_that_are_missing_doubled_or_elsewhere) {
  texts tagged;
  std::string page;
  for (int number = 1; number <= equations; ++number) {
    const std::string path = "core/" + std::to_string(number) + ".hpp";
    tagged[path] = "/// Text. @equation{" + std::to_string(number) + "}\n";
    page += equation_row(number, path);
  }
  EXPECT_EQ(check_equations(page, tagged), errors());
  EXPECT_EQ(check_equations("", tagged).size(), 12u);
  EXPECT_EQ(check_equations(page + equation_row(3, "core/3.hpp"), tagged).size(), 1u) << "twice";
  std::string shown = page;
  shown.replace(shown.find("`core/3.hpp`"), 12, "`core/4.hpp`");
  EXPECT_EQ(check_equations(shown, tagged).size(), 1u) << "shows another file than it leads to";

  texts wrong = tagged;
  wrong["core/3.hpp"] = "/// equation{3}, (3)\n";
  wrong["core/4.hpp"] += "/// @equation{1} \\equation{13}\n";
  std::swap(wrong["core/7.hpp"], wrong["core/8.hpp"]);
  EXPECT_EQ(
      check_equations(page, wrong),
      (errors{"(1) does not stand at one place", "(3) does not stand at one place", "(7) is listed elsewhere",
              "(8) is listed elsewhere", "(13) is not in the paper: core/4.hpp"}));
}

TEST(equations_check, notices_symbols_without_a_file_or_that_are_elsewhere) {
  const auto check = [](const std::string& row) {
    return check_symbols("| Symbol | File |\n| --- | --- |\n" + row + "\n\n| x | y |\n",
                         {{"a.hpp", "struct b { int q; }; int f(int);"}})
        .size();
  };
  const std::string file = " | [`a.hpp`](../include/passive_haptics/a.hpp) |";
  for (const char* right : {"`state.q`", "`b::q`, `result.other`", "`f(mechanism, q)`", "no code"})
    EXPECT_EQ(check(std::string("| ") + right + file), 0u) << right;
  for (const char* wrong : {"`g(f, q)`", "`state.qd`"})
    EXPECT_EQ(check(std::string("| ") + wrong + file), 1u) << wrong;
  EXPECT_EQ(check("| q | [a](b) |"), 0u);
  EXPECT_EQ(check("| q | |"), 1u);
}

}  // namespace
