// Headers are guarded, and no line is too wide.
#include "headers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

namespace {

using namespace repository;

constexpr int max_columns = 110;  // as in .clang-format

errors check_guard(const texts& headers) {
  errors all;
  for (const auto& [path, text] : headers)
    if (text.find("\n#pragma once\n") == std::string::npos) all.push_back(path + ": no #pragma once");
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

TEST(form, headers_are_guarded) { EXPECT_EQ(check_guard(headers()), errors()); }
TEST(form, no_line_is_too_wide) { EXPECT_EQ(check_width(headers()), errors()); }

// ---- the checks themselves

TEST(form_check, notices_a_missing_guard) {
  EXPECT_EQ(check_guard({{"core/a.hpp", "/// A sentence.\n#pragma once\n"}}), errors());
  EXPECT_EQ(check_guard({{"core/a.hpp", "// #pragma once\n"}}), errors{"core/a.hpp: no #pragma once"});
}

TEST(form_check, notices_wide_lines) {
  const std::string full(110, 'x');
  EXPECT_EQ(check_width({{"core/a.hpp", full + "\n" + full}}), errors());
  EXPECT_EQ(check_width({{"core/a.hpp", "\n" + full + "x\n"}}), errors{"core/a.hpp:2: 111 columns"});
  EXPECT_EQ(check_width({{"core/a.hpp", full.substr(1) + "\u00b7\n"}}), errors())
      << "a character of two bytes";
}

}  // namespace
