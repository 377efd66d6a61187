// Brakes that twist before they slip, and brakes with residual torque, on random devices.
#pragma once

#include <cstdint>
#include <string>

namespace experiments {

// 60 tendon devices of this seed under velocity_direct_control, for each presliding and residual torque:
// outcomes, ends of runs, and results of the wall calculator, as a Markdown table.
std::string soft_brakes(std::uint64_t seed);

}  // namespace experiments
