// Each equation of the paper stands at one place in include/, by its tag, and docs/notation.md says where.
#include "headers.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace repository;
using files = std::vector<std::string>;

constexpr int equations = 12;

// The headers in which @equation{number} stands, one entry for each time.
std::map<int, files> tags_of(const texts& headers) {
  static const std::regex tag(R"([@\\]equation\{(\d+)\})");
  std::map<int, files> all;
  for (const auto& [path, text] : headers) {
    for (std::sregex_iterator i(text.begin(), text.end(), tag), end; i != end; ++i)
      all[std::stoi((*i)[1])].push_back(path);
  }
  return all;
}

std::string list(const files& paths) {
  std::string all;
  for (const std::string& path : paths) all += (all.empty() ? "" : ", ") + path;
  return all.empty() ? "nowhere" : all;
}

errors check_tags(const texts& headers) {
  std::map<int, files> tags = tags_of(headers);
  errors all;
  for (int number = 1; number <= equations; ++number) {
    if (const files& found = tags[number]; found.size() != 1)
      all.push_back("(" + std::to_string(number) + "): " + list(found));
  }
  for (const auto& [number, found] : tags) {
    if (number < 1 || number > equations)
      all.push_back("the paper has no (" + std::to_string(number) + "): " + list(found));
  }
  return all;
}

// The rows "| (3) | ... | [file](../include/passive_haptics/file) |" of a page: the files of each equation.
std::map<int, files> listed_in(const std::string& page) {
  static const std::regex row(
      R"(^\| \((\d+)\) \|.*\| \[`([^`\]]*)`\]\(\.\./include/passive_haptics/([^)]*)\) \|$)");
  std::map<int, files> all;
  std::istringstream in(page);
  std::smatch match;
  for (std::string line; std::getline(in, line);) {
    if (!std::regex_match(line, match, row)) continue;
    all[std::stoi(match[1])].push_back(match[3]);
    if (match[2] != match[3]) all[std::stoi(match[1])].push_back(match[2]);  // shows one, leads to another
  }
  return all;
}

errors check_page(const std::string& page, const texts& headers) {
  std::map<int, files> listed = listed_in(page);
  std::map<int, files> tags = tags_of(headers);
  errors all;
  for (int number = 1; number <= equations; ++number) {
    if (listed[number].size() != 1 || listed[number] != tags[number])
      all.push_back("(" + std::to_string(number) + ") is listed at " + list(listed[number]) + ", stands at " +
                    list(tags[number]));
  }
  return all;
}

// The column File of every table that has one: which rows have no link in it?
errors check_files(const std::string& page) {
  errors all;
  std::istringstream in(page);
  bool has_files = false;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("|")) has_files = false;
    if (line.ends_with("| File |")) {
      has_files = true;
    } else if (has_files && !line.starts_with("| ---") && !line.ends_with(") |")) {
      all.push_back("no file: " + line);
    }
  }
  return all;
}

// Rows "| ... `state.q` ... | [..](../include/passive_haptics/file) |" whose file has none of the names.
errors check_names(const std::string& page, const texts& headers) {
  static const std::regex row(R"(^(\|.*\|) [^|]*\(\.\./include/passive_haptics/([^)]*)\) \|$)");
  static const std::regex name(R"(`(?:\w+(?:\.|::))?(\w+)[^`]*`)");  // `name`, `a.name`, `a::name(...)`
  errors all;
  std::istringstream in(page);
  std::smatch match;
  for (std::string line; std::getline(in, line);) {
    if (!std::regex_match(line, match, row)) continue;
    const std::string cells = match[1];
    const auto file = headers.find(match[2]);
    bool any_name = false, found = false;
    for (std::sregex_iterator i(cells.begin(), cells.end(), name), end; i != end; ++i) {
      any_name = true;
      found |=
          file != headers.end() && std::regex_search(file->second, std::regex("\\b" + i->str(1) + "\\b"));
    }
    if (any_name && !found) all.push_back("nothing of this in the file: " + line);
  }
  return all;
}

std::string notation() {
  return read(std::filesystem::path(PASSIVE_HAPTICS_SOURCE_DIR) / "docs" / "notation.md");
}

TEST(equations, stand_at_one_place_each) { EXPECT_EQ(check_tags(headers()), errors()); }
TEST(equations, stand_where_the_notation_says) { EXPECT_EQ(check_page(notation(), headers()), errors()); }
TEST(equations, symbols_have_files) {
  EXPECT_EQ(check_files(notation()), errors());
  EXPECT_NE(notation().find("| File |\n"), std::string::npos);
}

TEST(equations, symbols_are_in_their_files) { EXPECT_EQ(check_names(notation(), headers()), errors()); }

// ---- the checks themselves

texts tagged() {
  texts headers;
  for (int number = 1; number <= equations; ++number)
    headers["core/" + std::to_string(number) + ".hpp"] =
        "/// Text. @equation{" + std::to_string(number) + "}\n";
  return headers;
}

std::string row(int number, const std::string& path) {
  return "| (" + std::to_string(number) + ") | a \\| b | [`" + path + "`](../include/passive_haptics/" +
         path + ") |\n";
}

std::string page() {
  std::string all;
  for (int number = 1; number <= equations; ++number)
    all += row(number, "core/" + std::to_string(number) + ".hpp");
  return all;
}

TEST(equations_check, accepts_one_tag_each) {
  EXPECT_EQ(check_tags(tagged()), errors());
  EXPECT_EQ(check_page(page(), tagged()), errors());
  texts together = tagged();
  together["core/7.hpp"] = "/// @equation{7} @equation{8} \\equation{9}\n";
  together["core/8.hpp"] = together["core/9.hpp"] = "/// (8) and (9)\n";
  EXPECT_EQ(check_tags(together), errors());
}

TEST(equations_check, notices_tags_that_are_missing_doubled_or_unknown) {
  texts headers = tagged();
  headers["core/3.hpp"] = "/// equation{3}, (3)\n";
  headers["core/4.hpp"] += "/// @equation{1}\n";
  headers["core/5.hpp"] += "/// @equation{5} @equation{13}\n";
  const errors expected{"(1): core/1.hpp, core/4.hpp", "(3): nowhere", "(5): core/5.hpp, core/5.hpp",
                        "the paper has no (13): core/5.hpp"};
  EXPECT_EQ(check_tags(headers), expected);
}

TEST(equations_check, notices_a_page_that_leads_elsewhere) {
  texts moved = tagged();
  std::swap(moved["core/3.hpp"], moved["core/4.hpp"]);
  EXPECT_EQ(check_page(page(), moved).size(), 2u);
  EXPECT_EQ(check_page(page() + row(3, "core/3.hpp"), tagged()).size(), 1u) << "twice";
  EXPECT_EQ(check_page("", tagged()).size(), 12u);
  std::string shown = page();
  shown.replace(shown.find("`core/3.hpp`"), 12, "`core/4.hpp`");
  EXPECT_EQ(check_page(shown, tagged()).size(), 1u) << "shows another file than it leads to";
}

TEST(equations_check, notices_symbols_without_a_file) {
  const std::string head = "| Symbol | File |\n| --- | --- |\n";
  EXPECT_EQ(check_files(head + "| q | [a](b) |\n\n| x | y |\n"), errors());
  EXPECT_EQ(check_files(head + "| q | |\n| x | [a](b) |\n").size(), 1u);
}

TEST(equations_check, notices_symbols_that_are_elsewhere) {
  const auto check = [](const std::string& code) {
    const texts headers{{"a.hpp", "struct b { int q; }; int f(int);"}};
    return check_names("| x | " + code + " | [`a.hpp`](../include/passive_haptics/a.hpp) |\n", headers)
        .size();
  };
  EXPECT_EQ(check("`state.q`"), 0u);
  EXPECT_EQ(check("`b::q`, `result.other`"), 0u);
  EXPECT_EQ(check("`f(mechanism, q)`"), 0u);
  EXPECT_EQ(check("no code"), 0u);
  EXPECT_EQ(check("`g(f, q)`"), 1u);
  EXPECT_EQ(check("`state.qd`"), 1u);
}

}  // namespace
