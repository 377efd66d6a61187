// Figs. 8 to 10 under two readings of section 4: does alpha scale a command that is cut to what the brakes
// can make, or is it cut after? Hands that yield, brakes just strong enough for them.
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
  std::vector<ph::contact_metrics> figures;  // one a hand
  int reproduced;  // hands that show what the paper reports, beside no_direct_control
};

// What the paper reports of a hand: without the law 3 separations or more, with it at most 1; the depth and
// the hand's force vary less, brake 2 sticks less, less force retards the hand.
bool reproduces(const ph::contact_metrics& without, const ph::contact_metrics& with);

// The planar wall, the concave and the convex one, each at 1 kHz and at 20 Hz, under each of these laws; of
// bands_only the planar one, under the laws that need nothing of the device.
std::vector<reading_cell> read_the_paper(std::uint64_t seed, double time_step, bool bands_only = false);

// Medians over the hands, as a table of Markdown.
std::string reading_table(const std::vector<reading_cell>& cells);

}  // namespace experiments
