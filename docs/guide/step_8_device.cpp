#include "scara.hpp"

#include <passive_haptics/driver/calibration/device_calibration.hpp>
#include <passive_haptics/driver/control_loop.hpp>
#include <passive_haptics/driver/safe_port.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>

const ph::planar_sensor_frame<2> on_the_last_link{.link = {1, 1}};
ph::device_calibration_parameters<scara> measured() {
  ph::device_calibration_parameters<scara> p;
  for (ph::brake_curve& brake : p.brakes) brake = {.torque_per_ampere = 2, .current_limit = 0.5};
  return p;
}

// Instead of your hardware: a simulated arm. A hand presses its handle into the wall and along it.
struct bench {
  ph::simulated_device<scara> device{scara(), ph::brakes_of<scara>(), 0.5, {0.3, 1.2}};
  ph::device_calibration<scara, 2, ph::planar_sensor_frame<2>> units{device.mechanism(), measured(),
                                                                     on_the_last_link};
  ph::vector<double, 2> torque = {0, 0};
  double time = ph::monotonic_seconds();
};

// Your hardware, as the library sees it: counts come, currents go.
struct board {
  static constexpr int encoder_count = 2, brake_count = 2;
  bench* at;
  std::uint32_t sequence = 0;

  std::string open() { return {}; }
  ph::port_status read(ph::port_sample<2>& sample) noexcept {
    for (const double now = ph::monotonic_seconds(); at->time < now; at->time += 1e-4)
      at->device.advance(1e-4, at->torque, {0.3, 1});
    const auto counts = at->units.encoders.counts(at->units.axis_positions(at->device.q()));
    sample = {
        ph::monotonic_seconds(), ++sequence, {std::floor(counts[0]), std::floor(counts[1])}, {true, true}};
    return ph::port_status::ok;
  }
  ph::port_status write(const ph::brake_currents<2>& currents) noexcept {
    at->torque = {2 * currents[0], 2 * currents[1]};
    return ph::port_status::ok;
  }
  void release() noexcept { at->torque.setZero(); }
};

struct force_sensor {
  static constexpr int channel_count = 2;
  bench* at;
  std::uint32_t sequence = 0;

  std::string open() { return {}; }
  ph::port_status read(ph::port_sample<2>& sample) noexcept {
    const ph::vector<double, 2> felt =
        on_the_last_link(at->device.q()).transpose() * at->device.sensed_force();
    sample = {ph::monotonic_seconds(), ++sequence, {felt[0], felt[1]}, {true, true}};
    return ph::port_status::ok;
  }
};

int main() {
  bench hardware;
  const scara arm;
  const double wall = hardware.device.position()[1] + 0.002;  // 2 mm before the handle

  ph::device_calibration calibration(arm, measured(), on_the_last_link);
  ph::controller control(arm, ph::brakes_of<scara>(),
                         ph::scene(ph::wall(ph::half_space<2>({0, wall}, {0, -1}))),
                         ph::velocity_direct_control());
  ph::safe_port<board, force_sensor> port(
      {&hardware}, {&hardware},
      {.sensor = {.range = {50, 50}}, .currents = {.max_current = {0.5, 0.5}}, .hold_over = 1});
  if (const std::string missing = port.open(); !missing.empty()) {
    std::cerr << missing << "\n";
    return 1;
  }

  double max_depth = 0;
  ph::control_loop loop({.max_overruns = 1000, .max_sleep = 1});  // on a machine that does much else
  const ph::loop_report report = loop.run(
      [&](const ph::loop_cycle& now) {
        port.read(now.time);
        port.activate();  // a real program homes and tares before
        auto state = calibration.state(port.position_time(), port.position(), port.force());
        state.time = now.time;  // of this cycle: the sample may be that of the cycle before
        port.write(calibration.currents(control(state).capacity));
        max_depth = std::max(max_depth, hardware.device.position()[1] - wall);
        return now.number < 500;
      },
      [] { return false; }, [&](ph::fault why) { port.release({why}); });

  std::cout << report.cycles << " cycles; " << 1e3 * max_depth << " mm deep at most\n";
  const bool held =
      max_depth > 0 && max_depth < 0.02;  // without brakes the hand would be far behind the wall
  return held && hardware.torque.isZero(0) ? 0 : 1;
}
