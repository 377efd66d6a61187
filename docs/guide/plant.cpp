#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/wall_following.hpp>

#include <iostream>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;

int main() {
  const device arm;
  const ph::brakes_of<device> brakes;
  const ph::half_space<2> wall({0, 0.225}, {0, -1});
  const ph::point<2> start(0.06, 0.224);
  const auto q = arm.inverse(start, ph::elbow::left).q;

  ph::controller control(arm, brakes, ph::held_scene(ph::scene(ph::wall(wall)), 0.05), ph::direct_control());
  const ph::following_hand<double, 2> hand({1, 0}, start);
  ph::simulated_device<device> simulated(arm, brakes, hand.parameters().mass, q);
  const auto figures = ph::follow_wall(simulated, control, wall, hand, {.path_end = 0.1});
  std::cout << figures.separations << " separations, depth up to " << 1e3 * figures.max_depth << " mm\n";
  return figures.arrived ? 0 : 1;
}
