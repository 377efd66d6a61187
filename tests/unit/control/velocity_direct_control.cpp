// slow
// Direct control at the level of velocities, and what it is made of.
#include "../../property/chain_cases.hpp"
#include "../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/core/scalar/first_order_lag.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/simulated_device.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/shapes/offset.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iostream>
#include <stdexcept>
#include <utility>

namespace {

using table = ph::xy_table<double>;
using pair = ph::vector<double, 2>;
using law = ph::velocity_direct_control;
using constants = ph::velocity_direct_control_parameters;

// A floor at y = 0, free above; the table at x, y with velocity v, pushed by Fh.
ph::contact<2> floor_at(double x, double y) {
  return {.normal = {0, 1}, .depth = -y, .stiffness = 1e7, .sensed_at = {x, y}};
}

ph::brakes_of<table> without_lag() {
  ph::brakes_of<table> brakes;
  brakes.torque_limit.setConstant(100);
  brakes.time_constant.setZero();
  return brakes;
}

ph::step_result<table> once(const law& control, double y, const pair& v, const pair& Fh,
                            const ph::brakes_of<table>& brakes = without_lag()) {
  ph::contacts<2, 1> touched;
  touched.push_back(floor_at(0, y));
  ph::step_memory<law> memory;
  return ph::step(table(), brakes, touched, control, state_of<table>({0, y}, v, Fh), memory);
}

// With the hand that the law expects
double slide_mass() { return table().mass_matrix({0, 0})(1, 1) + constants().hand_mass; }

// Force for each m/s that the handle is too fast
double force_per_speed(const constants& p) { return slide_mass() / p.velocity_lag; }

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

// In a corner, where each wall has a brake of its own.
TEST(velocity_direct_control, holds_in_a_corner_what_sinks_and_nothing_that_leaves) {
  const constants p;
  const law control(p);
  const auto capacity = [&](const pair& v) {
    ph::contacts<2, 2> touched;
    for (const int i : {0, 1})
      touched.push_back({.normal = pair::Unit(i),
                         .depth = p.rest_depth,
                         .stiffness = 1e7,
                         .wall_number = i,
                         .sensed_at = {0, 0}});
    auto brakes = without_lag();
    brakes.rate_dead_band.setConstant(1e-9);
    ph::step_memory<law> memory;
    return pair(
        ph::step(table(), brakes, touched, control, state_of<table>({0, 0}, v, {0, 0}), memory).capacity);
  };
  const double mass = table().mass_matrix({0, 0})(0, 0) + p.hand_mass;
  for (const double force : {0.5, 3.0}) {
    const double v = force * p.velocity_lag / mass;
    EXPECT_TRUE(capacity({v, v}).isZero(0));
    EXPECT_NEAR(capacity({-v, -v})[0], force, 1e-6);
    EXPECT_NEAR(capacity({-v, -v})[1], force, 1e-6);
    EXPECT_NEAR(capacity({-v, v})[0], force, 1e-6);
    EXPECT_NEAR(capacity({-v, v})[1], 0, 1e-9);
  }
}

// Of two brakes that push alike the faster costs more power: shares as 1 / p^2, p = |w| and a thousandth of
// the fastest, which tells resting ones apart from none.
TEST(min_power_torques, of_several_walls_are_those_of_least_power) {
  ph::torque_range<double, 2> range;
  range.sign = {1, -1};
  range.lower = {0, 0};
  range.upper = {10, 10};
  const ph::matrix<double, 2, 2> rows = ph::matrix_of<2, 2>(1.0, -1.0, 0.0, 0.0);
  for (const pair& w : {pair(1, 3), pair(-3, 1), pair(2, 0), pair(0, 0)}) {
    const pair t = ph::min_power_torques<double, 2, 2>(rows, pair(4, 0), range, w);
    const double most = w.cwiseAbs().maxCoeff();
    const pair power = w.cwiseAbs().array() + 1e-3 * most;
    const double share = most > 0 ? power[1] * power[1] / power.squaredNorm() : 0.5;
    EXPECT_NEAR(t[0], 4 * share, 1e-8) << w.transpose();
    EXPECT_NEAR(t[1], 4 * (1 - share), 1e-8) << w.transpose();
  }
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

// The law on a slide that is held in one state, a cycle each millisecond.
struct held_slide {
  constants p = unfiltered();
  law control{p};
  ph::step_memory<law> memory = {};
  ph::brakes_of<table> brakes = without_lag();
  double time = 0;

  static constants unfiltered() {
    constants p;
    p.rate_lag = 0;
    p.depth_per_jump = 0;
    return p;
  }
  // Over a floor at this height [m]
  double cycle(double depth, double v, double Fh = 0, double height = 0) {
    ph::contacts<2, 1> touched;
    if (depth > 0) touched.push_back(floor_at(0, -depth));
    for (auto& c : touched) c.sensed_at[1] += height;
    auto state = state_of<table>({0, height - depth}, {0, v}, {0, Fh});
    state.time = time += 1e-3;
    return ph::step(table(), brakes, touched, control, state, memory).capacity[1];
  }
};

TEST(velocity_direct_control, learns_the_force_that_is_missing) {
  held_slide slide;
  const auto& p = slide.p;
  const double first = slide.cycle(p.rest_depth, -0.05), c = force_per_speed(p);
  EXPECT_NEAR(first, 0.05 * c, 1e-12);
  for (int k = 1; k <= 50; ++k)
    EXPECT_NEAR(slide.cycle(p.rest_depth, -0.05), first * (1 + (k - 1) * 1e-3 / p.integral_time), 1e-9);
  // Leaving with a brake that slips, it unlearns as fast
  for (int k = 0; k < 50; ++k) EXPECT_LE(slide.cycle(p.rest_depth, 0.05), first);
  EXPECT_NEAR(slide.cycle(p.rest_depth, -0.05), first, 1e-9);
  slide.cycle(-1, 0);  // free
  for (int k = 0; k < 50; ++k) slide.cycle(p.rest_depth, -0.05);
  slide.cycle(-1, 0);
  EXPECT_NEAR(slide.cycle(p.rest_depth, -0.05), first, 1e-9) << "a wall that was left is forgotten";
}

// What the brakes cannot make is not learned, and what was learned is kept within what they can.
TEST(velocity_direct_control, learns_no_more_than_its_brakes_can_make) {
  held_slide slide;
  const auto& p = slide.p;
  const double first = slide.cycle(p.rest_depth, -0.05);
  slide.brakes.torque_limit.setConstant(first - 0.5);
  for (int k = 0; k < 50; ++k) EXPECT_EQ(slide.cycle(p.rest_depth, -0.05), first - 0.5);
  slide.brakes.torque_limit.setConstant(100);
  EXPECT_NEAR(slide.cycle(p.rest_depth, -0.05), first, 1e-9);
  // Learned 6 N, then for a cycle at most 3 N, of which phi 5 N are fed forward; or 1 N of phi 10 N
  for (const auto& [limit, push] : {std::pair(3.0, 5.0), std::pair(1.0, 10.0)}) {
    for (int k = 0; k < 100; ++k) slide.cycle(p.rest_depth, -0.05);
    slide.brakes.torque_limit.setConstant(limit);
    slide.cycle(p.rest_depth, -0.05, -push);
    slide.brakes.torque_limit.setConstant(100);
    EXPECT_NEAR(slide.cycle(p.rest_depth, -0.05), first + std::max(limit - push * p.force_share, 0.0), 1e-9);
  }
  // A pull is not learned either
  slide.cycle(-1, 0);
  slide.cycle(p.rest_depth, 0.01, 10);
  slide.cycle(p.rest_depth, 0.01, 10);
  EXPECT_NEAR(slide.cycle(p.rest_depth, -0.05), first, 1e-9);
}

TEST(velocity_direct_control, smooths_rates_in_contact_alone) {
  held_slide slide;
  slide.p.rate_lag = constants().rate_lag;
  slide.p.integral_time = 1e9;  // nothing is learned
  slide.control = law(slide.p);
  const double c = force_per_speed(slide.p), fresh = -std::expm1(-1e-3 / slide.p.rate_lag);
  EXPECT_NEAR(slide.cycle(slide.p.rest_depth, -0.05), 0.05 * c, 1e-9);
  EXPECT_NEAR(slide.cycle(slide.p.rest_depth, -0.1), (0.05 + 0.05 * fresh) * c, 1e-6);
  slide.cycle(-1, 0);
  EXPECT_NEAR(slide.cycle(slide.p.rest_depth, -0.1), 0.1 * c, 1e-9);
}

// A push that is measured but not there: b undoes all that is fed forward for it, and no more.
TEST(velocity_direct_control, unlearns_a_push_that_is_not_there) {
  held_slide slide;
  const auto& p = slide.p;
  constexpr double push = 10;  // [N]
  EXPECT_NEAR(slide.cycle(p.rest_depth, -0.05, -push), 0.05 * force_per_speed(p) + push * p.force_share,
              1e-9);
  for (int k = 0; k < 100; ++k) slide.cycle(p.rest_depth, 0.05, -push);
  EXPECT_NEAR(slide.cycle(p.rest_depth, -0.05, -push), 0.05 * force_per_speed(p), 1e-9);
}

// Brakes that lag make nothing any more where the next contact begins.
TEST(velocity_direct_control, knows_that_brakes_are_let_go_in_free_space) {
  held_slide slide;
  slide.brakes.time_constant.setConstant(0.02);
  const double first = slide.cycle(slide.p.rest_depth, -0.05);
  for (int k = 0; k < 100; ++k) slide.cycle(slide.p.rest_depth, -0.05);
  slide.cycle(-1, 0);
  slide.time += 1;
  EXPECT_NEAR(slide.cycle(slide.p.rest_depth, -0.05), first, 1e-9);
}

// At rest it is held by 2 N: it is told twice that, and nothing is learned of it.
TEST(velocity_direct_control, a_brake_at_rest_is_told_little_more_than_what_holds_it) {
  held_slide slide;
  for (int k = 0; k < 50; ++k) EXPECT_NEAR(slide.cycle(5e-3, 0, -2), 4, 1e-9);
  EXPECT_NEAR(slide.cycle(slide.p.rest_depth, -0.05), 0.05 * force_per_speed(slide.p), 1e-9);
}

// Stuck as it leaves: b falls to a 1/e of itself on release_length.
TEST(velocity_direct_control, lets_a_brake_go_that_sticks_while_the_handle_leaves) {
  held_slide slide;
  const auto& p = slide.p;
  for (int k = 0; k < 100; ++k) slide.cycle(p.rest_depth, -0.05);
  const double learned = slide.cycle(p.rest_depth, -0.05) - 0.05 * force_per_speed(p);
  constexpr double speed = 0.01;  // within the dead band
  constexpr int cycles = 10;
  constexpr double push = 10;  // [N]
  for (int k = 0; k < cycles; ++k) slide.cycle(p.rest_depth, speed, -push);
  const double left = slide.cycle(p.rest_depth, -0.05) - 0.05 * force_per_speed(p);
  const double forward = push * p.force_share, share = std::pow(1 - 1e-3 * speed / p.release_length, cycles);
  EXPECT_NEAR(left, std::max((learned + forward) * share - forward, -forward), 0.05 * learned);
}

// However long it sticks so, no more is let go than all that is wanted: what the hand pulls is still met.
TEST(velocity_direct_control, lets_no_more_go_than_there_is) {
  held_slide slide;
  const auto& p = slide.p;
  for (int k = 0; k < 100; ++k) slide.cycle(p.rest_depth, -0.05);
  constexpr double pull = 10;  // [N], f_ff = -phi 10 N
  slide.time += 0.05;
  slide.cycle(p.rest_depth, 0.01, pull);
  EXPECT_NEAR(slide.cycle(p.rest_depth, -0.05), 0.05 * force_per_speed(p) + pull * p.force_share, 1e-9);
}

// What the depth jumps by, beyond its motion, is a count of the encoders: it rests deeper. At depths whose
// reference is below v_max.
TEST(velocity_direct_control, rests_deeper_where_it_sees_coarsely) {
  const constants p;
  constexpr double depth = 0.004, v = -0.05, dt = 1e-3;
  for (const double jump : {0.1e-3, 0.5e-3, 1e-3, 5e-3}) {
    held_slide slide;
    slide.p.depth_per_jump = p.depth_per_jump;
    slide.control = law(slide.p);
    slide.cycle(depth, v);
    const double f = slide.cycle(depth + jump - 2 * v * dt, v);
    const double rest = std::max(p.rest_depth, std::min(p.depth_per_jump * jump, constants::max_rest_depth));
    const double wanted = p.depth_gain * (depth + jump - 2 * v * dt - rest);
    EXPECT_NEAR(f, (wanted - v) * force_per_speed(p), 1e-9) << jump;
  }
}

// A floor that rises by itself is no count of the encoders.
TEST(velocity_direct_control, rests_no_deeper_where_the_wall_jumps) {
  held_slide slide;
  slide.p.depth_per_jump = constants().depth_per_jump;
  slide.p.integral_time = 1e9;  // nothing is learned
  slide.control = law(slide.p);
  constexpr double v = -0.05, rise = 2e-3, moved = 1e-4;
  const double depth = slide.p.rest_depth;
  slide.cycle(depth, v);
  const double f = slide.cycle(depth + rise + moved, v, 0, rise);
  EXPECT_NEAR(f, (slide.p.depth_gain * (rise + moved) - v) * force_per_speed(slide.p), 1e-6);
}

// A jump is forgotten in jump_time, and a pause of more than that forgets no more than all.
TEST(velocity_direct_control, forgets_how_coarsely_it_saw) {
  constexpr double depth = 0.004, v = -0.05, dt = 1e-3, jump = 0.5e-3, forgotten_in = 2;
  held_slide slide;
  slide.p.depth_per_jump = constants().depth_per_jump;
  slide.p.rest_depth = 1e-3;
  slide.p.integral_time = 1e9;  // nothing is learned
  slide.control = law(slide.p);
  const auto rest = [&] {
    return depth - (slide.cycle(depth, v) / force_per_speed(slide.p) + v) / slide.p.depth_gain;
  };
  slide.cycle(depth - jump + 2 * v * dt, v);
  EXPECT_NEAR(rest(), slide.p.depth_per_jump * jump, 1e-9);
  EXPECT_NEAR(rest(), slide.p.depth_per_jump * jump * (1 - dt / forgotten_in), 1e-9);
  slide.time += 0.5;
  EXPECT_NEAR(rest(),
              slide.p.depth_per_jump * jump * (1 - dt / forgotten_in) * (1 - (0.5 + dt) / forgotten_in),
              1e-9);
  for (int k = 0; k < 3; ++k) {
    slide.time += 5;
    EXPECT_NEAR(rest(), slide.p.rest_depth, 1e-9) << k;
  }
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

TEST(velocity_direct_control, a_held_contact_is_carried_on_to_second_order) {
  const ph::disc hollow({0, 1}, 1, ph::filling::hollow);
  const ph::point<2> sensed(0, -1e-3), now(0.01, -1e-3);
  const auto c = ph::sense(ph::scene(ph::wall(hollow)), sensed)[0];
  const ph::point<2> moved = now - sensed;
  const double depth = c.depth - moved.dot(c.normal + 0.5 * (c.curvature * moved));
  EXPECT_NEAR(depth, -hollow.distance(now), 1e-7);
  EXPECT_LE((ph::point<2>(c.normal + c.curvature * moved).normalized() - hollow.gradient(now)).norm(), 1e-5);
  EXPECT_GT(std::abs(c.depth - moved.dot(c.normal) + hollow.distance(now)), 4e-5)
      << "to first order it is off";
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
  constants p;
  p.velocity_lag = 0;
  try {
    const law control(p);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("velocity_lag [s] = 0, expected a finite number > 0"),
              std::string::npos)
        << error.what();
  }
}

// A handle pressed into a corner of two walls touches both and stays; each wall has a depth of its own.
TEST(velocity_direct_control, holds_in_the_corner_of_two_walls) {
  using M = ph::tendon_two_link<double>;
  const M arm;
  constants p;
  const ph::half_space<2> ceiling({0, 0.2}, {0, -1}), side({0.1, 0}, {-1, 0});
  ph::controller control(arm, ph::brakes_of<M>(), ph::scene(ph::wall(ceiling), ph::wall(side)), law(p));
  const pair q = arm.inverse({0.095, 0.192}, ph::elbow::left).q;
  ph::simulated_device device(arm, ph::brakes_of<M>(), 0.5, q);
  ph::first_order_lag<double, 2> sensor(pair::Constant(ph::low_pass_time_constant(200.0)));
  pair capacity = pair::Zero();
  double max_depth = -1, shallowest = 1;
  for (int k = 0; k < 20'000; ++k) {
    if (k % 10 == 0)
      capacity = control(ph::device_state<M>{k * 1e-4, device.q(), device.qd(), sensor.output()}).capacity;
    const pair v = device.velocity();
    device.advance(1e-4, capacity, pair(2, 2) - 20 * v);
    sensor.advance(1e-4, device.sensed_force());
    if (k < 10'000) continue;
    for (const double depth : {-ceiling.distance(device.position()), -side.distance(device.position())}) {
      max_depth = std::max(max_depth, depth);
      shallowest = std::min(shallowest, depth);
    }
  }
  EXPECT_GT(shallowest, 1e-4);
  EXPECT_LT(max_depth, p.rest_depth + 1e-3);
}

// More brakes than the least squares eliminate in closed form, fewer walls than brakes.
TEST(velocity_direct_control, keeps_to_six_brakes_at_two_walls) {
  using chain = chains::irregular_chain<double, 6, 3>;
  using M = chain::mechanism;
  const M arm = chain::make();
  const auto brakes = ph::brakes_of<M>();
  std::cout << "seed 36\n";
  ph::testing::random_source random(36);
  int displayed = 0;
  for (int k = 0; k < 300; ++k) {
    ph::device_state<M> state{
        .time = 1, .q = random.normal_vector<double, 6>(), .qd = random.normal_vector<double, 6>()};
    state.hand_force = random.normal_vector<double, 3>();
    const ph::point<3> x = arm.position(state.q), n = random.direction<double, 3>(),
                       other = random.direction<double, 3>();
    ph::controller control(arm, brakes,
                           ph::scene(ph::wall(ph::half_space<3>(x + 1e-3 * n, n)),
                                     ph::wall(ph::half_space<3>(x + 2e-3 * other, other))),
                           law());
    const auto result = control(state);
    ASSERT_EQ(result.outcome, ph::status::ok) << k;
    for (int i = 0; i < 6; ++i) {
      ASSERT_GE(result.capacity[i], 0) << k;
      ASSERT_LE(result.capacity[i], brakes.torque_limit[i]) << k;
      ASSERT_LE(result.signs[i] * result.torque[i], 0) << k;
    }
    displayed += !result.capacity.isZero();
  }
  EXPECT_GT(displayed, 100);
}

// Each brake there is at rest: its sign is that of the push on it, not of the velocity that is stopped at
// both walls, and it gets more than holds the hand.
TEST(velocity_direct_control, holds_a_handle_at_rest_in_a_corner) {
  const constants p;
  constexpr double sinking = 0.005;
  const pair push(2, 3);
  auto brakes = without_lag();
  brakes.rate_dead_band.setConstant(2 * sinking);
  ph::contacts<2, 2> corner;
  for (const pair& n : {pair(1, 0), pair(0, 1)})
    corner.push_back({.normal = n, .depth = p.rest_depth, .stiffness = 1e7, .sensed_at = {0, 0}});
  ph::step_memory<law> memory;
  const auto held =
      ph::step(table(), brakes, corner, law(), state_of<table>({0, 0}, {-sinking, -sinking}, -push), memory);
  for (int i = 0; i < 2; ++i)
    EXPECT_NEAR(held.capacity[i], sinking * force_per_speed(p) + 1.3 * push[i], 1e-6);
}

// Deeper than it shall rest, it creeps in, so that neither brake can push it out.
TEST(velocity_direct_control, lets_a_hand_pull_a_handle_at_rest_out_of_a_corner) {
  const auto capacity = [](double creep, double dead_band) {
    auto brakes = without_lag();
    brakes.rate_dead_band.setConstant(dead_band);
    ph::contacts<2, 2> corner;
    for (const int i : {0, 1})
      corner.push_back(
          {.normal = pair::Unit(i), .depth = 4e-3, .stiffness = 1e7, .wall_number = i, .sensed_at = {0, 0}});
    ph::step_memory<law> memory;
    const auto state = state_of<table>({0, 0}, {-creep, -creep}, {3, 3});
    return pair(ph::step(table(), brakes, corner, law(), state, memory).capacity);
  };
  EXPECT_EQ(capacity(1e-3, 2e-3), pair(0, 0));
  EXPECT_GT(capacity(1e-3, 1e-9).minCoeff(), 0) << "brakes that turn slow it down";
}

// A wall near the floor that is left: neither the torques nor the bias of the floor change.
TEST(velocity_direct_control, does_not_see_a_near_wall_that_demands_nothing) {
  using M = ph::tendon_two_link<double>;
  const M arm;
  const auto brakes = ph::brakes_of<M>();
  constexpr unsigned seed = 59;
  ph::testing::random_source random(seed);
  int braked = 0;
  for (int k = 0; k < 200; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", trial " << k);
    const pair q(random.uniform(-3.0, 3.0), random.uniform(0.5, 2.6)),
        push = random.normal_vector<double, 2>();
    const ph::matrix<double, 2, 2> J = arm.jacobian(q);
    const pair n = random.direction<double, 2>(), along(-n[1], n[0]);
    const double depth = random.uniform(0.0, 3e-3);
    ph::step_memory<law> of_one, of_two;
    for (int cycle = 0; cycle < 5; ++cycle) {
      const pair v = 0.1 * std::abs(random.normal<double>()) * along + random.uniform(-0.02, 0.02) * n;
      ph::device_state<M> state{.time = 1e-3 * cycle, .q = q, .qd = J.inverse() * v, .hand_force = push};
      const ph::contact<2> floor{
          .normal = n, .depth = depth, .stiffness = 1e7, .wall_number = 1, .sensed_at = arm.position(q)};
      auto near_by = floor;
      near_by.normal = along;
      near_by.depth = -8e-3;
      near_by.wall_number = 2;
      ph::contacts<2, 1> one;
      ph::contacts<2, 2> two;
      one.push_back(floor);
      for (const bool is_floor : {k % 2 == 0, k % 2 == 1}) two.push_back(is_floor ? floor : near_by);
      const auto expected = ph::step(arm, brakes, one, law(), state, of_one);
      EXPECT_EQ(ph::step(arm, brakes, two, law(), state, of_two).capacity, expected.capacity);
      braked += !expected.capacity.isZero(0);
    }
  }
  EXPECT_GT(braked, 200);
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
  for (int k = 0; k < 1000; ++k) {
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
  EXPECT_GT(pushed, 100);
  EXPECT_GT(turned, 20);
}

// Back along the wall the cone leaves brake 1 alone, 51 deg from the wall's normal, while brake 2 comes to
// rest: told more it does nothing. A law that does not know that lets the handle slide into the wall along
// the path of brake 2, by centimetres.
TEST(velocity_direct_control, knows_that_a_brake_at_rest_only_holds) {
  using M = ph::tendon_two_link<double>;
  const M arm;
  constants p;
  const ph::half_space<2> ceiling({0, 0.225}, {0, -1});
  for (const double x : {0.08, 0.11, 0.14, 0.165}) {
    ph::controller control(arm, ph::brakes_of<M>(), ph::scene(ph::wall(ceiling)), law(p));
    const pair q = arm.inverse({x, 0.221}, ph::elbow::left).q;
    ph::simulated_device device(arm, ph::brakes_of<M>(), 0.5, q);
    ph::first_order_lag<double, 2> sensor(pair::Constant(ph::low_pass_time_constant(200.0)));
    pair capacity = pair::Zero();
    double max_depth = -1;
    for (int k = 0; k < 20'000; ++k) {
      if (k % 10 == 0)
        capacity = control(ph::device_state<M>{k * 1e-4, device.q(), device.qd(), sensor.output()}).capacity;
      const pair v = device.velocity();
      device.advance(1e-4, capacity, pair(-1, 2) - 20 * v);
      sensor.advance(1e-4, device.sensed_force());
      max_depth = std::max(max_depth, -ceiling.distance(device.position()));
    }
    EXPECT_LT(max_depth, 12e-3) << "from x = " << x;
  }
}

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

// Against all ways to make the same on a grid.
TEST(min_power_torques, make_what_is_wanted_with_the_least_power) {
  constexpr unsigned seed = 9;
  using V = ph::vector<double, 3>;
  ph::testing::random_source random(seed);
  for (int k = 0; k < 200; ++k) {
    const V g = random.normal_vector<double, 3>(), w = random.normal_vector<double, 3>();
    ph::torque_range<double, 3> range;
    for (int i = 0; i < 3; ++i) {
      range.sign[i] = random.uniform(-1.0, 1.0) > 0 ? 1 : -1;
      range.lower[i] = random.uniform(0.0, 0.2);
      range.upper[i] = range.lower[i] + random.uniform(0.0, 1.0);
      range.sign_is_lasting[i] = true;
    }
    const V gain = range.sign.cwiseProduct(g);
    const double wanted = random.uniform(-0.5, 2.0);
    const V t = ph::min_power_torques<double, 3>(g, wanted, range, w);
    double most = 0, min_power = 1e9;
    for (int i = 0; i < 3; ++i) {
      EXPECT_GE(t[i], range.lower[i]);
      EXPECT_LE(t[i], range.upper[i]);
      most += gain[i] * (gain[i] > 0 ? range.upper[i] : range.lower[i]);
    }
    const double floor = gain.dot(range.lower);
    EXPECT_NEAR(gain.dot(t), std::max(floor, std::min(wanted, most)), 1e-12)
        << "seed " << seed << ", trial " << k;
    constexpr int steps = 20;
    for (int a = 0; a <= steps; ++a)
      for (int b = 0; b <= steps; ++b)
        for (int c = 0; c <= steps; ++c) {
          const V share(double(a) / steps, double(b) / steps, double(c) / steps);
          const V other = range.lower + share.cwiseProduct(range.upper - range.lower);
          if (gain.dot(other) >= std::min(wanted, most) - 1e-12)
            min_power = std::min(min_power, w.cwiseAbs().dot(other));
        }
    EXPECT_LE(w.cwiseAbs().dot(t), min_power + 1e-9) << "seed " << seed << ", trial " << k;
  }
}

// Beside brake i that is held, brake j gives the handle g_j - g_i A_ij / A_ii for each N m.
TEST(min_power_torques, ask_a_brake_that_turns_for_what_it_does_beside_one_that_is_held) {
  using V = ph::vector<double, 2>;
  for (const int held : {0, 1}) {
    for (const double sign : {-1.0, 1.0}) {
      const int turns = 1 - held;
      V g;
      g[held] = 1;
      g[turns] = -0.2 * sign;
      ph::torque_range<double, 2> range;
      range.sign[held] = 1;
      range.sign[turns] = sign;
      range.lower.setConstant(0.1);
      range.upper[held] = 3;
      range.upper[turns] = 1;
      range.A.diagonal().setConstant(2);
      range.A(held, turns) = range.A(turns, held) = -sign;
      range.any_at_rest = range.at_rest[held] = range.held[held] = true;
      range.sign_is_lasting.setConstant(true);
      const double alone = 3 - 0.2 * 0.1, beside = 0.5 - 0.2;
      for (const auto& [wanted, torque] : {std::pair(alone, 0.1), std::pair(alone + 0.5 * beside, 0.6),
                                           std::pair(alone + 2 * beside, 1.0)}) {
        const V t = ph::min_power_torques<double, 2>(g, wanted, range, V(0, 0));
        EXPECT_NEAR(t[held], 3, 1e-12) << wanted;
        EXPECT_NEAR(t[turns], torque, 1e-12) << wanted;
      }
    }
  }
}

// A brake at rest that pushes in, or makes nothing, is not held: no other is asked for more beside it.
TEST(min_power_torques, ask_nobody_beside_a_brake_that_is_not_held) {
  using V = ph::vector<double, 2>;
  const auto torques = [](double sign, double most) {
    ph::torque_range<double, 2> range;
    range.sign = V(sign, 1);
    range.lower = V(std::min(0.1, most), 0.2);
    range.upper = V(most, 5);
    range.A << 2, -1, -1, 2;
    range.any_at_rest = range.at_rest[0] = range.held[0] = true;
    range.sign_is_lasting.setConstant(true);
    return ph::min_power_torques<double, 2>(V(1, -0.2), 10, range, V(0, 0));
  };
  EXPECT_EQ(torques(1, 0.5), V(0.5, 5)) << "it is held, and the other helps";
  EXPECT_EQ(torques(1, 0), V(0, 0.2)) << "it makes nothing";
  EXPECT_EQ(torques(-1, 3), V(0.1, 0.2)) << "it pushes in";
}

// Brakes that turn in their order, each up to its most; one that is at rest is not asked.
TEST(min_power_torques, ask_brakes_beside_one_that_is_held_in_turn) {
  using V = ph::vector<double, 4>;
  ph::torque_range<double, 4> range;
  range.sign.setOnes();
  range.lower.setZero();
  range.upper = V(0.5, 5, 1, 5);
  range.A.setConstant(-1);
  range.A.diagonal().setConstant(2);  // 0.3 for each N m of the others
  range.any_at_rest = range.at_rest[0] = range.at_rest[1] = range.held[0] = true;
  range.sign_is_lasting.setConstant(true);
  const auto torques = [&](double wanted) {
    return ph::min_power_torques<double, 4>(V(1, -0.2, -0.2, -0.2), wanted, range, V::Zero());
  };
  EXPECT_LE((torques(0.5 + 0.3 * 0.4) - V(0.5, 0, 0.4, 0)).norm(), 1e-12);
  EXPECT_LE((torques(0.5 + 0.3 * 1.5) - V(0.5, 0, 1, 0.5)).norm(), 1e-12);
  EXPECT_LE((torques(100) - V(0.5, 0, 1, 5)).norm(), 1e-12);
  range.A(0, 3) = range.A(3, 0) = 1;  // the last would pull in
  EXPECT_LE((torques(100) - V(0.5, 0, 1, 0)).norm(), 1e-12);
}

// Two walls that the brakes can serve both: each gets what it wants, also where that is less than nothing.
TEST(min_power_torques, serve_several_walls_together) {
  ph::torque_range<double, 3> range;
  range.sign = {1, -1, 1};
  range.lower.setConstant(0.05);
  range.upper.setConstant(10);
  const ph::matrix<double, 2, 3> rows{{1, 0.5, -1}, {0.2, 1, 0.3}};
  const ph::vector<double, 3> w(1, 1, 1);
  for (const ph::vector<double, 2>& wanted : {ph::vector<double, 2>(2, 1), ph::vector<double, 2>(-1, 2)}) {
    const auto t = ph::min_power_torques<double, 3, 2>(rows, wanted, range, w);
    EXPECT_LE((rows * range.sign.cwiseProduct(t) - wanted).norm(), 1e-9);
    EXPECT_GE(t.minCoeff(), 0.05 - 1e-12);
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
  const ph::mechanism_pose<M> pose(delta, V(0.3, 0.4, 0.5));
  const auto cornered = [&](const V& v, const V& Fh, std::initializer_list<V> normals, bool closed = true) {
    std::array<plain_wall, 3> walls;
    int count = 0;
    for (const V& normal : normals) walls[std::size_t(count++)].along.normal = normal;
    walls[1].closed = closed;
    const V qd = delta.jacobian(pose.q()).inverse() * v;
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

TEST(brake_lag_model, follows_a_first_order_lag_and_inverts_it) {
  constexpr unsigned seed = 5;
  ph::testing::random_source random(seed);
  const pair lag(0.02, 0.005);
  ph::brake_lag_model model;
  ph::first_order_lag<double, 2> brake(lag);
  const double period = 1e-3, horizon = 5e-3;
  for (int k = 0; k < 1000; ++k) {
    model.advance(k * period, lag);
    pair u;
    for (int i = 0; i < 2; ++i)
      u[i] = model.command(i, random.uniform(0.0, 1.0), 1.0, ph::lag_share(horizon, lag[i]));
    ASSERT_TRUE((u.array() >= 0).all() && (u.array() <= 1).all());
    brake.advance(period, u);
  }
  // From rest and unlimited, the brake has the wanted torque a horizon later
  ph::brake_lag_model fresh;
  const double share = ph::lag_share(horizon, lag[0]);
  fresh.advance(0, lag);
  const double u = fresh.command(0, 0.3, 100.0, share);
  ph::first_order_lag<double, 1> one(ph::vector<double, 1>::Constant(lag[0]));
  EXPECT_NEAR(one.advance(horizon, ph::vector<double, 1>::Constant(u))[0], 0.3, 1e-14);
  // The model knows: asked for the same a horizon later, it commands just that
  fresh.advance(horizon, lag);
  EXPECT_NEAR(fresh.command(0, 0.3, 100.0, share), 0.3, 1e-14);
  EXPECT_EQ(fresh.command(1, 0.3, 100.0), 0.3) << "no lag, nothing to invert";
  EXPECT_EQ(fresh.command(0, 5.0, 0.4, share), 0.4) << "its limit";
  const double before = fresh.torque(0);
  fresh.advance(0, lag);
  EXPECT_EQ(fresh.torque(0), before) << "time runs backwards";
}

// The contacts of a cycle: a wall number and the angle of the normal [degrees] each.
ph::contacts<2, 8> touched_at(std::initializer_list<std::pair<int, double>> walls) {
  ph::contacts<2, 8> touched;
  for (const auto& [wall, angle] : walls)
    touched.push_back(
        {.normal = {std::cos(ph::radians(angle)), std::sin(ph::radians(angle))}, .wall_number = wall});
  return touched;
}

TEST(contact_memory, is_a_walls_own_while_it_is_touched) {
  ph::contact_memory<int, 8> memory;
  memory.begin_cycle(touched_at({{7, 90}, {9, 90}}));
  memory[0] = 70;
  memory[1] = 90;
  memory.begin_cycle(touched_at({{9, 90}, {7, 90}}));
  EXPECT_EQ(memory[0], 90);
  EXPECT_EQ(memory[1], 70);
  memory.begin_cycle(touched_at({{9, 80}}));
  memory.begin_cycle(touched_at({{7, 90}, {9, 75}}));
  EXPECT_EQ(memory[0], 0) << "it was not touched in between";
  EXPECT_EQ(memory[1], 90);
  memory.clear();
  memory.begin_cycle(touched_at({{9, 75}}));
  EXPECT_EQ(memory[0], 0);
}

TEST(contact_memory, is_each_faces_own_of_one_wall) {
  ph::contact_memory<int, 8> memory;
  memory.begin_cycle(touched_at({{7, 60}}));
  memory[0] = 60;
  memory.begin_cycle(touched_at({{7, 120}, {7, 62}}));
  EXPECT_EQ(memory[0], 0) << "another face of the same wall";
  EXPECT_EQ(memory[1], 60);
  memory[0] = 120;
  memory.begin_cycle(touched_at({{7, 150}}));
  EXPECT_EQ(memory[0], 120) << "the nearest normal, however far it turned";
}

// Between two blocks side by side: the second is near, with its flank, before its top takes over.
TEST(contact_memory, goes_on_across_a_seam) {
  ph::contact_memory<int, 8> memory;
  memory.begin_cycle(touched_at({{1, 90}, {2, 180}}));
  memory[0] = 90;
  memory[1] = 180;
  memory.begin_cycle(touched_at({{1, 0}, {2, 91}}));
  EXPECT_EQ(memory[0], 0);
  EXPECT_EQ(memory[1], 90);
  memory.begin_cycle(touched_at({{3, 130}}));
  EXPECT_EQ(memory[0], 0) << "no seam but an edge";
}

// Beyond max_contacts a law would share a memory between two walls.
TEST(a_law_with_a_memory_of_walls, releases_the_brakes_where_more_are_touched) {
  using M = ph::tendon_two_link<double>;
  const auto outcome = [](int walls, int near = 0) {
    ph::contacts<2, 12> touched;
    for (int k = 0; k < walls + near; ++k)
      touched.push_back({.normal = {0, -1},
                         .depth = k < near ? -1e-3 : 1e-3,
                         .stiffness = 1e3,
                         .wall_number = k,
                         .sensed_at = {0, 0}});
    ph::step_memory<ph::velocity_direct_control> memory;
    const auto result = ph::step(M(), ph::brakes_of<M>(), touched, ph::velocity_direct_control(),
                                 state_of<M>({0.2, 0.4}, {0.3, 2}, {0.1, 1}), memory);
    EXPECT_TRUE(result.outcome == ph::status::ok || result.capacity.isZero(0));
    return result.outcome;
  };
  EXPECT_EQ(outcome(8), ph::status::ok);
  EXPECT_EQ(outcome(9), ph::status::too_many_contacts);
  EXPECT_EQ(outcome(12), ph::status::too_many_contacts);
  EXPECT_EQ(outcome(1, 11), ph::status::ok) << "only near, not touched";
  EXPECT_EQ(outcome(8, 4), ph::status::ok);
  EXPECT_EQ(outcome(9, 3), ph::status::too_many_contacts);
}

}  // namespace
