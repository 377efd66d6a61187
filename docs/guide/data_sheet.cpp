#include <passive_haptics/passive_haptics.hpp>

#include <iomanip>
#include <iostream>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;

int main() {
  ph::tendon_two_link_parameters<double> dimensions;
  dimensions.arm.rotor_inertia_1 = dimensions.arm.rotor_inertia_2 = 0;  // the data sheet has them
  const device arm(dimensions);

  // Magnetic particle brake GBA of MAGPOWR; an encoder of 1024 lines on the shaft of each
  const ph::brake_data gba{.torque_limit = 7.5,         // [N m]
                           .residual_torque = 0.09,     // [N m], "non-excited drag torque"
                           .time_constant = 0.22,       // [s]
                           .fall_time_constant = 0.22,  // [s], not in the sheet: taken for that of the rise
                           .rotor_inertia = 0.00055};   // [kg m^2]
  ph::data_sheet<device> parts;
  parts.brakes = {gba, gba};
  parts.encoders = {ph::encoder_data{.counts_per_turn = 4096}, {.counts_per_turn = 4096}};

  // The handle slides along a wall at 0.1 m/s and touches it at 0.1 m/s
  const auto q = arm.inverse({0.12, 0.225}, ph::elbow::left).q;
  const ph::vector<double, 2> velocity(0.1, 0.1), normal(0, -1);
  const auto bought = ph::expected_rendering(arm, parts, q, velocity, normal);
  std::cout << to_text(bought) << "\n" << std::setprecision(3);

  for (ph::brake_data& brake : parts.brakes) brake.gear_ratio = 0.25;  // four turns of a link for one of it
  const auto geared = ph::expected_rendering(arm, parts, q, velocity, normal);
  std::cout << "geared down 1 to 4: free drag " << geared.free_drag.value << " N, strongest force "
            << geared.strongest_force.value << " N, depth " << 1e3 * geared.depth.value << " mm\n";

  for (ph::brake_data& brake : parts.brakes) brake.time_constant = brake.fall_time_constant = 0.020;
  const auto quick = ph::expected_rendering(arm, parts, q, velocity, normal);
  std::cout << "and quick, 20 ms: release " << 1e3 * quick.release_time.value << " ms\n";
}
