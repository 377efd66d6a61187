/// The section [brakes] of brake_driver from bench results.
#pragma once

#include <passive_haptics/bench/measured_brake.hpp>

#include <array>
#include <cstdio>
#include <string>

namespace example {

/// The section [brakes] of a configuration of brake_driver, which is also a complete configuration. Without
/// the rate_dead_band, which brake_driver computes from [encoders].
template <class M>
std::string brakes_section(const passive_haptics::measured_brakes_of<M>& found) {
  static_assert(M::brake_count == 2, "brake_driver has two brakes");
  const auto curves = passive_haptics::measured_curves(found);
  const auto brakes = passive_haptics::measured_brakes<M>(found);
  const auto text = [](double x) {
    std::array<char, 32> digits;
    std::snprintf(digits.data(), digits.size(), "%.9g", x);
    return std::string(digits.data());
  };
  const auto pair = [&](double x, double y) {
    return std::string("[").append(text(x)).append(", ").append(text(y)).append("]");
  };
  const auto row = [&](const char* key, double first, double second) {
    return std::string(key).append(" = ").append(pair(first, second)).append("\n");
  };
  std::string all = "[brakes]\n";
  all += row("residual_torque", curves[0].residual_torque, curves[1].residual_torque);
  all += row("current_limit", curves[0].current_limit, curves[1].current_limit);
  all += row("hysteresis", curves[0].hysteresis, curves[1].hysteresis);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    all += i == 0 ? "table_1 = [" : "table_2 = [";
    for (std::size_t k = 0; k < static_cast<std::size_t>(curves[i].points); ++k)
      all.append(k == 0 ? "" : ", ").append(pair(curves[i].table[k].current, curves[i].table[k].torque));
    all += "]\n";
  }
  return all + row("time_constant", brakes.time_constant[0], brakes.time_constant[1]);
}

}  // namespace example
