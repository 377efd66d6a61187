// slow, optimised
// velocity_direct_control in simulations: beside a brake at rest, and on devices that stall.
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

// Back along the wall the cone leaves only brake 1, 51 deg from the wall's normal, while brake 2 comes to
// rest and does nothing more. A law that ignores this lets the handle slide into the wall by centimetres.
TEST(velocity_direct_control, knows_that_a_brake_at_rest_only_holds) {
  const tendon arm;
  const ph::half_space<2> ceiling({0, 0.225}, {0, -1});
  for (const double x : {0.08, 0.14}) {
    ph::controller control(arm, ph::brakes_of<tendon>(), ph::scene(ph::wall(ceiling)),
                           ph::velocity_direct_control());
    ph::simulated_device device(arm, ph::brakes_of<tendon>(), 0.5,
                                arm.inverse({x, 0.221}, ph::elbow::left).q);
    ph::first_order_lag<double, 2> sensor(point::Constant(ph::low_pass_time_constant(200.0)));
    point capacity = point::Zero();
    double max_depth = -1;
    for (int k = 0; k < 20'000; ++k) {
      if (k % 10 == 0) {
        const ph::device_state<tendon> state{k * 1e-4, device.q(), device.qd(), sensor.output()};
        capacity = control(state).capacity;
      }
      device.advance(1e-4, capacity, point(-1, 2) - 20 * device.velocity());
      sensor.advance(1e-4, device.sensed_force());
      max_depth = std::max(max_depth, -ceiling.distance(device.position()));
    }
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
