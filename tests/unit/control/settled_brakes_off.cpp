// slow
// Brakes of arms with self-motion that are off or work one way: a brake that is off is one that is left out.
#include "arm_of_rods.hpp"

#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/control/laws/saturated_direct_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/control/pipelines/with_effects.hpp>
#include <passive_haptics/design/displayable.hpp>
#include <passive_haptics/force/effects/viscous_field.hpp>
#include <passive_haptics/mechanism/adaptors/braked_joints.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace ph = passive_haptics;

namespace {

constexpr unsigned seed_of_brakes_off = 20040627;

// Numbers from 0 to N - 1 but Off.
template <int N, int Off>
struct without {
  template <class M, int... I>
  static auto leave_out(const M& arm, std::integer_sequence<int, I...>) {
    return ph::braked_joints<M, (I < Off ? I : I + 1)...>(arm);
  }
  template <class M>
  static auto of(const M& arm) {
    return leave_out(arm, std::make_integer_sequence<int, N - 1>());
  }
  template <class V>
  static ph::vector<double, N - 1> of_vector(const V& all) {
    ph::vector<double, N - 1> some;
    for (int i = 0; i < N - 1; ++i) some[i] = all[i < Off ? i : i + 1];
    return some;
  }
};

// A state that moves into walls.
template <class M, int Walls>
struct case_of {
  ph::device_state<M> state;
  ph::contacts<2, Walls> touched;

  case_of(const M& arm, ph::testing::random_source& random) {
    state.time = 0;
    state.q = random.normal_vector<double, M::dof>();
    state.qd = random.normal_vector<double, M::dof>();
    state.hand_force = random.normal_vector<double, 2>();
    for (int j = 0; j < Walls; ++j)
      touched.push_back({.normal = random.direction<double, 2>(),
                         .depth = random.positive(1e-4, 1e-2),
                         .stiffness = 1000,
                         .wall_number = j,
                         .sensed_at = arm.position(state.q)});
  }
};

template <class Wide, class Narrow>
ph::device_state<Narrow> same_state(const ph::device_state<Wide>& wide) {
  ph::device_state<Narrow> state;
  state.time = wide.time;
  state.q = wide.q;
  state.qd = wide.qd;
  state.hand_force = wide.hand_force;
  return state;
}

// One brake is off; the arm without this brake is the measure.
template <int Walls, int N, int Off>
void expect_as_without() {
  SCOPED_TRACE(::testing::Message() << "seed " << seed_of_brakes_off << ", brake " << Off << " of " << N
                                    << " is off");
  const auto arm = arms::of_rods<N>();
  const auto light = without<N, Off>::of(arm);
  using M = std::remove_cvref_t<decltype(arm)>;
  using L = std::remove_cvref_t<decltype(light)>;
  ph::switchable_brakes<M> brakes;
  brakes.torque_limit.setConstant(2);
  brakes.switch_off(Off);
  ph::brakes_of<L> left;
  left.torque_limit.setConstant(2);
  ph::testing::random_source random(seed_of_brakes_off);
  int displayed = 0;
  for (int k = 0; k < 300; ++k) {
    const case_of<M, Walls> c(arm, random);
    ph::step_memory<ph::direct_control> memory, memory_of_light;
    const auto some = ph::step(arm, brakes, c.touched, ph::direct_control(), c.state, memory);
    const auto all =
        ph::step(light, left, c.touched, ph::direct_control(), same_state<M, L>(c.state), memory_of_light);
    ASSERT_EQ(some.outcome, ph::status::ok);
    ASSERT_EQ(some.display, all.display) << "case " << k;
    ASSERT_EQ(some.capacity[Off], 0.0);
    ASSERT_EQ(some.torque[Off], 0.0);
    ASSERT_EQ(some.cone_coefficients[Off], 0.0);
    displayed += ph::is_displayed(some.display) ? 1 : 0;
    ASSERT_LT((some.control_force - all.control_force).norm(),
              1e-12 * std::max(1.0, all.control_force.norm()));
    ASSERT_LT((without<N, Off>::of_vector(some.capacity) - all.capacity).norm(), 1e-11);
  }
  EXPECT_GT(displayed, 15);
}

TEST(settled_brakes_off, have_the_force_of_an_arm_without_this_brake) {
  expect_as_without<1, 3, 1>();
  expect_as_without<1, 4, 3>();
  expect_as_without<2, 4, 0>();
}

// A limit of 0 is no brake for displayable().
template <int N, int Off>
void expect_displayable_without() {
  const auto arm = arms::of_rods<N>();
  const auto light = without<N, Off>::of(arm);
  using M = std::remove_cvref_t<decltype(arm)>;
  using L = std::remove_cvref_t<decltype(light)>;
  ph::brake_vector<M> limit = ph::brake_vector<M>::Constant(2);
  limit[Off] = 0;
  ph::testing::random_source random(seed_of_brakes_off);
  int displayed = 0;
  for (int k = 0; k < 200; ++k) {
    SCOPED_TRACE(::testing::Message()
                 << "seed " << seed_of_brakes_off << ", case " << k << ", brake " << Off);
    const auto q = random.normal_vector<double, N>();
    const auto v = random.direction<double, 2>(), n = random.direction<double, 2>();
    const auto some = ph::displayable(arm, q, v, n, limit);
    const auto all = ph::displayable(light, q, v, n, ph::brake_vector<L>(ph::brake_vector<L>::Constant(2)));
    ASSERT_EQ(some.outcome, ph::status::ok);
    ASSERT_EQ(some.display, all.display);
    ASSERT_FALSE(ph::contains(some.held, Off)) << "a brake that is off holds nothing";
    ASSERT_NEAR(some.angle, all.angle, 1e-9);
    if (!ph::is_displayed(all.display)) continue;
    ++displayed;
    ASSERT_NEAR(some.max_force, all.max_force, 1e-9 * (1 + all.max_force));
    ASSERT_NEAR(some.max_approximated_force, all.max_approximated_force,
                1e-9 * (1 + all.max_approximated_force));
  }
  EXPECT_GT(displayed, 15);
}

TEST(settled_brakes_off, a_limit_of_zero_is_off_for_displayable) {
  expect_displayable_without<3, 1>();
  expect_displayable_without<4, 3>();
}

// Brakes that are off or work one way, at random, from cycle to cycle.
template <class M>
ph::switchable_brakes<M> random_intervals(ph::testing::random_source& random) {
  ph::switchable_brakes<M> brakes;
  for (int i = 0; i < M::brake_count; ++i) {
    brakes.torque_limit[i] = random.positive(0.1, 10.0);
    switch (static_cast<int>(random.uniform(0.0, 6.0))) {
      case 0: brakes.switch_off(i); break;
      case 1:
      case 2: brakes.make_positive(i); break;
      case 3: brakes.make_negative(i); break;
      default: brakes.switch_on(i);
    }
  }
  return brakes;
}

template <class M>
void expect_within_their_intervals(const ph::switchable_brakes<M>& brakes, const ph::step_result<M>& result) {
  for (int i = 0; i < M::brake_count; ++i) {
    SCOPED_TRACE(::testing::Message() << "brake " << i);
    const double lower = std::max(-brakes.torque_limit[i], brakes.torque_lower[i]),
                 upper = std::min(brakes.torque_limit[i], brakes.torque_upper[i]);
    ASSERT_GE(result.torque[i], lower);
    ASSERT_LE(result.torque[i], upper);
    ASSERT_LE(result.capacity[i], std::max(-lower, upper));
    ASSERT_LE(result.signs[i] * result.torque[i], 0.0);
    ASSERT_LE(result.settled_signs[i] * result.cone_coefficients[i], 0.0);
    if (lower == 0) {
      ASSERT_GE(result.cone_coefficients[i], 0.0);
    }
    if (upper == 0) {
      ASSERT_LE(result.cone_coefficients[i], 0.0);
    }
    if (lower == 0 && upper == 0) {
      ASSERT_EQ(result.capacity[i], 0.0) << "it is off";
    }
  }
}

template <class L, int N>
void expect_no_torque_beyond() {
  const auto arm = arms::of_rods<N>();
  using M = std::remove_cvref_t<decltype(arm)>;
  ph::testing::random_source random(seed_of_brakes_off);
  int works = 0;
  constexpr int walls = ph::saturates_before_scaling<L> ? 1 : 2;
  for (int run = 0; run < 100; ++run) {
    ph::step_memory<L> memory;
    case_of<M, walls> c(arm, random);
    if (random.coin()) {
      const auto only = c.touched[0];
      c.touched = {};
      c.touched.push_back(only);
    }
    for (int cycle = 0; cycle < 4; ++cycle) {
      SCOPED_TRACE(::testing::Message()
                   << "seed " << seed_of_brakes_off << ", run " << run << ", cycle " << cycle);
      const auto brakes = random_intervals<M>(random);
      c.state.time = 1e-3 * cycle;
      c.state.qd = random.coin() ? ph::joint_vector<M>(ph::joint_vector<M>::Zero())
                                 : ph::joint_vector<M>(random.normal_vector<double, N>());
      const auto result = ph::step(arm, brakes, c.touched, L(), c.state, memory);
      ASSERT_EQ(result.outcome, ph::status::ok);
      expect_within_their_intervals<M>(brakes, result);
      if (::testing::Test::HasFatalFailure()) return;
      works += (result.capacity.array() > 0).any() ? 1 : 0;
    }
  }
  EXPECT_GT(works, 60);
}

TEST(settled_brakes_off, no_law_commands_a_torque_beyond_an_interval) {
  expect_no_torque_beyond<ph::direct_control, 4>();
  expect_no_torque_beyond<ph::saturated_direct_control, 3>();
  expect_no_torque_beyond<ph::velocity_direct_control, 4>();
  expect_no_torque_beyond<ph::on_off_control, 3>();
}

// What is displayed is made by torques of the intervals: with T = 1, J^T Fc = t, also of one-way brakes that
// come to rest.
TEST(settled_brakes_off, one_way_brakes_at_rest_hold_only_their_way) {
  const auto arm = arms::of_rods<4>();
  using M = std::remove_cvref_t<decltype(arm)>;
  ph::testing::random_source random(seed_of_brakes_off);
  int displayed = 0, one_way_at_rest = 0;
  for (int k = 0; k < 1000; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed_of_brakes_off << ", case " << k);
    const case_of<M, 1> c(arm, random);
    ph::step_memory<ph::direct_control> memory;
    const auto result =
        ph::step(arm, random_intervals<M>(random), c.touched, ph::direct_control(), c.state, memory);
    if (!ph::is_displayed(result.display)) continue;
    ++displayed;
    const ph::joint_vector<M> t = ph::jacobian(arm, c.state.q).transpose() * result.control_force;
    ASSERT_LT((t - result.cone_coefficients).norm(), 1e-11 * result.control_force.norm());
    for (int i = 0; i < M::brake_count; ++i)
      one_way_at_rest += ph::contains(memory.start.held, i) && result.settled_signs[i] != 0;
  }
  EXPECT_GT(displayed, 100);
  EXPECT_GT(one_way_at_rest, 15);
}

// Intervals that cut nothing change nothing.
TEST(settled_brakes_off, intervals_without_bounds_change_no_bit) {
  const auto arm = arms::of_rods<3>();
  using M = std::remove_cvref_t<decltype(arm)>;
  const ph::brakes_of<M> plain;
  const ph::switchable_brakes<M> open = plain;
  ph::testing::random_source random(seed_of_brakes_off);
  for (int k = 0; k < 100; ++k) {
    const case_of<M, 1> c(arm, random);
    ph::step_memory<ph::direct_control> first, second;
    const auto a = ph::step(arm, plain, c.touched, ph::direct_control(), c.state, first);
    const auto b = ph::step(arm, open, c.touched, ph::direct_control(), c.state, second);
    ASSERT_EQ(a.display, b.display);
    ASSERT_EQ(a.torque, b.torque);
    ASSERT_EQ(a.control_force, b.control_force);
  }
}

// A wall and a field: the brake that is off stays so.
TEST(settled_brakes_off, effects_do_not_command_it) {
  const auto arm = arms::of_rods<4>();
  using M = std::remove_cvref_t<decltype(arm)>;
  ph::testing::random_source random(seed_of_brakes_off);
  int works = 0;
  for (int k = 0; k < 100; ++k) {
    const case_of<M, 1> c(arm, random);
    const ph::point<2> x = arm.position(c.state.q), n = c.touched[0].normal;
    const auto scene = ph::with_effects(
        ph::scene(ph::wall(ph::half_space<2>(x + 1e-3 * n, n), 1000)),
        ph::viscous_field<double, 2>({.viscosity = 3 * ph::matrix<double, 2, 2>::Identity()}));
    ph::switchable_brakes<M> brakes;
    brakes.switch_off(k % 4);
    ph::controller control(arm, brakes, scene, ph::direct_control());
    const auto result = control(c.state);
    ASSERT_EQ(result.outcome, ph::status::ok);
    ASSERT_EQ(result.capacity[k % 4], 0.0);
    works += (result.capacity.array() > 0).any() ? 1 : 0;
  }
  EXPECT_GT(works, 30);
}

}  // namespace
