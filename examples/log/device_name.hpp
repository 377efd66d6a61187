/// @file
/// The device file that belongs to a log.
#pragma once

#include <filesystem>
#include <string>

namespace example {

/// Name of the device file next to a log: LOG.device.toml for LOG.csv, LOG.device.toml.part for the
/// LOG.csv.part of a run that did not end.
inline std::string device_name(const std::string& log) {
  const std::filesystem::path path(log), without = path.parent_path() / path.stem();
  if (path.extension() == ".part") return device_name(without.string()) + ".part";
  return (path.extension() == ".csv" ? without : path).string() + ".device.toml";
}

}  // namespace example
