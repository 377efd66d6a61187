// One control cycle: what it decides, and what it refuses.
#include "../support.hpp"

#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/control/pipelines/torque_law.hpp>

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/shapes/offset.hpp>

#include <cmath>
#include <limits>
#include <utility>

namespace {

template <class T>
struct control_step : ::testing::Test {
  using table_type = ph::xy_table<T>;
};
TYPED_TEST_SUITE(control_step, scalars);

// Sliding brakes of the table, moving along (vx, vy) against the wall y = 0 from above.
template <class L, class T>
ph::step_result<ph::xy_table<T>> on_the_floor(T vx, T vy, const ph::vector<T, 2>& hand, double depth = 1e-6,
                                              double stiffness = 1e7) {
  using M = ph::xy_table<T>;
  ph::brakes_of<M> strong;
  strong.torque_limit.setConstant(T(100));
  return step_once<L>(M(), strong, state_of<M>({0, 0}, {vx, vy}, hand),
                      ph::contact<2>{.normal = {0, 1}, .depth = depth, .stiffness = stiffness});
}

TYPED_TEST(control_step, in_free_space_releases_the_brakes_and_asks_for_nothing) {
  using M = typename TestFixture::table_type;
  const auto result =
      step_once<ph::direct_control>(M(), ph::brakes_of<M>(), state_of<M>({0, 0}, {1, 1}, {1, 1}));
  EXPECT_EQ(result.outcome, ph::status::ok);
  EXPECT_EQ(result.wall_number, -1);
  EXPECT_EQ(result.power, ph::power_class::none);
  EXPECT_EQ(result.display, ph::display_class::exact);
  EXPECT_TRUE(result.capacity.isZero(0) && result.torque.isZero(0) && result.desired_force.isZero(0));
  EXPECT_EQ(ph::display_text(result), "no force demanded");
  EXPECT_EQ(ph::display_text(ph::released<ph::step_result<M>>(ph::status::scene_stale)), "none");
  EXPECT_EQ(ph::display_text(on_the_floor<ph::no_direct_control, TypeParam>(1, -1, {0, 0})), "exact");
}

TYPED_TEST(control_step, a_state_is_at_rest_and_has_no_time_until_it_is_filled) {
  using M = typename TestFixture::table_type;
  const ph::device_state<M> state;
  EXPECT_TRUE(std::isnan(state.time));
  EXPECT_TRUE(state.q.isZero(0) && state.qd.isZero(0) && state.hand_force.isZero(0));
  const ph::sensorless_device_state<M> sensorless;
  EXPECT_TRUE(std::isnan(sensorless.time));
  EXPECT_TRUE(sensorless.q.isZero(0) && sensorless.qd.isZero(0));
}

TYPED_TEST(control_step, refuses_a_state_whose_time_was_never_set) {
  using M = typename TestFixture::table_type;
  auto state = state_of<M>({0, 0}, {0, -1});
  state.time = ph::device_state<M>().time;
  const auto result = step_once<ph::no_direct_control>(
      M(), {}, state, ph::contact<2>{.normal = {0, 1}, .depth = 1e-3, .stiffness = 1e3});
  EXPECT_EQ(result.outcome, ph::status::state_not_finite);
  EXPECT_TRUE(result.capacity.isZero(0));
}

TYPED_TEST(control_step, a_touched_wall_without_force_asks_for_nothing) {
  for (const auto& [depth, stiffness] : {std::pair{1e-3, 0.0}, {0.0, 1e7}, {-1e-3, 1e7}}) {
    const auto result = on_the_floor<ph::no_direct_control, TypeParam>(0, -1, {0, 0}, depth, stiffness);
    EXPECT_EQ(result.outcome, ph::status::ok);
    EXPECT_EQ(result.power, ph::power_class::none);
    EXPECT_TRUE(result.capacity.isZero(0));
  }
}

TYPED_TEST(control_step, pushing_into_a_wall_brakes_its_axis_alone) {
  const auto result = on_the_floor<ph::no_direct_control, TypeParam>(1, -1, {0, 0});
  EXPECT_EQ(result.display, ph::display_class::exact);
  EXPECT_EQ(result.power, ph::power_class::passive_1);
  expect_near(result.capacity, ph::vector<TypeParam, 2>(0, 10), 10);
  expect_near(result.torque, ph::vector<TypeParam, 2>(0, 10), 10);
  EXPECT_FALSE(result.saturated);
  EXPECT_EQ(result.alpha, TypeParam(1));
}

TYPED_TEST(control_step, leaving_along_an_axis_of_the_table_displays_nothing) {
  const auto result = on_the_floor<ph::direct_control, TypeParam>(1, 1, {0, -1});
  EXPECT_EQ(result.display, ph::display_class::none);
  EXPECT_EQ(result.power, ph::power_class::active);
  EXPECT_TRUE(result.capacity.isZero(0));
}

TYPED_TEST(control_step, at_rest_the_hand_decides_and_the_brake_holds_no_more_than_it_pushes) {
  using T = TypeParam;
  const auto pressed = on_the_floor<ph::no_direct_control, T>(0, 0, {0, -3});
  EXPECT_EQ(pressed.signs, (ph::vector<T, 2>(0, -1)));
  expect_near(pressed.capacity, ph::vector<T, 2>(0, 10), 10);
  EXPECT_EQ(pressed.torque, (ph::vector<T, 2>(0, 3)));
  const auto pulled = on_the_floor<ph::no_direct_control, T>(0, 0, {0, 3});
  EXPECT_EQ(pulled.display, ph::display_class::none);
  EXPECT_TRUE(pulled.capacity.isZero(0));
  const auto harder = on_the_floor<ph::no_direct_control, T>(0, 0, {0, -30});
  expect_near(harder.torque, ph::vector<T, 2>(0, 10), 10);
}

TYPED_TEST(control_step, relative_velocity_decides_on_scaling_but_own_velocity_on_power) {
  using T = TypeParam;
  using M = typename TestFixture::table_type;
  ph::brakes_of<M> strong;
  strong.torque_limit.setConstant(T(100));
  ph::contact<2> wall{.normal = {0, 1}, .depth = 1e-6, .stiffness = 1e7};
  const auto run = [&](T vy, double wall_vy) {
    wall.wall_velocity = {5, wall_vy};
    return step_once<ph::direct_control>(M(), strong, state_of<M>({0, 0}, {1, vy}, {0, -2}), wall);
  };
  // Handle and wall both sink: the wall the faster, so that the handle leaves it
  EXPECT_NEAR(run(-1, -2).alpha, T(0.2), ph::rounding_tolerance<T>(2));
  EXPECT_EQ(run(-1, -2).power, ph::power_class::passive_1);
  EXPECT_EQ(run(-1, T(-0.5)).alpha, T(1));
  EXPECT_EQ(run(1, 2).power, ph::power_class::active) << "though the wall overtakes the handle";
}

TYPED_TEST(control_step, the_wall_that_asks_for_most_governs) {
  using T = TypeParam;
  using M = typename TestFixture::table_type;
  const ph::contact<2> weak{.normal = {1, 0}, .depth = 1e-3, .stiffness = 1e3, .wall_number = 4};
  const ph::contact<2> strong{.normal = {0, 1}, .depth = 1e-3, .stiffness = 2e3, .wall_number = 7};
  for (const auto& result :
       {step_once<ph::no_direct_control>(M(), {}, state_of<M>({0, 0}, {-1, -1}), weak, strong),
        step_once<ph::no_direct_control>(M(), {}, state_of<M>({0, 0}, {-1, -1}), strong, weak)}) {
    EXPECT_EQ(result.wall_number, 7);
    EXPECT_EQ(result.desired_force, (ph::vector<T, 2>(0, 2)));
  }
}

// Of one wall, of several, and beside a good one.
template <class L, class M>
void expect_refused(ph::contact<2> bad) {
  bad.sensed_at = {0, 0};
  const ph::contact<2> good{.normal = {0, 1}, .depth = 1e-3, .stiffness = 1e7, .sensed_at = {0, 0}};
  const auto moving_in = state_of<M>({0, 0}, {0, -1});
  for (const ph::step_result<M>& result :
       {step_once<L>(M(), {}, moving_in, bad), step_once<L>(M(), {}, moving_in, bad, bad),
        step_once<L>(M(), {}, moving_in, good, bad)}) {
    EXPECT_EQ(result.outcome, ph::status::contact_invalid)
        << "normal " << bad.normal.transpose() << ", stiffness " << bad.stiffness;
    EXPECT_TRUE(result.capacity.isZero(0));
  }
}

TYPED_TEST(control_step, refuses_a_normal_that_is_no_unit_vector_and_a_negative_stiffness) {
  using M = typename TestFixture::table_type;
  for (const double length : {0.0, 0.5, 1 - 1e-5, 1 + 1e-5, 3.0, 1000.0, 1e154, 1e200, 1e308, 1.7e308})
    expect_refused<ph::no_direct_control, M>({.normal = {0, length}, .depth = 1e-3, .stiffness = 1e7});
  for (const double depth : {1e-3, -1e-3})
    expect_refused<ph::no_direct_control, M>({.normal = {0, 1}, .depth = depth, .stiffness = -1e7});
  expect_refused<ph::velocity_direct_control, M>({.normal = {0, 3}, .depth = 1e-3, .stiffness = 1e7});
  expect_refused<ph::velocity_direct_control, M>({.normal = {0, 1}, .depth = 1e-3, .stiffness = -1e7});
  const auto in_float = step_once<ph::no_direct_control>(
      M(), {}, state_of<M>({0, 0}, {0, -1}),
      ph::contact<2>{
          .normal = ph::vector<float, 2>(0.6f, 0.8f).cast<double>(), .depth = 1e-3, .stiffness = 1e3});
  EXPECT_EQ(in_float.outcome, ph::status::ok) << "a normal that was computed in float";
}

TYPED_TEST(control_step, refuses_a_contact_without_sensed_at_under_a_law_that_reads_it) {
  using M = typename TestFixture::table_type;
  ph::contact<2> wall{.normal = {0, 1}, .depth = 1e-3, .stiffness = 1e7};
  const auto moving_in = state_of<M>({0, 0}, {0, -1}, {0, -1});
  for (const auto& result : {step_once<ph::velocity_direct_control>(M(), {}, moving_in, wall),
                             step_once<ph::velocity_direct_control>(M(), {}, moving_in, wall, wall)}) {
    EXPECT_EQ(result.outcome, ph::status::contact_invalid);
    EXPECT_TRUE(result.capacity.isZero(0));
  }
  EXPECT_EQ(step_once<ph::direct_control>(M(), {}, moving_in, wall).outcome, ph::status::ok);
  wall.sensed_at = {0, 0};
  const auto set = step_once<ph::velocity_direct_control>(M(), {}, moving_in, wall);
  EXPECT_EQ(set.outcome, ph::status::ok);
  EXPECT_GT(set.capacity[1], 0);
}

TYPED_TEST(control_step, refuses_a_time_that_does_not_rise_under_a_law_that_uses_differences) {
  using M = typename TestFixture::table_type;
  const auto floor = ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1})));
  ph::controller control(M(), ph::brakes_of<M>(), floor, ph::velocity_direct_control());
  ph::controller other(M(), ph::brakes_of<M>(), floor, ph::direct_control());
  const auto at = [](double time, double y) {
    auto state = state_of<M>({0, TypeParam(y)}, {0, -1}, {0, -1});
    state.time = time;
    return state;
  };
  for (const double y : {-1e-3, 1.0}) {  // in the wall and in free space
    control.reset();
    EXPECT_EQ(control(at(5, y)).outcome, ph::status::ok);
    EXPECT_EQ(control(at(5, -1e-3)).outcome, ph::status::time_not_rising) << "it stands still";
    EXPECT_EQ(control(at(5, y)).outcome, ph::status::time_not_rising);
    EXPECT_EQ(control(at(5.001, y)).outcome, ph::status::ok);
    const auto back = control(at(4, -1e-3));
    EXPECT_EQ(back.outcome, ph::status::time_not_rising) << "it goes back";
    EXPECT_TRUE(back.capacity.isZero(0));
    EXPECT_EQ(control(at(4.001, y)).outcome, ph::status::ok) << "it rises again";
    control.reset();
    EXPECT_EQ(control(at(0, y)).outcome, ph::status::ok) << "another motion";
    for (const double time : {5.0, 5.0, 4.0}) EXPECT_EQ(other(at(time, y)).outcome, ph::status::ok);
  }
}

TYPED_TEST(control_step, keeps_the_stiffness_where_the_new_one_is_none) {
  using M = typename TestFixture::table_type;
  const ph::half_space<2> floor({0, 0}, {0, 1});
  ph::controller control(M(), ph::brakes_of<M>(), ph::scene(ph::wall(floor), ph::wall(floor)),
                         ph::no_direct_control());
  const auto state = state_of<M>({0, TypeParam(-1e-4)}, {0, -1});
  const auto held = control(state).capacity;
  EXPECT_GT(held.norm(), 0);
  auto& one = control.scene().template get<0>();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double none : {-1e7, -1e-300, infinity, -infinity, std::nan("")}) {
    EXPECT_FALSE(one.set_stiffness(none)) << none;
    EXPECT_EQ(one.stiffness(), 1e7);
    EXPECT_EQ(control(state).capacity, held);
  }
  EXPECT_TRUE(one.set_stiffness(0) && control.scene().template get<1>().set_stiffness(0));
  EXPECT_TRUE(control(state).capacity.isZero(0));
}

// A wall of the user's, whose gradient is three times as long as it should be.
struct steep_floor {
  static constexpr int dimension = 2;
  double distance(const ph::point<2>& x) const { return x[1]; }
  ph::point<2> gradient(const ph::point<2>&) const { return {0, 3}; }
};

TYPED_TEST(control_step, refuses_a_shape_whose_gradient_is_no_unit_vector) {
  using M = typename TestFixture::table_type;
  ph::controller control(M(), ph::brakes_of<M>(), ph::scene(ph::wall(steep_floor())),
                         ph::no_direct_control());
  ph::controller wider(M(), ph::brakes_of<M>(), ph::scene(ph::wall(ph::offset(steep_floor(), 0.01))),
                       ph::no_direct_control());
  EXPECT_EQ(control(state_of<M>({0, 1}, {0, -1})).outcome, ph::status::ok) << "in free space";
  const auto inside = state_of<M>({0, TypeParam(-1e-4)}, {0, -1});
  EXPECT_EQ(control(inside).outcome, ph::status::contact_invalid);
  EXPECT_EQ(wider(inside).outcome, ph::status::contact_invalid);
  EXPECT_TRUE(control(inside).capacity.isZero(0));
}

// A fault in any of several walls is reported, though another one would have governed.
TYPED_TEST(control_step, a_depth_that_is_not_finite_in_any_contact_is_a_fault) {
  using M = typename TestFixture::table_type;
  const ph::contact<2> good{.normal = {0, 1}, .depth = 1e-3, .stiffness = 1e7};
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
    ph::contact<2> spoiled = good;
    spoiled.depth = bad;
    for (const auto& result :
         {step_once<ph::no_direct_control>(M(), {}, state_of<M>({0, 0}, {0, -1}), good, spoiled),
          step_once<ph::no_direct_control>(M(), {}, state_of<M>({0, 0}, {0, -1}), spoiled, good)}) {
      EXPECT_EQ(result.outcome, ph::status::contact_invalid);
      EXPECT_TRUE(result.capacity.isZero(0));
    }
  }
}

TYPED_TEST(control_step, denormal_depths_rates_and_forces_change_nothing) {
  using T = TypeParam;
  const T least = std::numeric_limits<T>::denorm_min();
  const auto shallow =
      on_the_floor<ph::no_direct_control, T>(0, -1, {0, 0}, std::numeric_limits<double>::denorm_min(), 1);
  EXPECT_EQ(shallow.outcome, ph::status::ok);
  EXPECT_LE(shallow.capacity.norm(), least);
  // Slower than the dead band, softer than the hand's: as if nothing moved and nobody pushed
  const auto still = on_the_floor<ph::no_direct_control, T>(least, -least, {least, -least});
  EXPECT_EQ(still.signs, (ph::vector<T, 2>(0, 0)));
  EXPECT_TRUE(still.torque.isZero(0));
  expect_near(still.capacity, ph::vector<T, 2>(0, 10), 10);
}

TYPED_TEST(control_step, runs_without_a_force_sensor_where_the_law_needs_none) {
  using T = TypeParam;
  using M = typename TestFixture::table_type;
  ph::controller control(M(), {}, ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}), 1e3)),
                         ph::no_direct_control{});
  // Sinking: as with a sensor. At rest: no side is known, so the brake may hold either way, and predicts
  // nothing
  const auto sinking = control(ph::sensorless_device_state<M>{0.0, {0, T(-1e-4)}, {0, -1}});
  expect_near(sinking.torque, ph::vector<T, 2>(0, T(0.1)), 1);
  const auto resting = control(ph::sensorless_device_state<M>{0.0, {0, T(-1e-4)}, {0, 0}});
  EXPECT_TRUE(resting.signs.isZero(0) && resting.torque.isZero(0));
  expect_near(resting.capacity, ph::vector<T, 2>(0, T(0.1)), 1);
}

// A law that answers nonsense is stopped.
struct nonsense {
  template <class T, int D>
  T scale(const ph::contact_situation<T, D>&) const noexcept {
    return static_cast<T>(value);
  }
  double value = 0;
};

TYPED_TEST(control_step, a_scale_outside_zero_and_one_is_a_fault) {
  using M = typename TestFixture::table_type;
  const auto run = [](double value) {
    ph::contacts<2, 1> touched;
    touched.push_back({.normal = {0, 1}, .depth = 1e-6, .stiffness = 1e7});
    ph::step_memory<nonsense> memory;
    return ph::step(M(), ph::brakes_of<M>(), touched, nonsense{value}, state_of<M>({0, 0}, {0, -1}), memory);
  };
  for (const double bad : {-0.1, 1.001, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(run(bad).outcome, ph::status::scale_out_of_range) << bad;
    EXPECT_TRUE(run(bad).capacity.isZero(0) && run(bad).torque.isZero(0)) << bad;
  }
  for (const double good : {0.0, 0.5, 1.0}) EXPECT_EQ(run(good).outcome, ph::status::ok) << good;
}

// A TorqueLaw may remember; reset() forgets. It opposes with one N m more each time, and fails before time 0.
struct counting_law {
  static constexpr bool commands_torques = true;
  struct memory {
    int calls = 0;
    int released = 0;
  };
  template <class M, class EMatrix, int D, int N, class B>
  ph::brake_vector<M> torque(const ph::brake_situation<M, EMatrix, B>& now, const ph::contacts<D, N>&,
                             memory& m) const noexcept {
    ++m.calls;
    const bool fails = now.time < 0;
    return -now.s * (fails ? std::numeric_limits<typename M::scalar>::quiet_NaN()
                           : static_cast<typename M::scalar>(m.calls));
  }
  void released(memory& m, double) const noexcept { ++m.released; }
};

// Its account: of the force that these torques make before the limits, on the floor that wants 10 N.
struct given_torque {
  static constexpr bool commands_torques = true;
  double x = 0, y = 0;
  template <class M, class EMatrix, int D, int N, class B>
  ph::brake_vector<M> torque(const ph::brake_situation<M, EMatrix, B>&,
                             const ph::contacts<D, N>&) const noexcept {
    return ph::as<typename M::scalar>(ph::point<2>(x, y));
  }
};

TYPED_TEST(control_step, tells_what_force_the_torques_of_a_law_make) {
  using T = TypeParam;
  using M = typename TestFixture::table_type;
  const auto run = [](const given_torque& law, const ph::vector<T, 2>& v) {
    ph::brakes_of<M> strong;
    strong.torque_limit.setConstant(T(100));
    ph::contacts<2, 1> touched;
    touched.push_back({.normal = {0, 1}, .depth = 1e-6, .stiffness = 1e7});
    ph::step_memory<given_torque> memory;
    return ph::step(M(), strong, touched, law, state_of<M>({0, 0}, v), memory);
  };
  const auto exact = run({0, 10}, {-1, -1});
  EXPECT_EQ(exact.display, ph::display_class::exact);
  EXPECT_EQ(exact.power, ph::power_class::passive_1);
  EXPECT_NEAR(exact.approximation_cosine, 1, 1e-6);
  const auto slanted = run({3, 4}, {-1, -1});
  EXPECT_EQ(slanted.display, ph::display_class::approximate);
  EXPECT_EQ(slanted.power, ph::power_class::passive_1) << "Fd itself could be displayed";
  EXPECT_NEAR(slanted.approximation_cosine, 0.8, 1e-6);
  EXPECT_EQ(slanted.control_force, (ph::vector<T, 2>(3, 4)));
  EXPECT_EQ(slanted.cone_coefficients, (ph::vector<T, 2>(3, 4)));
  expect_near(slanted.desired_force, ph::vector<T, 2>(0, 10), 10);
  const auto along = run({3, 0}, {-1, -1});
  EXPECT_EQ(along.display, ph::display_class::none);
  EXPECT_EQ(along.approximation_cosine, T(0));
  EXPECT_EQ(along.capacity, (ph::vector<T, 2>(3, 0)));
  const auto driving = run({3, 10}, {-1, 1});
  EXPECT_EQ(driving.power, ph::power_class::active);
  EXPECT_EQ(driving.display, ph::display_class::none);
  EXPECT_EQ(driving.capacity, (ph::vector<T, 2>(3, 0))) << "y would have to drive";
  const auto strong = run({150, 40}, {-1, -1});
  EXPECT_TRUE(strong.saturated);
  EXPECT_EQ(strong.torque, (ph::vector<T, 2>(100, 40))) << "each within its limit";
  EXPECT_EQ(strong.control_force, (ph::vector<T, 2>(150, 40))) << "before the limits";
}

template <class T>
struct law_memory : ::testing::Test {
  using M = ph::xy_table<T>;
  ph::contacts<2, 1> touched;
  ph::step_memory<counting_law> memory;
  void SetUp() override { touched.push_back({.normal = {0, 1}, .depth = 1e-3, .stiffness = 1e3}); }
  auto run(double time, const ph::contacts<2, 1>& walls) {
    ph::brakes_of<M> strong;
    strong.torque_limit.setConstant(100);
    auto state = state_of<M>({0, 0}, {0, -1});
    state.time = time;
    return ph::step(M(), strong, walls, counting_law{}, state, memory);
  }
};
TYPED_TEST_SUITE(law_memory, scalars);

TYPED_TEST(law_memory, goes_from_cycle_to_cycle) {
  EXPECT_EQ(this->run(1, this->touched).capacity[1], 1);
  EXPECT_EQ(this->run(2, this->touched).capacity[1], 2);
  this->memory = {};
  EXPECT_EQ(this->run(3, this->touched).capacity[1], 1);
}

TYPED_TEST(law_memory, is_kept_only_by_a_cycle_that_ends_well) {
  this->run(1, this->touched);
  EXPECT_EQ(this->run(-1, this->touched).outcome, ph::status::result_not_finite);
  EXPECT_EQ(this->memory.law.calls, 1);
  EXPECT_EQ(this->memory.law.released, 1);
  auto spoiled = this->touched;
  spoiled.begin()->normal[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(this->run(2, spoiled).outcome, ph::status::contact_invalid);
  EXPECT_EQ(this->memory.law.calls, 1);
  EXPECT_EQ(this->memory.law.released, 2);
  EXPECT_EQ(this->run(3, this->touched).capacity[1], 2);
}

TYPED_TEST(law_memory, is_told_of_free_space) {
  this->run(1, this->touched);
  EXPECT_EQ(this->run(2, {}).outcome, ph::status::ok);
  EXPECT_EQ(this->memory.law.calls, 1);
  EXPECT_EQ(this->memory.law.released, 1);
}

TYPED_TEST(control_step, a_law_keeps_its_memory_until_reset) {
  using T = TypeParam;
  using M = typename TestFixture::table_type;
  const auto state = state_of<M>({0, T(-1e-4)}, {0, -1});
  ph::brakes_of<M> strong;
  strong.torque_limit.setConstant(100);
  ph::controller strongly(M(), strong, ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}))),
                          counting_law{});
  EXPECT_EQ(strongly(state).capacity[1], T(1));
  EXPECT_EQ(strongly(state).capacity[1], T(2));
  strongly.reset();
  EXPECT_EQ(strongly(state).capacity[1], T(1));
}

}  // namespace
