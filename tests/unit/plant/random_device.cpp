// slow
// Random devices: within their ranges, the same for the same seed, on planes that can be followed.
#include "../support.hpp"

#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/random_device.hpp>

#include <numbers>
#include <stdexcept>

namespace {

using tendon = ph::tendon_two_link<double>;
const ph::workspace<tendon> space{{-3.1, -2.5}, {3.1, -0.6}, 0.1};

TEST(random_device, is_the_same_for_the_same_seed_and_number) {
  const auto a = ph::draw_device(tendon(), space, 5, 17), b = ph::draw_device(tendon(), space, 5, 17);
  EXPECT_EQ(a.brakes[0].gain, b.brakes[0].gain);
  EXPECT_EQ(a.plane.q, b.plane.q);
  EXPECT_EQ(a.environment_rate, b.environment_rate);
  EXPECT_NE(a.brakes[0].gain, ph::draw_device(tendon(), space, 5, 18).brakes[0].gain);
  EXPECT_NE(a.brakes[0].gain, ph::draw_device(tendon(), space, 6, 17).brakes[0].gain);
}

TEST(random_device, lies_within_the_ranges) {
  const ph::device_ranges r;
  const auto within = [](double x, const ph::device_ranges::interval& i) {
    return x >= i.low * (1 - 1e-12) && x <= i.high * (1 + 1e-12);
  };
  int impedances = 0;
  constexpr int count = 100;
  for (int k = 0; k < count; ++k) {
    const auto d = ph::draw_device(tendon(), space, 1, static_cast<std::uint64_t>(k));
    EXPECT_EQ(validate(d.hand), "");
    EXPECT_EQ(validate(d.run), "");
    EXPECT_TRUE(within(d.inertia, r.inertia));
    for (int i = 0; i < 2; ++i) {
      const auto& brake = d.brakes[static_cast<std::size_t>(i)];
      EXPECT_EQ(validate(brake), "");
      EXPECT_TRUE(within(brake.gain, r.gain));
      EXPECT_TRUE(within(brake.residual.strength, r.residual_torque));
      EXPECT_TRUE(within(brake.time_constant, r.rise_time_constant));
      EXPECT_TRUE(within(brake.fall_ratio * brake.time_constant, r.rise_time_constant));
      EXPECT_TRUE(within(d.known_brakes.torque_limit[i], r.torque_limit));
      EXPECT_EQ(brake.torque_limit, brake.gain * d.known_brakes.torque_limit[i]);
    }
    EXPECT_TRUE(within(d.run.sensor_scale, r.sensor_scale));
    EXPECT_TRUE(within(2 * std::numbers::pi / d.run.encoder_resolution, r.encoder_counts));
    EXPECT_TRUE(within(d.hand.speed, r.hand_speed));
    EXPECT_TRUE(within(d.hand.mass, r.hand_mass));
    const bool impedance = d.hand.normal_stiffness > 0;
    impedances += impedance ? 1 : 0;
    EXPECT_TRUE(within(impedance ? d.hand.normal_stiffness * d.hand.target_depth : d.hand.push, r.push));
    EXPECT_TRUE(within(d.wall_stiffness, r.wall_stiffness));
  }
  EXPECT_NEAR(impedances, count / 2, 25) << "five standard deviations";
}

template <class M>
void expect_a_way(const M& mechanism, const ph::workspace<M>& where) {
  for (std::uint64_t k = 0; k < 10; ++k) {
    const auto d = ph::draw_device(mechanism, where, 2, k);
    const auto& p = d.plane;
    EXPECT_NEAR(p.normal.norm(), 1, 1e-12);
    EXPECT_NEAR(p.direction.norm(), 1, 1e-12);
    EXPECT_NEAR(p.normal.dot(p.direction), 0, 1e-12);
    EXPECT_LE((mechanism.position(p.q) - p.start).norm(), 1e-12);
    const double gap = p.normal.dot(p.start - p.surface);
    EXPECT_GE(gap, 0.002 - 1e-12);
    EXPECT_LE(gap, 0.006 + 1e-12);
    const ph::task_vector<M> v = ph::jacobian(mechanism, p.q) * p.qd;
    EXPECT_NEAR(v.dot(p.direction), d.hand.speed, 1e-9);
    EXPECT_LT(v.dot(p.normal), -0.05 + 1e-9) << "towards the wall";
    EXPECT_GE(ph::max_cosine(mechanism, p.q, p.direction, p.normal), where.min_cosine);
    EXPECT_NEAR(d.run.path_end, p.direction.dot(p.start) + where.path_length, 1e-12);
  }
}

TEST(random_plane, can_be_followed_and_felt_where_it_begins) {
  expect_a_way(tendon(), space);
  expect_a_way(ph::delta<double>(), {{-0.2, -0.2, -0.2}, {1.1, 1.1, 1.1}, 0.05});
  expect_a_way(ph::xy_table<double>(), {{-0.1, -0.1}, {0.1, 0.1}, 0.1, 0.1});
}

// A table's normal along y, its way along x: only brake y has a force along the normal, and it holds if
// the handle does not move; along a slant the brake that is overtaken does.
TEST(random_plane, best_cosine_is_that_of_the_nearest_reference_force) {
  const ph::xy_table<double> table;
  const ph::vector<double, 2> slant = ph::vector<double, 2>(0.8, -0.6), normal(0.6, 0.8);
  EXPECT_NEAR(ph::max_cosine<ph::xy_table<double>>(table, {0, 0}, slant, normal), 0.8, 1e-12);
  EXPECT_NEAR(ph::max_cosine<ph::xy_table<double>>(table, {0, 0}, -slant, normal), 0.6, 1e-12);
}

TEST(random_plane, reports_that_there_is_none) {
  ph::workspace<tendon> out = space;
  out.max_condition = 1;
  std::mt19937_64 bits(1);
  EXPECT_THROW(ph::draw_plane(tendon(), out, 0.1, 0.004, 0.1, bits), std::invalid_argument);
}

// A torque of a turning brake is a force of a sliding one, at the radius of the workspace.
TEST(random_device, of_slides_has_forces_and_lengths) {
  const auto turning = ph::draw_device(ph::xy_table<double>(), {{-0.1, -0.1}, {0.1, 0.1}, 0.1, 1.0}, 3, 4);
  const auto sliding = ph::draw_device(ph::xy_table<double>(), {{-0.1, -0.1}, {0.1, 0.1}, 0.1, 0.1}, 3, 4);
  EXPECT_NEAR(sliding.brakes[0].torque_limit, 10 * turning.brakes[0].torque_limit, 1e-12);
  EXPECT_NEAR(sliding.brakes[1].residual.strength, 10 * turning.brakes[1].residual.strength, 1e-12);
  EXPECT_NEAR(sliding.known_brakes.rate_dead_band[0], 0.1 * turning.known_brakes.rate_dead_band[0], 1e-15);
  EXPECT_NEAR(sliding.run.encoder_resolution, 0.1 * turning.run.encoder_resolution, 1e-15);
}

}  // namespace
