#include <passive_haptics/passive_haptics.hpp>

#include <iostream>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;
using state = ph::device_state<device>;  // or ph::sensorless_device_state<device>

int main() {
  const device arm;
  const ph::brakes_of<device> brakes;
  const auto law = ph::recommended_law<state>(arm, brakes);
  std::cout << ph::reason_for_law<state>(arm, brakes) << "\n";

  const ph::half_space<2> plane({0, 0.225}, {0, -1});
  ph::controller control(arm, brakes, ph::scene(ph::wall(plane)), law);
  return control(state{.time = 0, .q = {0.3, 1.2}}).outcome == ph::status::ok ? 0 : 1;
}
