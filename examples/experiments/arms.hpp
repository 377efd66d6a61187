// Arms with more joints than the task has dimensions, and arms with brakes on some of their joints.
#pragma once

#include "markdown.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace experiments {

inline constexpr std::size_t arm_walls = 60;                      // of each arm, random
inline constexpr std::array arm_lags{0.005, 0.020, 0.040};        // of the brakes [s]
enum class arm_encoders { exact, counts };                        // 4096 per turn, with rate_estimator
inline constexpr std::size_t arm_settings = 2 * arm_lags.size();  // each lag with each encoder
inline constexpr std::size_t sampled_setting = 1;                 // exact encoders, 20 ms

// Outcomes of the hands at all walls, for one lag and one kind of encoders.
struct arm_cell {
  int gliding = 0;  // touched, never separated, depth up to 10 mm, arrived
  int separating = 0;
  int too_weak = 0;       // not gliding, and over a tenth of the path no set of brakes displays 2 N
  double median_std = 0;  // of the depth [m]
  double max_power = 0;   // of a brake on the device in a time step [W]
};

struct arm_row {
  std::string arm, law;
  std::array<std::optional<arm_cell>, arm_settings> cells;  // empty if not measured
};

// All rows, or a sample: the recommended law of an arm with all brakes and of one with some, at one setting.
// All rows take minutes to compile, so only the program of the sections has them.
enum class arm_extent { sample, all };
#ifdef EXPERIMENTS_ALL_ARMS
inline constexpr arm_extent built_extent = arm_extent::all;
#else
inline constexpr arm_extent built_extent = arm_extent::sample;
#endif
inline constexpr std::size_t felt_runs = 3;
inline constexpr std::size_t arm_runs =
    felt_runs + (built_extent == arm_extent::all ? 16 * arm_settings : 4) * arm_walls;

// The tables felt_forces and arms of docs/results.md: forces felt by a hand on arms, and whether it glides.
// Returns true if no brake delivered power.
bool follow_with_arms(page_tables& page);

// Rows of a Markdown table; "-" for values that were not measured.
std::string arm_lines(const std::vector<arm_row>& rows);

// In separate files, compiled in parallel.
void follow_with_3r(std::vector<arm_row>& rows);
void follow_with_4r(std::vector<arm_row>& rows);
void follow_with_some_brakes(std::vector<arm_row>& rows);
void follow_with_4r_in_space(std::vector<arm_row>& rows);

}  // namespace experiments
