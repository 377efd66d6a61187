// docs/architecture.md lists every header of the path, each at one place, and every folder of include/.
#include "texts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>

namespace {

using namespace repository;

// "1. [`control/cycle.hpp`](...)" and, in lines that begin with "- `control/`: ", `name` for
// control/name.hpp.
std::multiset<std::string> path_in(const std::string& page) {
  std::multiset<std::string> all;
  for (const auto& item : matches("^[0-9]+\\. \\[`([^`]+)`\\]", page)) all.insert(item[1]);
  for (const auto& rest : matches("^- `([a-z]+/)`: (.*)$", page))
    for (const auto& name : matches("`([a-z0-9_]+)`", rest[2])) all.insert(rest[1] + name[1] + ".hpp");
  return all;
}

// "control/    ..." and below it "  laws/    ...".
std::set<std::string> folders_in(const std::string& page) {
  std::set<std::string> all;
  std::string layer;
  for (const auto& folder : matches("^(  )?([a-z_]+(/[a-z_]+)?)/ ", page)) {
    if (folder[1].empty()) layer = folder[2];
    all.insert(folder[1].empty() ? layer : layer + "/" + folder[2]);
  }
  return all;
}

template <class Set>
errors differences(const Set& found, const Set& listed) {
  errors all;
  std::set_symmetric_difference(found.begin(), found.end(), listed.begin(), listed.end(),
                                std::back_inserter(all));
  return all;
}

// What the page lacks, lists twice, or lists as of the path though it is in a subdirectory.
errors check_listed_path(const std::string& page, const texts& headers, std::multiset<std::string> path) {
  for (const auto& [header, text] : headers)
    if (is_of_the_path(header)) path.insert(header);
  return differences(path, path_in(page));
}

errors check_folders(const std::string& page, const texts& headers) {
  std::set<std::string> folders;
  for (const auto& [header, text] : headers) folders.insert(folder_of(header));
  folders.erase("");
  return differences(folders, folders_in(page));
}

TEST(architecture, lists_the_path) {
  EXPECT_EQ(check_listed_path(read(root / "docs/architecture.md"), headers(),
                              // read with the path, though they are in subdirectories
                              {"control/pipelines/one_wall.hpp", "mechanism/models/two_link.hpp",
                               "mechanism/models/tendon_two_link.hpp", "scene/shapes/half_space.hpp"}),
            errors());
}

TEST(architecture, lists_every_folder) {
  EXPECT_EQ(check_folders(read(root / "docs/architecture.md"), headers()), errors());
}

TEST(architecture_check, notices_what_is_missing_or_too_much) {
  const texts some{{"core/a.hpp", ""}, {"core/b.hpp", ""}, {"core/linear/c.hpp", ""}, {"plant/d.hpp", ""}};
  const auto check = [&](const std::string& page) {
    return check_listed_path(page, some, {"core/linear/c.hpp"});
  };
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
