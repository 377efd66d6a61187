// Corners of half-spaces in a hand's closed loop, under every law.
#pragma once

#include <cstddef>
#include <string>

namespace experiments {

// A table of Markdown, with this number of corners for each device.
std::string corner_table(std::size_t count);

}  // namespace experiments
