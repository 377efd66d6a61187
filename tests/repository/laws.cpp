// A law has one name: that of its type, in code, configuration, tables and pictures.
#include "headers.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
const fs::path root = PASSIVE_HAPTICS_SOURCE_DIR;

// In words or shortened; in pictures and tables also "direct control" alone, which is the paper's method.
const std::regex other_names(
    R"((no|saturated|velocity|on-off|bang-bang) direct control|direct, limits|limits first|direct, dead|velocity, on|velocity ratio control|on-off control|bang-bang control)",
    std::regex::icase);
const std::regex method_as_a_law(R"(\| (?:[^|]*, )?direct control *\||>direct control<|Hz +direct control)");

std::vector<fs::path> files() {
  std::vector<fs::path> all{root / "README.md"};
  for (const char* folder : {"docs", "examples"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string end = entry.path().extension().string();
      for (const char* read : {".md", ".svg", ".toml", ".txt", ".cpp", ".hpp"})
        if (end == read) all.push_back(entry.path());
    }
  return all;
}

// Lines of a text that name a law in another way, as "FILE:LINE: TEXT".
std::vector<std::string> other_names_in(const std::string& file, const std::string& text) {
  std::vector<std::string> found;
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (std::regex_search(line, other_names) || std::regex_search(line, method_as_a_law))
      found.push_back(file + ":" + std::to_string(number) + ": " + line.substr(0, 100));
  }
  return found;
}

TEST(laws, have_one_name_each) {
  std::size_t read = 0;
  for (const fs::path& file : files()) {
    ++read;
    EXPECT_EQ(other_names_in(file.string(), repository::read(file)), std::vector<std::string>());
  }
  EXPECT_GT(read, 100u);
}

TEST(laws_check, notices_another_name) {
  for (const char* line : {"| planar | direct, limits first | 3 |", "| direct control | 3 |",
                           "| planar, 20 Hz | direct control | 3 |", "Velocity direct control sees the wall",
                           "<text>direct control</text>", "no direct control"})
    EXPECT_EQ(other_names_in("page", line).size(), 1u) << line;
  for (const char* line : {"| direct_control | 3 |", "with direct control it glides, without it bounces",
                           "| a smooth path with direct control | yes |", "`velocity_direct_control`"})
    EXPECT_EQ(other_names_in("page", line).size(), 0u) << line;
}

}  // namespace
