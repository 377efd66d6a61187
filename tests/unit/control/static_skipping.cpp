// slow
// What a scene, a law, a state or the brakes do not need does not exist: counted on each rung of the ladder
// (benchmarks/scenes), and its absence changes no result.
#include "../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/shapes/moving.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <limits>

namespace {

using pair = ph::vector<double, 2>;

struct calls_made {
  int position = 0, jacobian = 0, transmission = 0, distance = 0, gradient = 0, velocity = 0;
};

// ---- what counts

struct counting_table {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  pair position(const pair& q) const {
    ++count->position;
    return q;
  }
  ph::diagonal_matrix<double, 2> jacobian() const {
    ++count->jacobian;
    return {1, 1};
  }
  calls_made* count;
};

struct counting_geared_table : counting_table {
  ph::diagonal_matrix<double, 2> transmission() const {
    ++count->transmission;
    return {2, 3};
  }
};

struct counting_plane {
  static constexpr int dimension = 2;
  double distance(const pair& x) const {
    ++count->distance;
    return plane.distance(x);
  }
  pair gradient(const pair& x) const {
    ++count->gradient;
    return plane.gradient(x);
  }
  calls_made* count;
  ph::half_space<2> plane{{0, 0}, {0.6, 0.8}};
};

struct counting_conveyor : counting_plane {
  pair velocity(const pair&) const {
    ++count->velocity;
    return {0, 0};
  }
};

// ---- brakes that tell only a part

struct limits_alone {
  pair torque_limit = {1, 1};
};
struct dead_bands_alone {
  static constexpr bool unlimited = true;
  pair rate_dead_band = {0.02, 0.02};
};
struct lag_alone {
  static constexpr bool unlimited = true;
  pair time_constant = {0.02, 0.02};
};

template <class M, class Brakes, class Law, class... Shapes>
auto control_of(const M& mechanism, const Brakes& brakes, const Law& law, const Shapes&... shapes) {
  return ph::controller(mechanism, brakes, ph::scene(ph::wall(shapes, 1e4)...), law);
}

struct static_skipping : ::testing::Test {
  calls_made count;
  counting_table table{&count};
  counting_plane plane{&count};
  ph::sensorless_device_state<counting_table> blind{0.0, {-0.1, -0.1}, {-0.5, 0.01}};
  ph::device_state<counting_table> sensed{0.0, {-0.1, -0.1}, {-0.5, 0.01}, {0, -2}};
  void SetUp() override { sensed.hand_force = {0, -2}; }
};

TEST_F(static_skipping, the_first_rung_needs_each_quantity_once_and_no_more) {
  auto control = control_of(table, ph::unlimited_brakes(), ph::no_direct_control(), plane);
  count = {};
  const auto result = control(blind);
  EXPECT_EQ(result.display, ph::display_class::approximate);
  EXPECT_EQ(count.position, 1);
  EXPECT_EQ(count.distance, 1);
  EXPECT_EQ(count.gradient, 1);
  EXPECT_EQ(count.jacobian, 1);
  EXPECT_EQ(count.transmission + count.velocity, 0);
  EXPECT_EQ(result.signs, pair(-1, 1)) << "slower than any dead band, but there is none";
  EXPECT_GT(result.capacity[0], 1000) << "and no limit";
  EXPECT_FALSE(result.saturated);
}

TEST_F(static_skipping, free_space_needs_a_position_and_a_distance_of_each_wall) {
  auto control =
      control_of(table, ph::unlimited_brakes(), ph::no_direct_control(), plane, counting_conveyor{plane});
  count = {};
  blind.q = {1, 1};
  EXPECT_EQ(control(blind).wall_number, -1);
  EXPECT_EQ(count.position, 1);
  EXPECT_EQ(count.distance, 2);
  EXPECT_EQ(count.gradient + count.velocity + count.jacobian, 0);
}

TEST_F(static_skipping, limits_cut) {
  auto control = control_of(table, limits_alone(), ph::no_direct_control(), plane);
  const auto result = control(blind);
  EXPECT_TRUE(result.saturated);
  EXPECT_EQ(result.capacity.maxCoeff(), 1);
}

TEST_F(static_skipping, dead_bands_alone_find_brakes_at_rest) {
  auto control = control_of(table, dead_bands_alone(), ph::no_direct_control(), plane);
  const auto result = control(blind);
  EXPECT_EQ(result.signs, pair(-1, 0));
  EXPECT_EQ(result.torque[1], 0);
  EXPECT_GT(result.capacity[1], 0);
  EXPECT_FALSE(result.saturated);
}

TEST_F(static_skipping, the_hands_torque_needs_a_hand_force_and_a_dead_band) {
  auto sticking = control_of(table, dead_bands_alone(), ph::no_direct_control(), plane);
  const auto held = sticking(sensed);
  EXPECT_EQ(held.signs, pair(-1, -1));
  EXPECT_EQ(held.torque[1], 2) << "no more than the hand pushes";
  auto slipping = control_of(table, ph::unlimited_brakes(), ph::no_direct_control(), plane);
  sensed.qd[1] = 0;
  const auto free = slipping(sensed);
  EXPECT_EQ(free.signs, pair(-1, 0)) << "whoever pushes";
}

TEST_F(static_skipping, a_second_wall_costs_its_distance_alone) {
  counting_plane far = plane;
  far.plane = ph::half_space<2>({-10, 0}, {1, 0});
  auto control = control_of(table, ph::unlimited_brakes(), ph::no_direct_control(), plane, far);
  control(blind);
  EXPECT_EQ(count.distance, 2);
  EXPECT_EQ(count.gradient, 1);
}

TEST_F(static_skipping, only_a_wall_that_can_move_is_asked_for_its_velocity) {
  auto control = control_of(table, ph::unlimited_brakes(), ph::no_direct_control(), counting_conveyor{plane});
  control(blind);
  EXPECT_EQ(count.velocity, 1);
  EXPECT_EQ(count.gradient, 1);
}

TEST_F(static_skipping, a_transmission_costs_its_rates) {
  ph::controller control(counting_geared_table{{&count}}, ph::unlimited_brakes(),
                         ph::scene(ph::wall(plane, 1e4)), ph::no_direct_control());
  EXPECT_EQ(count.transmission, 1) << "its inverse is made once";
  count = {};
  control(blind);
  EXPECT_EQ(count.transmission, 1);
  EXPECT_EQ(count.jacobian, 1);
}

// ---- what is not there changes nothing

// The same brakes with members that say nothing.
template <class M>
ph::brakes_of<M> unbounded() {
  using T = typename M::scalar;
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(std::numeric_limits<T>::max());
  brakes.rate_dead_band.setZero();
  brakes.torque_dead_band.setZero();
  return brakes;
}

template <class M, class Law, class State, class Scene, class Some, class All>
void expect_twins(const Law& law, const Scene& scene, const Some& some, const All& all) {
  constexpr unsigned seed = 8;
  using T = typename M::scalar;
  ph::testing::random_source random(seed);
  ph::controller a(M(), some, scene, law);
  ph::controller b(M(), all, scene, law);
  auto lean = a;
  int displayed = 0;
  for (int k = 0; k < 2000; ++k) {
    State s{k * 1e-3, T(0.6) * random.direction<T, M::dof>(), random.direction<T, M::dof>()};
    if constexpr (requires { s.hand_force; }) s.hand_force = T(2) * random.direction<T, 2>();
    else if (k % 5 == 0) s.qd[k % M::dof] = T(0);  // with a hand force, it alone decides at rest
    const auto x = a(s), y = b(s);
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", state " << k);
    ASSERT_EQ(x.outcome, y.outcome);
    ASSERT_EQ(x.capacity, y.capacity);
    ASSERT_EQ(x.torque, y.torque);
    ASSERT_EQ(x.signs, y.signs);
    ASSERT_EQ(x.display, y.display);
    ASSERT_EQ(x.power, y.power);
    ASSERT_EQ(x.alpha, y.alpha);
    ASSERT_EQ(x.approximation_cosine, y.approximation_cosine);
    ASSERT_EQ(lean.command(s).capacity, x.capacity);
    displayed += x.capacity.isZero(0) ? 0 : 1;
  }
  EXPECT_GT(displayed, 100);
}

const auto one = ph::scene(ph::wall(ph::half_space<2>({0.25, 0}, {-0.6, 0.8}), 1e4));
const auto corner = ph::scene(ph::wall(ph::half_space<2>({0, 0.1}, {0.6, -0.8}), 1e4),
                              ph::wall(ph::half_space<2>({0.27, 0}, {-1, 0.1}), 1e3));

template <class M>
struct absent_members : ::testing::Test {};
using devices = ::testing::Types<ph::xy_table<double>, ph::xy_table<float>, ph::tendon_two_link<double>,
                                 ph::tendon_two_link<float>>;
TYPED_TEST_SUITE(absent_members, devices);

TYPED_TEST(absent_members, are_members_that_say_nothing_without_a_hand_force) {
  using M = TypeParam;
  using blind = ph::sensorless_device_state<M>;
  const ph::unlimited_brakes none;
  expect_twins<M, ph::no_direct_control, blind>({}, one, none, unbounded<M>());
  expect_twins<M, ph::on_off_control, blind>({}, one, none, unbounded<M>());
}

TYPED_TEST(absent_members, are_members_that_say_nothing_where_brakes_slip) {
  using M = TypeParam;
  expect_twins<M, ph::direct_control, ph::device_state<M>>({}, one, ph::unlimited_brakes(), unbounded<M>());
}

TEST(several_contacts_without_limits, are_met_as_with_limits_out_of_reach) {
  using M = ph::tendon_two_link<double>;
  auto far = unbounded<M>();
  far.torque_limit.setConstant(1e12);
  expect_twins<M, ph::direct_control, ph::device_state<M>>({}, corner, ph::unlimited_brakes(), far);
  expect_twins<M, ph::no_direct_control, ph::sensorless_device_state<M>>({}, corner, ph::unlimited_brakes(),
                                                                         far);
}

TEST(limits_without_dead_bands, are_those_of_brake_parameters) {
  using M = ph::tendon_two_link<double>;
  auto all = unbounded<M>();
  all.torque_limit = limits_alone().torque_limit;
  expect_twins<M, ph::direct_control, ph::device_state<M>>({}, corner, limits_alone(), all);
}

TEST(a_lag_alone, is_enough_for_a_law_that_needs_it) {
  using M = ph::tendon_two_link<double>;
  auto all = unbounded<M>();
  all.torque_limit.setConstant(1e12);
  expect_twins<M, ph::velocity_direct_control, ph::device_state<M>>(ph::velocity_direct_control(), corner,
                                                                    lag_alone(), all);
}

TEST(fixed_walls, are_moving_walls_at_rest) {
  using M = ph::tendon_two_link<double>;
  const ph::half_space<2> plane({0.25, 0}, {-0.6, 0.8});
  const auto fixed = ph::scene(ph::wall(plane, 1e4));
  const auto moving = ph::scene(ph::wall(ph::moving(plane), 1e4));
  ph::controller a(M(), ph::brakes_of<M>(), fixed, ph::direct_control());
  ph::controller b(M(), ph::brakes_of<M>(), moving, ph::direct_control());
  ph::testing::random_source random(3);
  int displayed = 0;
  for (int k = 0; k < 1000; ++k) {
    const ph::device_state<M> s{0, 0.6 * random.direction<double, 2>(), random.direction<double, 2>(),
                                2 * random.direction<double, 2>()};
    const auto x = a(s), y = b(s);
    ASSERT_EQ(x.capacity, y.capacity) << k;
    ASSERT_EQ(x.alpha, y.alpha) << k;
    ASSERT_EQ(x.power, y.power) << k;
    displayed += x.capacity.isZero(0) ? 0 : 1;
  }
  EXPECT_GT(displayed, 100);
}

// As in step.cpp, through a scene that is sensed.
TEST(a_moving_wall, decides_on_scaling_by_relative_velocity_and_on_power_by_the_handles_own) {
  using M = ph::xy_table<double>;
  ph::brakes_of<M> strong;
  strong.torque_limit.setConstant(1e3);
  ph::controller control(M(), strong, ph::scene(ph::wall(ph::moving(ph::half_space<2>({0, 0}, {0, 1})), 1e4)),
                         ph::direct_control());
  const auto run = [&](double vy, double wall_vy) {
    control.scene().get<0>().shape.set_motion({0, 0}, {5, wall_vy});
    return control(ph::device_state<M>{0, {0, -1e-3}, {1, vy}, {0, -2}});
  };
  EXPECT_NEAR(run(-1, -2).alpha, 0.2, 1e-12) << "the wall sinks the faster: the handle leaves it";
  EXPECT_EQ(run(-1, -2).power, ph::power_class::passive_1);
  EXPECT_EQ(run(-1, -0.5).alpha, 1);
  EXPECT_EQ(run(1, 2).power, ph::power_class::active) << "though the wall overtakes the handle";
}

// ---- faults

TEST(brakes_that_tell_a_part, are_checked_for_what_they_tell) {
  using M = ph::xy_table<double>;
  const auto make = [](const auto& brakes) {
    ph::controller control(M(), brakes, ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}))),
                           ph::no_direct_control());
  };
  EXPECT_EQ(thrown_by([&] { make(ph::unlimited_brakes()); }), "nothing");
  EXPECT_EQ(thrown_by([&] { make(limits_alone()); }), "nothing");
  EXPECT_EQ(thrown_by([&] { make(limits_alone{{1, -2}}); }),
            "passive_haptics: torque_limit[1] [N m] = -2, expected a finite number >= 0");
  EXPECT_EQ(validate(ph::unlimited_brakes()), "");
  EXPECT_EQ(ph::check_brakes(dead_bands_alone{{-1, 0}}),
            "rate_dead_band[0] [rad/s] = -1, expected a finite number >= 0");
  ph::step_memory<ph::no_direct_control> memory;
  const ph::sensorless_device_state<M> s{0, {0, 0}, {1, -1}};
  ph::contacts<2, 1> touched;
  touched.push_back({.normal = {0, 1}, .depth = 1e-3, .stiffness = 1e3});
  EXPECT_EQ(ph::step(M(), limits_alone{{1, -2}}, touched, ph::no_direct_control(), s, memory).outcome,
            ph::status::parameters_invalid);
  EXPECT_EQ(ph::step(M(), ph::unlimited_brakes(), touched, ph::no_direct_control(), s, memory).capacity,
            pair(0, 1));
}

TEST(an_angle_that_is_not_finite, is_a_fault_in_contact_and_in_free_space) {
  using M = ph::xy_table<double>;
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {inf, -inf, std::numeric_limits<double>::quiet_NaN()}) {
    ph::step_options<double> options;
    options.min_cosine = bad;
    ph::controller control(M(), ph::unlimited_brakes(),
                           ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0.6, 0.8}), 1e3)),
                           ph::no_direct_control(), options);
    const ph::sensorless_device_state<M> pressed{0, {-1, -1}, {-1, 1}}, free{0, {1, 1}, {-1, -1}};
    for (const auto& state : {pressed, free}) {
      EXPECT_EQ(control(state).outcome, ph::status::parameters_invalid) << bad;
      EXPECT_EQ(control.command(state).outcome, ph::status::parameters_invalid) << bad;
      EXPECT_TRUE(control.command(state).capacity.isZero(0)) << bad;
    }
  }
}

TEST(faults_without_any_need, are_still_faults) {
  using M = ph::xy_table<double>;
  const double inf = std::numeric_limits<double>::infinity();
  const auto stiff = ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0.6, 0.8}), 1e308));
  ph::controller control(M(), ph::unlimited_brakes(), stiff, ph::no_direct_control());
  ph::sensorless_device_state<M> s{0, {-1, -1}, {-1, 1}};
  EXPECT_EQ(control(s).outcome, ph::status::result_not_finite) << "1.4e308 N, scaled by 1 / 0.36";
  s.q = {-10, -10};
  EXPECT_EQ(control(s).outcome, ph::status::contact_invalid);
  s.qd[0] = inf;
  EXPECT_EQ(control(s).outcome, ph::status::state_not_finite);
  EXPECT_TRUE(control.command(s).capacity.isZero(0));
}

}  // namespace
