// Figs. 8 to 10 under two readings of section 4: alpha is applied after or before the torque limit. Compliant
// hands, with brakes just strong enough for them.
#pragma once

#include "planar.hpp"

#include <vector>

namespace experiments {

inline constexpr std::size_t hand_count = 60;
inline constexpr std::array reading_laws{law::none, law::direct, law::saturated, law::velocity};

// All hands along one wall at one rate.
struct reading_cell {
  std::string wall;
  double rate;  // of the environment [Hz]
  law which;
  std::vector<ph::contact_metrics> figures;  // one per hand
  int reproduced;  // hands that reproduce the paper, compared with no_direct_control
};

// The paper's observations for a hand: 3 or more separations without the law, at most 1 with it; less
// variation of depth and hand force, less sticking of brake 2, less retarding force.
bool reproduces(const ph::contact_metrics& without, const ph::contact_metrics& with);

// The planar wall, the concave and the convex one, each at 1 kHz and at 20 Hz, under each of these laws; of
// bands_only the planar one, under the laws that need nothing of the device.
std::vector<reading_cell> read_the_paper(std::uint64_t seed, double time_step, bool bands_only = false,
                                         simulation plant = simulation::own);

// Markdown table of medians over the hands.
std::string reading_table(const std::vector<reading_cell>& cells);

// Medians of both plants next to each other, as a table of Markdown.
std::string plant_table(const std::vector<reading_cell>& own, const std::vector<reading_cell>& mujoco);

}  // namespace experiments
