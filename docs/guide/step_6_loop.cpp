#include "scara.hpp"

#include <passive_haptics/plant/simulated_device.hpp>

#include <algorithm>
#include <iostream>

const ph::half_space<2> table({0, 0.16}, {0, -1});  // a point of the surface [m], the outward normal

auto make_controller() {
  const scara arm;
  ph::brakes_of<scara> brakes;
  brakes.torque_limit = {1, 1};  // [N m]
  return ph::controller(arm, brakes, ph::scene(ph::wall(table, 2e5)), ph::recommended_law(arm, brakes));
}

class arm_control {
 public:
  // Currents [A] of brakes of 0.5 N m/A, once each millisecond
  ph::vector<double, 2> update(const ph::device_state<scara>& state) {
    const auto result = controller_(state);
    if (result.outcome != ph::status::ok) std::cerr << to_string(result.outcome) << "\n";
    return result.capacity / 0.5;  // 0 after any fault
  }

 private:
  decltype(make_controller()) controller_ = make_controller();
};

int main() {
  std::cout << ph::reason_for_law(scara(), ph::brakes_of<scara>()) << "\n";
  arm_control control;
  // A simulated arm instead of yours: 1 mm before the wall, with a hand of 0.5 kg
  ph::simulated_device<scara> device(scara(), ph::brakes_of<scara>(), 0.5, {0.3, 1.2});
  double max_depth = 0;
  for (int k = 0; k < 500; ++k) {
    const auto current = control.update({1e-3 * k, device.q(), device.qd(), device.sensed_force()});
    for (int i = 0; i < 10; ++i) device.advance(1e-4, 0.5 * current, {0.3, 1});  // and a push [N]
    max_depth = std::max(max_depth, -table.distance(device.position()));
  }
  std::cout << 1e3 * max_depth << " mm deep at most\n";
  return max_depth > 0 && max_depth < 0.005 ? 0 : 1;  // without brakes the hand would be far behind the wall
}
