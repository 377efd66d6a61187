// slow
// Several walls at an arm whose self-motion settles: the best set of brakes at rest, and a hand in a corner.
#include "arm_of_rods.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/plant/simulated_device.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <Eigen/LU>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ph = passive_haptics;

namespace {

using arm_3 = arms::arm<3>;

struct two_walls {
  ph::device_state<arm_3> state;
  ph::contacts<2, 2> touched;
};

two_walls random_walls(ph::testing::random_source& random) {
  two_walls all;
  all.state.time = 0;
  all.state.q = random.normal_vector<double, arm_3::dof>();
  all.state.qd = random.normal_vector<double, arm_3::dof>();
  all.state.hand_force = random.normal_vector<double, 2>();
  for (int j = 0; j < 2; ++j)
    all.touched.push_back({.normal = random.direction<double, 2>(),
                           .depth = random.positive(1e-5, 1e-2),
                           .stiffness = 1000,
                           .wall_number = j});
  return all;
}

// What of the demands a set leaves, those first that have priority.
std::array<double, 2> left_by(const ph::brake_vector<arm_3>& signs,
                              const ph::matrix<double, arm_3::brake_count, 2>& W,
                              const ph::step_result_of_contacts<arm_3, 2>& result,
                              const std::array<ph::point<2>, 2>& normals) {
  constexpr int m = arm_3::brake_count;
  std::array<ph::contact_demand<double, 2>, 2> demands;
  for (std::size_t j = 0; j < 2; ++j)
    demands[j] = {normals[j], result.contacts[j].wanted, result.contacts[j].has_priority};
  auto box = ph::torques_within<double, m>(
      signs, ph::brake_vector<arm_3>::Constant(std::numeric_limits<double>::infinity()));
  for (int i = 0; i < m; ++i)
    if (W.row(i).isZero(0)) box.lower[i] = box.upper[i] = 0;
  const auto met = ph::contact_forces<double, 2, m, 2>({W.transpose()}, box, demands, 2);
  std::array<double, 2> left{};
  for (std::size_t j = 0; j < 2; ++j) {
    double& level = left[demands[j].has_priority ? 0 : 1];
    level = std::hypot(level, demands[j].force - met.displayed[j]);
  }
  return left;
}

TEST(settled_walls, are_met_by_the_best_set_of_brakes_at_rest) {
  const arm_3 mechanism = arms::of_rods<3>();
  ph::testing::random_source random(20040627);
  int met = 0, unmet = 0;
  for (int k = 0; k < 200; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed 20040627, state " << k);
    const auto walls = random_walls(random);
    ph::step_memory<ph::direct_control> memory;
    ph::brakes_of<arm_3> brakes;
    brakes.torque_limit.setConstant(1e6);
    const auto result = ph::step(mechanism, brakes, walls.touched, ph::direct_control(), walls.state, memory);
    ASSERT_EQ(result.outcome, ph::status::ok);
    const std::array<ph::point<2>, 2> normals{walls.touched[0].normal, walls.touched[1].normal};
    // The promises
    ASSERT_TRUE((result.settled_signs.array() * result.cone_coefficients.array() <= 0).all());
    ASSERT_TRUE((result.signs.array() * result.torque.array() <= 0).all());
    const ph::joint_vector<arm_3> balance =
        ph::transposed_transmission(mechanism, walls.state.q) * result.cone_coefficients -
        ph::transposed(ph::jacobian_matrix<arm_3>(ph::jacobian(mechanism, walls.state.q))) *
            result.control_force;
    const double size = result.cone_coefficients.norm() + result.control_force.norm();
    ASSERT_LE(balance.norm(), 1e-9 * size);
    ASSERT_LE(result.control_force.dot(result.settled_velocity),
              1e-9 * size + result.cone_coefficients.cwiseAbs().dot(brakes.rate_dead_band));
    // No other set leaves less
    const ph::settled_rates<arm_3> rates({mechanism, walls.state.q});
    std::array<double, 2> left{}, least{1e300, 1e300};
    for (std::size_t j = 0; j < 2; ++j) {
      const auto& report = result.contacts[j];
      double& level = left[report.has_priority ? 0 : 1];
      level = std::hypot(level, report.wanted - report.displayed);
    }
    rates.for_each([&](ph::brake_set, const auto& W) {
      const ph::brake_vector<arm_3> w = W * result.settled_velocity;
      const ph::brake_vector<arm_3> none = ph::brake_vector<arm_3>::Zero();
      const auto of_set = left_by(ph::brake_signs(w, none, brakes), W, result, normals);
      const double equal = 1e-6 * (1 + least[0]);
      if (of_set[0] < least[0] - equal || (of_set[0] < least[0] + equal && of_set[1] < least[1]))
        least = of_set;
      return false;
    });
    const double wanted = result.contacts[0].wanted + result.contacts[1].wanted;
    ASSERT_LE(left[0], least[0] + 1e-6 * (1 + wanted));
    ASSERT_LE(left[1], least[1] + 1e-6 * (1 + wanted));
    ++(left[0] + left[1] < 1e-6 * (1 + wanted) ? met : unmet);
  }
  EXPECT_GT(met, 8);
  EXPECT_GT(unmet, 20);
}

// Walls of 1e6 N/m through these places: a floor to the south and a side to the west.
struct a_corner {
  arm_3 mechanism = arms::of_rods<3>();
  ph::joint_vector<arm_3> q{0.4, 0.7, 0.6};
  ph::point<2> x = mechanism.position(q);
  ph::half_space<2> floor, side;
  ph::brakes_of<arm_3> brakes = [] {
    ph::brakes_of<arm_3> b;
    b.torque_limit.setConstant(2);
    return b;
  }();
  ph::controller<arm_3, decltype(ph::scene(ph::wall(floor), ph::wall(side))), ph::velocity_direct_control>
      control;

  // From the handle at the start
  a_corner(double depth, double off_the_side)
      : floor(x + ph::point<2>(0, depth), {0, 1}),
        side(x - ph::point<2>(off_the_side, 0), {1, 0}),
        control(mechanism, brakes, ph::scene(ph::wall(floor, 1e6), ph::wall(side, 1e6)),
                ph::velocity_direct_control()) {}

  // A simulated device; push(time, device) is what the hand does, visit(time, device) sees each step.
  template <class Push, class Visit>
  void run(double hand_mass, double duration, const Push& push, const Visit& visit) {
    ph::simulated_device<arm_3> device(mechanism, brakes, hand_mass, q);
    constexpr double step = 2e-4;
    ph::brake_vector<arm_3> capacity = ph::brake_vector<arm_3>::Zero();
    for (int k = 0; k < std::lround(duration / step); ++k) {
      const double time = k * step;
      if (k % 5 == 0) {
        const auto result =
            control(ph::device_state<arm_3>{time, device.q(), device.qd(), device.sensed_force()});
        ASSERT_EQ(result.outcome, ph::status::ok);
        capacity = result.capacity;
      }
      device.advance(step, capacity, push(time, device));
      visit(time, device);
    }
    EXPECT_LT(device.energy().max_brake_power, 1e-15);
  }
};

// A hand pushes with 2 N into a corner of two walls at right angles; a moment later it pulls out of one.
TEST(settled_walls, hold_a_hand_in_a_corner) {
  a_corner corner(-1e-3, 1e-3);
  double max_depth = 0;
  ph::point<2> at_the_end;
  corner.run(
      0.3, 1.4,
      [](double time, const auto& device) {
        return ph::point<2>(ph::point<2>(time >= 1 ? 0.6 : -1.4, -1.4) - 2 * device.velocity());
      },
      [&](double time, const auto& device) {
        at_the_end = device.position();
        if (time < 1)
          max_depth =
              std::max({max_depth, -corner.floor.distance(at_the_end), -corner.side.distance(at_the_end)});
      });
  EXPECT_LT(max_depth, 8e-3);
  EXPECT_GT(corner.side.distance(at_the_end), 5e-3) << "a hand that pulls out of one wall is free";
  EXPECT_LT(-corner.floor.distance(at_the_end), 8e-3);
}

// 10 mm deep in the floor, 1 mm off the side, the hand pulls out of the floor along the side.
TEST(settled_walls, let_a_hand_leave_a_wall_beside_another_one) {
  a_corner corner(10e-3, 1e-3);
  const ph::jacobian_matrix<arm_3> J(ph::jacobian(corner.mechanism, corner.q));
  const ph::joint_vector<arm_3> qd =
      J.transpose() * ph::matrix<double, 2, 2>(J * J.transpose()).inverse() * ph::vector<double, 2>(0, 0.03);
  EXPECT_EQ(corner.control(ph::device_state<arm_3>{0, corner.q, qd, {-0.5, 1}}).capacity.maxCoeff(), 0);
}

// A flick along the floor, towards a side 30 mm away, that ends halfway: the sensor reads nothing then.
TEST(settled_walls, stop_a_hand_that_coasts_into_a_corner) {
  a_corner corner(-0.2e-3, 30e-3);
  double max_depth = 0;
  bool coasts = false;
  corner.run(
      0.5, 1,
      [&](double, const auto& device) {
        coasts = coasts || corner.side.distance(device.position()) < 15e-3;
        return ph::point<2>(coasts ? 0.0 : -2.0, -1);
      },
      [&](double, const auto& device) {
        max_depth = std::max(max_depth, -corner.side.distance(device.position()));
      });
  EXPECT_TRUE(coasts);
  EXPECT_LT(max_depth, 1e-3);
}

}  // namespace
