// The texts of the repository, and patterns in them, for its rules.
#pragma once

#include <regex.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace repository {

namespace fs = std::filesystem;
using strings = std::vector<std::string>;
using errors = strings;
using texts = std::map<std::string, std::string>;  // by path under include/passive_haptics/

inline const fs::path root = PASSIVE_HAPTICS_SOURCE_DIR;
constexpr const char* umbrella = "passive_haptics.hpp";

inline std::string read(const fs::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline const texts& headers() {
  static const texts all = [] {
    const fs::path folder = root / "include" / "passive_haptics";
    texts found;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file())
        found[fs::relative(entry.path(), folder).generic_string()] = read(entry.path());
    return found;
  }();
  return all;
}

inline strings lines_of(const std::string& text) {
  strings all;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) all.push_back(line);
  return all;
}

// The groups of each match of an extended regular expression of POSIX, which compiles in less time than
// std::regex. Group 0 is the whole match; ^ and $ match at lines.
inline std::vector<strings> matches(const std::string& expression, const std::string& text) {
  constexpr std::size_t group_count = 5;
  regex_t compiled;
  if (regcomp(&compiled, expression.c_str(), REG_EXTENDED | REG_NEWLINE) != 0)
    throw std::invalid_argument(expression);
  std::vector<strings> all;
  regmatch_t groups[group_count];
  for (std::size_t at = 0; at < text.size();) {
    const int flags = at > 0 && text[at - 1] != '\n' ? REG_NOTBOL : 0;
    if (regexec(&compiled, text.c_str() + at, group_count, groups, flags) != 0) break;
    strings& found = all.emplace_back();
    for (const auto& g : groups)
      found.push_back(g.rm_so < 0 ? ""
                                  : text.substr(at + std::size_t(g.rm_so), std::size_t(g.rm_eo - g.rm_so)));
    at += std::size_t(std::max(groups[0].rm_eo, 1));
  }
  regfree(&compiled);
  return all;
}

// The first folder: "scene" of scene/mesh/proxy.hpp.
inline std::string layer_of(const std::string& path) {
  const auto slash = path.find('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

// The whole folder: "scene/mesh" of scene/mesh/proxy.hpp.
inline std::string folder_of(const std::string& path) {
  const auto slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

// True for the files directly in the directory of one of the first layers, which are the reader's path.
inline bool is_of_the_path(const std::string& header) {
  return !matches("^(core|mechanism|brake|scene|force|control)/[^/]*$", header).empty();
}

}  // namespace repository
