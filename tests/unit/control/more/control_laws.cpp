// What each law commands, by hand on the XY table, where E = I and forces are torques.
#include "../../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/rivals/bang_bang_control.hpp>
#include <passive_haptics/control/laws/rivals/coercive_force_approximation.hpp>
#include <passive_haptics/control/laws/rivals/on_off_control.hpp>
#include <passive_haptics/control/laws/rivals/single_degree_of_freedom_control.hpp>
#include <passive_haptics/control/laws/rivals/velocity_ratio_control.hpp>
#include <passive_haptics/control/laws/saturated_direct_control.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/wall_following.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <Eigen/LU>

#include <stdexcept>

namespace {

using table = ph::xy_table<double>;
using V2 = Eigen::Vector2d;

// The wall is above, free below.
ph::contact<2> above(double depth, double stiffness = 1000) {
  return {.normal = {0, -1}, .depth = depth, .stiffness = stiffness, .sensed_at = {0, 0}};
}
// Out of this wall is to the right and mostly down.
ph::contact<2> slanted(double depth, double stiffness = 1000) {
  return {.normal = V2(0.6, -0.8), .depth = depth, .stiffness = stiffness, .sensed_at = {0, 0}};
}

// The same, moving.
ph::contact<2> moving(const V2& velocity, ph::contact<2> c) {
  c.wall_velocity = velocity;
  return c;
}

// A law with what it remembers, on the table with brakes of 10 N and a dead band of 2 mm/s.
template <class L>
struct on_table {
  L law = {};
  ph::step_memory<L> memory = {};
  ph::brakes_of<table> brakes = [] {
    ph::brakes_of<table> b;
    b.torque_limit.setConstant(10);
    b.rate_dead_band.setConstant(0.002);
    return b;
  }();
  ph::step_options<double> options = {};

  template <class... Walls>
  ph::step_result<table> operator()(const V2& v, const V2& hand, const Walls&... walls) {
    ph::contacts<2, 2> touched;
    (touched.push_back(walls), ...);
    return ph::step(table(), brakes, touched, law, state_of<table>({0, 0}, v, hand), memory, options);
  }
};

constexpr double rounding = 1e-12;

// ---- the order of limits and alpha

template <class Law>
ph::step_result<table> leave_the_wall(const V2& hand, double limit, const ph::step_options<double>& options) {
  ph::brakes_of<table> brakes;
  brakes.torque_limit.setConstant(limit);
  ph::contacts<2, 1> wall;
  wall.push_back(above(0.005, 1e7));  // 5e4 N
  ph::step_memory<Law> memory;
  return ph::step(table(), brakes, wall, Law(), state_of<table>({0, 0}, {0.05, -0.01}, hand), memory,
                  options);
}

TEST(order_of_saturation, alpha_scales_the_force_or_what_the_brakes_can_make_of_it) {
  const V2 hand(0, 2);
  for (const auto policy : {ph::saturation::keep_direction, ph::saturation::clamp_each}) {
    const ph::step_options<double> options(ph::approximation_parameters<double>(), policy);
    const auto printed = leave_the_wall<ph::direct_control>(hand, 10, options);
    const auto read = leave_the_wall<ph::saturated_direct_control>(hand, 10, options);
    for (const auto& result : {printed, read}) {
      EXPECT_EQ(result.outcome, ph::status::ok);
      EXPECT_NEAR(result.alpha, 2 / 5e4, 1e-12);  // as the paper prints it
      EXPECT_NEAR(result.control_force.norm(), 5e4, 1e-6) << "before alpha and limits";
    }
    EXPECT_NEAR(printed.capacity[1], 2, rounding);
    EXPECT_FALSE(printed.saturated);
    EXPECT_NEAR(read.capacity[1], 10 * 2 / 5e4, rounding);
    EXPECT_TRUE(read.saturated);
    EXPECT_EQ(printed.capacity[0], 0);
    EXPECT_EQ(read.capacity[0], 0);
  }
}

TEST(order_of_saturation, is_the_same_where_nothing_is_cut_or_scaled) {
  const ph::step_options<double> options;
  const auto same = [&](const V2& hand, double limit) {
    const auto printed = leave_the_wall<ph::direct_control>(hand, limit, options);
    const auto read = leave_the_wall<ph::saturated_direct_control>(hand, limit, options);
    EXPECT_EQ(printed.capacity, read.capacity);
    EXPECT_EQ(printed.torque, read.torque);
    EXPECT_EQ(printed.saturated, read.saturated);
  };
  same({0, 2}, 1e6);   // strong brakes
  same({0, -2}, 10);   // a hand that pulls away: alpha = 0
  same({0, 1e6}, 10);  // and one that pushes harder than the wall: alpha = 1
}

// ---- direct control with a dead band

TEST(direct_control_dead_band, nulls_a_handle_that_sinks_slowly) {
  const V2 n(0, -1), hand(0, 1);  // presses with 1 N against 4 N
  const auto alpha = [&](const ph::direct_control& law, double outward) {
    return law.scale(ph::contact_situation<double, 2>{n, 4, outward, hand});
  };
  const ph::direct_control as_printed, early{.velocity_dead_band = 0.005};
  for (const double outward : {0.1, 0.006}) {
    EXPECT_EQ(alpha(as_printed, outward), 0.25);
    EXPECT_EQ(alpha(early, outward), 0.25);
  }
  for (const double outward : {0.0, -0.0, -0.001, -0.0049}) {
    EXPECT_EQ(alpha(as_printed, outward), 1) << outward;
    EXPECT_EQ(alpha(early, outward), 0.25) << outward;
  }
  for (const double outward : {-0.005, -0.1}) {
    EXPECT_EQ(alpha(as_printed, outward), 1) << outward;
    EXPECT_EQ(alpha(early, outward), 1) << outward;
  }
  on_table<ph::direct_control> step{.law = early};
  EXPECT_DOUBLE_EQ(step({0.1, 0.004}, hand, above(0.004)).alpha, 0.25);
}

// ---- coercive force approximation

TEST(coercive_force_approximation, is_the_desired_force_in_passive_region_1) {
  on_table<ph::coercive_force_approximation> law;
  const auto result = law({-0.1, 0.1}, {0, 0}, slanted(0.005));  // 5 N
  EXPECT_LE((result.torque - V2(3, -4)).norm(), rounding);
  EXPECT_EQ(result.display, ph::display_class::exact);
}

TEST(coercive_force_approximation, holds_brakes_that_move_in_and_releases_those_that_move_out) {
  on_table<ph::coercive_force_approximation> law;
  EXPECT_LE((law({0.1, 0.1}, {0, 0}, slanted(0.005)).torque - V2(0, -4)).norm(), rounding);
  EXPECT_LE((law({-0.1, -0.1}, {0, 0}, slanted(0.005)).torque - V2(3, 0)).norm(), rounding);
  EXPECT_TRUE(law({0.1, -0.1}, {0, 0}, slanted(0.005)).capacity.isZero(0)) << "both move out";
}

TEST(coercive_force_approximation, judges_brakes_at_rest_by_the_hand) {
  on_table<ph::coercive_force_approximation> law;
  EXPECT_LE((law({0, 0}, {1, 1}, slanted(0.005)).capacity - V2(0, 4)).norm(), rounding);
  EXPECT_LE((law({0, 0}, {0, 0}, slanted(0.005)).capacity - V2(3, 4)).norm(), rounding)
      << "nobody pushes: both";
  EXPECT_EQ(law({0, 0}, {1, 1}, slanted(1)).capacity, V2(0, 10)) << "the limit";
}

TEST(coercive_force_approximation, of_two_walls_takes_the_larger_part) {
  on_table<ph::coercive_force_approximation> law;
  EXPECT_LE((law({-0.1, 0.1}, {0, 0}, slanted(0.005), above(0.003)).torque - V2(3, -4)).norm(), rounding);
  EXPECT_LE((law({-0.1, 0.1}, {0, 0}, slanted(0.005), above(0.006)).torque - V2(3, -6)).norm(), rounding);
}

// Brakes that it holds move in, those that it releases move out: so also where the cone has nothing to
// display.
TEST(coercive_force_approximation, leaves_no_motion_into_the_wall_where_nothing_can_be_displayed) {
  using device = ph::tendon_two_link<double>;
  const device arm;
  ph::testing::random_source random(1);
  int coerced = 0, exact = 0, rounded = 0;
  for (int k = 0; k < 3000; ++k) {
    const auto state = state_of<device>({random.uniform(-3.0, 3.0), random.uniform(0.3, 2.8)},
                                        {random.wide(0.1, 3.0), random.wide(0.1, 3.0)});
    const auto contact = asking_for<2>(5 * random.direction<double, 2>());
    const auto none = step_once<ph::no_direct_control>(arm, ph::brakes_of<device>(), state, contact);
    const auto result =
        step_once<ph::coercive_force_approximation>(arm, ph::brakes_of<device>(), state, contact);
    const auto E = ph::brake_jacobian(arm, state.q);
    V2 w = ph::brake_rates(arm, state.q, state.qd);
    for (int i = 0; i < 2; ++i) {
      if (result.capacity[i] > 0) w[i] = 0;
    }
    EXPECT_GE(contact.normal.dot(E * w), -1e-12);
    const bool held = (result.capacity.array() > 0 && result.capacity.array() < 1).all();
    if (held) ++(result.display == ph::display_class::exact ? exact : rounded);
    if (none.display == ph::display_class::none && result.capacity.norm() > 0) ++coerced;
  }
  EXPECT_GT(coerced, 10);
  EXPECT_GT(exact, 100) << "passive region 1, within the limits";
  EXPECT_LE(rounded, 10) << "near singular poses";
}

// ---- single-degree-of-freedom control

using sdof = on_table<ph::single_degree_of_freedom_control>;
constexpr ph::single_degree_of_freedom_parameters band{.reference_depth = 1e-3, .band = 0.2e-3};

TEST(single_degree_of_freedom, locks_for_the_flattest_path_that_fits) {
  // Moving by (1, 1): with x locked straight in (0, 1), with y locked out by (1, 0)
  const V2 v(0.1, 0.1);
  EXPECT_EQ(sdof{.law = {band}}(v, {0, 0}, slanted(1e-3)).torque, V2(0, -10)) << "flattest";
  EXPECT_EQ(sdof{.law = {band}}(v, {0, 0}, slanted(2e-3)).torque, V2(0, -10)) << "too deep: the path out";
  EXPECT_EQ(sdof{.law = {band}}(v, {0, 0}, slanted(0.1e-3)).torque, V2(-10, 0)) << "too far out: the path in";
  // By (-1, 1) both lead in, by (1, -1) both lead out
  EXPECT_EQ(sdof{.law = {band}}({-0.1, 0.1}, {0, 0}, slanted(2e-3)).torque, V2(10, -10)) << "no way out: all";
  EXPECT_EQ(sdof{.law = {band}}({-0.1, 0.1}, {0, 0}, slanted(1e-3)).torque, V2(0, -10));
  EXPECT_EQ(sdof{.law = {band}}({0.1, -0.1}, {0, 0}, slanted(0.1e-3)).torque, V2(0, 10))
      << "no way in: flattest";
}

TEST(single_degree_of_freedom, keeps_its_brake_within_the_band) {
  sdof law{.law = {band}};
  const V2 v(0.1, 0.1), x_locked(-10, 0), y_locked(0, -10);
  EXPECT_EQ(law(v, {0, 0}, slanted(0.7e-3)).torque, x_locked);
  EXPECT_EQ(law(v, {0, 0}, slanted(1.1e-3)).torque, x_locked) << "within";
  EXPECT_EQ(law(v, {0, 0}, slanted(1.3e-3)).torque, y_locked) << "over it";
  EXPECT_EQ(law(v, {0, 0}, slanted(0.9e-3)).torque, y_locked) << "within";
  EXPECT_EQ(law(v, {0, 0}, slanted(0.7e-3)).torque, x_locked);
  law.law.released(law.memory.law, 0);
  EXPECT_EQ(law(v, {0, 0}, slanted(1e-3)).torque, y_locked) << "after free space the flattest";
  EXPECT_EQ(law(v, {0, 0}, slanted(0.7e-3)).torque, x_locked);
  EXPECT_EQ(law({-0.1, 0.1}, {0, 0}, slanted(2e-3)).torque, V2(10, -10));
  EXPECT_EQ(law({-0.1, 0.06}, {0, 0}, slanted(1e-3)).torque, V2(0, -10)) << "after all the flattest";
  law({-0.1, 0.1}, {0, 0}, slanted(2e-3));
  EXPECT_EQ(law({-0.1, 0.1}, {0, 0}, above(1e-3)).torque, V2(0, -10)) << "along the wall";
  law({-0.1, 0.1}, {0, 0}, slanted(2e-3));
  const ph::contact<2> beside{.normal = {1, 0}, .depth = 1e-3, .stiffness = 1000, .sensed_at = {0, 0}};
  EXPECT_EQ(law({-0.1, 0.1}, {0, 0}, beside).torque, V2(10, 0)) << "along the wall";
}

TEST(single_degree_of_freedom, asks_the_hand_where_brakes_are_at_rest) {
  EXPECT_EQ(sdof{.law = {band}}({0, 0}, {1, 1}, slanted(2e-3)).capacity, V2(0, 10));
  EXPECT_EQ(sdof{.law = {band}}({0, 0}, {-1, 1}, slanted(2e-3)).capacity, V2(10, 10));
}

TEST(single_degree_of_freedom, sees_paths_from_a_wall_that_moves) {
  // With x locked the handle slides along the wall then, by 0.1 (0.8, 0.6)
  EXPECT_EQ(sdof{.law = {band}}({0.1, 0.1}, {0, 0}, moving({-0.08, 0.04}, slanted(1e-3))).torque, V2(-10, 0));
  EXPECT_EQ(sdof{.law = {band}}({0.1, 0.1}, {0, 0}, moving({0.08, 0.16}, slanted(1e-3))).torque, V2(-10, 0));
}

// The table with P-TER's brakes: on x, y, their difference and their sum.
struct four_brakes {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 4;
  V2 position(const V2& q) const { return q; }
  ph::diagonal_matrix<double, 2> jacobian() const { return ph::diagonal_matrix<double, 2>(V2(1, 1)); }
  ph::matrix<double, 4, 2> transmission() const {
    return ph::matrix<double, 4, 2>{{1, 0}, {0, 1}, {1, -1}, {1, 1}};
  }
};

// Which of them is locked; -1 for none, 4 for all.
int locked_of_four(const V2& v, const V2& hand, const ph::contact<2>& wall) {
  ph::brakes_of<four_brakes> brakes;
  brakes.torque_limit.setConstant(10);
  brakes.rate_dead_band.setConstant(0.002);
  ph::contacts<2, 1> touched;
  touched.push_back(wall);
  ph::step_memory<ph::single_degree_of_freedom_control> memory;
  const auto result = ph::step(four_brakes(), brakes, touched, ph::single_degree_of_freedom_control{band},
                               state_of<four_brakes>({0, 0}, v, hand), memory);
  EXPECT_EQ(result.outcome, ph::status::ok);
  int locked = -1;
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(result.capacity[i] == 0 || result.capacity[i] == 10);
    EXPECT_LE(result.signs[i] * result.torque[i], 0);
    if (result.capacity[i] > 0) locked = locked < 0 ? i : 4;
  }
  return locked;
}

// By (1, 0.6) the paths are (0, 1), (1, 0), (1, 1) and (1, -1), their slopes -0.8, 0.6, -0.14 and 0.99.
TEST(single_degree_of_freedom, of_four_brakes_has_four_paths) {
  const V2 v(0.1, 0.06);
  EXPECT_EQ(locked_of_four(v, {0, 0}, slanted(1e-3)), 2) << "flattest";
  EXPECT_EQ(locked_of_four(v, {0, 0}, slanted(2e-3)), 1) << "too deep: the flattest out";
  EXPECT_EQ(locked_of_four(v, {0, 0}, slanted(0.1e-3)), 2) << "too far out: the flattest in";
  EXPECT_EQ(locked_of_four({-0.06, 0.1}, {0, 0}, slanted(2e-3)), 4) << "(-1, 1), and no path leads out";
  EXPECT_EQ(locked_of_four({0, 0}, {1, 0.6}, slanted(2e-3)), 1) << "at rest the hand is asked";
}

// With brake i locked the joints move along the one u with T_i u = 0.
TEST(single_degree_of_freedom, of_four_brakes_locks_for_the_flattest_path_in_any_pose) {
  using device = ph::five_bar<double, 4>;
  const device chain;
  ph::testing::random_source random(7);
  for (int k = 0; k < 200; ++k) {
    const V2 q(random.uniform(1.7, 2.6), random.uniform(0.5, 1.4));
    const V2 qd(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0));
    const double angle = random.uniform(-3.0, 3.0);
    const ph::contact<2> wall{.normal = V2(std::cos(angle), std::sin(angle)),
                              .depth = 1e-3,
                              .stiffness = 1e4,
                              .sensed_at = chain.position(q)};
    V2::Index flattest = 0;
    Eigen::Vector4d slope;
    for (int i = 0; i < 4; ++i) {
      const auto T = chain.transmission();
      const V2 v = ph::velocity<device>(chain, q, V2(-T(i, 1), T(i, 0)));
      slope[i] = std::abs(wall.normal.dot(v)) / v.norm();
    }
    slope.minCoeff(&flattest);
    const auto result = step_once<ph::single_degree_of_freedom_control>(chain, ph::brakes_of<device>(),
                                                                        state_of<device>(q, qd), wall);
    EXPECT_GT(result.capacity[flattest], 0) << "seed 7, sample " << k;
    EXPECT_EQ((result.capacity.array() > 0).count(), 1);
  }
}

// ---- velocity ratio control

using ratio = on_table<ph::velocity_ratio_control>;
const ph::velocity_ratio_parameters ratios{
    .reference_depth = 1e-3, .approach_length = 10e-3, .steepest_slope = 0.2};

TEST(velocity_ratio, brakes_who_is_too_fast_in_proportion) {
  const auto torque = [](const V2& v, double depth) {
    return ratio{.law = {ratios}}(v, {0, 0}, above(depth)).torque;
  };
  const auto expect = [](const V2& t, double x, double y) {
    EXPECT_LE((t - V2(x, y)).norm(), 1e-9) << t.transpose();
  };
  expect(torque({0.1, 0.1}, 1e-3), 0, -10);    // along the wall is wanted: y turns the wrong way
  expect(torque({0.1, -0.1}, 1e-3), 0, 10);    // the same outwards
  expect(torque({0.1, -0.02}, 2e-3), 0, 5);    // out by 0.1 is wanted: y is twice too fast
  expect(torque({0.1, -0.005}, 2e-3), -5, 0);  // and here x
  expect(torque({0.1, -0.01}, 2e-3), 0, 0);    // and here nobody
  expect(torque({0.1, -0.02}, 9e-3), 0, 0);    // no steeper than 0.2
  expect(torque({0, 0.1}, 1e-3), 0, -10);      // straight in: nothing along the wall
}

TEST(velocity_ratio, holds_at_rest_what_the_hand_would_move_the_wrong_way) {
  EXPECT_EQ((ratio{.law = {ratios}}({0, 0}, {0, 1}, above(1e-3)).capacity), V2(0, 10));
  EXPECT_TRUE((ratio{.law = {ratios}}({0, 0}, {0, 0}, above(1e-3)).capacity.isZero(0)));
}

TEST(velocity_ratio, sees_the_motion_from_a_wall_that_moves) {
  // Sinking by 0.01 there: w* = (0.1, -0.02)
  const auto t = ratio{.law = {ratios}}({0.1, -0.01}, {0, 0}, moving({0, -0.02}, above(1e-3))).torque;
  EXPECT_LE((t - V2(-5, 0)).norm(), 1e-9) << t.transpose();
}

// ---- on-off control

using relay = on_table<ph::on_off_control>;
constexpr ph::on_off_parameters on_off{.reference_depth = 1e-3, .hysteresis = 0.1e-3, .lead = 0.01};

TEST(on_off, switches_with_hysteresis_about_the_depth_to_come) {
  relay law{.law = {on_off}};
  const auto works = [&](double depth, double outward) {
    const auto result = law({0, -outward}, {0, 1}, above(depth));
    EXPECT_TRUE(result.capacity.isZero(0) || (result.capacity - V2(0, 1000 * depth)).norm() < rounding);
    return result.capacity[1] > 0;
  };
  EXPECT_FALSE(works(1e-3, 0)) << "off at first";
  EXPECT_TRUE(works(0.5e-3, -0.1)) << "1.5 mm to come";
  EXPECT_TRUE(works(0.95e-3, 0)) << "within";
  EXPECT_FALSE(works(0.85e-3, 0));
  EXPECT_FALSE(works(1.05e-3, 0)) << "within";
  EXPECT_TRUE(works(1.15e-3, 0));
  law.law.released(law.memory.law, 0);
  EXPECT_FALSE(works(1.05e-3, 0)) << "off again after free space";
  EXPECT_TRUE(works(1.15e-3, 0));
  EXPECT_GT(law({0, 0}, {0, 1}, moving({0, -0.1}, above(0.5e-3))).capacity[1], 0) << "the wall comes";
}

TEST(on_off, lets_a_hand_go_that_leaves) {
  relay law{.law = {on_off}};
  EXPECT_GT(law({0, 0.1}, {0, 1}, above(2e-3)).capacity[1], 0);
  EXPECT_TRUE(law({0, -0.2}, {0, -1}, above(2e-3)).capacity.isZero(0));
}

TEST(on_off, displays_what_no_direct_control_does) {
  for (const double angle : {89.0, 20.0}) {  // of 37 degrees, where a brake would drive
    for (const auto policy : {ph::saturation::keep_direction, ph::saturation::clamp_each}) {
      SCOPED_TRACE(::testing::Message() << "up to " << angle << " degrees, policy " << int(policy));
      const ph::step_options<double> options(ph::approximation_parameters<double>{ph::radians(angle)},
                                             policy);
      relay law{.law = {on_off}, .options = options};
      on_table<ph::no_direct_control> plain{.options = options};
      for (const V2& v : {V2(0.1, 0.1), V2(-0.1, 0.1)}) {
        EXPECT_EQ(law(v, {0, 0}, slanted(5e-3)).capacity, plain(v, {0, 0}, slanted(5e-3)).capacity);
        EXPECT_EQ(law(v, {0, 0}, slanted(1)).capacity, plain(v, {0, 0}, slanted(1)).capacity);
        EXPECT_EQ(law(v, {0, 0}, slanted(5e-3), above(4e-3)).capacity,
                  plain(v, {0, 0}, slanted(5e-3), above(4e-3)).capacity);
      }
    }
  }
}

// ---- bang-bang control

using steering = on_table<ph::bang_bang_control>;
constexpr ph::bang_bang_parameters turns{.reference_depth = 1e-3,
                                         .approach_length = 2e-3,
                                         .approach_slope = 0.5,
                                         .approach_hysteresis = 0.4,
                                         .following_hysteresis = 0.2};
// Along the wall above, out of it by this slope.
V2 motion(double slope) { return 0.1 * V2(std::sqrt(1 - slope * slope), -slope); }

TEST(bang_bang, turns_towards_a_slope_in_proportion_to_the_depth_error) {
  const V2 free(0, 0), out(0, -10);
  const auto torque = [](double slope, double depth) {
    return steering{.law = {turns}}(motion(slope), {0, 0}, above(depth)).torque;
  };
  EXPECT_EQ(torque(-0.19, 1e-3), free) << "along the wall is wanted";
  EXPECT_EQ(torque(-0.21, 1e-3), out) << "y moves in";
  EXPECT_EQ(torque(-0.03, 1.4e-3), out) << "0.2 is wanted";
  EXPECT_EQ(torque(0.03, 1.4e-3), free);
  EXPECT_EQ(torque(-0.03, 0.6e-3), free) << "-0.2 is wanted";
  EXPECT_EQ(torque(0.03, 0.6e-3), V2(0, 10)) << "y moves out";
  EXPECT_EQ(torque(-0.03, 2.6e-3), out) << "0.5 is wanted, and 0.4 off is far";
  EXPECT_EQ(torque(0.05, 9e-3), free) << "no brake moves in";
}

TEST(bang_bang, locks_the_brakes_that_move_the_wrong_way) {
  const auto torque = [](const V2& v, double depth) {
    return steering{.law = {turns}}(v, {0, 0}, slanted(depth)).torque;
  };
  EXPECT_EQ(torque({0.1, 0.1}, 2e-3), V2(0, -10)) << "x moves out, y in";
  EXPECT_EQ(torque({-0.1, 0.1}, 2e-3), V2(10, -10)) << "both in";
  EXPECT_EQ(torque({0.1, -0.1}, 0.1e-3), V2(-10, 10)) << "both out, and too far out";
  EXPECT_EQ(torque({0.1, 0.001}, 0.1e-3), V2(-10, 0)) << "y rests";
}

// Far off the wanted slope is clipped, to either side, and the far hysteresis is the one that counts.
TEST(bang_bang, far_off_wants_no_steeper_slope) {
  const V2 n(0.6, -0.8), along(0.8, 0.6), free(0, 0);
  ph::bang_bang_parameters deep = turns;
  deep.reference_depth = 3e-3;
  const auto torque = [&](double slope, double depth) {
    const V2 v = slope * n + std::sqrt(1 - slope * slope) * along;  // x moves out, y in
    return steering{.law = {deep}}(0.1 * v, {0, 0}, slanted(depth)).torque;
  };
  EXPECT_EQ(torque(0.11, 5e-3), free) << "0.39 off";
  EXPECT_EQ(torque(0.09, 5e-3), V2(0, -10)) << "0.41 off: out";
  EXPECT_EQ(torque(-0.11, 1e-3), free);
  EXPECT_EQ(torque(-0.09, 1e-3), V2(-10, 0)) << "in";
}

TEST(bang_bang, turns_until_the_error_has_changed_its_sign) {
  steering law{.law = {turns}};
  const auto locked = [&](double slope) { return law(motion(slope), {0, 0}, above(1e-3)).capacity; };
  EXPECT_EQ(locked(-0.1), V2(0, 0)) << "straight on";
  EXPECT_EQ(locked(-0.3), V2(0, 10));
  EXPECT_EQ(locked(-0.1), V2(0, 10)) << "still turning";
  EXPECT_EQ(law({0.1, 0.001}, {0, 0}, above(1.2e-3)).capacity, V2(0, 10)) << "it stays locked at rest";
  EXPECT_EQ(locked(0.01), V2(0, 0)) << "turned";
  EXPECT_EQ(locked(-0.1), V2(0, 0));
  EXPECT_EQ(locked(-0.3), V2(0, 10));
  law.law.released(law.memory.law, 0);
  EXPECT_EQ(locked(-0.1), V2(0, 0)) << "after free space straight on";
  EXPECT_EQ(locked(-0.3), V2(0, 10));
}

TEST(bang_bang, sees_the_motion_from_a_wall_that_moves) {
  const auto torque = [](const V2& v, const V2& wall_velocity, double depth) {
    return steering{.law = {turns}}(v, {0, 0}, moving(wall_velocity, above(depth))).torque;
  };
  EXPECT_EQ(torque({0.1, 0.005}, {0, -0.02}, 1e-3), V2(0, -10)) << "slope -0.24";
  EXPECT_EQ(torque({0.1, 0.005}, {0, 0.02}, 1e-3), V2(0, 0)) << "slope 0.15";
  EXPECT_EQ(torque({0.1, 0.05}, {0.1, 0.05}, 9e-3), V2(0, -10)) << "with the wall: a slope of 0";
}

TEST(bang_bang, is_free_at_rest_and_asks_no_hand) {
  steering law{.law = {turns}};
  EXPECT_EQ(law({0, 0.1}, {0, 1}, above(2e-3)).capacity, V2(0, 10));
  EXPECT_TRUE(law({0, 0}, {0, 1}, above(2e-3)).capacity.isZero(0));
}

// ---- parameters

TEST(control_law_parameters, say_what_is_wrong) {
  EXPECT_EQ(validate(ph::direct_control{}), "");
  EXPECT_EQ(validate(ph::direct_control{.velocity_dead_band = -1}),
            "velocity_dead_band [m/s] = -1, expected a finite number >= 0");
  EXPECT_EQ(validate(ph::single_degree_of_freedom_parameters{}), "");
  EXPECT_EQ(validate(ph::single_degree_of_freedom_parameters{.band = -1}),
            "band [m] = -1, expected a finite number >= 0");
  EXPECT_EQ(validate(ph::velocity_ratio_parameters{}), "");
  EXPECT_EQ(validate(ph::velocity_ratio_parameters{.approach_length = 0}),
            "approach_length [m] = 0, expected a finite number > 0");
  EXPECT_EQ(validate(ph::on_off_parameters{}), "");
  EXPECT_EQ(validate(ph::on_off_parameters{.lead = -1}), "lead [s] = -1, expected a finite number >= 0");
  EXPECT_EQ(validate(ph::bang_bang_parameters{}), "");
  EXPECT_EQ(validate(ph::bang_bang_parameters{.approach_length = 0}),
            "approach_length [m] = 0, expected a finite number > 0");
}

TEST(control_law_parameters, are_checked_by_a_controller) {
  const auto walls = ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, -1})));
  const table device;
  const ph::brakes_of<table> brakes;
  EXPECT_THROW(ph::controller(device, brakes, walls, ph::direct_control{.velocity_dead_band = -1}),
               std::invalid_argument);
  EXPECT_THROW(ph::controller(device, brakes, walls, ph::on_off_control{{.hysteresis = -1}}),
               std::invalid_argument);
  EXPECT_NO_THROW(ph::controller(device, brakes, walls, ph::direct_control{}));
}

// ---- along the wall of the paper (example 03)

template <class L>
struct along_the_wall : ::testing::Test {};
using rivals = tested_types<ph::coercive_force_approximation, ph::single_degree_of_freedom_control,
                            ph::velocity_ratio_control, ph::on_off_control, ph::bang_bang_control>;
TYPED_TEST_SUITE(along_the_wall, rivals);

TYPED_TEST(along_the_wall, the_hand_arrives_near_its_surface) {
  using device_type = ph::tendon_two_link<double>;
  const ph::half_space<2> wall({0, 0.225}, {0, -1});
  const device_type arm;
  const ph::brakes_of<device_type> brakes;
  const auto q = arm.inverse({0.045, 0.221}, ph::elbow::left).q;
  for (const double rate : {1000.0, 20.0}) {
    ph::controller control(arm, brakes, ph::held_scene(ph::scene(ph::wall(wall)), 1 / rate), TypeParam());
    const ph::following_hand<double, 2> hand({1, 0}, arm.position(q));
    ph::simulated_device<device_type> device(arm, brakes, hand.parameters().mass, q);
    device.set_motion(q, ph::jacobian(arm, q).inverse() * V2(0.05, 0.1));
    const auto figures = ph::follow_wall(device, control, wall, hand, {});
    EXPECT_TRUE(figures.arrived) << rate << " Hz";
    EXPECT_LT(figures.depth_max, rate > 100 ? 2e-3 : 5e-3) << rate << " Hz";
    EXPECT_LT(figures.depth_range, rate > 100 ? 4e-3 : 8e-3) << rate << " Hz";
    EXPECT_LT(figures.retarding_force, 3) << rate << " Hz";
  }
}

// Its relay judges the depth at the handle, of which a slow scene gives an old one.
TEST(on_off, is_as_deep_at_20_Hz_as_at_1_kHz) {
  using device_type = ph::tendon_two_link<double>;
  const device_type arm;
  const ph::brakes_of<device_type> brakes;
  const auto q = arm.inverse({0.045, 0.221}, ph::elbow::left).q;
  const auto follow = [&](const auto& wall, double rate) {
    ph::controller control(arm, brakes, ph::held_scene(ph::scene(ph::wall(wall)), 1 / rate),
                           ph::on_off_control());
    const ph::following_hand<double, 2> hand({1, 0}, arm.position(q));
    ph::simulated_device<device_type> device(arm, brakes, hand.parameters().mass, q);
    device.set_motion(q, ph::jacobian(arm, q).inverse() * V2(0.05, 0.1));
    return ph::follow_wall(device, control, wall, hand, {});
  };
  const auto expect_same = [&](const auto& wall) {
    const auto fast = follow(wall, 1000), slow = follow(wall, 20);
    EXPECT_EQ(slow.separations, fast.separations);
    EXPECT_LT(slow.depth_max, 1.1 * fast.depth_max);
    EXPECT_LT(slow.depth_std, 1.2 * fast.depth_std);
  };
  expect_same(ph::half_space<2>({0, 0.225}, {0, -1}));
  expect_same(ph::disc({0.11, -0.1}, 0.325, ph::filling::hollow));
}

// Figures of the same hand along the same wall, with 2 or with P-TER's 4 brakes of a five-bar.
template <int Brakes>
ph::contact_metrics along_with(double slant) {
  using device_type = ph::five_bar<double, Brakes>;
  const device_type chain;
  const ph::brakes_of<device_type> brakes;
  const auto q = chain.inverse({-0.03, 0.1}).q;
  const V2 n(std::sin(slant), -std::cos(slant)), along(-n[1], n[0]);
  const ph::half_space<2> wall(chain.position(q) - 0.004 * n, n);
  ph::controller control(chain, brakes, ph::scene(ph::wall(wall)), ph::single_degree_of_freedom_control());
  const ph::following_hand<double, 2> hand(along, chain.position(q));
  ph::simulated_device<device_type> device(chain, brakes, hand.parameters().mass, q);
  device.set_motion(q, ph::jacobian(chain, q).inverse() * (0.05 * along - 0.1 * n));
  ph::wall_following_parameters p;
  p.path_end = 0.06;
  return ph::follow_wall(device, control, wall, hand, p);
}

// More paths, of which one is flatter: less zigzag and less drag.
TEST(single_degree_of_freedom, follows_a_wall_better_with_four_brakes_than_with_two) {
  for (const double slant : {-0.2, 0.0, 0.2}) {
    const auto two = along_with<2>(slant), four = along_with<4>(slant);
    EXPECT_TRUE(two.arrived && four.arrived) << slant;
    EXPECT_LT(four.depth_std, 0.6 * two.depth_std) << slant;
    EXPECT_LT(four.retarding_force, 0.6 * two.retarding_force) << slant;
  }
}

}  // namespace
