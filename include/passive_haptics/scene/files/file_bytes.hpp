/// Reading of whole files.
#pragma once

#include <passive_haptics/scene/files/file_kind.hpp>
#include <passive_haptics/scene/files/text_lines.hpp>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <system_error>

namespace passive_haptics {

/// Reads the file into `bytes`. Returns an error text, empty if there is none: a file that is missing, not
/// regular, too large, unreadable, compressed or of a foreign kind. Never waits for a FIFO or a device.
inline std::string read_file(const std::filesystem::path& path, std::string& bytes,
                             std::uintmax_t max_size = std::numeric_limits<std::uintmax_t>::max()) {
  if (std::string error = check_regular_file(path); !error.empty()) return error;
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) return error.message();
  if (size > max_size) return std::to_string(size) + " bytes: expected at most " + std::to_string(max_size);
  std::ifstream in(path, std::ios::binary);
  if (!in) return "cannot be read: expected a file that you may read";
  bytes.resize(static_cast<std::size_t>(size));
  in.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(in.gcount()));  // the file may have become shorter
  return in.bad() ? "cannot be read to its end" : detail::foreign_file_error(bytes);
}

}  // namespace passive_haptics
