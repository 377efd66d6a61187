// One control cycle: what it decides.
#include "../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <cmath>
#include <cstring>
#include <new>
#include <numbers>
#include <utility>

namespace {

using table = ph::xy_table<double>;
using arm = ph::tendon_two_link<double>;
using pair = ph::vector<double, 2>;

ph::brakes_of<table> strong_brakes() {
  ph::brakes_of<table> strong;
  strong.torque_limit.setConstant(100);
  return strong;
}

// Brakes of the table, moving at v against the wall y = 0 from above.
template <class L>
ph::step_result<table> on_the_floor(const pair& v, const pair& hand, double depth = 1e-6,
                                    double stiffness = 1e7) {
  return step_once<L>(table(), strong_brakes(), state_of<table>({0, 0}, v, hand),
                      ph::contact<2>{.normal = {0, 1}, .depth = depth, .stiffness = stiffness});
}

TEST(step, in_free_space_releases_the_brakes_and_demands_nothing) {
  const auto result =
      step_once<ph::direct_control>(table(), ph::brakes_of<table>(), state_of<table>({0, 0}, {1, 1}, {1, 1}));
  EXPECT_EQ(result.outcome, ph::status::ok);
  EXPECT_EQ(result.wall_number, -1);
  EXPECT_EQ(result.power, ph::power_class::none);
  EXPECT_EQ(result.display, ph::display_class::exact);
  EXPECT_TRUE(result.capacity.isZero(0) && result.torque.isZero(0) && result.desired_force.isZero(0));
  EXPECT_EQ(ph::display_text(result), "no force demanded");
  EXPECT_EQ(ph::display_text(ph::released<ph::step_result<table>>(ph::status::scene_stale)), "none");
  EXPECT_EQ(ph::display_text(on_the_floor<ph::no_direct_control>({1, -1}, {0, 0})), "exact");
}

TEST(step, a_state_has_no_time_until_it_is_filled_and_a_result_is_that_of_free_space) {
  const ph::device_state<table> state;
  EXPECT_TRUE(std::isnan(state.time));
  EXPECT_TRUE(state.q.isZero(0) && state.qd.isZero(0) && state.hand_force.isZero(0));
  const ph::step_result_of_contacts<table, 2> fresh;
  EXPECT_EQ(fresh.outcome, ph::status::ok);
  EXPECT_EQ(fresh.wall_number, -1);
  EXPECT_EQ(fresh.power, ph::power_class::none);
  EXPECT_EQ(fresh.display, ph::display_class::exact);
  EXPECT_FALSE(fresh.saturated);
  EXPECT_EQ(fresh.alpha, 1);
  EXPECT_EQ(fresh.approximation_cosine, 1);
  EXPECT_TRUE(fresh.capacity.isZero(0) && fresh.torque.isZero(0) && fresh.signs.isZero(0));
  EXPECT_TRUE(fresh.desired_force.isZero(0) && fresh.control_force.isZero(0));
  EXPECT_EQ(fresh.contact_count, 0);
  using result = ph::step_result<table>;
  EXPECT_EQ(ph::released<result>(ph::status::state_not_finite).display, ph::display_class::none);
  EXPECT_EQ(ph::released<result>(ph::status::ok).display, ph::display_class::exact);
}

// As a member of a driver's struct before the first cycle, where other bytes were before.
TEST(step, a_command_is_that_of_released_brakes_at_first) {
  alignas(64) unsigned char storage[sizeof(ph::brake_command<table>)];
  std::memset(storage, 0x41, sizeof storage);
  const auto* fresh = ::new (storage) ph::brake_command<table>;
  EXPECT_TRUE(fresh->capacity.isZero(0));
  EXPECT_EQ(fresh->outcome, ph::status::ok);
}

TEST(step, a_touched_wall_without_force_demands_nothing) {
  for (const auto& [depth, stiffness] : {std::pair{1e-3, 0.0}, {0.0, 1e7}, {-1e-3, 1e7}}) {
    const auto result = on_the_floor<ph::no_direct_control>({0, -1}, {0, 0}, depth, stiffness);
    EXPECT_EQ(result.outcome, ph::status::ok);
    EXPECT_EQ(result.power, ph::power_class::none);
    EXPECT_TRUE(result.capacity.isZero(0));
  }
}

TEST(step, pushing_into_a_wall_brakes_its_axis_only) {
  const auto result = on_the_floor<ph::no_direct_control>({1, -1}, {0, 0});
  EXPECT_EQ(result.display, ph::display_class::exact);
  EXPECT_EQ(result.power, ph::power_class::passive_1);
  expect_near(result.capacity, pair(0, 10), 10);
  expect_near(result.torque, pair(0, 10), 10);
  EXPECT_FALSE(result.saturated);
  EXPECT_EQ(result.alpha, 1);
}

TEST(step, leaving_along_an_axis_of_the_table_displays_nothing) {
  const auto result = on_the_floor<ph::direct_control>({1, 1}, {0, -1});
  EXPECT_EQ(result.display, ph::display_class::none);
  EXPECT_EQ(result.power, ph::power_class::active);
  EXPECT_TRUE(result.capacity.isZero(0));
}

TEST(step, at_rest_the_hand_decides_and_the_brake_holds_no_more_than_it_pushes) {
  const auto pressed = on_the_floor<ph::no_direct_control>({0, 0}, {0, -3});
  EXPECT_EQ(pressed.signs, pair(0, -1));
  expect_near(pressed.capacity, pair(0, 10), 10);
  EXPECT_EQ(pressed.torque, pair(0, 3));
  const auto pulled = on_the_floor<ph::no_direct_control>({0, 0}, {0, 3});
  EXPECT_EQ(pulled.display, ph::display_class::none);
  EXPECT_TRUE(pulled.capacity.isZero(0));
  const auto harder = on_the_floor<ph::no_direct_control>({0, 0}, {0, -30});
  expect_near(harder.torque, pair(0, 10), 10);
}

TEST(step, relative_velocity_decides_on_scaling_but_own_velocity_on_power) {
  ph::contact<2> wall{.normal = {0, 1}, .depth = 1e-6, .stiffness = 1e7};
  const auto run = [&](double vy, double wall_vy) {
    wall.wall_velocity = {5, wall_vy};
    return step_once<ph::direct_control>(table(), strong_brakes(), state_of<table>({0, 0}, {1, vy}, {0, -2}),
                                         wall);
  };
  // Handle and wall both sink: the wall the faster, so that the handle leaves it
  EXPECT_NEAR(run(-1, -2).alpha, 0.2, 1e-12);
  EXPECT_EQ(run(-1, -2).power, ph::power_class::passive_1);
  EXPECT_EQ(run(-1, -0.5).alpha, 1);
  EXPECT_EQ(run(1, 2).power, ph::power_class::active) << "though the wall overtakes the handle";
}

TEST(step, the_wall_that_demands_most_governs) {
  const ph::contact<2> weak{.normal = {1, 0}, .depth = 1e-3, .stiffness = 1e3, .wall_number = 4};
  const ph::contact<2> strong{.normal = {0, 1}, .depth = 1e-3, .stiffness = 2e3, .wall_number = 7};
  const auto state = state_of<table>({0, 0}, {-1, -1});
  for (const auto& result : {step_once<ph::no_direct_control>(table(), {}, state, weak, strong),
                             step_once<ph::no_direct_control>(table(), {}, state, strong, weak)}) {
    EXPECT_EQ(result.wall_number, 7);
    EXPECT_EQ(result.desired_force, pair(0, 2));
  }
}

TEST(step, coincident_walls_act_as_one) {
  const ph::wall soft(ph::half_space<2>({0, 0.3}, {0.3, 1}), 1);  // below the torque limits
  const auto state = state_of<arm>({0.2, 0.4}, {-1, 2}, {0, -1});
  const auto a = ph::controller(arm(), {}, ph::scene(soft), ph::direct_control{})(state);
  const auto b = ph::controller(arm(), {}, ph::scene(soft, soft), ph::direct_control{})(state);
  EXPECT_EQ(a.wall_number, 0);
  EXPECT_EQ(b.wall_number, 0);
  EXPECT_GT(a.capacity.norm(), 0);
  EXPECT_FALSE(a.saturated);
  expect_near(a.capacity, b.capacity, 1);
}

TEST(step, runs_without_a_force_sensor_where_the_law_needs_none) {
  ph::controller control(table(), {}, ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}), 1e3)),
                         ph::no_direct_control{});
  // Sinking: as with a sensor. At rest: no side is known, so the brake may hold either way
  const auto sinking = control(ph::sensorless_device_state<table>{0.0, {0, -1e-4}, {0, -1}});
  expect_near(sinking.torque, pair(0, 0.1), 1);
  const auto resting = control(ph::sensorless_device_state<table>{0.0, {0, -1e-4}, {0, 0}});
  EXPECT_TRUE(resting.signs.isZero(0) && resting.torque.isZero(0));
  expect_near(resting.capacity, pair(0, 0.1), 1);
}

// Moving up along a slanted wall: only brake 1 may help, at the wall's own angle from its axis.
TEST(step, beyond_the_largest_approximation_angle_displays_nothing) {
  const auto run = [](double slant, const ph::step_options<double>& options) {
    const double a = ph::radians(slant);
    ph::contacts<2, 1> touched;
    touched.push_back({.normal = {std::cos(a), std::sin(a)}, .depth = 1e-6, .stiffness = 1e7});
    ph::step_memory<ph::no_direct_control> memory;
    return ph::step(table(), ph::brakes_of<table>(), touched, ph::no_direct_control{},
                    state_of<table>({0, 0}, {-1, 1}), memory, options);
  };
  const ph::step_options<double> narrow(ph::approximation_parameters<double>{ph::radians(30.0)}), usual;
  EXPECT_EQ(run(29, narrow).display, ph::display_class::approximate);
  EXPECT_NEAR(ph::degrees(run(29, narrow).approximation_angle()), 29, 1e-4);
  EXPECT_EQ(run(31, narrow).display, ph::display_class::none);
  EXPECT_EQ(run(31, narrow).approximation_cosine, 0);
  EXPECT_TRUE(run(31, narrow).capacity.isZero(0));
  EXPECT_EQ(run(88.9, usual).display, ph::display_class::approximate);
  EXPECT_EQ(run(89.1, usual).display, ph::display_class::none);
}

// Straight and folded: J is singular, the half-space form still answers.
TEST(step, at_a_singular_pose_is_no_fault) {
  int displayed = 0;
  for (const double q2 : {0.0, std::numbers::pi, -std::numbers::pi}) {
    for (int direction = 0; direction < 16; ++direction) {
      const double a = direction * std::numbers::pi / 8;
      for (const auto& qd : {pair(1, 2), pair(-1, 3), pair(0.5, -4), pair(-2, -2), pair(0, 0)}) {
        const auto result = step_once<ph::direct_control>(
            arm(), {}, state_of<arm>({0.7, q2}, qd, {0.3, -0.7}),
            ph::contact<2>{.normal = {std::cos(a), std::sin(a)}, .depth = 1e-4, .stiffness = 1e4});
        ASSERT_EQ(result.outcome, ph::status::ok) << "q2 = " << q2;
        EXPECT_TRUE((result.signs.array() * result.torque.array() <= 0).all());
        EXPECT_TRUE((result.capacity.array() <= 1).all());
        displayed += ph::is_displayed(result.display);
      }
    }
  }
  EXPECT_GT(displayed, 0);
}

}  // namespace
