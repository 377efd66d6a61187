// slow
// Brakes of arms with self-motion that are off or work one way: a brake that is off is one that is left out.
#include "arm_of_rods.hpp"
#include "random_intervals.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/saturated_direct_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/control/pipelines/with_effects.hpp>
#include <passive_haptics/design/displayable.hpp>
#include <passive_haptics/force/effects/viscous_field.hpp>
#include <passive_haptics/mechanism/adaptors/braked_joints.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ph = passive_haptics;

namespace {

constexpr unsigned seed_of_brakes_off = 20040627;

using arm_3 = arms::arm<3>;
using two_of_three = ph::braked_joints<arm_3, 0, 2>;
constexpr int off = 1;  // the brake that this arm lacks

// A state that moves into walls.
template <class M, int Walls>
struct case_of {
  ph::device_state<M> state;
  ph::contacts<2, Walls> touched;

  case_of(const M& arm, ph::testing::random_source& random) {
    state = {0, random.normal_vector<double, M::dof>(), random.normal_vector<double, M::dof>(),
             random.normal_vector<double, 2>()};
    for (int j = 0; j < Walls; ++j)
      touched.push_back({.normal = random.direction<double, 2>(),
                         .depth = random.positive(1e-4, 1e-2),
                         .stiffness = 1000,
                         .wall_number = j,
                         .sensed_at = arm.position(state.q)});
  }
};

// One brake is off; the arm without this brake is the measure.
template <int Walls>
void expect_as_without() {
  const auto arm = arms::of_rods<3>();
  const two_of_three light(arm);
  ph::switchable_brakes<arm_3> brakes;
  brakes.torque_limit.setConstant(2);
  brakes.switch_off(off);
  ph::brakes_of<two_of_three> left;
  left.torque_limit.setConstant(2);
  ph::testing::random_source random(seed_of_brakes_off);
  int displayed = 0;
  for (int k = 0; k < 300; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed_of_brakes_off << ", case " << k);
    const case_of<arm_3, Walls> c(arm, random);
    const ph::device_state<two_of_three> same{0, c.state.q, c.state.qd, c.state.hand_force};
    ph::step_memory<ph::direct_control> memory, memory_of_light;
    const auto some = ph::step(arm, brakes, c.touched, ph::direct_control(), c.state, memory);
    const auto all = ph::step(light, left, c.touched, ph::direct_control(), same, memory_of_light);
    ASSERT_EQ(some.outcome, ph::status::ok);
    ASSERT_EQ(some.display, all.display);
    ASSERT_EQ(some.capacity[off], 0.0);
    ASSERT_EQ(some.torque[off], 0.0);
    ASSERT_EQ(some.cone_coefficients[off], 0.0);
    displayed += ph::is_displayed(some.display) ? 1 : 0;
    ASSERT_LT((some.control_force - all.control_force).norm(),
              1e-12 * std::max(1.0, all.control_force.norm()));
    ASSERT_LT((ph::vector<double, 2>(some.capacity[0], some.capacity[2]) - all.capacity).norm(), 1e-11);
  }
  EXPECT_GT(displayed, 15);
}

TEST(settled_brakes_off, have_the_force_of_an_arm_without_this_brake) {
  expect_as_without<1>();
  expect_as_without<2>();
}

TEST(settled_brakes_off, a_limit_of_zero_is_off_for_displayable) {
  const auto arm = arms::of_rods<3>();
  const two_of_three light(arm);
  const ph::vector<double, 3> limit(2, 0, 2);
  ph::testing::random_source random(seed_of_brakes_off);
  int displayed = 0;
  for (int k = 0; k < 200; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed_of_brakes_off << ", case " << k);
    const auto q = random.normal_vector<double, 3>();
    const auto v = random.direction<double, 2>(), n = random.direction<double, 2>();
    const auto some = ph::displayable(arm, q, v, n, limit);
    const auto all = ph::displayable(light, q, v, n, {2, 2});
    ASSERT_EQ(some.outcome, ph::status::ok);
    ASSERT_EQ(some.display, all.display);
    ASSERT_FALSE(ph::contains(some.held, off)) << "a brake that is off holds nothing";
    ASSERT_NEAR(some.angle, all.angle, 1e-9);
    if (!ph::is_displayed(all.display)) continue;
    ++displayed;
    ASSERT_NEAR(some.max_force, all.max_force, 1e-9 * (1 + all.max_force));
    ASSERT_NEAR(some.max_approximated_force, all.max_approximated_force,
                1e-9 * (1 + all.max_approximated_force));
  }
  EXPECT_GT(displayed, 15);
}

template <class L, int Walls>
void expect_no_torque_beyond() {
  const auto arm = arms::of_rods<3>();
  ph::testing::random_source random(seed_of_brakes_off);
  int works = 0;
  for (int run = 0; run < 100; ++run) {
    ph::step_memory<L> memory;
    case_of<arm_3, Walls> c(arm, random);
    for (int cycle = 0; cycle < 4; ++cycle) {
      SCOPED_TRACE(::testing::Message()
                   << "seed " << seed_of_brakes_off << ", run " << run << ", cycle " << cycle);
      const auto brakes = random_brakes<arm_3>(random);
      c.state.time = 1e-3 * cycle;
      c.state.qd = (random.coin() ? 0 : 1) * random.normal_vector<double, 3>();
      const auto result = ph::step(arm, brakes, c.touched, L(), c.state, memory);
      ASSERT_EQ(result.outcome, ph::status::ok);
      expect_within_intervals<arm_3>(brakes, result, c.state.qd);
      if (::testing::Test::HasFatalFailure()) return;
      works += (result.capacity.array() > 0).any() ? 1 : 0;
    }
  }
  EXPECT_GT(works, 60);
}

TEST(settled_brakes_off, no_law_commands_a_torque_beyond_an_interval) {
  expect_no_torque_beyond<ph::direct_control, 2>();
  expect_no_torque_beyond<ph::saturated_direct_control, 1>();
  expect_no_torque_beyond<ph::velocity_direct_control, 2>();
}

// What is displayed is made by torques of the intervals: with T = 1, J^T Fc = t, also of one-way brakes that
// come to rest.
TEST(settled_brakes_off, one_way_brakes_at_rest_hold_only_their_way) {
  const auto arm = arms::of_rods<3>();
  ph::testing::random_source random(seed_of_brakes_off);
  int displayed = 0, one_way_at_rest = 0;
  for (int k = 0; k < 1000; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed_of_brakes_off << ", case " << k);
    const case_of<arm_3, 1> c(arm, random);
    const auto brakes = random_brakes<arm_3>(random);
    ph::step_memory<ph::direct_control> memory;
    const auto result = ph::step(arm, brakes, c.touched, ph::direct_control(), c.state, memory);
    expect_within_intervals<arm_3>(brakes, result, c.state.qd);
    if (!ph::is_displayed(result.display)) continue;
    ++displayed;
    const ph::joint_vector<arm_3> t = ph::jacobian(arm, c.state.q).transpose() * result.control_force;
    ASSERT_LT((t - result.cone_coefficients).norm(), 1e-11 * result.control_force.norm());
    for (int i = 0; i < 3; ++i)
      one_way_at_rest += ph::contains(memory.start.held, i) && result.settled_signs[i] != 0;
  }
  EXPECT_GT(displayed, 100);
  EXPECT_GT(one_way_at_rest, 15);
}

// A wall and a field: the brake that is off stays so.
TEST(settled_brakes_off, effects_do_not_command_it) {
  const auto arm = arms::of_rods<3>();
  const ph::viscous_field<double, 2> honey({.viscosity = 3 * ph::matrix<double, 2, 2>::Identity()});
  ph::testing::random_source random(seed_of_brakes_off);
  int works = 0;
  for (int k = 0; k < 100; ++k) {
    const case_of<arm_3, 1> c(arm, random);
    ph::switchable_brakes<arm_3> brakes;
    brakes.switch_off(k % 3);
    ph::step_memory<ph::direct_control> memory;
    const auto result =
        ph::step(arm, brakes, ph::with_effects(c.touched, honey), ph::direct_control(), c.state, memory);
    ASSERT_EQ(result.outcome, ph::status::ok);
    ASSERT_EQ(result.capacity[k % 3], 0.0);
    works += (result.capacity.array() > 0).any() ? 1 : 0;
  }
  EXPECT_GT(works, 30);
}

}  // namespace
