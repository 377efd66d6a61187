/// @file
/// What stands at a path: a device or a FIFO is no place to read a file from or to put one.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace passive_haptics {

/// In words: "a regular file", "a directory", "a device", "a FIFO", "a socket", "nothing", "a link to
/// nothing". Links are followed. Opens nothing, so it never waits.
inline std::string file_kind(const std::filesystem::path& path) {
  using type = std::filesystem::file_type;
  std::error_code error;
  const auto at = std::filesystem::status(path, error);
  switch (at.type()) {
    case type::regular: return "a regular file";
    case type::directory: return "a directory";
    case type::block:
    case type::character: return "a device";
    case type::fifo: return "a FIFO";
    case type::socket: return "a socket";
    case type::not_found: return std::filesystem::is_symlink(path, error) ? "a link to nothing" : "nothing";
    default: return error ? "unknown (" + error.message() + ")" : "unknown";
  }
}

/// Why nothing is read from there; empty if it is a regular file.
inline std::string check_regular_file(const std::filesystem::path& path) {
  const std::string kind = file_kind(path);
  if (kind == "a regular file") return "";
  return kind == "nothing" ? "no such file" : "is " + kind + ", expected a regular file";
}

}  // namespace passive_haptics
