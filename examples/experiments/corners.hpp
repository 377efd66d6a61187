// Corners of two and three planes, and other obstacles near a wall, in a hand's closed loop under every law.
#pragma once

#include "markdown.hpp"
#include "numbered.hpp"

namespace experiments {

inline constexpr std::uint64_t corner_seed = 59;
inline constexpr number_range default_corners{0, 59};

// Three tables of docs/results.md for corners with these numbers; rows are printed as they are computed.
page_tables follow_corners(const number_range& which);

}  // namespace experiments
