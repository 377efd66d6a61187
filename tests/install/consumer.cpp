// A user's project in small: a wall, one control cycle, and a check that it brakes.
#include <passive_haptics/passive_haptics.hpp>

#include <iostream>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;

int major_version_seen_elsewhere();  // other.cpp: a second translation unit with the same headers

int main() {
  const device arm;
  const ph::half_space<2> plane({0, 0.225}, {0, -1});
  ph::controller control(arm, ph::brakes_of<device>(), ph::scene(ph::wall(plane)), ph::direct_control());
  ph::device_state<device> state;
  state.time = 0;
  state.q = arm.inverse({0.12, 0.226}, ph::elbow::left).q;
  state.qd = {-0.2, 1};
  const auto result = control(state);
  std::cout << "passive_haptics " << PASSIVE_HAPTICS_VERSION_MAJOR << "." << PASSIVE_HAPTICS_VERSION_MINOR
            << ": capacity " << result.capacity.transpose() << " N m\n";
  const bool brakes = result.outcome == ph::status::ok && result.capacity.maxCoeff() > 0;
  return brakes && major_version_seen_elsewhere() == PASSIVE_HAPTICS_VERSION_MAJOR ? 0 : 1;
}
