// slow
// Which way brakes at rest are pushed, where the mechanism's inertia is known: against the simulated device,
// against a motion that is integrated, and where the rule has no unique torques.
#include "../support.hpp"

#include <passive_haptics/brake/at_rest/hand_torque_at_rest.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/two_link.hpp>
#include <passive_haptics/plant/simulated_device.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace hand_torques {

using pair = ph::vector<double, 2>;
using square = ph::matrix<double, 2, 2>;
using flags = ph::vector<bool, 2>;
constexpr unsigned seed = 20040627;

// Brakes without lag
template <class M>
ph::brakes_of<M> quick_brakes() {
  ph::brakes_of<M> brakes;
  brakes.time_constant.setZero();
  return brakes;
}

// A random motion in which brake `rests` is at rest and the other slips.
template <class M>
ph::device_state<M> random_motion(const M& arm, int rests, ph::testing::random_source& random) {
  ph::device_state<M> state;
  state.time = 0;
  state.q = random.between<double, 2>(pair(-1, 0.5), pair(1, 2.5));
  pair w;
  w[rests] = 0;
  w[1 - rests] = random.wide(0.5, 5.0);
  state.qd = ph::transposed_transmission(arm, state.q).transpose().inverse() * w;
  state.hand_force = random.uniform(0.5, 5.0) * random.direction<double, 2>();
  return state;
}

// Brake `rests` of the device, held or let go beside the other one that slips: its torque, and its
// acceleration.
struct simulated {
  double torque, acceleration;
};
template <class M>
simulated simulate(const M& arm, const ph::device_state<M>& state, int rests, double held, double slips) {
  constexpr double dt = 1e-7;
  ph::brakes_of<M> brakes = quick_brakes<M>();
  brakes.torque_limit.setConstant(1e3);
  ph::simulated_device<M> device(arm, brakes, 0.0, state.q);
  device.set_motion(state.q, state.qd);
  pair capacity;
  capacity[rests] = held;
  capacity[1 - rests] = slips;
  device.advance(dt, capacity, state.hand_force);
  return {device.brake_torque()[rests], device.rates()[rests] / dt};
}

TEST(exact_hand_torque, pushes_a_brake_at_rest_the_way_it_would_accelerate) {
  using M = ph::tendon_two_link<double>;
  const M arm;
  const auto brakes = quick_brakes<M>();
  ph::testing::random_source random(seed);
  int static_wrong = 0, alone_wrong = 0;
  constexpr int motions = 400;
  for (int k = 0; k < motions; ++k) {
    const int rests = k % 2;
    const auto state = random_motion(arm, rests, random);
    const ph::mechanism_pose<M> pose(arm, state.q);
    pair strength = pair::Zero();
    strength[1 - rests] = random.uniform(0.0, 0.5);
    const pair w = pose.brake_rates(state.qd);
    const double th = ph::exact_hand_torque<M>(pose, brakes, state, w, strength)[rests];
    const simulated held = simulate(arm, state, rests, 1e3, strength[1 - rests]);
    const simulated free = simulate(arm, state, rests, 0, strength[1 - rests]);
    ASSERT_NEAR(held.torque, -th, 1e-4 * (1 + std::abs(th))) << k;
    if (std::abs(th) < 1e-4) continue;
    ASSERT_EQ(free.acceleration > 0, th > 0) << k;
    static_wrong +=
        (ph::brake_torque(ph::brake_jacobian(arm, state.q), state.hand_force)[rests] > 0) != (th > 0);
    alone_wrong += (ph::exact_hand_torque<M>(pose, brakes, state, w, pair(0, 0))[rests] > 0) != (th > 0);
  }
  EXPECT_GT(static_wrong, motions / 10);
  EXPECT_GT(alone_wrong, motions / 10);
}

// ---- more brakes at rest than joints, and a mass matrix that is none

TEST(torques_at_rest, of_more_brakes_than_joints_hold_and_are_the_shortest) {
  ph::testing::random_source random(seed);
  for (int k = 0; k < 100; ++k) {
    const square half{{random.normal<double>(), random.normal<double>()},
                      {random.normal<double>(), random.normal<double>()}};
    const square M = half * half.transpose() + 0.1 * square::Identity();
    ph::matrix<double, 2, 4> Tt;
    for (int i = 0; i < 4; ++i) Tt.col(i) = random.normal_vector<double, 2>();
    if (k % 2 == 0) Tt.col(3) = Tt.col(0);  // two brakes of one axis
    const pair drive = random.normal_vector<double, 2>();
    const ph::vector<double, 4> none = ph::vector<double, 4>::Zero();
    const auto th = ph::hand_torque_at_rest<double, 2, 4>(M, Tt, drive, none, {true, true, true, true});
    EXPECT_LE((Tt * th - drive).norm(), 1e-11 * (1 + drive.norm()));
    const ph::vector<double, 4> other = Tt.transpose() * (Tt * Tt.transpose()).inverse() * drive;
    EXPECT_LE((th - other).norm(), 1e-9 * (1 + other.norm()));
    const auto twice = ph::hand_torque_at_rest<double, 2, 4>(M, Tt, drive, none, {true, false, false, true});
    if (k % 2 == 0) {
      EXPECT_NEAR(twice[0], twice[3], 1e-12 * (1 + twice.norm()));
    }
    EXPECT_EQ(twice[1], 0);
    // A drift that no torque cancels, two rates for one axis, leaves finite numbers
    const auto torn =
        ph::hand_torque_at_rest<double, 2, 4>(M, Tt, drive, {1, 0, 0, -1}, {true, false, false, true});
    EXPECT_TRUE(ph::all_finite(torn));
  }
}

TEST(torques_at_rest, of_a_mass_matrix_that_is_none_are_zero) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double entry : {0.0, -1.0, nan}) {
    const auto th = ph::hand_torque_at_rest<double, 2, 2>(square{{entry, 0}, {0, 1}}, square::Identity(),
                                                          pair(1, 1), pair(0, 0), flags(true, true));
    EXPECT_EQ(th, pair(0, 0));
  }
  // No transmission holds anything
  const auto loose = ph::hand_torque_at_rest<double, 2, 2>(square::Identity(), square::Zero(), pair(1, 1),
                                                           pair(0, 0), flags(true, true));
  EXPECT_EQ(loose, pair(0, 0));
}

// ---- Td qd, of a transmission that depends on the pose

// Two links whose second brake sits on a cam: derivatives by dual numbers,
struct cam_arm : ph::two_link<double> {
  template <class S>
  ph::matrix<S, 2, 2> transmission(const ph::vector<S, 2>& q) const {
    using std::cos, std::sin;
    ph::matrix<S, 2, 2> T;
    T << S(1), S(0.3) * sin(q[1]), S(0.5) * cos(q[0]), S(2) + S(0.4) * sin(q[0] + q[1]);
    return T;
  }
};
// by differences,
struct plain_cam_arm : ph::two_link<double> {
  square transmission(const pair& q) const { return cam_arm().transmission(q); }
};
// or written out
struct known_cam_arm : plain_cam_arm {
  pair brake_bias_acceleration(const pair& q, const pair& qd) const {
    return {0.3 * std::cos(q[1]) * qd[1] * qd[1],
            -0.5 * std::sin(q[0]) * qd[0] * qd[0] + 0.4 * std::cos(q[0] + q[1]) * (qd[0] + qd[1]) * qd[1]};
  }
};

TEST(brake_bias_acceleration, is_the_derivative_of_the_transmission) {
  static_assert(ph::Dynamics<cam_arm> && ph::detail::differentiates_transmission<cam_arm> &&
                !ph::detail::differentiates_transmission<plain_cam_arm>);
  ph::testing::random_source random(seed);
  for (int k = 0; k < 100; ++k) {
    const pair q = random.normal_vector<double, 2>(), qd = 3 * random.normal_vector<double, 2>();
    const pair known = ph::brake_bias_acceleration(known_cam_arm(), q, qd);
    EXPECT_LE((ph::brake_bias_acceleration(cam_arm(), q, qd) - known).norm(), 1e-14 * (1 + qd.squaredNorm()));
    EXPECT_LE((ph::brake_bias_acceleration(plain_cam_arm(), q, qd) - known).norm(),
              1e-9 * (1 + qd.squaredNorm()));
    EXPECT_EQ(ph::brake_bias_acceleration(ph::tendon_two_link<double>(), q, qd), pair(0, 0));
    EXPECT_EQ(ph::brake_bias_acceleration(ph::two_link<double>(), q, qd), pair(0, 0));
  }
  EXPECT_EQ(ph::brake_bias_acceleration(plain_cam_arm(), pair(1, 2), pair(0, 0)), pair(0, 0));
}

// The torques hold a brake on a cam: its rate, along a motion that they drive, changes by no first power of
// time. Without Td qd it does.
template <class M>
double change_of_rate(const M& arm, const ph::device_state<M>& state, int rests, const pair& t) {
  constexpr double h = 1e-5;
  const square Tt = ph::transposed_transmission(arm, state.q);
  const pair qdd =
      arm.mass_matrix(state.q).inverse() *
      (arm.jacobian(state.q).transpose() * state.hand_force - arm.bias_torque(state.q, state.qd) + Tt * t);
  const auto rate = [&](double s) {
    return ph::brake_rates(arm, pair(state.q + s * state.qd + s * s / 2 * qdd),
                           pair(state.qd + s * qdd))[rests];
  };
  return (rate(h) - rate(-h)) / (2 * h);
}

TEST(brake_bias_acceleration, is_part_of_what_holds_a_brake) {
  const cam_arm arm;
  const auto brakes = quick_brakes<cam_arm>();
  ph::testing::random_source random(seed);
  double max_drift = 0;
  for (int k = 0; k < 100; ++k) {
    const int rests = k % 2;
    const auto state = random_motion(arm, rests, random);
    const ph::mechanism_pose<cam_arm> pose(arm, state.q);
    const pair w = pose.brake_rates(state.qd);
    pair strength = pair::Zero();
    strength[1 - rests] = random.uniform(0.0, 0.3);
    pair t = -ph::exact_hand_torque<cam_arm>(pose, brakes, state, w, strength);
    t[1 - rests] = -std::copysign(strength[1 - rests], w[1 - rests]);
    const pair drift = ph::brake_bias_acceleration(arm, state.q, state.qd);
    const double size = state.qd.squaredNorm() + 1e4 * (state.hand_force.norm() * 0.3 + t.norm());
    EXPECT_LE(std::abs(change_of_rate(arm, state, rests, t)), 1e-6 * size);
    max_drift = std::max(max_drift, std::abs(drift[rests]));
  }
  EXPECT_GT(max_drift, 1);
}

}  // namespace hand_torques
