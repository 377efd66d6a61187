// Headers are guarded, and no line is too wide.
#include "texts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace {

using namespace repository;

constexpr int max_columns = 110;  // as in .clang-format

// Characters of UTF-8: all bytes but those that continue one.
long columns_of(const std::string& line) {
  return std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; });
}

errors check_form(const texts& headers) {
  errors all;
  for (const auto& [path, text] : headers) {
    if (text.find("\n#pragma once\n") == std::string::npos) all.push_back(path + ": no #pragma once");
    for (const std::string& line : lines_of(text))
      if (columns_of(line) > max_columns) all.push_back(path + ": too wide: " + line);
  }
  return all;
}

TEST(form, headers_are_guarded_and_no_line_is_too_wide) { EXPECT_EQ(check_form(headers()), errors()); }

TEST(form_check, notices_missing_guards_and_wide_lines) {
  const std::string guard = "/// A sentence.\n#pragma once\n", full(110, 'x');
  EXPECT_EQ(check_form({{"a.hpp", guard + full + "\n" + full.substr(1) + "\u00b7\n"}}), errors());
  EXPECT_EQ(check_form({{"a.hpp", guard + full + "x"}}), errors{"a.hpp: too wide: " + full + "x"});
  EXPECT_EQ(check_form({{"a.hpp", "// #pragma once\n"}}), errors{"a.hpp: no #pragma once"});
}

}  // namespace
