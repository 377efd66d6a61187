// slow, optimised
// Devices whose brakes come to rest again and again: coarse encoders, a slow hand and a constant push.
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/plant/random_device.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>

namespace {

namespace ph = passive_haptics;
using tendon = ph::tendon_two_link<double>;

tendon tendon_of(double inertia) {
  ph::tendon_two_link_parameters<double> p;
  for (double* mass : {&p.mass_1, &p.mass_2, &p.handle_mass, &p.rotor_inertia_1, &p.rotor_inertia_2})
    *mass *= inertia;
  return tendon(p);
}

// Brakes that are let go while they hold let each of these sink by over 39 mm. A search over all commands
// finds ways on which they sink by 10.3, 30 and 17 mm.
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
    std::printf("seed %d, device %d: %.1f mm\n", int(seed), int(number), 1e3 * figures.max_depth);
  }
}

}  // namespace
