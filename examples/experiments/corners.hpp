// Corners of two and three planes, and other obstacles near a wall, in a hand's closed loop under every law.
#pragma once

#include "markdown.hpp"

#include <cstddef>
#include <cstdint>

namespace experiments {

inline constexpr std::uint64_t corner_seed = 59;
inline constexpr std::size_t corner_count = 60;

// Three tables of docs/results.md; rows are printed as they are computed.
page_tables follow_corners();

}  // namespace experiments
