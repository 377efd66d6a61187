// The headers of include/ as texts, for the rules of the repository.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace repository {

using texts = std::map<std::string, std::string>;  // by path under include/passive_haptics/
using errors = std::vector<std::string>;

constexpr const char* umbrella = "passive_haptics.hpp";

// The files directly in the directory of one of these are the reader's path; the rest is in subdirectories.
inline const std::set<std::string> path_stages{"core", "mechanism", "brake", "scene", "force", "control"};

inline std::string read(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

inline const texts& headers() {
  static const texts all = [] {
    namespace fs = std::filesystem;
    const fs::path root = fs::path(PASSIVE_HAPTICS_SOURCE_DIR) / "include" / "passive_haptics";
    texts found;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      if (entry.is_regular_file())
        found[fs::relative(entry.path(), root).generic_string()] = read(entry.path());
    }
    return found;
  }();
  return all;
}

// The first folder: "scene" of scene/mesh/proxy.hpp.
inline std::string stage_of(const std::string& path) {
  const auto slash = path.find('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

// The whole folder: "scene/mesh" of scene/mesh/proxy.hpp.
inline std::string folder_of(const std::string& path) {
  const auto slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

// What stands between <> or "" of each #include.
inline std::vector<std::string> includes_of(const std::string& text) {
  static const std::regex line(R"(^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]*)[>"])", std::regex::multiline);
  std::vector<std::string> all;
  for (std::sregex_iterator i(text.begin(), text.end(), line), end; i != end; ++i) all.push_back((*i)[1]);
  return all;
}

// The part after passive_haptics/; empty for other libraries.
inline std::string own(const std::string& include) {
  const std::string prefix = "passive_haptics/";
  return include.starts_with(prefix) ? include.substr(prefix.size()) : "";
}

}  // namespace repository
