#include "scara.hpp"

#include <passive_haptics/driver/calibration/device_calibration.hpp>

#include <cmath>

int main() {
  const scara arm;

  ph::device_calibration_parameters<scara> measured;
  measured.encoders.counts_per_turn = {8192, -8192};  // the second encoder counts backwards
  for (ph::brake_curve& brake : measured.brakes)
    brake = {.residual_torque = 0.02, .torque_per_ampere = 2, .current_limit = 0.5};
  const ph::planar_sensor_frame<2> on_the_last_link{.link = {1, 1}};  // rotates with q1 + q2
  ph::device_calibration calibration(arm, measured, on_the_last_link);
  calibration.encoders.set_zero_count({1200, -340});  // the counts at q = 0, found by homing

  const ph::device_state<scara> state = calibration.state(0, {1200 + 2048, -340}, {0, 1.5});
  const ph::brake_currents<2> currents = calibration.currents({0.5, 0});  // [A] for 0.5 N m and nothing
  return std::abs(ph::degrees(state.q[0]) - 90) < 1e-9 && std::abs(currents[0] - 0.24) < 1e-9 ? 0 : 1;
}
