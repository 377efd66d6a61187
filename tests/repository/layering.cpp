// Data flows one way through the folders of include/, the path includes no subdirectories, every header is
// reached.
#include "headers.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace repository;

// Layers: a directory includes itself and those of a lower layer.
const std::map<std::string, int> layers{{"core", 0},   {"mechanism", 1}, {"brake", 2},   {"scene", 3},
                                        {"force", 4},  {"control", 5},   {"design", 6},  {"plant", 7},
                                        {"driver", 7}, {"bench", 8},     {"interop", 9}, {"testing", 9}};
// Folders that nobody else includes, so not the umbrella either; but suites of testing/ are about ports, too,
// and a bench has one.
const std::set<std::string> leaves{"driver", "bench", "interop", "testing"};
// Rooms that headers of the path may include.
const std::set<std::string> subdirectories_of_the_path{"core/scalar", "core/linear", "force/torques",
                                                       "force/forms", "control/pipelines"};

bool is_dependency(const std::string& include, const std::string& folder) {
  if (include.find_first_of("/.") == std::string::npos) return true;  // the standard library
  if (include.starts_with("Eigen/")) return true;
  if (include.starts_with("boost/hana/"))
    return true;  // in parts: the whole of it does not compile with libc++
  return (folder == "testing" && (include.starts_with("gtest/") || include.starts_with("benchmark/"))) ||
         folder == "interop" || folder == "driver";
}

errors check_flow(const texts& headers) {
  errors all;
  for (const auto& [path, text] : headers) {
    const std::string from = stage_of(path);
    if (path != umbrella && !layers.contains(from)) all.push_back(path + ": no layer has this directory");
    for (const std::string& include : includes_of(text)) {
      const std::string target = own(include);
      const std::string to = stage_of(target);
      if (target.empty()) {
        if (!is_dependency(include, from)) all.push_back(path + ": not a dependency: " + include);
      } else if (!headers.contains(target)) {
        all.push_back(path + ": no such header: " + include);
      } else if (target == umbrella) {
        all.push_back(path + ": includes the umbrella");
      } else if (to != from && leaves.contains(to) &&
                 !(to == "driver" && (from == "testing" || from == "bench"))) {
        all.push_back(path + ": nobody else includes " + to + "/: " + include);
      } else if (path != umbrella && to != from && layers.contains(from) &&
                 layers.at(to) >= layers.at(from)) {
        all.push_back(path + ": against the flow: " + include);
      }
    }
  }
  return all;
}

errors check_path(const texts& headers) {
  errors all;
  for (const auto& [path, text] : headers) {
    if (!path_stages.contains(folder_of(path))) continue;
    for (const std::string& include : includes_of(text)) {
      const std::string target = own(include);
      const bool in_a_room = folder_of(target) != stage_of(target);
      if (in_a_room && !subdirectories_of_the_path.contains(folder_of(target)))
        all.push_back(path + ": of the path, includes of a subdirectory: " + include);
    }
  }
  return all;
}

errors check_reach(const texts& headers) {
  std::set<std::string> reached;
  std::vector<std::string> open{umbrella};  // and what is included by itself
  for (const auto& [path, text] : headers) {
    if (stage_of(path) == "plant" || folder_of(path) == "scene/files" || folder_of(path) == "design/map")
      open.push_back(path);
  }
  while (!open.empty()) {
    const std::string path = open.back();
    open.pop_back();
    if (!headers.contains(path) || !reached.insert(path).second) continue;
    for (const std::string& include : includes_of(headers.at(path))) open.push_back(own(include));
  }
  errors all;
  for (const auto& [path, text] : headers) {
    if (!reached.contains(path) && !leaves.contains(stage_of(path)))
      all.push_back(path + ": not in the umbrella");
  }
  return all;
}

std::string include(const std::string& path) { return "#include <passive_haptics/" + path + ">\n"; }

TEST(layering, includes_follow_the_flow) { EXPECT_EQ(check_flow(headers()), errors()); }
TEST(layering, every_header_is_in_the_umbrella_or_a_room_beside_it) {
  EXPECT_EQ(check_reach(headers()), errors());
}
TEST(layering, the_path_includes_no_room) { EXPECT_EQ(check_path(headers()), errors()); }
TEST(layering, all_headers_were_found) {
  EXPECT_GT(headers().size(), 30u);
  for (const char* path : {umbrella, "core/linear/cone.hpp", "testing/step_properties.hpp"})
    EXPECT_TRUE(headers().contains(path));
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

TEST(layering_check, notices_a_room_that_the_path_includes) {
  const auto check = [](const std::string& from, const std::string& to) {
    return check_path({{from, include(to)}, {to, ""}}).size();
  };
  EXPECT_EQ(check("control/a.hpp", "force/b.hpp"), 0u);
  EXPECT_EQ(check("core/a.hpp", "core/linear/b.hpp"), 0u);
  EXPECT_EQ(check("force/a.hpp", "force/torques/b.hpp"), 0u);
  EXPECT_EQ(check("control/laws/a.hpp", "scene/mesh/b.hpp"), 0u);
  EXPECT_EQ(check("plant/a.hpp", "control/laws/b.hpp"), 0u);
  EXPECT_EQ(check(umbrella, "control/laws/b.hpp"), 0u);
  EXPECT_EQ(check_path({{"core/a.hpp", "#include <vector>\n"}}), errors());
  EXPECT_EQ(check("control/a.hpp", "control/laws/b.hpp"), 1u);
  EXPECT_EQ(check("scene/a.hpp", "scene/shapes/b.hpp"), 1u);
  EXPECT_EQ(check("force/a.hpp", "core/linear/inner/b.hpp"), 1u);
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

}  // namespace
