// Headers are short, guarded and documented, no line is too wide, no folder is without a group.
#include "headers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace {

using namespace repository;

constexpr int max_lines = 250;
constexpr int max_columns = 110;  // as in .clang-format

errors check_form(const texts& headers) {
  errors all;
  for (const auto& [path, text] : headers) {
    if (!text.starts_with("/// @file\n/// "))
      all.push_back(path + ": does not open with /// @file and a sentence");
    if (text.find("\n#pragma once\n") == std::string::npos) all.push_back(path + ": no #pragma once");
    const auto lines = std::count(text.begin(), text.end(), '\n');
    if (lines > max_lines) all.push_back(path + ": " + std::to_string(lines) + " lines");
  }
  return all;
}

// Characters of UTF-8: all bytes but those that continue one.
long columns_of(const std::string& line) {
  return std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; });
}

errors check_width(const texts& headers) {
  errors all;
  for (const auto& [path, text] : headers) {
    std::istringstream in(text);
    int number = 0;
    for (std::string line; std::getline(in, line);) {
      ++number;
      if (const long columns = columns_of(line); columns > max_columns)
        all.push_back(path + ":" + std::to_string(number) + ": " + std::to_string(columns) + " columns");
    }
  }
  return all;
}

// Every folder has its group in Doxygen's pages, every group its folder.
errors check_groups(const texts& headers, const std::string& groups) {
  std::set<std::string> folders;
  for (const auto& [path, text] : headers) {
    std::string folder = folder_of(path);
    std::replace(folder.begin(), folder.end(), '/', '_');
    if (!folder.empty()) folders.insert(folder);
  }
  static const std::regex group(R"(@defgroup (\S+) )");
  std::set<std::string> named;
  for (std::sregex_iterator i(groups.begin(), groups.end(), group), end; i != end; ++i) named.insert((*i)[1]);
  errors all;
  std::set_symmetric_difference(folders.begin(), folders.end(), named.begin(), named.end(),
                                std::back_inserter(all));
  return all;
}

TEST(form, headers_are_short_guarded_and_documented) { EXPECT_EQ(check_form(headers()), errors()); }
TEST(form, no_line_is_too_wide) { EXPECT_EQ(check_width(headers()), errors()); }
TEST(form, every_folder_has_a_group) {
  const std::filesystem::path root = PASSIVE_HAPTICS_SOURCE_DIR;
  EXPECT_EQ(check_groups(headers(), read(root / "docs" / "site" / "groups.dox")), errors());
}

// ---- the checks themselves

TEST(form_check, notices_bad_form) {
  const std::string good = "/// @file\n/// What it is.\n#pragma once\n";
  EXPECT_EQ(check_form({{"core/a.hpp", good + std::string(247, '\n')}}), errors());
  EXPECT_EQ(check_form({{"core/a.hpp", good + std::string(248, '\n')}}), errors{"core/a.hpp: 251 lines"});
  EXPECT_EQ(check_form({{"core/a.hpp", "/// @file\n/// What it is.\n"}}).size(), 1u);
  EXPECT_EQ(check_form({{"core/a.hpp", "\n#pragma once\n"}}).size(), 1u);
}

TEST(form_check, notices_wide_lines) {
  const std::string full(110, 'x');
  EXPECT_EQ(check_width({{"core/a.hpp", full + "\n" + full}}), errors());
  EXPECT_EQ(check_width({{"core/a.hpp", full + "x"}}), errors{"core/a.hpp:1: 111 columns"});
  EXPECT_EQ(check_width({{"core/a.hpp", "\n" + full + "x\n"}}), errors{"core/a.hpp:2: 111 columns"});
  EXPECT_EQ(check_width({{"core/a.hpp", full.substr(1) + "\u00b7\n"}}), errors())
      << "a character of two bytes";
  EXPECT_EQ(check_width({{"core/a.hpp", full + "\u00b7\n"}}).size(), 1u);
}

TEST(form_check, notices_folders_without_a_group) {
  const texts some{{"core/a.hpp", ""}, {"core/linear/b.hpp", ""}, {"all.hpp", ""}};
  EXPECT_EQ(check_groups(some, "/// @defgroup core core: a\n/// @defgroup core_linear linear\n"), errors());
  EXPECT_EQ(check_groups(some, "/// @defgroup core core: a\n"), errors{"core_linear"});
  EXPECT_EQ(check_groups({}, "/// @defgroup core core: a\n"), errors{"core"});
}

}  // namespace
