#include <passive_haptics/interop/mujoco.hpp>
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/wall_following.hpp>

#include <cstdio>
#include <string>
#include <utility>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;

int main() {
  const device arm;
  const ph::brakes_of<device> brakes;
  const ph::half_space<2> wall({0, 0.225}, {0, -1});
  const ph::point<2> start(0.06, 0.224);
  const auto q = arm.inverse(start, ph::elbow::left).q;
  const ph::following_hand<double, 2> hand({1, 0}, start);
  const double hand_mass = hand.parameters().mass;

  const auto follow = [&](const char* name, auto plant) {
    ph::controller control(arm, brakes, ph::scene(ph::wall(wall)), ph::velocity_direct_control());
    const auto figures = ph::follow_wall(plant, control, wall, hand, {.path_end = 0.1});
    std::printf("%-17s %d separations, depth up to %.1f mm\n", name, figures.separations,
                1e3 * figures.max_depth);
    return figures.arrived;
  };
  const bool arrived = follow("simulated_device:", ph::simulated_device<device>(arm, brakes, hand_mass, q)) &&
                       follow("mujoco_device:", ph::mujoco_device<device>(arm, brakes, hand_mass, q));

  std::string model = ph::mujoco_model(arm, hand_mass);  // MJCF, to look at or to change
  const ph::mujoco_device<device> own(arm, ph::ideal_brakes(brakes), hand_mass, q, model);

  const double time_step = 1e-4;  // [s]
  const ph::brake_vector<device> creep = own.creep_rates(time_step);
  std::printf("brakes that hold 1 N m creep at %.1e and %.1e rad/s\n", creep[0], creep[1]);
  return arrived ? 0 : 1;
}
