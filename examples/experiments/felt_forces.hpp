// Forces of arms with self-motion as felt by a stiff hand.
#pragma once

#include "felt_force.hpp"

#include <string>

namespace experiments {

// Markdown table for three arms.
std::string felt_forces();

// Each in the file of its arm's runs, with which it shares most of the compilation.
felt_row feel_3r(std::size_t states);
felt_row feel_two_brakes(std::size_t states);
felt_row feel_4r(std::size_t states);

}  // namespace experiments
