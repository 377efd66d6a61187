// docs/architecture.md lists every header of the path, each at one place, and every folder of include/.
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

// "1. [`control/cycle.hpp`](...)" and, in lines that begin with "- `control/`: ", `name` for
// control/name.hpp.
std::multiset<std::string> path_in(const std::string& page) {
  static const std::regex item(R"(^\d+\. \[`([^`]+)`\].*)"), rest(R"(^- `(\w+/)`: (.*))"), name(R"(`(\w+)`)");
  std::multiset<std::string> all;
  std::istringstream in(page);
  std::smatch match;
  for (std::string line; std::getline(in, line);) {
    if (std::regex_match(line, match, item)) all.insert(match[1]);
    if (!std::regex_match(line, match, rest)) continue;
    const std::string layer = match[1], names = match[2];
    for (std::sregex_iterator i(names.begin(), names.end(), name), end; i != end; ++i)
      all.insert(layer + i->str(1) + ".hpp");
  }
  return all;
}

// "control/    ..." and below it "  laws/    ...".
std::set<std::string> folders_in(const std::string& page) {
  static const std::regex folder(R"(^(  )?(\w+(?:/\w+)?)/ .*)");
  std::set<std::string> all;
  std::istringstream in(page);
  std::smatch match;
  std::string layer;
  for (std::string line; std::getline(in, line);) {
    if (!std::regex_match(line, match, folder)) continue;
    if (!match[1].matched) layer = match[2];
    all.insert(match[1].matched ? layer + "/" + match[2].str() : layer);
  }
  return all;
}

// What the page lacks, lists twice, or lists as of the path though it is in a subdirectory.
errors check_path(const std::string& page, const texts& headers, const std::set<std::string>& rooms_files) {
  std::multiset<std::string> path(rooms_files.begin(), rooms_files.end());
  for (const auto& [header, text] : headers) {
    if (path_stages.contains(folder_of(header))) path.insert(header);
  }
  const std::multiset<std::string> listed = path_in(page);
  errors all;
  std::set_symmetric_difference(path.begin(), path.end(), listed.begin(), listed.end(),
                                std::back_inserter(all));
  return all;
}

errors check_folders(const std::string& page, const texts& headers) {
  std::set<std::string> folders;
  for (const auto& [header, text] : headers) folders.insert(folder_of(header));
  folders.erase("");
  const std::set<std::string> listed = folders_in(page);
  errors all;
  std::set_symmetric_difference(folders.begin(), folders.end(), listed.begin(), listed.end(),
                                std::back_inserter(all));
  return all;
}

// Read with the path, though they are in subdirectories.
const std::set<std::string> read_with_the_path{
    "control/pipelines/one_wall.hpp", "mechanism/models/two_link.hpp", "mechanism/models/tendon_two_link.hpp",
    "scene/shapes/half_space.hpp"};

std::string architecture() {
  return read(std::filesystem::path(PASSIVE_HAPTICS_SOURCE_DIR) / "docs" / "architecture.md");
}

TEST(architecture, lists_the_path) {
  EXPECT_EQ(check_path(architecture(), headers(), read_with_the_path), errors());
}
TEST(architecture, lists_every_folder) { EXPECT_EQ(check_folders(architecture(), headers()), errors()); }

// ---- the checks themselves

TEST(architecture_check, notices_what_is_missing_or_too_much) {
  const texts some{{"core/a.hpp", ""}, {"core/b.hpp", ""}, {"core/linear/c.hpp", ""}, {"plant/d.hpp", ""}};
  const auto check = [&](const std::string& page) { return check_path(page, some, {"core/linear/c.hpp"}); };
  const std::string good =
      "1. [`core/a.hpp`](x): a\n12. [`core/linear/c.hpp`](x): c\n- `core/`: `b` (of `core`)\n";
  EXPECT_EQ(check(good), errors{"core/core.hpp"});
  EXPECT_EQ(check("1. [`core/a.hpp`](x): a\n- `core/`: `b`, `linear/c`\n"), errors{"core/linear/c.hpp"});
  EXPECT_EQ(check("1. [`core/linear/c.hpp`](x)\n- `core/`: `b`, `a`, `b`\n"), errors{"core/b.hpp"});
}

TEST(architecture_check, notices_folders) {
  const texts some{{"core/a.hpp", ""}, {"core/linear/c.hpp", ""}, {"all.hpp", ""}};
  EXPECT_EQ(check_folders("core/    a\n  linear/  b\n", some), errors());
  EXPECT_EQ(check_folders("core/    a\n", some), errors{"core/linear"});
  EXPECT_EQ(check_folders("core/    a\n  linear/  b\nplant/ c\n", some), errors{"plant"});
}

}  // namespace
