#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

#include <algorithm>
#include <iostream>

namespace ph = passive_haptics;
using scara = ph::two_link<double>;

int main() {
  const scara arm({.length_1 = 0.2, .length_2 = 0.1});
  const ph::brakes_of<scara> brakes;
  const ph::half_space<2> table({0, 0.2}, {0, -1});
  // In place of yours: 5 mm before the wall, with a hand of 0.5 kg
  ph::simulated_device<scara> device(arm, brakes, 0.5, arm.inverse({0.1, 0.195}, ph::elbow::left).q);

  ph::controller control(arm, brakes, ph::scene(ph::wall(table, 2e5)), ph::recommended_law(arm, brakes));
  std::cout << ph::reason_for_law(arm, brakes) << "\n";

  ph::device_state<scara> state;
  double max_depth = 0;
  for (int k = 0; k < 500; ++k) {  // each millisecond
    state.time = 1e-3 * k;
    state.q = device.q();
    state.qd = device.qd();
    state.hand_force = device.sensed_force();
    const auto result = control(state);
    if (result.outcome != ph::status::ok) return 1;
    const ph::vector<double, 2> current = result.capacity / 0.5;  // [A] for brakes of 0.5 N m/A
    for (int i = 0; i < 10; ++i) device.advance(1e-4, 0.5 * current, {0.3, 1});  // and a push [N]
    max_depth = std::max(max_depth, -table.distance(device.position()));
  }
  std::cout << 1e3 * max_depth << " mm deep at most\n";
  return max_depth > 0 && max_depth < 0.005 ? 0 : 1;  // without brakes the hand would be far behind the wall
}
