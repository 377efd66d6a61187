// slow, optimised
// What each law commands, by hand on the XY table, where E = I and forces are torques.
#include "../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/control/laws/saturated_direct_control.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/wall_following.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <Eigen/LU>

#include <algorithm>
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
  for (const double outward : {0.1, 0.006, 0.0, -0.0, -0.001, -0.0049, -0.005, -0.1}) {
    EXPECT_EQ(alpha(as_printed, outward), outward > 0 ? 0.25 : 1) << outward;
    EXPECT_EQ(alpha(early, outward), outward > -0.005 ? 0.25 : 1) << outward;
  }
  on_table<ph::direct_control> step{.law = early};
  EXPECT_DOUBLE_EQ(step({0.1, 0.004}, hand, above(0.004)).alpha, 0.25);
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

// ---- parameters

TEST(control_law_parameters, say_what_is_wrong) {
  EXPECT_EQ(validate(ph::direct_control{}), "");
  EXPECT_EQ(validate(ph::direct_control{.velocity_dead_band = -1}),
            "velocity_dead_band [m/s] = -1: expected a finite number >= 0");
  EXPECT_EQ(validate(ph::on_off_parameters{}), "");
  EXPECT_EQ(validate(ph::on_off_parameters{.lead = -1}), "lead [s] = -1: expected a finite number >= 0");
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

// ---- along walls

using tendon = ph::tendon_two_link<double>;

template <class Wall>
ph::contact_metrics follow_under_on_off_control(const Wall& wall, double rate) {
  const tendon arm;
  const ph::brakes_of<tendon> brakes;
  const auto q = arm.inverse({0.045, 0.221}, ph::elbow::left).q;
  ph::controller control(arm, brakes, ph::held_scene(ph::scene(ph::wall(wall)), 1 / rate),
                         ph::on_off_control());
  const ph::following_hand<double, 2> hand({1, 0}, arm.position(q));
  ph::simulated_device<tendon> device(arm, brakes, hand.parameters().mass, q);
  device.set_motion(q, ph::jacobian(arm, q).inverse() * V2(0.05, 0.1));
  return ph::follow_wall(device, control, wall, hand, {});
}

// Its relay judges the depth at the handle, of which a slow scene gives an old one.
template <class Wall>
void expect_as_deep_at_20_Hz_as_at_1_kHz(const Wall& wall, double max_depth) {
  const auto fast = follow_under_on_off_control(wall, 1000), slow = follow_under_on_off_control(wall, 20);
  EXPECT_EQ(slow.separations, fast.separations);
  EXPECT_LT(slow.max_depth, 1.1 * fast.max_depth);
  EXPECT_LT(slow.depth_std, 1.2 * fast.depth_std);
  EXPECT_TRUE(fast.arrived && slow.arrived);
  EXPECT_LT(fast.max_depth, max_depth);
  EXPECT_LT(fast.depth_range, 4e-3);
  EXPECT_LT(slow.depth_range, 8e-3);
  EXPECT_LT(std::max(fast.retarding_force, slow.retarding_force), 3);
}

TEST(on_off, leads_the_hand_along_a_wall_at_any_rate_of_its_scene) {
  expect_as_deep_at_20_Hz_as_at_1_kHz(ph::half_space<2>({0, 0.225}, {0, -1}), 2e-3);
  expect_as_deep_at_20_Hz_as_at_1_kHz(ph::disc({0.11, -0.1}, 0.325, ph::filling::hollow), 4e-3);
}

}  // namespace
