// slow
// The wall calculator against the closed form of its equation of motion, and by hand on an XY table.
#include "../support.hpp"

#include <passive_haptics/design/braked_wall_at.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>

#include <passive_haptics/testing/support/random.hpp>

#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace {

// A wall whose brakes answer at once, a hand that brings no force.
ph::braked_wall bare_wall() {
  ph::braked_wall wall;
  wall.force = wall.approximated_force = 10;
  wall.inertia = 0.5;
  wall.approach_speed = 0.1;
  wall.time_constant = wall.push = wall.hand_damping = 0;
  wall.control_period = 1e-9;
  wall.scene_period = wall.reaction_time = wall.rest_depth = wall.depth_per_jump = 0;
  return wall;
}

TEST(wall_limits, what_comes_late_adds_the_way_made_meanwhile) {
  ph::braked_wall wall = bare_wall();
  const double before = limits_of(wall).depth;
  wall.scene_period = 0.050;
  wall.reaction_time = 0.004;
  const ph::wall_limits after = limits_of(wall);
  EXPECT_NEAR(after.depth, before + 0.029 * wall.approach_speed, 1e-5);
  EXPECT_NEAR(after.rigid_depth, before + 0.025 * wall.approach_speed, 1e-5);
  EXPECT_EQ(after.stiffness, wall.approximated_force / after.rigid_depth);
  std::swap(wall.scene_period, wall.control_period);
  EXPECT_EQ(limits_of(wall).depth, after.depth) << "whichever is slower";
}

// Lambda v' = P - R - B v - F (1 - exp(-t / T_b)), solved; the depth at the first v = 0.
double exact_depth(const ph::braked_wall& w) {
  const double rate = w.hand_damping / w.inertia,
               settled = (w.push - w.residual_force - w.force) / w.hand_damping;
  const double forced = w.force / (w.hand_damping - w.inertia / w.time_constant);
  const double free = w.approach_speed - settled - forced;
  const auto v = [&](double t) {
    return settled + free * std::exp(-rate * t) + forced * std::exp(-t / w.time_constant);
  };
  double before = 0, after = 1e-3;
  while (v(after) > 0) after *= 1.01;
  for (int k = 0; k < 100; ++k) (v((before + after) / 2) > 0 ? before : after) = (before + after) / 2;
  return settled * after - free / rate * std::expm1(-rate * after) -
         forced * w.time_constant * std::expm1(-after / w.time_constant);
}

TEST(wall_limits, the_landing_is_the_solution_of_its_equation) {
  constexpr unsigned seed = 1904;
  SCOPED_TRACE("seed " + std::to_string(seed));
  ph::testing::random_source random(seed);
  for (int k = 0; k < 50; ++k) {
    ph::braked_wall wall = bare_wall();
    wall.force = random.uniform(8.0, 60.0);
    wall.residual_force = random.uniform(-1.0, 1.0);
    wall.inertia = random.uniform(0.2, 2.0);
    wall.push = random.uniform(0.0, 5.0);
    wall.hand_damping = random.uniform(1.0, 30.0);
    wall.time_constant = random.uniform(0.002, 0.04);
    wall.approach_speed = random.uniform(0.01, 0.2);
    const double exact = exact_depth(wall);
    EXPECT_NEAR(limits_of(wall).depth, exact, 1e-3 * exact + 1e-6) << k;
  }
}

TEST(wall_limits, brakes_that_are_too_weak_hold_nothing) {
  ph::braked_wall wall;
  wall.push = 20;
  wall.force = wall.approximated_force = 5;
  EXPECT_FALSE(limits_of(wall).holds());
  EXPECT_EQ(limits_of(wall).stiffness, 0);
  wall.hand_stiffness = 1000;  // the hand itself gives way 15 mm deep
  EXPECT_TRUE(limits_of(wall).holds());
  wall.hand_stiffness = 200;  // and here 75 mm deep, which is not held
  EXPECT_FALSE(limits_of(wall).holds());
  wall.force = wall.approximated_force = 0;
  EXPECT_EQ(limits_of(wall).stiffness, 0);
}

TEST(wall_limits, a_hand_that_takes_over_a_second_to_stop_is_not_held) {
  ph::braked_wall wall = bare_wall();
  wall.inertia = 10;
  wall.force = wall.approximated_force = 0.2;
  wall.approach_speed = 0.0195;
  EXPECT_NEAR(limits_of(wall).depth, 0.0195 * 0.0195 * 10 / (2 * 0.2), 1e-6);
  wall.approach_speed = 0.0205;
  EXPECT_FALSE(limits_of(wall).holds());
}

TEST(wall_limits, coarse_encoders_let_the_hand_rest_deeper) {
  ph::braked_wall wall;
  wall.approach_speed = 0;
  wall.push = -1;
  const ph::velocity_direct_control_parameters law;
  wall.depth_resolution = 0.9 * law.rest_depth / law.depth_per_jump;
  EXPECT_EQ(limits_of(wall).depth, law.rest_depth);
  EXPECT_EQ(limits_of(wall).rigid_depth, 0) << "a hand that does not come";
  wall.depth_resolution = 2 * law.rest_depth / law.depth_per_jump;
  EXPECT_DOUBLE_EQ(limits_of(wall).depth, 2 * law.rest_depth);
  wall.depth_per_jump /= 1.5;
  EXPECT_DOUBLE_EQ(limits_of(wall).depth, 2 * law.rest_depth / 1.5);
  wall.depth_resolution = 1;
  EXPECT_EQ(limits_of(wall).depth, ph::velocity_direct_control_parameters::max_rest_depth);
  wall.rest_depth = 2 * ph::velocity_direct_control_parameters::max_rest_depth;
  EXPECT_EQ(limits_of(wall).depth, wall.rest_depth);
}

TEST(wall_limits, a_drift_is_told_by_a_count_in_twice_the_time_averaged) {
  ph::braked_wall wall;
  wall.depth_resolution = 1e-4;
  wall.averaging_time = 0.016;
  EXPECT_DOUBLE_EQ(limits_of(wall).drift, 1e-4 / 0.032);
}

// Each member in turn, and numbers that overflow together.
TEST(wall_limits, numbers_that_are_none_are_refused_by_name) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto error_of = [](const ph::braked_wall& wall) { return thrown_by([&] { limits_of(wall); }); };
  ph::braked_wall wall;
  ph::for_each_member(wall, [&](const ph::member_description& about, double& value) {
    const double good = value;
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, -1e9}) {
      if (about.hard.contains(bad)) continue;
      value = bad;
      const std::string error = error_of(wall);
      EXPECT_NE(error.find(std::string(about.name) + " of a braked_wall"), std::string::npos) << error;
    }
    value = good;
  });
  wall.inertia = wall.hand_damping = std::numeric_limits<double>::max();
  wall.approach_speed = 2;
  EXPECT_EQ(
      error_of(wall),
      "passive_haptics: depth of the landing at a braked_wall [m] = nan: expected a number: give forces "
      "in N and the inertia in kg, so that none of them overflows");
}

TEST(wall_limits, of_a_normal_of_any_length_are_those_of_its_direction) {
  using M = ph::tendon_two_link<double>;
  using V = ph::vector<double, 2>;
  const M arm;
  const V q = arm.inverse({0.1, 0.2}, ph::elbow::left).q, n(0.6, -0.8), v(0.05, 0.1);
  const auto wall = [&](const V& normal) {
    return ph::braked_wall_at(arm, q, v, normal, ph::brakes_of<M>(), V(0.1, 0.1), V(1e-3, 1e-3), 0.5);
  };
  for (const double length : {1e-200, 2.0, 1e308}) {
    const ph::braked_wall found = wall(length * n);
    ph::for_each_member(found, [&](const auto& about, double value) {
      EXPECT_NEAR(value, wall(n).*about.pointer, 1e-12 * std::abs(value)) << about.name << ' ' << length;
    });
  }
  for (const V& none : {V(0, 0), V(std::nan(""), 0), V(0, std::numeric_limits<double>::infinity())})
    EXPECT_THROW(limits_of(wall(none)), std::invalid_argument);
}

TEST(wall_limits, without_force_no_stiffness_is_of_use) {
  ph::braked_wall wall;
  wall.approximated_force = wall.approach_speed = 0;
  wall.push = -1;
  EXPECT_EQ(limits_of(wall).stiffness, 0) << "no NaN";
  wall.approximated_force = 1;
  EXPECT_TRUE(std::isinf(limits_of(wall).stiffness)) << "of a wall that the hand does not get into";
}

// Slides along x and y: along y the brake of y holds, and drags along x do not matter.
TEST(wall_limits, are_those_of_a_slide_by_hand) {
  const ph::xy_table<float> table;
  using V = ph::vector<float, 2>;
  ph::brakes_of<ph::xy_table<float>> brakes;
  brakes.torque_limit = {7, 12};
  brakes.time_constant = {0.01f, 0.03f};
  const auto at = [&](const V& n) {
    return ph::braked_wall_at(table, V(0, 0), V(0.05f, -0.15f), n, brakes, V(0.5f, 0.25f), V(1e-5f, 2e-5f),
                              0.5f);
  };
  const ph::braked_wall wall = at({0, 1}), left = at({1, 0});
  constexpr double rounding = 1e-5;
  EXPECT_NEAR(wall.force, 12, 12 * rounding);
  EXPECT_NEAR(wall.approximated_force, 12, 12 * rounding);
  EXPECT_NEAR(wall.residual_force, 0.25, rounding);
  EXPECT_EQ(wall.sliding_residual, 0) << "the brake of y rests while the handle slides along x";
  EXPECT_NEAR(wall.inertia, double(table.mass_matrix(V(0, 0))(1, 1)) + 0.5, rounding);
  EXPECT_NEAR(wall.depth_resolution, 2e-5, 1e-5 * rounding);
  EXPECT_NEAR(wall.approach_speed, 0.15, rounding);
  EXPECT_NEAR(wall.time_constant, 0.03, rounding);
  EXPECT_EQ(left.approach_speed, 0);
  EXPECT_NEAR(left.depth_resolution, 1e-5, 1e-5 * rounding);
}

// The force of the residual torques on a sliding handle, by virtual work.
TEST(wall_limits, residual_torques_that_push_out_more_than_the_hand_pushes_in_are_told) {
  using M = ph::tendon_two_link<double>;
  using V = ph::vector<double, 2>;
  const M arm;
  const V n(0, -1), residual(0.1, 0.1), along(0.05, 0);
  int out = 0, in = 0;
  for (const double x : {-0.05, 0.02, 0.1, 0.15, 0.18}) {
    const V q = arm.inverse({x, 0.2}, ph::elbow::left).q;
    const ph::matrix<double, 2, 2> J(ph::jacobian(arm, q));
    const V w = ph::brake_rates(arm, q, V(J.inverse() * along));
    const V t(-residual[0] * (w[0] > 0 ? 1 : -1), -residual[1] * (w[1] > 0 ? 1 : -1));
    // Forces by virtual work: F . v = t . w for each v
    const auto force_along = [&](const V& v) { return t.dot(ph::brake_rates(arm, q, V(J.inverse() * v))); };
    ph::braked_wall wall =
        ph::braked_wall_at(arm, q, V(along - 0.1 * n), n, ph::brakes_of<M>(), residual, V(0, 0), 0.5);
    EXPECT_NEAR(wall.sliding_residual, force_along(n), 1e-12);
    EXPECT_LT(force_along({1, 0}), 0) << "along the wall it drags";
    (wall.sliding_residual > 0 ? out : in) += 1;
    wall.push = 1.01 * wall.sliding_residual;
    EXPECT_FALSE(limits_of(wall).pushed_out);
    wall.push = 0.99 * wall.sliding_residual;
    EXPECT_EQ(limits_of(wall).pushed_out, wall.sliding_residual > 0);
  }
  EXPECT_GT(out, 0);
  EXPECT_GT(in, 0);
  EXPECT_EQ(ph::sliding_residual(arm, arm.inverse({0.1, 0.2}, ph::elbow::left).q, n, n, residual), 0)
      << "at rest along the wall";
}

// A brake that turns round half-way through the landing: before it by a little, and after.
TEST(wall_limits, are_of_the_signs_half_way_through_a_landing) {
  using M = ph::tendon_two_link<double>;
  using V = ph::vector<double, 2>;
  const M arm;
  const ph::brakes_of<M> brakes;
  const V q = arm.inverse({0.1, 0.226}, ph::elbow::left).q, n(0, -1);
  const ph::matrix<double, 2, 2> J(ph::jacobian(arm, q));
  const auto rates = [&](const V& v) -> V { return ph::brake_rates(arm, q, V(J.inverse() * v)); };
  const auto max_force = [&](const V& v) {
    return ph::displayable(arm, q, v, n, brakes.torque_limit).max_force;
  };
  int turned = 0;
  for (int i = 0; i < 2; ++i) {
    for (const double part : {0.45, 0.55}) {  // of the velocity into the wall, at which brake i stands still
      const double along = part * rates(n)[i] / rates(V(1, 0))[i];
      const V v = 0.1 * (V(along, 0) - n), half = 0.1 * (V(along, 0) - n / 2);
      EXPECT_DOUBLE_EQ(ph::braked_wall_at(arm, q, v, n, brakes, V(0, 0), V(0, 0), 0.5).force,
                       max_force(half));
      turned += std::abs(max_force(half) - max_force(v)) > 0.1;
    }
  }
  EXPECT_GE(turned, 1);
}

}  // namespace
