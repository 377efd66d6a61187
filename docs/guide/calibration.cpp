#include <passive_haptics/driver/calibration/device_calibration.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>

#include <iostream>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;

int main() {
  const device arm;

  ph::device_calibration_parameters<device, 6> measured;
  measured.encoders.counts_per_turn = {8192, -8192};  // counts fall where brake 2 turns in its positive sense
  measured.brakes[0] = {.residual_torque = 0.02, .torque_per_ampere = 1.6, .current_limit = 0.5};
  measured.brakes[1] = {.residual_torque = 0.02, .current_limit = 0.5};
  measured.brakes[1].table = {{{0, 0.02}, {0.1, 0.12}, {0.3, 0.48}, {0.5, 0.80}}};
  measured.brakes[1].points = 4;
  measured.force.newtons_per_unit *= 1e-6;  // micronewtons, Fx and Fy first
  measured.force.handle_mass = 0.1;
  // Angles of both links add up to that of the last one
  const ph::planar_sensor_frame<2> last_link{.link = {1, 1}, .mounting = 0.5};
  ph::device_calibration calibration(arm, measured, last_link);

  // Readings of the ports while a jig holds the handle in the reference pose, hand off
  const auto counts = [](double) { return std::array<double, 2>{1200, -340}; };
  const auto readings = [](double) { return std::array<double, 6>{2e5, -1e5, 4e6, 0, 0, 0}; };

  const ph::vector<double, 2> reference(0, 1.5707963267948966);
  ph::homing<2> home(calibration.encoders, calibration.axis_positions(reference));
  ph::steady_mean<6> unloaded({.tolerance = 5e4});
  for (double t = 0; t < 2; t += 0.001) {
    home.add(t, ph::vector<double, 2>(counts(t).data()));
    unloaded.add(t, ph::vector<double, 6>(readings(t).data()));
  }
  calibration.encoders.set_zero_count(home.zero_count());
  const auto frame = calibration.sensor_frame(reference);
  calibration.force.set_tare(calibration.force.tare_of(unloaded.mean(), frame));

  const ph::device_state<device> state = calibration.state(2.5, counts(2.5), readings(2.5));
  const ph::brake_currents<2> currents = calibration.currents({0.5, 0.5});
  std::cout << "q = " << state.q.transpose() << " rad, hand force " << state.hand_force.norm() << " N; "
            << currents[0] << " A and " << currents[1] << " A for 0.5 N m each\n";

  const double count = 2 * 3.141592653589793 / 8192;
  std::cout << "rate_dead_band >= " << ph::rate_dead_band(count, 16, 0.001) << " rad/s\n";
  return (state.q - reference).norm() < 1e-9 && state.hand_force.norm() < 1e-9 ? 0 : 1;
}
