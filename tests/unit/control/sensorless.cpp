// slow, optimised
// Without a force sensor: the probe on paper, and simulated hands that want to leave a wall.
#include "../support.hpp"

#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/control/sensorless/sensorless_controller.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/simulated_device.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace {

// ---- the probe

using probe = ph::release_probe<2>;
using phase = probe::phase;
constexpr ph::release_probe_parameters quick{
    .probe_period = 0.1, .probe_time = 0.05, .motion_threshold = 1e-5};
const ph::point<2> out(0, -1);

struct handle {
  probe p{quick};
  phase at(double time, double outward, double rest) {
    return p.update(time, {0.3, 0.2 - outward}, out, rest);
  }
};

TEST(release_probe, waits_for_the_rest_and_ends_when_nothing_moves) {
  handle h;
  EXPECT_EQ(h.at(0, 0, 0), phase::watching);
  EXPECT_EQ(h.at(0.05, 0, 0.05), phase::watching);
  EXPECT_EQ(h.at(0.1, 0, 0.1), phase::probing);
  EXPECT_EQ(h.at(0.12, 0.9e-5, 0.12), phase::probing) << "less than the threshold";
  EXPECT_EQ(h.at(0.149, -0.9e-5, 0.14), phase::probing);
  EXPECT_EQ(h.at(0.151, 0, 0.15), phase::watching);
}

TEST(release_probe, holds_again_when_the_handle_sinks) {
  handle h;
  h.at(0.1, 0, 0.1);
  EXPECT_EQ(h.at(0.11, -1.1e-5, 0), phase::watching);
}

TEST(release_probe, stays_released_until_the_handle_moves_in_again) {
  handle h;
  h.at(0.1, 0, 0.1);
  EXPECT_EQ(h.at(0.11, 1.1e-5, 0), phase::released);
  EXPECT_EQ(h.at(5, 1e-3, 0), phase::released);
  EXPECT_EQ(h.at(6, 1e-3 - 0.9e-5, 9), phase::released);
  EXPECT_EQ(h.at(7, 1e-3 - 1.1e-5, 0), phase::watching) << "from the farthest point out";
}

TEST(release_probe, forgets) {
  handle h;
  h.at(0.1, 0, 0.1);
  h.p.clear();
  EXPECT_EQ(h.p.now(), phase::watching);
  EXPECT_EQ(h.at(0.11, 1, 0), phase::watching);
}

TEST(release_probe, complains_of_its_times) {
  EXPECT_EQ(validate(quick), "");
  EXPECT_EQ(validate(ph::release_probe_parameters{.probe_time = 0}),
            "probe_time [s] = 0, expected a finite number > 0");
  EXPECT_THROW(probe({.probe_period = -1}), std::invalid_argument);
  EXPECT_DOUBLE_EQ(ph::max_release_time(quick), 0.2);
}

// ---- the controller

using device = ph::tendon_two_link<double>;
using state = ph::sensorless_device_state<device>;
const ph::half_space<2> wall({0, 0.225}, {0, -1});

template <class L>
auto controller_with(L law = {}, const ph::sensorless_parameters& p = {}) {
  return ph::sensorless_controller(device(), ph::brakes_of<device>(), ph::scene(ph::wall(wall)), law, p);
}

TEST(sensorless_controller, is_as_its_law_in_motion_and_releases_on_faults) {
  const device arm;
  auto control = controller_with(ph::no_direct_control());
  ph::controller plain(arm, ph::brakes_of<device>(), ph::scene(ph::wall(wall)), ph::no_direct_control());
  const auto q = arm.inverse({0.1, 0.226}, ph::elbow::left).q;
  for (int k = 0; k < 5; ++k) {
    const state now{k * 1e-3, q, {-0.3, 0.5}};
    EXPECT_EQ(control(now).capacity, plain(now).capacity);
  }
  EXPECT_GT(control(state{0.005, q, {-0.3, 0.5}}).capacity.norm(), 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const state& bad : {state{nan, q, {0, 0}}, state{0, {nan, 0}, {0, 0}}, state{0, q, {0, nan}}}) {
    const auto result = control(bad);
    EXPECT_NE(result.outcome, ph::status::ok);
    EXPECT_TRUE(result.capacity.isZero(0));
  }
  EXPECT_EQ(control(state{0.007, q, {-0.3, 0.5}}).outcome, ph::status::ok);
  for (const double time : {0.007, 0.001, 0.001}) {  // it stands still, goes back, and stands still
    const auto result = control(state{time, q, {-0.3, 0.5}});
    EXPECT_EQ(result.outcome, ph::status::time_not_rising);
    EXPECT_TRUE(result.capacity.isZero(0));
  }
  EXPECT_EQ(control(state{0.002, q, {-0.3, 0.5}}).outcome, ph::status::ok);
}

// Held at rest inside: both brakes hold, are probed, and hold again as nothing moves.
TEST(sensorless_controller, probes_brakes_that_hold) {
  const device arm;
  const ph::sensorless_parameters p{.observer = {}, .probe = quick};
  auto control = controller_with(ph::direct_control(), p);
  const auto q = arm.inverse({0.1, 0.226}, ph::elbow::left).q;
  int told_0 = 0;
  for (int k = 0; k < 1000; ++k) {
    const auto result = control(state{k * 1e-3, q, {0, 0}});
    ASSERT_EQ(result.outcome, ph::status::ok);
    EXPECT_TRUE(result.signs.isZero(0));
    const bool probing = control.probing() == phase::probing;
    EXPECT_TRUE(result.capacity.isZero(0) || !probing);
    EXPECT_TRUE(probing || result.capacity.norm() > 0);
    told_0 += probing ? 1 : 0;
  }
  EXPECT_NEAR(told_0, 1000 * 0.05 / 0.15, 30);
}

// After a probe brakes are told more than the law commands, in contact alone.
TEST(sensorless_controller, makes_up_for_what_a_probe_took) {
  const device arm;
  const ph::sensorless_parameters p{.observer = {}, .probe = quick};
  const ph::no_direct_control law;
  const auto soft = ph::scene(ph::wall(wall, 1000.0));  // 1 N at 1 mm: below the limits
  ph::sensorless_controller control(arm, ph::brakes_of<device>(), soft, law, p);
  ph::controller plain(arm, ph::brakes_of<device>(), soft, law);
  const auto inside = arm.inverse({0.1, 0.226}, ph::elbow::left).q;
  const auto outside = arm.inverse({0.1, 0.2}, ph::elbow::left).q;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  int made_up = 0;
  bool probed = false;
  for (int k = 0; k < 1000; ++k) {
    const bool probes = control.probing() == phase::probing;
    auto again = control;
    EXPECT_TRUE(again(state{k * 1e-3, outside, {0, 0}}).capacity.isZero(0));
    again = control;
    EXPECT_TRUE(again(state{k * 1e-3, inside, {nan, 0}}).capacity.isZero(0));
    const auto result = control(state{k * 1e-3, inside, {0, 0}});
    if (control.probing() == phase::probing) continue;
    const Eigen::Vector2d wanted = plain(state{k * 1e-3, inside, {0, 0}}).capacity;
    EXPECT_TRUE((result.capacity.array() >= wanted.array()).all());
    if (probes) probed = true;
    made_up += (result.capacity.array() > wanted.array()).any();
    EXPECT_TRUE(probed || result.capacity == wanted);
  }
  EXPECT_GT(made_up, 5);
  EXPECT_LT(made_up, 300);
}

// Slipping all the time, after free space and after a reset as well.
TEST(sensorless_controller, probes_no_brake_that_slips) {
  const device arm;
  auto control = controller_with(ph::no_direct_control(), {.observer = {}, .probe = quick});
  const auto inside = arm.inverse({0.1, 0.226}, ph::elbow::left).q;
  const auto outside = arm.inverse({0.1, 0.2}, ph::elbow::left).q;
  double time = 0;
  const auto slide = [&] {
    for (int k = 0; k < 300; ++k, time += 1e-3) {
      EXPECT_GT(control(state{time, inside, {-0.3, 0.5}}).capacity.norm(), 0);
      ASSERT_EQ(control.probing(), phase::watching) << time;
    }
  };
  slide();
  control(state{time, outside, {0, 0}});
  time += 1e-3;
  slide();
  control.reset();
  slide();
  control(state{time, inside, {0, 0}});
  control.reset();
  time = 0;  // before it was at rest
  slide();
}

// The motion before a reset is none of the hand's after it.
TEST(sensorless_controller, knows_of_no_hand_after_a_reset) {
  const device arm;
  auto control = controller_with(ph::no_direct_control());
  const auto outside = arm.inverse({0.1, 0.2}, ph::elbow::left).q;
  for (int k = 0; k < 20; ++k) control(state{k * 1e-3, outside, {-0.02 * k, 0.03 * k}});
  EXPECT_GT(control.hand().force.norm(), 0.1);
  control.reset();
  control(state{0.02, outside, {-0.4, 0.6}});
  EXPECT_TRUE(control.hand().force.isZero(0)) << control.hand().force.transpose();
}

TEST(sensorless_controller, takes_any_state_and_reads_no_force) {
  const device arm;
  auto one = controller_with(ph::direct_control()), other = controller_with(ph::direct_control());
  const auto q = arm.inverse({0.1, 0.226}, ph::elbow::left).q;
  for (int k = 0; k < 20; ++k) {
    const Eigen::Vector2d qd(0.3, -0.5 + 0.02 * k);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto a = one(state{k * 1e-3, q, qd});
    const auto b = other(ph::device_state<device>{k * 1e-3, q, qd, {nan, nan}});
    EXPECT_EQ(a.capacity, b.capacity);
    EXPECT_EQ(b.outcome, ph::status::ok);
  }
}

// ---- a simulated hand that presses on the wall, and then wants to leave

struct escape {
  double depth_at_reversal = 0, max_depth = 0;
  double to_release =
      -1;  // from the reversal until the probe released the brakes for good, or the handle was out
  double to_leave = -1;  // until the handle was out; -1 if it never was
};

template <class Control>
escape press_and_pull(Control& control, double press, double pull, double along, double reversal) {
  const device arm;
  ph::brakes_of<device> brakes;
  ph::simulated_device<device> handle(arm, brakes, 0.5, arm.inverse({0.1, 0.224}, ph::elbow::left).q);
  const double dt = 1e-4;
  Eigen::Vector2d told(0, 0);
  escape found;
  bool released = false;
  for (int k = 0; k * dt < reversal + 3; ++k) {
    const double time = k * dt;
    const bool leaves = time >= reversal;
    if (k % 10 == 0) {
      told = control(state{time, handle.q(), handle.qd()}).capacity;
      if constexpr (requires { control.probing(); }) {
        if (leaves && !released && control.probing() == phase::released) found.to_release = time - reversal;
        released = leaves && control.probing() == phase::released;
      }
    }
    // Fingers damp what they hold
    const Eigen::Vector2d wish =
        Eigen::Vector2d(leaves ? 0 : along, leaves ? -pull : press) - 5.0 * handle.velocity();
    handle.advance(dt, told, wish);
    const double depth = -wall.distance(handle.position());
    if (!leaves) found.depth_at_reversal = depth;
    found.max_depth = std::max(found.max_depth, depth);
    if (leaves && depth < 0) {
      found.to_leave = time - reversal;
      if (found.to_release < 0) found.to_release = found.to_leave;
      break;
    }
  }
  return found;
}

template <class L>
struct sensorless_escape : ::testing::Test {};
using laws = tested_types<ph::no_direct_control, ph::direct_control, ph::velocity_direct_control>;
TYPED_TEST_SUITE(sensorless_escape, laws);

TYPED_TEST(sensorless_escape, is_within_the_stated_time) {
  const ph::sensorless_parameters p;
  const double stated = ph::max_release_time(p.probe);
  double worst_release = 0, worst_leave = 0, max_depth = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    ph::testing::random_source random(seed);
    const double press = random.uniform(0.5, 3.0), along = random.uniform(-1.0, 1.0);
    const double reversal = random.uniform(0.3, 1.5);
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", press " << press << " N, along " << along
                                      << " N, reversal at " << reversal << " s");
    auto control = controller_with(TypeParam(), p);
    const escape e = press_and_pull(control, press, 1.0, along, reversal);
    EXPECT_GT(e.max_depth, 0);
    ASSERT_GE(e.to_leave, 0) << "locked inside";
    EXPECT_LE(e.to_release, stated);
    // 1 N moves handle and hand, less than 1.5 kg, out of this depth; twice for what the brakes lag
    EXPECT_LE(e.to_leave, stated + 2 * std::sqrt(2 * e.max_depth * 1.5) + 0.06);
    worst_release = std::max(worst_release, e.to_release);
    worst_leave = std::max(worst_leave, e.to_leave);
    max_depth = std::max(max_depth, e.max_depth);
  }
  std::printf("released within %.3f s (stated %.3f), out within %.3f s, deepest %.2f mm\n", worst_release,
              stated, worst_leave, 1e3 * max_depth);
}

// What the probe is for: without it and without a sensor the brakes hold the hand inside for good.
TEST(sensorless_escape_without_probe, never_ends) {
  const device arm;
  ph::controller control(arm, ph::brakes_of<device>(), ph::scene(ph::wall(wall)), ph::no_direct_control());
  EXPECT_LT(press_and_pull(control, 2, 1, 0, 0.5).to_leave, 0);
}

// A hand that only presses sinks by its probes; this is how much. [mm/s]
template <class L>
double sinking() {
  const auto depth_after = [](double time) {
    auto control = controller_with(L());
    return press_and_pull(control, 2, 1, 0, time).depth_at_reversal;
  };
  const double two = depth_after(2), rate = (depth_after(10) - two) / 8;
  std::printf("pressed with 2 N: %.2f mm deep after 2 s, then %.3f mm/s\n", 1e3 * two, 1e3 * rate);
  return 1e3 * rate;
}

TEST(sensorless_pressing, sinks_slowly) { EXPECT_LT(sinking<ph::direct_control>(), 0.15); }
// A law that counts on what its brakes make: 1.2 mm/s unless they make up for what a probe took
TEST(sensorless_pressing, sinks_slowly_under_a_law_that_inverts_the_brakes_lag) {
  EXPECT_LT(sinking<ph::velocity_direct_control>(), 0.3);
}

}  // namespace
