#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using scara = ph::two_link<double>;

int main() {
  const scara arm({.length_1 = 0.2, .length_2 = 0.1});
  const ph::half_space<2> table({0, 0.2}, {0, -1});
  ph::controller control(arm, ph::brakes_of<scara>(), ph::scene(ph::wall(table, 2e5)), ph::direct_control());

  ph::device_state<scara> state{.time = 0, .q = {0.9, 0.7}, .qd = {0.5, -0.2}, .hand_force = {0, 1}};
  const auto result = control(state);  // each millisecond
  if (result.outcome != ph::status::ok) return 1;
  const ph::vector<double, 2> current = result.capacity / 0.5;  // [A] for brakes of 0.5 N m/A
  return current.minCoeff() >= 0 ? 0 : 1;
}
