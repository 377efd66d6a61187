// A scene that is sampled more slowly than it is asked.
#include "../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/shapes/moving.hpp>

#include <limits>

namespace {

const auto walls = ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}), 1.0));

// The depth that the held scene shows at a time when the true one is `depth`.
template <class Held>
double shown(Held& held, double depth, double time) {
  const auto& touched = sense(held, {0, -depth}, time);
  return touched.empty() ? 0 : touched[0].depth;
}

// 20 Hz against 1 kHz, times as a loop makes them (a multiple, or a sum that gathers rounding).
TEST(held_scene, samples_every_fiftieth_cycle_without_drift) {
  for (const bool summed : {false, true}) {
    ph::held_scene held(walls, 0.05);
    double sum = 0;
    for (int k = 0; k < 100000; ++k) {
      const double time = summed ? sum : k * 1e-3;
      const double cycle = k + 1;  // a depth that tells the cycles apart
      ASSERT_EQ(shown(held, cycle, time), cycle - k % 50) << "cycle " << k << (summed ? ", summed" : "");
      sum += 1e-3;
    }
  }
}

TEST(held_scene, has_another_margin_from_its_next_sample_on) {
  ph::held_scene held(walls, 1.0);
  EXPECT_EQ(shown(held, -0.5, 0), 0);
  held.set_margin(0.75);
  EXPECT_EQ(shown(held, -0.5, 0.5), 0);
  EXPECT_EQ(shown(held, -0.5, 1), -0.5);
}

TEST(held_scene, a_hair_before_the_period_is_the_period_but_a_millionth_is_not) {
  ph::held_scene held(walls, 1.0);
  EXPECT_EQ(shown(held, 1, 0), 1);
  EXPECT_EQ(shown(held, 2, 1 - 1e-6), 1);
  EXPECT_EQ(shown(held, 3, 1 - 1e-12), 3);
  EXPECT_EQ(shown(held, 4, 2.4), 4);
  EXPECT_EQ(shown(held, 5, 3.1), 4) << "the period counts from the last sample";
  EXPECT_EQ(shown(held, 6, 3.4), 6);
}

TEST(held_scene, period_zero_samples_every_time) {
  ph::held_scene held(walls, 0);
  double depth = 0;
  for (const double time : {0.0, 0.0, 1e-9, 5.0, 5.0}) EXPECT_EQ(shown(held, ++depth, time), depth) << time;
}

TEST(held_scene, samples_anew_where_time_runs_backwards) {
  ph::held_scene held(walls, 1.0);
  EXPECT_EQ(shown(held, 1, 100), 1);
  EXPECT_EQ(shown(held, 2, -1e6), 2);
  EXPECT_EQ(shown(held, 3, -1e6 + 0.5), 2);
  EXPECT_EQ(shown(held, 4, -1e6 + 1), 4);
}

// As a law carries a contact on by what the handle moved since, it does so by what the wall moved.
TEST(held_scene, carries_where_it_was_sensed_along_with_a_wall_that_moves) {
  ph::moving floor(ph::half_space<2>({0, 0}, {0, 1}));
  floor.set_motion({0, 0}, {2, 3});
  ph::held_scene held(ph::scene(ph::wall(floor)), 1.0);
  for (const double time : {0.0, 0.25, 0.75, 0.5})
    EXPECT_EQ(sense(held, {5, -1}, 10 + time)[0].sensed_at, ph::point<2>(5 + 2 * time, -1 + 3 * time));
  EXPECT_EQ(sense(held, {6, -1}, 11)[0].sensed_at, ph::point<2>(6, -1));
}

TEST(held_scene, recovers_from_a_time_that_is_not_finite) {
  ph::held_scene held(walls, 1.0);
  shown(held, 1, std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(shown(held, 2, 0), 2);
  EXPECT_EQ(shown(held, 3, 0.5), 2);
}

// The controller keeps faulty states from the held scene: the next good cycle sees what was held before.
TEST(held_scene, is_not_shown_a_state_that_is_not_finite) {
  using M = ph::xy_table<double>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(100);
  ph::controller control(M(), brakes, ph::held_scene(walls, 1.0), ph::no_direct_control{});
  const auto depth = [&](double time, double y) {
    const auto result = control(ph::device_state<M>{time, {0, y}, {0, 0}, {0, 0}});
    return result.outcome == ph::status::ok ? result.desired_force.norm() : -1;
  };
  EXPECT_DOUBLE_EQ(depth(0, -3), 3);
  EXPECT_EQ(depth(nan, -4), -1);
  EXPECT_EQ(depth(0.3, nan), -1);
  EXPECT_EQ(depth(2.0, nan), -1) << "would have been a sampling instant";
  EXPECT_DOUBLE_EQ(depth(0.5, -5), 3);
  EXPECT_DOUBLE_EQ(depth(1.0, -6), 6);
}

}  // namespace
