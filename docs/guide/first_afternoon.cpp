#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

#include <cmath>
#include <iostream>
#include <vector>

namespace ph = passive_haptics;
using device = ph::two_link<double>;

int main() {
  const device arm;
  const ph::brakes_of<device> brakes;
  const auto scene = ph::scene(ph::wall(ph::half_space<2>({0, 0.25}, {0, -1})));

  // In place of your device: a hand that moves the handle to and fro
  ph::simulated_device<device> simulated(arm, brakes, 0.1, {0.3, 1.2});
  ph::device_state<device> state;
  std::vector<ph::device_state<device>> recorded;
  for (int k = 0; k < 2000; ++k) {
    state.time = 1e-3 * k;
    state.q = simulated.q();
    state.qd = simulated.qd();
    state.hand_force = {0.6 * std::cos(9 * state.time), 0.5 * std::sin(7 * state.time)};
    recorded.push_back(state);
    simulated.advance(1e-3, {0, 0}, state.hand_force);
  }

  std::cerr << ph::plausibility(arm, brakes, scene, state.q);               // once, at the start
  std::cerr << ph::plausibility(arm, recorded);                             // states of some seconds, once
  std::cerr << "optional members: " << to_text(ph::describe(arm)) << "\n";  // of your own mechanism
  return (ph::plausibility(arm, brakes, scene, state.q) + ph::plausibility(arm, recorded)).empty() ? 0 : 1;
}
