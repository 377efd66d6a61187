// slow
// Effects next to walls: which comes first, faults, what changes nothing, and every kind of scene.
#include "../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/pipelines/with_effects.hpp>
#include <passive_haptics/force/effects/end_stops.hpp>
#include <passive_haptics/force/effects/viscous_field.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/world/scene_exchange.hpp>

#include <limits>

namespace {

constexpr double without_limit = std::numeric_limits<double>::infinity();

ph::viscous_field<double, 2> drag_of(double viscosity) {
  return ph::viscous_field<double, 2>({.viscosity = viscosity * ph::matrix<double, 2, 2>::Identity()});
}

const ph::wall ground(ph::half_space<2>({0, 0}, {0, 1}), 5e3);

// A straight elbow is a singular pose: its stop moves nothing but the elbow, and is displayed all the same.
TEST(end_stops_in_a_cycle, hold_at_a_singular_pose) {
  using M = ph::two_link<double>;
  const ph::end_stops<double, 2> stops({.lower = {-without_limit, 0.1}, .stiffness = {0, 20}});
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(100);
  ph::controller control(M(), brakes, ph::with_effects(ph::no_walls<2>(), stops, drag_of(0)),
                         ph::direct_control());
  const auto result = control(ph::device_state<M>{0, {0.6, 0}, {0, -1}, {0, 0}});
  ASSERT_EQ(result.outcome, ph::status::ok);
  expect_near(result.torque, ph::vector<double, 2>(0, 2), 2);
}

TEST(end_stops_in_a_cycle, come_before_forces_and_after_walls) {
  using M = ph::xy_table<double>;
  const ph::end_stops<double, 2> stops({.upper = {0, 0}, .stiffness = {100, 100}});
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(50);
  brakes.rate_dead_band.setConstant(1e-9);
  const ph::device_state<M> state{0, {0.1, 0.2}, {0.1, 0.2}, {-3, 0}};  // both slides behind their stops
  ph::step_memory<ph::direct_control> memory;
  ph::contacts<2, 1> touched;
  const auto cycle = [&] {
    const auto table = ph::with_effects(touched, stops, drag_of(10));
    return ph::step(M(), brakes, table, ph::direct_control(), state, memory);
  };
  expect_near(cycle().torque, ph::vector<double, 2>(-10 - 1, -20 - 2), 20);
  touched.push_back(asking_for<2>({-7, 0}));  // a wall that the first slide moves into: 7 N and no more
  expect_near(cycle().torque, ph::vector<double, 2>(-7, -20 - 2), 20);
  touched.clear();
  touched.push_back(asking_for<2>({7, 0}));  // and one that it leaves, where the hand presses with 3 N
  expect_near(cycle().torque, ph::vector<double, 2>(0, -20 - 2), 20);
  EXPECT_FALSE(cycle().saturated);
  brakes.torque_limit[1] = 21;
  expect_near(cycle().torque, ph::vector<double, 2>(0, -21), 20);
  EXPECT_TRUE(cycle().saturated);
}

TEST(with_effects, reports_faults_as_without) {
  using M = ph::tendon_two_link<double>;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  ph::step_memory<ph::direct_control> memory;
  const auto outcome = [&](const ph::device_state<M>& state, const ph::contact<2>& c) {
    ph::contacts<2, 2> touched;
    touched.push_back(c);
    return ph::step(M(), ph::brakes_of<M>(), ph::with_effects(touched, drag_of(1)), ph::direct_control(),
                    state, memory)
        .outcome;
  };
  const auto fine = asking_for<2>({0, 5});
  auto broken = fine;
  broken.depth = nan;
  EXPECT_EQ(outcome({0, {1, 1}, {1, 1}, {0, 0}}, fine), ph::status::ok);
  EXPECT_EQ(outcome({0, {1, nan}, {1, 1}, {0, 0}}, fine), ph::status::state_not_finite);
  EXPECT_EQ(outcome({0, {1, 1}, {1, 1}, {0, 0}}, broken), ph::status::contact_invalid);
}

// A law whose scale() may not be called where no wall demands a force.
struct strict_law {
  template <class T, int D>
  T scale(const ph::contact_situation<T, D>& c) const noexcept {
    return c.desired_magnitude > T(0) ? T(1) : std::numeric_limits<T>::quiet_NaN();
  }
};

TEST(with_effects, asks_no_law_in_free_space) {
  using M = ph::xy_table<double>;
  ph::controller control(M(), ph::brakes_of<M>(), ph::with_effects(ph::scene(ground, ground), drag_of(1)),
                         strict_law());
  const auto free = control(ph::device_state<M>{0, {0, 1}, {1, 1}, {0, 0}});
  EXPECT_EQ(free.outcome, ph::status::ok);
  EXPECT_EQ(free.contact_count, 0);
  EXPECT_FALSE(free.contacts[0].has_priority) << "nothing was left";
}

// A wall that demands nothing takes nothing from an effect along its normal.
TEST(with_effects, act_through_a_wall_that_asks_for_nothing) {
  using M = ph::xy_table<double>;
  ph::contacts<2, 2> touched;
  auto wall = asking_for<2>({0, 5});
  wall.depth = 0;
  touched.push_back(wall);
  ph::step_memory<ph::no_direct_control> memory;
  const auto result = ph::step(M(), ph::unlimited_brakes(), ph::with_effects(touched, drag_of(2)),
                               ph::no_direct_control(), state_of<M>({0, 0}, {0, -1}), memory);
  EXPECT_EQ(result.torque, ph::point<2>(0, 2));
}

// What a scene remembers and reports goes through.
TEST(with_effects, goes_around_a_scene) {
  using M = ph::xy_table<double>;
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(50);
  ph::controller control(M(), brakes, ph::with_effects(ph::held_scene(ph::scene(ground), 0.01), drag_of(10)),
                         ph::direct_control());
  const ph::device_state<M> inside{0, {0, -1e-3}, {0.1, -0.1}, {0, -1}},
      outside{1, {0, 1}, {0.1, -0.1}, {0, 0}};
  const auto felt = control(inside);
  EXPECT_EQ(felt.wall_number, 0);
  expect_near(felt.torque, ph::vector<double, 2>(-1, 5), 5);
  EXPECT_EQ(control.command(inside).capacity, felt.capacity);
  control.reset();
  expect_near(control(outside).torque, ph::vector<double, 2>(-1, 1), 1);
  EXPECT_EQ(control(outside).wall_number, -1);
}

TEST(with_effects, says_what_its_scene_says) {
  using M = ph::xy_table<double>;
  ph::scene_exchange exchange(ph::scene(ground), 0.0);
  ph::controller control(M(), ph::brakes_of<M>(),
                         ph::with_effects(ph::latest_scene(exchange, {.stale_after = 0.1}), drag_of(1)),
                         ph::direct_control());
  EXPECT_EQ(control(ph::device_state<M>{0.05, {0, 1}, {1, 1}, {0, 0}}).outcome, ph::status::ok);
  EXPECT_EQ(control(ph::device_state<M>{0.2, {0, 1}, {1, 1}, {0, 0}}).outcome, ph::status::scene_stale);
}

// Forces of effects that are barely numbers, of a spatial device, whose torques are found by scaling.
TEST(effects_beside_a_wall, of_velocities_near_overflow_give_a_status_or_torques) {
  using M = ph::delta<double>;
  const M device;
  const ph::viscous_field<double, 3> drag({.viscosity = 3 * ph::matrix<double, 3, 3>::Identity()});
  ph::testing::random_source random(1);
  int faults = 0, steps = 0;
  for (int k = 0; k < 100; ++k) {
    ph::device_state<M> state{0, 0.5 * random.direction<double, 3>(), random.direction<double, 3>(),
                              random.direction<double, 3>()};
    state.qd[k % 3] = std::pow(10.0, random.uniform(k % 4 < 2 ? 150.0 : 307.5, 308.2));
    ph::contacts<3, 1> touched;
    if (k % 2 == 0)
      touched.push_back({.normal = random.direction<double, 3>(), .depth = 1e-3, .stiffness = 1e4});
    ph::step_memory<ph::direct_control> memory;
    const auto result = ph::step(device, ph::brakes_of<M>(), ph::with_effects(touched, drag),
                                 ph::direct_control(), state, memory);
    ASSERT_TRUE(ph::all_finite(result.capacity) && ph::all_finite(result.torque)) << k;
    ASSERT_TRUE(result.outcome == ph::status::ok || result.capacity.isZero(0)) << k;
    ++(result.outcome == ph::status::ok ? steps : faults);
  }
  EXPECT_GT(faults, 3);
  EXPECT_GT(steps, 3);
}

}  // namespace
