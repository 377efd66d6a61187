// Devices that nobody tuned a law for: of six kinds, drawn from wide ranges (plant/random_device.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace experiments {

// Of all devices of one kind under the law, which knows their limits and rise times (or believes others).
struct wide_row {
  std::string device;
  std::size_t count = 0;
  int held = 0;        // released, their residual torque alone keeps the hand off the wall
  int separating = 0;  // of the others
  int floating = 0;
  int never = 0;
  int deep = 0;                          // over 10 mm,
  int deep_nothing = 0;                  // of these: on over a tenth of the way nothing can be displayed,
  int deep_weak = 0;                     // or less than what the hand pushes with 10 mm deep
  double median_std = 0, max_power = 0;  // [m], [W]
};

enum class belief {
  data_sheet,  // nominal inertia, true limits and rise times
  wrong,       // lag 0.3 to 3 times, inertia 0.5 to 2 times the true one, together
  extreme,  // as wrong, of devices with gains of 0.5 to 1.5, lags of 1 to 100 ms and dead times up to 10 ms
};

// 300 (scaled by `share`) tendon devices, 60 of each other kind under velocity_direct_control.
std::vector<wide_row> follow_with_wide_devices(std::uint64_t seed, belief what, double share = 1,
                                               double time_step = 1e-4);

// 300 tendon devices for each of ten seeds from this one on, and their sum as the last row: a table of
// Markdown.
std::string wide_seeds(std::uint64_t first_seed);

// How many of 300 tendon devices separate, by the depth at which the law lets the handle rest.
struct rest_depth_row {
  double rest_depth = 0;  // [m]
  int first_seed = 0, second_seed = 0, wrong = 0, extreme = 0;
  double median_max_depth = 0;  // of the devices of the first seed [m]
};
std::vector<rest_depth_row> follow_at_rest_depths();
std::string rest_depth_table(const std::vector<rest_depth_row>& rows);

// The rows as a table of Markdown.
std::string wide_table(const std::vector<wide_row>& rows);

}  // namespace experiments
