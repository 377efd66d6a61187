// slow
// Direct control at the level of velocities, in single cycles.
#include "velocity_floor.hpp"

#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <algorithm>
#include <cmath>

namespace {

ph::step_result<table> once(const law& control, double y, const pair& v, const pair& Fh,
                            const ph::brakes_of<table>& brakes = without_lag()) {
  ph::contacts<2, 1> touched;
  touched.push_back(floor_at(0, y));
  ph::step_memory<law> memory;
  return ph::step(table(), brakes, touched, control, state_of<table>({0, y}, v, Fh), memory);
}

TEST(velocity_direct_control, brakes_what_its_velocity_and_a_share_of_the_push_ask_for) {
  const constants p;
  const law control(p);
  // Sinking at 0.1 m/s at the depth of rest: the reference is to stand still
  const auto sinking = once(control, -p.rest_depth, {0, -0.1}, {0, -2});
  const double force = 0.1 * force_per_speed(p) + 2 * p.force_share;
  EXPECT_NEAR(sinking.capacity[1], force, 1e-12);
  EXPECT_EQ(sinking.capacity[0], 0) << "along the wall";
  EXPECT_LT(sinking.torque[1] * -0.1, 0) << "it resists";
  // The account tells the force that the torques make, not the wall's 1e4 N
  EXPECT_EQ(sinking.display, ph::display_class::approximate);
  EXPECT_NEAR(sinking.control_force[1], force, 1e-12);
  EXPECT_NEAR(sinking.approximation_angle(), 0, 1e-7);
  // Not so deep as it shall rest: it may go on as fast as k_d allows
  const double inward = p.depth_gain * (p.rest_depth - 1e-4);
  EXPECT_EQ(once(control, -1e-4, {0, -0.9 * inward}, {0, 0}).capacity[1], 0);
  EXPECT_NEAR(once(control, -1e-4, {0, -inward - 0.01}, {0, 0}).capacity[1], 0.01 * force_per_speed(p),
              1e-12);
  // Far too deep: not faster out than v_max
  EXPECT_NEAR(once(control, -0.5, {0, -0.05}, {0, 0}).capacity[1],
              (0.05 + p.velocity_limit) * force_per_speed(p), 1e-12);
}

// Capacities at this depth of two walls, each with a brake of its own.
pair in_a_corner(double depth, double dead_band, const pair& v, const pair& Fh) {
  ph::contacts<2, 2> corner;
  for (const int i : {0, 1})
    corner.push_back(
        {.normal = pair::Unit(i), .depth = depth, .stiffness = 1e7, .wall_number = i, .sensed_at = {0, 0}});
  auto brakes = without_lag();
  brakes.rate_dead_band.setConstant(dead_band);
  ph::step_memory<law> memory;
  return ph::step(table(), brakes, corner, law(), state_of<table>({0, 0}, v, Fh), memory).capacity;
}

TEST(velocity_direct_control, holds_in_a_corner_what_sinks_and_nothing_that_leaves) {
  const constants p;
  const auto capacity = [&](const pair& v) { return in_a_corner(p.rest_depth, 1e-9, v, {0, 0}); };
  for (const double force : {0.5, 3.0}) {
    const double v = force / force_per_speed(p);
    EXPECT_TRUE(capacity({v, v}).isZero(0));
    EXPECT_LE((capacity({-v, -v}) - pair(force, force)).norm(), 1e-6);
    EXPECT_LE((capacity({-v, v}) - pair(force, 0)).norm(), 1e-6);
  }
}

// Each brake there is at rest: its sign is that of the push on it, not of the velocity that is stopped at
// both walls, and it gets more than holds the hand.
TEST(velocity_direct_control, holds_a_handle_at_rest_in_a_corner) {
  constexpr double sinking = 0.005;
  const constants p;
  const pair push(2, 3), v(-sinking, -sinking);
  const pair expected = pair::Constant(sinking * force_per_speed(p)) + 1.3 * push;
  EXPECT_LE((in_a_corner(p.rest_depth, 2 * sinking, v, -push) - expected).norm(), 1e-6);
}

TEST(velocity_direct_control, never_holds_a_handle_that_leaves) {
  for (const double Fh : {-2.0, 0.0, 2.0}) {
    const auto leaving = once(law(), -constants().rest_depth, {0, 0.05}, {0, Fh});
    EXPECT_TRUE(leaving.capacity.isZero(0)) << "hand force " << Fh;
  }
  const double y = -constants().rest_depth;
  EXPECT_TRUE(once(law(), y, {0, 0}, {0, 1}).capacity.isZero(0)) << "a pull at rest";
  EXPECT_GT(once(law(), y, {0, 0}, {0, -1}).capacity[1], 0) << "a push at rest";
}

// A wall that moves is met as by a handle that moves the other way; one sensed elsewhere, as where the handle
// is.
TEST(velocity_direct_control, sees_the_wall_from_where_the_handle_is_and_how_it_moves) {
  const auto braked = [&](double v, double wall_v, double sensed_higher) {
    ph::contacts<2, 1> touched;
    auto floor = floor_at(0, -2e-3 + sensed_higher);
    floor.wall_velocity = {5, wall_v};
    touched.push_back(floor);
    ph::step_memory<law> memory;
    return ph::step(table(), without_lag(), touched, law(), state_of<table>({0, -2e-3}, {0, v}, {0, -2}),
                    memory)
        .capacity[1];
  };
  const double as_it_is = braked(-0.1, 0, 0);
  EXPECT_GT(as_it_is, 2);
  EXPECT_NEAR(braked(-0.06, 0.04, 0), as_it_is, 1e-9);
  EXPECT_NEAR(braked(-0.14, -0.04, 0), as_it_is, 1e-9);
  for (const double higher : {-1.5e-3, 1e-3}) EXPECT_NEAR(braked(-0.1, 0, higher), as_it_is, 1e-9);
  EXPECT_NEAR(braked(-0.011, 0, 1.9e-3), braked(-0.011, 0, 0), 1e-9);
}

TEST(velocity_direct_control, brakes_before_the_touch_within_its_margin) {
  constants p;
  const law control(p);
  const double margin = control.margin(without_lag());
  EXPECT_NEAR(margin, p.approach_speed / p.depth_gain, 1e-15);
  // 2 mm off the surface
  const auto approaching = [&](double speed, double off) { return once(control, off, {0, -speed}, {0, 0}); };
  const double allowed = p.depth_gain * (p.rest_depth + 0.002);
  EXPECT_EQ(approaching(0.99 * allowed, 0.002).capacity[1], 0);
  const auto result = approaching(allowed + 0.02, 0.002);
  EXPECT_NEAR(result.capacity[1], 0.02 * force_per_speed(p), 1e-9);
  EXPECT_EQ(result.wall_number, 0);
  EXPECT_EQ(result.desired_force, pair(0, 0)) << "before the touch the wall demands nothing";
  EXPECT_EQ(result.power, ph::power_class::none);
  EXPECT_GT(approaching(0.5, 0.99 * margin).capacity[1], 0);
  EXPECT_EQ(approaching(0.5, 1.01 * margin).capacity[1], 0);
  EXPECT_EQ(approaching(0.5, 1.01 * margin).wall_number, -1);
}

TEST(velocity_direct_control, has_a_margin_by_the_slowest_lag_and_none_at_an_approach_speed_of_0) {
  auto brakes = ph::brakes_of<table>();
  brakes.time_constant = {0.005, 0.02};
  EXPECT_NEAR(law().margin(brakes), 0.011, 1e-15);
  EXPECT_NEAR(law({.approach_speed = 0.2}).margin(brakes), 0.022, 1e-15);
  const law late({.approach_speed = 0});
  EXPECT_EQ(late.margin(brakes), 0);
  EXPECT_EQ(once(late, 1e-6, {0, -0.5}, {0, 0}).wall_number, -1);
  EXPECT_EQ(once(late, -1e-6, {0, -0.5}, {0, 0}).wall_number, 0);
}

// Along a circle it takes v^2 / R to stay at one depth.
TEST(velocity_direct_control, brakes_for_the_curvature_of_a_wall) {
  const double depth = constants().rest_depth;
  for (const auto side : {ph::filling::hollow, ph::filling::solid}) {
    const bool concave = side == ph::filling::hollow;
    const ph::disc round({0, concave ? 0.5 : -0.5}, 0.5, side);
    const auto touched = ph::sense(ph::scene(ph::wall(round)), {0, -depth});
    ASSERT_EQ(touched.size(), 1);
    ph::step_memory<law> memory;
    const auto result = ph::step(table(), without_lag(), touched, law(),
                                 state_of<table>({0, -depth}, {0.2, 0}, {0, -2}), memory);
    const double curving = (concave ? 1 : -1) * 0.2 * 0.2 / (concave ? 0.5 + depth : 0.5 - depth);
    EXPECT_NEAR(result.capacity[1], 2 * constants().force_share + slide_mass() * curving, 1e-9);
  }
}

// Of a round wall that was sensed elsewhere it is the normal there that counts.
TEST(velocity_direct_control, turns_the_normal_of_a_round_wall_that_was_sensed_elsewhere) {
  constexpr double radius = 0.5;
  const ph::disc round({0, -radius}, radius, ph::filling::solid);
  const ph::point<2> now(0.02, -3e-3);
  const auto braked = [&](const ph::point<2>& sensed) {
    const auto touched = ph::sense(ph::scene(ph::wall(round)), sensed);
    ph::step_memory<law> memory;
    return ph::step(table(), without_lag(), touched, law(), state_of<table>(now, {-0.2, -0.1}, {1, -2}),
                    memory)
        .control_force;
  };
  const pair there = braked(now), elsewhere = braked({0, -2e-3});
  EXPECT_GT(there.norm(), 10);
  EXPECT_LE((elsewhere - there).norm(), 0.05);
}

TEST(velocity_direct_control, refuses_constants_that_make_no_sense) {
  EXPECT_NE(
      thrown_by([] { law({.velocity_lag = 0}); }).find("velocity_lag [s] = 0: expected a finite number > 0"),
      std::string::npos);
}

// A wall near the floor that is left: neither the torques nor the bias of the floor change.
TEST(velocity_direct_control, does_not_see_a_near_wall_that_demands_nothing) {
  constexpr unsigned seed = 59;
  ph::testing::random_source random(seed);
  int braked = 0;
  for (int k = 0; k < 50; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", trial " << k);
    const pair n = random.direction<double, 2>(), along(-n[1], n[0]),
               push = random.normal_vector<double, 2>();
    const ph::contact<2> floor{.normal = n,
                               .depth = random.uniform(0.0, 3e-3),
                               .stiffness = 1e7,
                               .wall_number = 1,
                               .sensed_at = {0, 0}};
    auto near_by = floor;
    near_by.normal = along;
    near_by.depth = -8e-3;
    near_by.wall_number = 2;
    ph::contacts<2, 1> one;
    ph::contacts<2, 2> two;
    one.push_back(floor);
    for (const bool is_floor : {k % 2 == 0, k % 2 == 1}) two.push_back(is_floor ? floor : near_by);
    ph::step_memory<law> of_one, of_two;
    for (int cycle = 0; cycle < 5; ++cycle) {
      const pair v = 0.1 * std::abs(random.normal<double>()) * along + random.uniform(-0.02, 0.02) * n;
      auto state = state_of<table>({0, 0}, v, push);
      state.time = 1e-3 * cycle;
      const auto expected = ph::step(table(), ph::brakes_of<table>(), one, law(), state, of_one);
      EXPECT_EQ(ph::step(table(), ph::brakes_of<table>(), two, law(), state, of_two).capacity,
                expected.capacity);
      braked += !expected.capacity.isZero(0);
    }
  }
  EXPECT_GT(braked, 50);
}

// Which way a brake pushes is told by its rate once the handle has stopped sinking, w* = w - Lambda_n g n . v
// (g = T M^-1 J^T n), or sinks only to the depth of rest. Of brakes that push out then, the one with the
// least power |w*| / |g| for each acceleration makes all of the force.
TEST(velocity_direct_control, takes_the_brake_that_pushes_with_the_least_power_once_it_has_landed) {
  using M = ph::tendon_two_link<double>;
  constexpr unsigned seed = 12;
  ph::testing::random_source random(seed);
  const M arm;
  const constants p;
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(1e6);
  brakes.rate_dead_band.setConstant(1e-9);
  brakes.time_constant.setZero();
  int pushed = 0, turned = 0;
  for (int k = 0; k < 300; ++k) {
    const pair q(random.uniform(-3.0, 3.0), random.uniform(0.5, 2.6)), qd = random.normal_vector<double, 2>(),
                                                                       n = random.direction<double, 2>();
    const double depth = random.uniform(0.0, 6e-3);
    const ph::pose_dynamics<M> device({arm, q}, qd, p.hand_mass);
    const auto along = ph::response_along(n, device, pair(0, 0));
    const double sinking = -n.dot(device.velocity);
    const double v_ref =
        std::clamp(p.depth_gain * (depth - p.rest_depth), -p.velocity_limit, p.velocity_limit);
    const double force = along.inertia * ((v_ref + sinking) / p.velocity_lag - along.free);
    if (sinking < 0.1 || force < 0) continue;
    const pair landed = device.rates + along.inertia * (std::min(v_ref, 0.0) + sinking) * along.g;
    const pair power = landed.cwiseQuotient(along.g);  // < 0 where it pushes out
    if (power.minCoeff() > 0) continue;                // none will
    int best = 0;
    for (int i = 1; i < 2; ++i)
      if (power[i] < 0 && (power[best] > 0 || power[i] > power[best])) best = i;

    ph::contacts<2, 1> touched;
    touched.push_back({.normal = n, .depth = depth, .stiffness = 1e7, .sensed_at = arm.position(q)});
    ph::step_memory<law> memory;
    const auto result = ph::step(arm, brakes, touched, law(p), state_of<M>(q, qd), memory);
    const double torque = force / along.inertia / std::abs(along.g[best]);
    EXPECT_NEAR(result.capacity[best], torque, 1e-9 * torque) << "seed " << seed << ", trial " << k;
    EXPECT_EQ(result.capacity[1 - best], 0) << "seed " << seed << ", trial " << k;
    ++pushed;
    turned += (device.rates.array() * landed.array() < 0).any();
  }
  EXPECT_GT(pushed, 30);
  EXPECT_GT(turned, 5);
}

}  // namespace
