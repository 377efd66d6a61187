/// The keys of a device file that only brake_driver reads.
#pragma once

#include <passive_haptics/runtime/device_file/toml_section.hpp>

#include <string>

namespace example {

/// Skips the keys of brake_driver. Throws std::invalid_argument, as finish() of the file does, if the file
/// has another key that nobody read.
inline void finish_without_driver(passive_haptics::runtime::toml_section& file) {
  for (const char* key : {"log", "encoders", "homing", "port", "loop", "safety", "simulation"})
    file.pass_over(key);
  auto brakes = file.section("brakes");
  for (const char* key : {"residual_torque", "torque_per_ampere", "table_1", "table_2", "current_limit",
                          "hysteresis", "loss_per_kelvin", "continuous_current", "heat", "max_rise_rate"})
    brakes.pass_over(key);
  auto sensor = file.section("sensor");
  std::string type = "simulated";
  sensor.read("type", type, {"simulated", "comedi", "net_ft", "none"});
  sensor.pass_over_others();
  file.finish();
}

}  // namespace example
