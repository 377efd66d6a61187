// A control loop whose states have the torques on brakes at rest.
#include "../support.hpp"

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/sensorless/torques_at_rest.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace states_at_rest {

using device = ph::tendon_two_link<double>;
using pair = ph::vector<double, 2>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr unsigned seed = 20040627;

static_assert(ph::HandTorqueState<ph::device_state_at_rest<device>, device> &&
              ph::HandForceState<ph::device_state_at_rest<device>, device> &&
              !ph::HandTorqueState<ph::device_state<device>, device>);

// A random motion in which brake `rests` is at rest and the other slips.
ph::device_state<device> motion_with_rest(int rests, ph::testing::random_source& random) {
  ph::device_state<device> state;
  state.time = 0;
  state.q = random.between<double, 2>(pair(-1, 0.5), pair(1, 2.5));
  pair w;
  w[rests] = 0;
  w[1 - rests] = random.wide(0.5, 5.0);
  state.qd = ph::transposed_transmission(device(), state.q).transpose().inverse() * w;
  state.hand_force = random.uniform(0.5, 5.0) * random.direction<double, 2>();
  return state;
}

template <class State>
auto in_contact(const State& state) {
  return step_once<ph::direct_control>(device(), ph::brakes_of<device>(), state,
                                       ph::contact<2>{.normal = {0, 1}, .depth = 1e-3, .stiffness = 1e3});
}

TEST(hand_torques_of_a_state, decide_the_signs_and_torques_of_brakes_at_rest) {
  ph::testing::random_source random(seed);
  int holding = 0;
  for (int k = 0; k < 200; ++k) {
    const int rests = k % 2;
    ph::device_state_at_rest<device> state{motion_with_rest(rests, random), pair::Zero()};
    for (const double push : {0.02, -0.02, 1e-10, 0.0}) {
      state.hand_torque.setConstant(push);
      const auto result = in_contact(state);
      ASSERT_EQ(result.outcome, ph::status::ok);
      EXPECT_EQ(result.signs[rests], std::abs(push) > 1e-9 ? ph::sgn(push) : 0) << push;
      EXPECT_LE(result.signs[rests] * result.torque[rests], 0);
      EXPECT_LE(std::abs(result.torque[rests]), result.capacity[rests]);
      if (std::abs(push) > 1e-9) {
        EXPECT_LE(std::abs(result.torque[rests]), std::abs(push));
      }
      holding += result.torque[rests] != 0;
    }
  }
  EXPECT_GT(holding, 20);
}

TEST(hand_torques_of_a_state, that_are_not_finite_release_the_brakes) {
  ph::testing::random_source random(seed);
  ph::device_state_at_rest<device> state{motion_with_rest(0, random), pair(0, nan)};
  const auto result = in_contact(state);
  EXPECT_EQ(result.outcome, ph::status::state_not_finite);
  EXPECT_EQ(result.capacity, pair(0, 0));
}

TEST(torques_at_rest, are_the_exact_ones_beside_what_the_brakes_make_by_their_lag) {
  ph::brakes_of<device> brakes;
  brakes.time_constant.setConstant(0.02);
  const device arm;
  ph::testing::random_source random(seed);
  int turned = 0;
  for (int k = 0; k < 500; ++k) {
    const int rests = k % 2;
    auto state = motion_with_rest(rests, random);
    const ph::mechanism_pose<device> pose(arm, state.q);
    const pair w = pose.brake_rates(state.qd);
    const auto th = [&](double strength) {
      return ph::exact_hand_torque<device>(pose, brakes, state, w, pair(strength, strength))[rests];
    };
    ph::torques_at_rest<device> rest(device(), brakes);
    const auto before = rest.update(state, pair::Zero());
    EXPECT_EQ(before.hand_torque[rests], th(0));
    EXPECT_EQ(before.hand_torque[1 - rests], 0);
    EXPECT_TRUE(before.q == state.q && before.qd == state.qd && before.hand_force == state.hand_force);
    const double capacity = random.uniform(0.0, 0.5);
    state.time = 0.01;
    const double after = rest.update(state, pair::Constant(capacity)).hand_torque[rests];
    const double expected = th(capacity * (1 - std::exp(-0.5)));
    EXPECT_NEAR(after, expected, 1e-12 * (1 + std::abs(expected)));
    turned += (after > 0) != (before.hand_torque[rests] > 0);
    rest.reset();
    EXPECT_EQ(rest.update(state, pair::Zero()).hand_torque[rests], th(0));
  }
  EXPECT_GT(turned, 5);
}

TEST(torques_at_rest, are_zero_where_none_is_at_rest_or_anything_is_no_number) {
  const ph::brakes_of<device> brakes;
  ph::testing::random_source random(seed);
  auto moving = motion_with_rest(0, random);
  moving.qd = {1, 2};
  EXPECT_EQ(ph::torques_at_rest<device>(device(), brakes).update(moving, pair::Zero()).hand_torque,
            pair(0, 0));
  const auto state = motion_with_rest(0, random);
  ph::torques_at_rest<device> rest(device(), brakes);
  EXPECT_NE(rest.update(state, pair::Zero()).hand_torque[0], 0);
  EXPECT_EQ(rest.update(state, pair(nan, 0)).hand_torque, pair(0, 0));
  auto bad = state;
  bad.time = nan;
  EXPECT_EQ(rest.update(bad, pair::Zero()).hand_torque, pair(0, 0));
  bad = state;
  bad.hand_force[1] = nan;
  EXPECT_EQ(rest.update(bad, pair::Zero()).hand_torque, pair(0, 0));
  EXPECT_NE(rest.update(state, pair::Zero()).hand_torque[0], 0);
}

// Brakes that can be switched off, and brakes without limit and lag.
TEST(torques_at_rest, are_those_of_any_brakes_that_can_be_at_rest) {
  ph::testing::random_source random(seed);
  const device arm;
  ph::switchable_brakes<device> off;
  off.time_constant.setZero();
  off.switch_off(1);
  ph::torques_at_rest of_off(arm, off);
  ph::torques_at_rest of_unlimited(arm, ph::unlimited_brake_parameters<double, 2>());
  for (int k = 0; k < 50; ++k) {
    const auto state = motion_with_rest(0, random);
    const pair th = of_off.update(state, {0, 0.1}).hand_torque;
    EXPECT_NE(th[0], 0);
    EXPECT_NEAR(of_unlimited.update(state, {0, 0.1}).hand_torque[0], th[0], 1e-14 * (1 + std::abs(th[0])));
  }
}

}  // namespace states_at_rest
