// A corner and a curved wall: first the forces of the brakes, then a hand.
#include <passive_haptics/design/sink_slope.hpp>
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/wall_following.hpp>

#include <cmath>
#include <iostream>

namespace ph = passive_haptics;
using device = ph::five_bar<double>;
using vector = ph::vector<double, 2>;

int main() {
  const device arm(
      {.base_distance = 0.1, .proximal_1 = 0.12, .proximal_2 = 0.12, .distal_1 = 0.16, .distal_2 = 0.16});
  ph::brakes_of<device> brakes;
  brakes.torque_limit = {2, 2};  // [N m]
  bool as_foreseen = true;

  // A corner
  const ph::half_space<2> top({0, 0.2}, {0, -1}), side({0.02, 0}, {-1, 0});
  const vector corner(0.02, 0.2), start(-0.02, 0.199);
  const auto along_top = [&](double u) {
    return ph::path_point<device>{arm.inverse(start + u * (corner - start)).q, {1, 0}, {0, -1}};
  };
  std::cout << "less than 2 N on " << 100 * ph::undisplayable_share(arm, along_top, brakes.torque_limit, 2.0)
            << " % of the way into the corner\n";

  ph::controller control(arm, brakes, ph::scene(ph::wall(top), ph::wall(side)),
                         ph::recommended_law(arm, brakes));
  ph::simulated_device plant(arm, brakes, 0.5, arm.inverse(start).q);
  const ph::following_hand<double, 2> hand({1, 0}, start);  // 5 cm/s, pushes with 2 N
  for (int k = 0; k <= 3000; ++k) {
    const ph::device_state<device> state{1e-3 * k, plant.q(), plant.qd(), plant.sensed_force()};
    const auto result = control(state);
    const vector push =
        hand.force(state.time, plant.position(), plant.velocity(), {0, -1}, -top.distance(plant.position()));
    plant.advance(1e-3, result.capacity, push);
  }
  const double in_top = -1e3 * top.distance(plant.position()),
               in_side = -1e3 * side.distance(plant.position());
  std::cout << "after 3 s " << in_top << " mm deep in the top, " << in_side << " mm in the side\n";
  as_foreseen = as_foreseen && in_top < 5 && in_side < 5;

  // A curved wall: the lower side of a disc of 40 mm, at three distances from the base
  for (const double y : {0.22, 0.20, 0.17}) {
    const ph::disc circle({0, y}, 0.04);
    const auto around = [&](double u) {  // from -40 to 40 degrees
      const double a = ph::radians(-40 + 80 * u);
      const vector normal(std::sin(a), -std::cos(a)), forward(std::cos(a), std::sin(a));
      return ph::path_point<device>{arm.inverse(vector(0, y) + 0.04 * normal).q, forward, normal};
    };
    const double nothing = ph::undisplayable_share(arm, around);
    const double sinks = 1e3 * ph::sink_depth(arm, around, brakes.torque_limit, 2.0);

    const vector first = arm.position(around(0).q) + 1e-3 * around(0).normal;
    ph::controller follow(arm, brakes, ph::scene(ph::wall(circle)), ph::recommended_law(arm, brakes));
    ph::simulated_device device_at_disc(arm, brakes, 0.5, arm.inverse(first).q);
    const auto figures = ph::follow_wall(device_at_disc, follow, circle,
                                         ph::following_hand<double, 2>({1, 0}, first), {.path_end = 0.025});
    std::cout << "y = " << y << " m: nothing on " << 100 * nothing << " % of the way, sinks " << sinks
              << " mm; the hand gets " << 1e3 * figures.max_depth << " mm deep, " << to_string(figures.end)
              << "\n";
    as_foreseen = as_foreseen && figures.separations == 0 && 1e3 * figures.max_depth < sinks + 3;
  }
  return as_foreseen ? 0 : 1;
}
