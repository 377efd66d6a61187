// What a stiff hand feels of the forces of arms with self-motion.
#pragma once

#include "felt_force.hpp"

#include <string>

namespace experiments {

// Of three arms, as a table of Markdown.
std::string felt_forces();

// Each beside the runs of its arm, with which it shares most of what the compiler does.
felt_row feel_3r(std::size_t states);
felt_row feel_two_brakes(std::size_t states);
felt_row feel_4r(std::size_t states);

}  // namespace experiments
