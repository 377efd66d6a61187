// Data flows one way through the folders of include/, the path includes no subdirectories, every header is
// reached.
#include "texts.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

namespace {

using namespace repository;

// A directory includes itself and those of a lower layer.
const std::map<std::string, int> layers{{"core", 0},    {"mechanism", 1}, {"brake", 2},   {"scene", 3},
                                        {"force", 4},   {"control", 5},   {"design", 6},  {"plant", 7},
                                        {"driver", 7},  {"bench", 8},     {"runtime", 9}, {"interop", 10},
                                        {"testing", 10}};
// Folders that nobody else includes, so not the umbrella either; but suites of testing/ are about ports, too,
// and a bench has one.
const std::set<std::string> leaves{"driver", "bench", "runtime", "interop", "testing"};
// Subdirectories that headers of the path may include.
const std::set<std::string> subdirectories_of_the_path{"core/scalar", "core/linear", "force/torques",
                                                       "force/forms", "control/pipelines"};

// What stands between <> or "" of each #include.
strings includes_of(const std::string& text) {
  strings all;
  for (const auto& line : matches("^[ \t]*#[ \t]*include[ \t]*[<\"]([^>\"]*)[>\"]", text))
    all.push_back(line[1]);
  return all;
}

// The part after passive_haptics/; empty for other libraries.
std::string own(const std::string& include) {
  const std::string prefix = "passive_haptics/";
  return include.starts_with(prefix) ? include.substr(prefix.size()) : "";
}

bool is_dependency(const std::string& include, const std::string& path) {
  const std::string layer = layer_of(path);
  if (include.find_first_of("/.") == std::string::npos) return true;  // the standard library
  if (include.starts_with("Eigen/")) return true;
  // In parts: the whole of it does not compile with libc++
  if (include.starts_with("boost/hana/")) return true;
  if (include.starts_with("toml++/")) return folder_of(path) == "runtime/device_file";
  return (layer == "testing" && (include.starts_with("gtest/") || include.starts_with("benchmark/"))) ||
         layer == "interop" || layer == "driver";
}

errors check_flow(const texts& headers) {
  errors all;
  for (const auto& [path, text] : headers) {
    const std::string from = layer_of(path);
    if (path != umbrella && !layers.contains(from)) all.push_back(path + ": no layer has this directory");
    for (const std::string& include : includes_of(text)) {
      const std::string target = own(include);
      const std::string to = layer_of(target);
      if (target.empty()) {
        if (!is_dependency(include, path)) all.push_back(path + ": not a dependency: " + include);
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
      const bool in_a_subdirectory = folder_of(target) != layer_of(target);
      if (is_of_the_path(path) && in_a_subdirectory &&
          !subdirectories_of_the_path.contains(folder_of(target)))
        all.push_back(path + ": of the path, includes of a subdirectory: " + include);
    }
  }
  return all;
}

errors check_reach(const texts& headers) {
  std::set<std::string> reached;
  strings open{umbrella};  // and what is included by itself
  for (const auto& [path, text] : headers)
    if (layer_of(path) == "plant" || folder_of(path) == "scene/files" || folder_of(path) == "design/map")
      open.push_back(path);
  while (!open.empty()) {
    const std::string path = open.back();
    open.pop_back();
    if (!headers.contains(path) || !reached.insert(path).second) continue;
    for (const std::string& include : includes_of(headers.at(path))) open.push_back(own(include));
  }
  errors all;
  for (const auto& [path, text] : headers)
    if (!reached.contains(path) && !leaves.contains(layer_of(path)))
      all.push_back(path + ": not in the umbrella");
  return all;
}

TEST(layering, includes_follow_the_flow) { EXPECT_EQ(check_flow(headers()), errors()); }
TEST(layering, every_header_is_in_the_umbrella_or_included_by_itself) {
  EXPECT_EQ(check_reach(headers()), errors());
  EXPECT_GT(headers().size(), 30u);
}

std::string include_of(const std::string& path) { return "#include <passive_haptics/" + path + ">\n"; }

TEST(layering_check, notices_an_include_against_the_flow_or_of_a_subdirectory) {
  const auto check = [](const std::string& from, const std::string& to) {
    return check_flow({{from, include_of(to)}, {to, ""}}).size();
  };
  using include = std::pair<std::string, std::string>;
  for (const auto& [from, to] : {include{"brake/a.hpp", "core/b.hpp"},
                                 {"brake/a.hpp", "brake/b.hpp"},
                                 {"testing/a.hpp", "plant/b.hpp"},
                                 {"testing/a.hpp", "driver/b.hpp"},
                                 {umbrella, "plant/b.hpp"},
                                 {umbrella, "control/laws/b.hpp"},
                                 {"core/a.hpp", "core/linear/b.hpp"},
                                 {"control/laws/a.hpp", "scene/mesh/b.hpp"}})
    EXPECT_EQ(check(from, to), 0u) << from << " " << to;
  for (const auto& [from, to] : {include{"core/a.hpp", "brake/b.hpp"},
                                 {"plant/a.hpp", "driver/b.hpp"},
                                 {"driver/a.hpp", "plant/b.hpp"},
                                 {"interop/a.hpp", "testing/b.hpp"},
                                 {"plant/a.hpp", "testing/b.hpp"},
                                 {"plant/a.hpp", umbrella},
                                 {umbrella, "testing/b.hpp"},
                                 {"elsewhere/a.hpp", "core/b.hpp"},
                                 {"control/a.hpp", "control/laws/b.hpp"},
                                 {"scene/a.hpp", "scene/shapes/b.hpp"},
                                 {"force/a.hpp", "core/linear/inner/b.hpp"}})
    EXPECT_EQ(check(from, to), 1u) << from << " " << to;
}

TEST(layering_check, notices_other_libraries_and_missing_headers) {
  const auto check = [](const std::string& path, const std::string& text) {
    return check_flow({{path, text}}).size();
  };
  EXPECT_EQ(
      check("core/a.hpp", "#include <vector>\n#include <Eigen/Core>\n#include <boost/hana/tuple.hpp>\n"), 0u);
  EXPECT_EQ(check("testing/a.hpp", "#include <gtest/gtest.h>\n"), 0u);
  EXPECT_EQ(check("plant/a.hpp", "#include <gtest/gtest.h>\n"), 1u);
  EXPECT_EQ(check("runtime/device_file/a.hpp", "#include <toml++/toml.h>\n"), 0u);
  EXPECT_EQ(check("runtime/a.hpp", "#include <toml++/toml.h>\n"), 1u);
  EXPECT_EQ(check("core/a.hpp", "#include <boost/hana.hpp>\n  #  include \"b.hpp\"\n"), 2u);
  EXPECT_EQ(check("brake/a.hpp", include_of("core/lost.hpp")), 1u);
}

TEST(layering_check, notices_a_header_that_the_umbrella_does_not_reach) {
  const texts headers{{umbrella, include_of("brake/a.hpp")},
                      {"brake/a.hpp", include_of("core/b.hpp")},
                      {"core/b.hpp", ""},
                      {"core/lost.hpp", ""},
                      {"testing/c.hpp", ""}};
  EXPECT_EQ(check_reach(headers), errors{"core/lost.hpp: not in the umbrella"});
}

}  // namespace
