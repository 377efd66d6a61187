// Brakes that twist before they slip, and brakes that drag without current, on random devices.
#pragma once

#include <cstdint>
#include <string>

namespace experiments {

// 60 tendon devices of this seed under velocity_direct_control, for each presliding and each residual torque:
// what became of the hand, how its runs ended, and what the wall calculator says, as a table of Markdown.
std::string soft_brakes(std::uint64_t seed);

}  // namespace experiments
