// tests/unit/control/library_functions.hpp lists every function of include/ by its name.
#include "headers.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>

namespace {

using namespace repository;
namespace fs = std::filesystem;

// Deduction guides look like functions, and with sense and scene_status a user brings a scene of his own.
const std::set<std::string> no_functions{"decltype", "int", "sense", "scene_status"};

// Names at the begin of a line, before a parenthesis: functions of a namespace.
std::set<std::string> functions_in(const std::string& text) {
  static const std::regex head(
      R"(^(?!static_assert|using|explicit|return|template|TYPED_|REGISTER_|TEST)(\[\[.*\]\] )?[\w:][\w:<>,&*. ]*?[ &*]([a-z]\w*)\()",
      std::regex::multiline);
  static const std::regex type(R"((?:class|struct) ([a-z]\w*))");
  std::set<std::string> all;
  for (std::sregex_iterator i(text.begin(), text.end(), head), end; i != end; ++i) all.insert(i->str(2));
  for (std::sregex_iterator i(text.begin(), text.end(), type), end; i != end; ++i) all.erase(i->str(1));
  for (const std::string& name : no_functions) all.erase(name);
  return all;
}

std::string list_of(const texts& headers) {
  std::set<std::string> names;
  for (const auto& [path, text] : headers) {
    if (stage_of(path) != "driver" && stage_of(path) != "bench" && stage_of(path) != "testing")
      names.merge(functions_in(text));
  }
  std::string all =
      "// The functions of include/ that a control cycle may call, by name; tests/repository/functions.cpp "
      "keeps the\n// list. f(name) for each.\n#pragma once\n\n// clang-format off\n#define "
      "PASSIVE_HAPTICS_FUNCTIONS(f)";
  for (const std::string& name : names) all += " \\\n  f(" + name + ")";
  return all + "\n// clang-format on\n";
}

TEST(functions, are_listed) {
  const fs::path path = fs::path(PASSIVE_HAPTICS_SOURCE_DIR) / "tests/unit/control/library_functions.hpp";
  const std::string right = list_of(headers());
  if (std::getenv("PASSIVE_HAPTICS_WRITE_PAGES") != nullptr) std::ofstream(path) << right;
  EXPECT_TRUE(read(path) == right) << path
                                   << " is out of date: run this test with PASSIVE_HAPTICS_WRITE_PAGES=1";
}

TEST(functions_check, finds_heads) {
  EXPECT_EQ(functions_in("template <class M>\nauto jacobian(const M& m) {\n  return f(m);\n}\n"
                         "vector<T, D> of(const T&);\nstruct wall {};\nwall wall(int);\n"),
            (std::set<std::string>{"jacobian", "of"}));
}

}  // namespace
