// Data flows one way through the folders of include/; every header is short, guarded and reached.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

using texts = std::map<std::string, std::string>;  // by path under include/passive_haptics/
using errors = std::vector<std::string>;

constexpr const char* umbrella = "passive_haptics.hpp";
constexpr int most_lines = 250;

// Stages: a folder includes itself and folders of a lower stage.
const std::map<std::string, int> stages{{"core", 0},    {"mechanism", 1}, {"brake", 2}, {"scene", 3},
                                        {"force", 4},   {"control", 5},   {"plant", 6}, {"driver", 6},
                                        {"interop", 7}, {"testing", 7}};
// Folders that nobody else includes, so not the umbrella either; but suites of testing/ are about ports, too.
const std::set<std::string> leaves{"driver", "interop", "testing"};

std::string folder_of(const std::string& path) {
  const auto slash = path.find('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

// What stands between <> or "" of each #include.
std::vector<std::string> includes_of(const std::string& text) {
  static const std::regex line(R"(^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]*)[>"])", std::regex::multiline);
  std::vector<std::string> all;
  for (std::sregex_iterator i(text.begin(), text.end(), line), end; i != end; ++i) all.push_back((*i)[1]);
  return all;
}

// The part after passive_haptics/; empty for other libraries.
std::string own(const std::string& include) {
  const std::string prefix = "passive_haptics/";
  return include.starts_with(prefix) ? include.substr(prefix.size()) : "";
}

bool is_dependency(const std::string& include, const std::string& folder) {
  if (include.find_first_of("/.") == std::string::npos) return true;  // the standard library
  if (include.starts_with("Eigen/") || include.starts_with("unsupported/Eigen/")) return true;
  if (include.starts_with("boost/hana/"))
    return true;  // in parts: the whole of it does not compile with libc++
  return (folder == "testing" && (include.starts_with("gtest/") || include.starts_with("benchmark/"))) ||
         folder == "interop" || folder == "driver";
}

errors check_flow(const texts& headers) {
  errors all;
  for (const auto& [path, text] : headers) {
    const std::string from = folder_of(path);
    if (path != umbrella && !stages.contains(from)) all.push_back(path + ": no stage has this folder");
    for (const std::string& include : includes_of(text)) {
      const std::string target = own(include);
      const std::string to = folder_of(target);
      if (target.empty()) {
        if (!is_dependency(include, from)) all.push_back(path + ": not a dependency: " + include);
      } else if (!headers.contains(target)) {
        all.push_back(path + ": no such header: " + include);
      } else if (target == umbrella) {
        all.push_back(path + ": includes the umbrella");
      } else if (to != from && leaves.contains(to) && !(from == "testing" && to == "driver")) {
        all.push_back(path + ": nobody else includes " + to + "/: " + include);
      } else if (path != umbrella && to != from && stages.contains(from) &&
                 stages.at(to) >= stages.at(from)) {
        all.push_back(path + ": against the flow: " + include);
      }
    }
  }
  return all;
}

errors check_reach(const texts& headers) {
  std::set<std::string> reached;
  std::vector<std::string> open{umbrella};  // and the simulation, which is included by itself
  for (const auto& [path, text] : headers) {
    if (folder_of(path) == "plant") open.push_back(path);
  }
  while (!open.empty()) {
    const std::string path = open.back();
    open.pop_back();
    if (!headers.contains(path) || !reached.insert(path).second) continue;
    for (const std::string& include : includes_of(headers.at(path))) open.push_back(own(include));
  }
  errors all;
  for (const auto& [path, text] : headers) {
    if (!reached.contains(path) && !leaves.contains(folder_of(path)))
      all.push_back(path + ": not in the umbrella");
  }
  return all;
}

errors check_form(const texts& headers) {
  errors all;
  for (const auto& [path, text] : headers) {
    if (!text.starts_with("/// @file\n/// "))
      all.push_back(path + ": does not open with /// @file and a sentence");
    if (text.find("\n#pragma once\n") == std::string::npos) all.push_back(path + ": no #pragma once");
    const auto lines = std::count(text.begin(), text.end(), '\n');
    if (lines > most_lines) all.push_back(path + ": " + std::to_string(lines) + " lines");
  }
  return all;
}

const texts& repository() {
  static const texts all = [] {
    namespace fs = std::filesystem;
    const fs::path root = fs::path(PASSIVE_HAPTICS_SOURCE_DIR) / "include" / "passive_haptics";
    texts found;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      if (!entry.is_regular_file()) continue;
      std::ostringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      found[fs::relative(entry.path(), root).generic_string()] = text.str();
    }
    return found;
  }();
  return all;
}

std::string include(const std::string& path) { return "#include <passive_haptics/" + path + ">\n"; }

TEST(layering, includes_follow_the_flow) { EXPECT_EQ(check_flow(repository()), errors()); }
TEST(layering, every_header_is_in_the_umbrella_or_part_of_the_plant) {
  EXPECT_EQ(check_reach(repository()), errors());
}
TEST(layering, headers_are_short_guarded_and_documented) { EXPECT_EQ(check_form(repository()), errors()); }
TEST(layering, all_headers_were_found) {
  EXPECT_GT(repository().size(), 30u);
  for (const char* path : {umbrella, "core/linear/cone.hpp", "testing/step_properties.hpp"})
    EXPECT_TRUE(repository().contains(path));
}

// ---- the checks themselves

TEST(layering_check, notices_an_include_against_the_flow) {
  const auto check = [](const std::string& from, const std::string& to) {
    return check_flow({{from, include(to)}, {to, ""}}).size();
  };
  EXPECT_EQ(check("brake/a.hpp", "core/b.hpp"), 0u);
  EXPECT_EQ(check("brake/a.hpp", "brake/b.hpp"), 0u);
  EXPECT_EQ(check("testing/a.hpp", "plant/b.hpp"), 0u);
  EXPECT_EQ(check("testing/a.hpp", "driver/b.hpp"), 0u);
  EXPECT_EQ(check("core/a.hpp", "brake/b.hpp"), 1u);
  EXPECT_EQ(check("interop/a.hpp", "driver/b.hpp"), 1u);
  EXPECT_EQ(check("plant/a.hpp", "driver/b.hpp"), 1u);
  EXPECT_EQ(check("driver/a.hpp", "plant/b.hpp"), 1u);
  EXPECT_EQ(check("interop/a.hpp", "testing/b.hpp"), 1u);
  EXPECT_EQ(check("testing/a.hpp", "interop/b.hpp"), 1u);
  EXPECT_EQ(check("plant/a.hpp", "testing/b.hpp"), 1u);
  EXPECT_EQ(check("plant/a.hpp", umbrella), 1u);
  EXPECT_EQ(check(umbrella, "plant/b.hpp"), 0u);
  EXPECT_EQ(check(umbrella, "testing/b.hpp"), 1u);
  EXPECT_EQ(check("elsewhere/a.hpp", "core/b.hpp"), 1u);
}

TEST(layering_check, notices_other_libraries_and_missing_headers) {
  const auto check = [](const std::string& path, const std::string& text) {
    return check_flow({{path, text}}).size();
  };
  EXPECT_EQ(
      check("core/a.hpp", "#include <vector>\n#include <Eigen/Core>\n#include <boost/hana/tuple.hpp>\n"), 0u);
  EXPECT_EQ(check("core/a.hpp", "#include <boost/hana.hpp>\n"), 1u);
  EXPECT_EQ(check("core/a.hpp", "  #  include \"b.hpp\"\n"), 1u);
  EXPECT_EQ(check("plant/a.hpp", "#include <gtest/gtest.h>\n"), 1u);
  EXPECT_EQ(check("testing/a.hpp", "#include <gtest/gtest.h>\n"), 0u);
  EXPECT_EQ(check("brake/a.hpp", include("core/lost.hpp")), 1u);
}

TEST(layering_check, notices_a_header_that_the_umbrella_does_not_reach) {
  const texts headers{{umbrella, include("brake/a.hpp")},
                      {"brake/a.hpp", include("core/b.hpp")},
                      {"core/b.hpp", ""},
                      {"core/lost.hpp", ""},
                      {"testing/c.hpp", ""}};
  EXPECT_EQ(check_reach(headers), errors{"core/lost.hpp: not in the umbrella"});
}

TEST(layering_check, notices_bad_form) {
  const std::string good = "/// @file\n/// What it is.\n#pragma once\n";
  EXPECT_EQ(check_form({{"core/a.hpp", good + std::string(247, '\n')}}), errors());
  EXPECT_EQ(check_form({{"core/a.hpp", good + std::string(248, '\n')}}), errors{"core/a.hpp: 251 lines"});
  EXPECT_EQ(check_form({{"core/a.hpp", "/// @file\n/// What it is.\n"}}).size(), 1u);
  EXPECT_EQ(check_form({{"core/a.hpp", "\n#pragma once\n"}}).size(), 1u);
}

}  // namespace
