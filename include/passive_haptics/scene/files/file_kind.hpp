/// The kind of file at a path.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace passive_haptics {

/// Returns "a regular file", "a directory", "a device", "a FIFO", "a socket", "nothing" or "a link to
/// nothing". Follows links; opens nothing, so it never waits.
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

/// Returns why the path cannot be read as a regular file; empty if it can.
inline std::string check_regular_file(const std::filesystem::path& path) {
  const std::string kind = file_kind(path);
  if (kind == "a regular file") return "";
  return kind == "nothing" ? "no such file" : "is " + kind + ": expected a regular file";
}

}  // namespace passive_haptics
