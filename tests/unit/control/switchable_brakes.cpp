// Cycles of brakes that are off or work one way, under every law.
#include "../support.hpp"
#include "polar_arm.hpp"
#include "random_intervals.hpp"

#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace {

using planar = ph::tendon_two_link<double>;
constexpr double any_torque = std::numeric_limits<double>::infinity();

// Brakes of each kind, poses, rates and hands at random, at one wall or two that meet; cycles follow each
// other under the same memory.
template <class L, class M>
void expect_no_torque_that_a_brake_cannot_make(const M& mechanism) {
  ph::testing::random_source random(20040627);
  int working = 0, beside_one_off = 0;
  for (int run = 0; run < 150; ++run) {
    SCOPED_TRACE(::testing::Message() << "seed 20040627, run " << run);
    const ph::vector<double, 2> q(random.uniform(-1.0, 2.0), random.uniform(0.5, 1.5));
    const ph::point<2> x = mechanism.position(q), n = random.direction<double, 2>();
    ph::contacts<2, 2> touched;
    touched.push_back({.normal = n, .depth = 2e-3, .stiffness = 1e5, .wall_number = 0, .sensed_at = x});
    if (random.coin())
      touched.push_back({.normal = ph::point<2>(-n[1], n[0]),
                         .depth = 3e-3,
                         .stiffness = 1e4,
                         .wall_number = 1,
                         .sensed_at = x});
    ph::step_memory<L> memory;
    for (int cycle = 0; cycle < 4; ++cycle) {
      const auto brakes = random_brakes<M>(random);
      ph::device_state<M> state{1e-3 * cycle, q, 0.5 * random.normal_vector<double, 2>(),
                                random.normal_vector<double, 2>()};
      if (random.coin()) state.qd[0] = 0;
      if (random.coin()) state.hand_force.setZero();
      const auto result = ph::step(mechanism, brakes, touched, L(), state, memory);
      ASSERT_EQ(result.outcome, ph::status::ok);
      const ph::brake_vector<M> w = ph::brake_rates(mechanism, state.q, state.qd);
      expect_within_intervals<M>(brakes, result, w);
      if (::testing::Test::HasFatalFailure()) return;
      const bool works = (result.capacity.array() > 0).any();
      working += works ? 1 : 0;
      beside_one_off += works && (brakes.torque_lower.array() == brakes.torque_upper.array()).any() ? 1 : 0;
      if (!ph::TorqueLaw<L> && touched.size() == 1) {
        ASSERT_GE(result.control_force.dot(n), 0.0) << "pulls into the wall";
      }
    }
  }
  EXPECT_GT(working, 40);
  EXPECT_GT(beside_one_off, 5);
}

// Arms whose self-motion settles: settled_brakes_off.cpp.
TEST(switchable_brakes, make_no_torque_beyond_their_intervals) {
  expect_no_torque_that_a_brake_cannot_make<ph::velocity_direct_control>(planar());
  expect_no_torque_that_a_brake_cannot_make<ph::on_off_control>(planar());
  expect_no_torque_that_a_brake_cannot_make<ph::direct_control>(polar_arm());
  expect_no_torque_that_a_brake_cannot_make<ph::velocity_direct_control>(polar_arm());
}

// Intervals that cut nothing.
TEST(switchable_brakes, that_are_all_on_are_brakes_without_an_interval_to_the_bit) {
  const polar_arm mechanism;
  ph::testing::random_source random(7);
  const ph::brakes_of<polar_arm> plain;
  const ph::switchable_brakes<polar_arm> all_on = plain;
  const ph::vector<double, 2> q(0.7, 1.1);
  ph::contacts<2, 2> touched;
  touched.push_back(
      {.normal = {0.6, 0.8}, .depth = 1e-3, .stiffness = 1e4, .sensed_at = mechanism.position(q)});
  const auto step = [&](const auto& brakes, const auto& state) {
    ph::step_memory<ph::direct_control> memory;
    return ph::step(mechanism, brakes, touched, ph::direct_control(), state, memory);
  };
  for (int k = 0; k < 200; ++k) {
    const auto state =
        state_of<polar_arm>(q, random.normal_vector<double, 2>(), random.normal_vector<double, 2>());
    const auto a = step(plain, state), b = step(all_on, state);
    ASSERT_EQ(a.outcome, b.outcome);
    ASSERT_EQ(a.capacity, b.capacity);
    ASSERT_EQ(a.torque, b.torque);
    ASSERT_EQ(a.signs, b.signs);
    ASSERT_EQ(a.cone_coefficients, b.cone_coefficients);
    ASSERT_EQ(a.saturated, b.saturated);
  }
}

// 2 mm in a wall of 1 kN/m, whichever of three brakes is switched off while it holds the push, and on again.
TEST(switchable_brakes, of_which_one_is_switched_off_while_it_holds_leave_its_force_to_the_others) {
  const polar_arm mechanism;
  const ph::vector<double, 2> q(0.7, 0.2);
  const auto G = ph::force_generators(mechanism, q);
  int taken_over = 0;
  for (int k = 0; k < 48; ++k) {
    SCOPED_TRACE(::testing::Message() << "direction " << k / 3 << ", brake " << k % 3);
    const double angle = 2 * 3.141592653589793 * (k / 3) / 16;
    const int off = k % 3;
    const ph::point<2> n(std::cos(angle), std::sin(angle)), along(-n[1], n[0]);
    const ph::matrix<double, 2, 2> J(ph::jacobian(mechanism, q));
    const auto state = state_of<polar_arm>(q, J.inverse() * (0.05 * along - 0.02 * n), -3 * n);
    ph::switchable_brakes<polar_arm> brakes;
    brakes.torque_limit.setConstant(100);
    brakes.rate_dead_band.setConstant(1e-9);
    ph::contacts<2, 2> touched;
    touched.push_back({.normal = n, .depth = 2e-3, .stiffness = 1e3});
    ph::step_memory<ph::direct_control> memory;
    const auto next = [&] {
      const auto result = ph::step(mechanism, brakes, touched, ph::direct_control(), state, memory);
      if (ph::is_displayed(result.display)) {
        EXPECT_NEAR((G * result.torque).dot(n), 2, 1e-9);
      }
      return result.capacity;
    };
    const auto before = next();
    brakes.switch_off(off);
    const auto after = next();
    EXPECT_EQ(after[off], 0);
    EXPECT_TRUE(before[off] > 0 || after == before) << "what did nothing is not missed";
    brakes.switch_on(off);
    EXPECT_EQ(next(), before) << "on again";
    taken_over += before[off] > 0 && !after.isZero(0);
  }
  EXPECT_GT(taken_over, 10);
}

TEST(switchable_brakes, that_work_one_way_have_its_sign_at_rest) {
  ph::switchable_brakes<planar> brakes;
  brakes.make_positive(0);
  brakes.make_negative(1);
  const ph::vector<double, 2> rest(0, 0), turning(1, 1), other(-1, -1);
  EXPECT_EQ(ph::signs_within(rest, brakes), (ph::vector<double, 2>(-1, 1)));
  EXPECT_EQ(ph::signs_within(turning, brakes), turning);
  EXPECT_EQ(ph::brakes_off(turning, brakes), (ph::vector<double, 2>(1, 0)));
  EXPECT_EQ(ph::brakes_off(other, brakes), (ph::vector<double, 2>(0, 1)));
  brakes.switch_on(0);
  brakes.switch_off(1);
  EXPECT_EQ(ph::signs_within(rest, brakes), rest);
  EXPECT_EQ(ph::brakes_off(rest, brakes), (ph::vector<double, 2>(0, 1)));
  brakes.torque_limit[0] = 0;
  EXPECT_EQ(ph::brakes_off(rest, brakes), (ph::vector<double, 2>(1, 1)));
}

TEST(switchable_brakes, are_cut_each_to_its_own_interval) {
  ph::switchable_brakes<planar> brakes;
  brakes.torque_limit = {2, 2};
  brakes.torque_lower = {-0.5, -any_torque};
  brakes.torque_upper = {1, 4};
  using V = ph::vector<double, 2>;
  const auto each = [&](const V& t) {
    return ph::within_limits(t, brakes, ph::saturation::clamp_each).torque;
  };
  EXPECT_EQ(each({-3, -3}), V(-0.5, -2));
  EXPECT_EQ(each({3, 3}), V(1, 2));
  const auto together = ph::within_limits(V(-1, 1), brakes, ph::saturation::keep_direction);
  EXPECT_EQ(together.torque, V(-0.5, 0.5));
  EXPECT_TRUE(together.limited);
  EXPECT_TRUE(ph::any_at_limit(V(-0.5, 0), brakes));
  EXPECT_FALSE(ph::any_at_limit(V(0.5, 0), brakes));
  EXPECT_EQ((ph::max_torques_of<double, 2>(brakes)), V(1, 2)) << "the longer way, within the limit";
  brakes.switch_off(1);
  EXPECT_FALSE(ph::any_at_limit(V(0, 0), brakes));
  const auto box = ph::torque_box_of(V(-1, 0), brakes);
  EXPECT_EQ(box.lower, V(0, 0));
  EXPECT_EQ(box.upper, V(1, 0));
  const auto cone = ph::unbounded_torque_box_of(V(1, 0), brakes);
  EXPECT_EQ(cone.lower, V(-any_torque, 0));
  EXPECT_EQ(cone.upper, V(0, 0));
}

TEST(switchable_brakes, say_what_is_wrong_with_their_interval) {
  ph::switchable_brakes<planar> brakes;
  EXPECT_EQ(ph::validate(brakes), "");
  EXPECT_EQ(ph::check_brakes(brakes), "");
  brakes.torque_upper[1] = -1;
  EXPECT_EQ(ph::check_brakes(brakes),
            "torque_upper[1] [N m] = -1: expected a number >= 0, or inf for no bound");
  brakes.torque_lower[0] = 2;
  EXPECT_EQ(ph::validate(brakes), "torque_lower[0] [N m] = 2: expected a number <= 0, or -inf for no bound");
  EXPECT_EQ(ph::check_brakes(brakes), ph::validate(brakes));
}

TEST(switchable_brakes, that_become_invalid_release_all) {
  const planar arm;
  const ph::vector<double, 2> q(0.7, 1.1);
  const ph::point<2> x = arm.position(q);
  ph::switchable_brakes<planar> brakes;
  ph::controller control(arm, brakes,
                         ph::scene(ph::wall(ph::half_space<2>(x + ph::point<2>(0, 1e-3), {0, 1}))),
                         ph::direct_control());
  const ph::device_state<planar> state{0, q, {0.1, -0.3}, {0, -1}};
  EXPECT_EQ(control(state).outcome, ph::status::ok);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 0.1}) {
    brakes.torque_lower[1] = bad;
    control.set_brakes(brakes);
    EXPECT_EQ(control(state).outcome, ph::status::parameters_invalid) << bad;
    EXPECT_TRUE(control(state).capacity.isZero(0));
  }
  brakes.switch_on(1);
  control.set_brakes(brakes);
  EXPECT_EQ(control(state).outcome, ph::status::ok);
  EXPECT_EQ(control.brakes().torque_upper[1], any_torque);
}

}  // namespace
