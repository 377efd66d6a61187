/// The device file that belongs to a log.
#pragma once

#include <filesystem>
#include <string>

namespace example {

/// File name of a log's device: LOG.device.toml for LOG.csv, LOG.device.toml.part for the LOG.csv.part of an
/// incomplete run.
inline std::string device_name(const std::string& log) {
  const std::filesystem::path path(log), without = path.parent_path() / path.stem();
  if (path.extension() == ".part") return device_name(without.string()) + ".part";
  return (path.extension() == ".csv" ? without : path).string() + ".device.toml";
}

}  // namespace example
