// slow
// What velocity_direct_control is made of: response along a normal, holding and stopping torques, corners.
#include <passive_haptics/control/laws/velocity/stopping_torques.hpp>
#include <passive_haptics/control/laws/velocity/torque_range.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

namespace {

namespace ph = passive_haptics;
using pair = ph::vector<double, 2>;

// Of a delta in a random pose: n . xdd without brakes, for each torque, and the inertia along n.
TEST(normal_response, is_that_of_the_mechanism) {
  using M = ph::delta<double>;
  using V = ph::vector<double, 3>;
  constexpr unsigned seed = 8;
  ph::testing::random_source random(seed);
  const M delta;
  for (int k = 0; k < 20; ++k) {
    const V q(0.4 + random.uniform(-0.3, 0.3), 0.4 + random.uniform(-0.3, 0.3),
              0.4 + random.uniform(-0.3, 0.3));
    const V qd = random.normal_vector<double, 3>(), n = random.direction<double, 3>(),
            Fh = random.normal_vector<double, 3>(), t = random.normal_vector<double, 3>();
    const ph::pose_dynamics<M> device({delta, q}, qd);
    const auto along = ph::response_along(n, device, Fh);
    const ph::matrix<double, 3, 3> J = delta.jacobian(q), inverse_mass = delta.mass_matrix(q).inverse();
    const V xdd = J * inverse_mass * (J.transpose() * Fh + t - delta.bias_torque(q, qd)) +
                  delta.bias_acceleration(q, qd);
    EXPECT_NEAR(along.free + along.g.dot(t), n.dot(xdd), 1e-9 * xdd.norm()) << "seed " << seed;
    EXPECT_NEAR(1 / along.inertia, n.dot(J * inverse_mass * J.transpose() * n), 1e-9 / along.inertia);
    EXPECT_LE((along.per_newton - J * inverse_mass * J.transpose() * n).norm(), 1e-9 / along.inertia);
  }
}

// Torques that hold all brakes at rest leave them without acceleration.
TEST(holding_torques, hold) {
  using M = ph::tendon_two_link<double>;
  const M arm;
  const pair q = arm.inverse({0.1, 0.2}, ph::elbow::left).q, Fh(1, 2);
  const ph::pose_dynamics<M> device({arm, q}, {1, -2});
  const pair strong(100, 100), weak(0.05, 0.05), none(0, 0), drive = device.J.transpose() * Fh - device.bias;
  pair t = none;
  ph::brake_inertia<M> A;
  for (int k = 0; k < 100; ++k) t = ph::holding_torques(device, Fh, {true, true}, t, strong, A);
  const pair qdd = device.mass.solve(pair(drive + device.Tt * t));
  EXPECT_LE(qdd.norm(), 1e-6);
  // With brake 2 let go, brake 1 is held for itself alone
  const pair alone = ph::holding_torques(device, Fh, {true, false}, none, strong, A);
  const pair held = device.mass.solve(pair(drive + device.Tt.col(0) * alone[0]));
  EXPECT_NEAR(arm.transmission().row(0).dot(held), 0, 1e-9);
  // With brake 1 too weak to hold, brake 2 is held beside what that makes
  pair beside = ph::holding_torques(device, Fh, {true, false}, none, weak, A);
  EXPECT_GT(std::abs(beside[0]), weak[0]);
  beside[0] = std::copysign(weak[0], beside[0]);
  EXPECT_NEAR(arm.transmission().row(1).dot(device.mass.solve(pair(drive + device.Tt * beside))), 0, 1e-9);
}

// A wall as is_cornered sees it.
struct plain_wall {
  struct {
    ph::vector<double, 3> normal;
  } along;
  bool closed = true;
  bool is_closed() const { return closed; }
};

TEST(is_cornered, if_two_walls_or_more_leave_no_way) {
  using M = ph::delta<double>;
  using V = ph::vector<double, 3>;
  const M delta;
  const V n(0, 0.6, 0.8), other(0, -0.6, 0.8), third(1, 0, 0), still = V::Zero();
  const V q(0.3, 0.4, 0.5);
  const ph::mechanism_pose<M> pose(delta, q);
  const auto cornered = [&](const V& v, const V& Fh, std::initializer_list<V> normals, bool closed = true) {
    std::array<plain_wall, 3> walls;
    int count = 0;
    for (const V& normal : normals) walls[std::size_t(count++)].along.normal = normal;
    walls[1].closed = closed;
    const V qd = delta.jacobian(q).inverse() * v;
    const ph::pose_dynamics<M> device(pose, qd, 0.4);
    return ph::is_cornered(device, ph::weighted_motion<M>(device, qd, Fh), walls, count, 0.01);
  };
  const V into = -2 * n - other, along(0.1, 0, 0);
  EXPECT_TRUE(cornered(still, into, {n, other}));
  EXPECT_FALSE(cornered(along, still, {n, other})) << "along the valley";
  EXPECT_FALSE(cornered(along, into, {n, other})) << "along the valley, pressed in";
  EXPECT_TRUE(cornered(-along, into, {n, other, third})) << "to the end of the valley";
  EXPECT_FALSE(cornered(still, -into, {n, other})) << "out";
  EXPECT_FALSE(cornered(still, -n, {n})) << "one wall";
  EXPECT_FALSE(cornered(still, -n, {n, other}, false)) << "the other one is only near";
}

// Brakes at rest, as a brake that turns may push one way only.
TEST(stopping_torques, stop_a_device_in_their_time_and_hold_the_hand) {
  using M = ph::tendon_two_link<double>;
  constexpr unsigned seed = 60;
  constexpr double time = 0.0075, held = 1.3;
  ph::testing::random_source random(seed);
  const M arm;
  ph::brakes_of<M> brakes;
  brakes.rate_dead_band.setConstant(1e9);
  for (int k = 0; k < 100; ++k) {
    const pair q(random.uniform(-3.0, 3.0), random.uniform(0.5, 2.6)), qd = random.normal_vector<double, 2>(),
                                                                       Fh = random.normal_vector<double, 2>();
    const ph::pose_dynamics<M> device({arm, q}, qd, 0.4);
    const ph::matrix<double, 2, 2> mass = arm.mass_matrix(q) + 0.4 * device.J.transpose() * device.J;
    const pair needed =
        device.Tt.inverse() * (mass * qd / time + held * (device.J.transpose() * Fh - device.bias));
    const auto stopping = [&](double limit) {
      brakes.torque_limit.setConstant(limit);
      return ph::stopping_torques(device, ph::weighted_motion<M>(device, qd, Fh), brakes, time);
    };
    const pair magnitude = needed.cwiseAbs();
    EXPECT_LE((stopping(1e9) - magnitude).norm(), 1e-9 * needed.norm()) << "seed " << seed << ", trial " << k;
    const double weak = 0.7 * magnitude.maxCoeff();
    EXPECT_EQ(stopping(weak).maxCoeff(), weak);
    EXPECT_GE(stopping(weak).minCoeff(), (1 - 1e-9) * std::min(magnitude.minCoeff(), weak))
        << "beside one at its limit";
    EXPECT_EQ(stopping(0), pair(0, 0));
  }
}

// A hand that stops a slide faster than it should stop would need a brake that drives.
TEST(stopping_torques, of_a_brake_that_turns_never_drive) {
  using M = ph::xy_table<double>;
  const M table;
  ph::brakes_of<M> brakes;
  brakes.rate_dead_band.setConstant(1e-3);
  for (const double side : {1.0, -1.0}) {
    const pair q(0, 0), qd(0.01 * side, 0), Fh(-5 * side, 0);
    const ph::pose_dynamics<M> device({table, q}, qd, 0.4);
    const auto t = ph::stopping_torques(device, ph::weighted_motion<M>(device, qd, Fh), brakes, 0.0075);
    EXPECT_LE(t.norm(), 1e-9);
  }
}

}  // namespace
