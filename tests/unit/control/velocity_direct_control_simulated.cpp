// slow, optimised
// velocity_direct_control in simulations: in corners, beside a brake at rest, and on devices that stall.
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/core/scalar/first_order_lag.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/plant/random_device.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace {

namespace ph = passive_haptics;
using tendon = ph::tendon_two_link<double>;
using point = ph::point<2>;

// Two seconds of a hand that pushes from x; visit(time, position) in each step.
template <class Scene, class Visit>
void push_for_two_seconds(const Scene& scene, const point& x, const point& push, Visit&& visit) {
  const tendon arm;
  ph::controller control(arm, ph::brakes_of<tendon>(), scene, ph::velocity_direct_control());
  ph::simulated_device device(arm, ph::brakes_of<tendon>(), 0.5, arm.inverse(x, ph::elbow::left).q);
  ph::first_order_lag<double, 2> sensor(point::Constant(ph::low_pass_time_constant(200.0)));
  point capacity = point::Zero();
  for (int k = 0; k < 20'000; ++k) {
    const double time = k * 1e-4;
    if (k % 10 == 0)
      capacity = control(ph::device_state<tendon>{time, device.q(), device.qd(), sensor.output()}).capacity;
    device.advance(1e-4, capacity, push - 20 * device.velocity());
    sensor.advance(1e-4, device.sensed_force());
    visit(time, device.position());
  }
}

// A handle pressed into a corner of two walls touches both and stays; each wall has a depth of its own.
TEST(velocity_direct_control, holds_in_the_corner_of_two_walls) {
  const ph::half_space<2> ceiling({0, 0.2}, {0, -1}), side({0.1, 0}, {-1, 0});
  double max_depth = -1, shallowest = 1;
  push_for_two_seconds(ph::scene(ph::wall(ceiling), ph::wall(side)), {0.095, 0.192}, {2, 2},
                       [&](double time, const point& x) {
                         if (time < 1) return;
                         for (const double depth : {-ceiling.distance(x), -side.distance(x)}) {
                           max_depth = std::max(max_depth, depth);
                           shallowest = std::min(shallowest, depth);
                         }
                       });
  EXPECT_GT(shallowest, 1e-4);
  EXPECT_LT(max_depth, ph::velocity_direct_control_parameters().rest_depth + 1e-3);
}

// Back along the wall the cone leaves only brake 1, 51 deg from the wall's normal, while brake 2 comes to
// rest and does nothing more. A law that ignores this lets the handle slide into the wall by centimetres.
TEST(velocity_direct_control, knows_that_a_brake_at_rest_only_holds) {
  const ph::half_space<2> ceiling({0, 0.225}, {0, -1});
  for (const double x : {0.08, 0.14}) {
    double max_depth = -1;
    push_for_two_seconds(ph::scene(ph::wall(ceiling)), {x, 0.221}, {-1, 2}, [&](double, const point& now) {
      max_depth = std::max(max_depth, -ceiling.distance(now));
    });
    EXPECT_LT(max_depth, 12e-3) << "from x = " << x;
  }
}

tendon tendon_of(double inertia) {
  ph::tendon_two_link_parameters<double> p;
  for (double* mass : {&p.mass_1, &p.mass_2, &p.handle_mass, &p.rotor_inertia_1, &p.rotor_inertia_2})
    *mass *= inertia;
  return tendon(p);
}

// Coarse encoders, a slow hand and a constant push: brakes come to rest again and again. If they are released
// while they hold, each handle sinks by over 39 mm; a search over all commands finds 10.3, 30 and 17 mm.
TEST(velocity_direct_control, holds_on_where_it_is_pushed_and_hardly_moves) {
  constexpr std::uint64_t seed = 20261;
  struct stall {
    std::uint64_t number;
    double max_depth;  // [m]
  };
  for (const auto& [number, max_depth] : {stall{251, 15.5e-3}, stall{202, 45e-3}, stall{190, 25.5e-3}}) {
    const auto d = ph::draw_device(tendon_of(1), {{-3.1, -2.5}, {3.1, -0.6}, 0.1}, seed, number);
    const ph::half_space<2> wall(d.plane.surface, d.plane.normal);
    ph::controller control(
        tendon_of(1), d.known_brakes,
        ph::held_scene(ph::scene(ph::wall(wall, d.wall_stiffness)), 1 / d.environment_rate),
        ph::velocity_direct_control());
    ph::simulated_device<tendon> plant(tendon_of(d.inertia), d.brakes, d.hand.mass, d.plane.q);
    plant.set_motion(d.plane.q, d.plane.qd);
    const ph::following_hand<double, 2> hand(d.plane.direction, d.plane.start, d.hand);
    const ph::contact_metrics figures = ph::follow_wall(plant, control, wall, hand, d.run);
    EXPECT_LE(figures.max_depth, max_depth) << "seed " << seed << ", device " << number;
    EXPECT_FALSE(figures.separates()) << "seed " << seed << ", device " << number;
  }
}

}  // namespace
