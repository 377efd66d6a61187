// slow
// Optional members of brakes, mechanisms, walls and states: their absence changes no result.
#include "../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/shapes/moving.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <algorithm>
#include <limits>

namespace {

using pair = ph::vector<double, 2>;

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

const ph::wall<ph::half_space<2>> slanted_wall(ph::half_space<2>({0, 0}, {0.6, 0.8}), 1e4);

// In this wall of the table, the second slide slower than the dead bands.
template <class Brakes, class State>
auto slide_in(const Brakes& brakes, const State& state) {
  return ph::controller(ph::xy_table<double>(), brakes, ph::scene(slanted_wall),
                        ph::no_direct_control())(state);
}

TEST(brakes_that_tell_a_part, do_what_they_tell) {
  using M = ph::xy_table<double>;
  const ph::sensorless_device_state<M> blind{0.0, {-0.1, -0.1}, {-0.5, 0.01}};
  ph::device_state<M> sensed{0.0, {-0.1, -0.1}, {-0.5, 0.01}, {0, -2}};
  const auto bare = slide_in(ph::unlimited_brakes(), blind);
  EXPECT_EQ(bare.signs, pair(-1, 1)) << "slower than any dead band, but there is none";
  EXPECT_GT(bare.capacity[0], 1000) << "and no limit";
  EXPECT_FALSE(bare.saturated);
  const auto cut = slide_in(limits_alone(), blind);
  EXPECT_TRUE(cut.saturated);
  EXPECT_EQ(cut.capacity.maxCoeff(), 1);
  const auto rests = slide_in(dead_bands_alone(), blind);
  EXPECT_EQ(rests.signs, pair(-1, 0));
  EXPECT_EQ(rests.torque[1], 0);
  EXPECT_GT(rests.capacity[1], 0);
  EXPECT_FALSE(rests.saturated);
  const auto held = slide_in(dead_bands_alone(), sensed);
  EXPECT_EQ(held.signs, pair(-1, -1));
  EXPECT_EQ(held.torque[1], 2) << "no more than the hand pushes";
  sensed.qd[1] = 0;
  EXPECT_EQ(slide_in(ph::unlimited_brakes(), sensed).signs, pair(-1, 0)) << "whoever pushes";
}

// The same device without the hints: dense matrices that depend on the pose.
template <class T>
struct dense_table {
  using scalar = T;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  ph::vector<T, 2> position(const ph::vector<T, 2>& q) const { return q; }
  ph::matrix<T, 2, 2> jacobian(const ph::vector<T, 2>&) const { return ph::matrix<T, 2, 2>::Identity(); }
};
template <class T>
struct diagonal_gears : ph::xy_table<T> {
  ph::diagonal_matrix<T, 2> transmission() const { return ph::diagonal_matrix<T, 2>(T(4), T(-0.3)); }
};
template <class T>
struct dense_gears : dense_table<T> {
  ph::matrix<T, 2, 2> transmission(const ph::vector<T, 2>&) const {
    return ph::matrix<T, 2, 2>{{T(4), T(0)}, {T(0), T(-0.3)}};
  }
};

template <class Hinted, class Dense>
void expect_same_as_dense() {
  using T = typename Hinted::scalar;
  ph::testing::random_source random(21);
  for (int k = 0; k < 500; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed 21, trial " << k);
    const ph::vector<T, 2> q = random.normal_vector<T, 2>(), hand = random.normal_vector<T, 2>();
    ph::vector<T, 2> qd = random.normal_vector<T, 2>();
    if (k % 3 == 0) qd[k % 2] = T(0);
    const ph::contact<2> wall{.normal = random.direction<double, 2>(), .depth = 1e-4, .stiffness = 1e4};
    const auto a = step_once<ph::direct_control>(Hinted(), {}, state_of<Hinted>(q, qd, hand), wall);
    const auto b = step_once<ph::direct_control>(Dense(), {}, state_of<Dense>(q, qd, hand), wall);
    EXPECT_EQ(a.display, b.display);
    EXPECT_EQ(a.power, b.power);
    EXPECT_EQ(a.signs, b.signs);
    const double size = 1 / std::max(1e-3, double(a.approximation_cosine));
    expect_near(a.capacity, b.capacity, size * size);
    expect_near(a.torque, b.torque, size * size);
    EXPECT_NEAR(a.alpha, b.alpha, ph::rounding_tolerance<T>(2));
  }
}

TEST(hints, of_a_diagonal_jacobian_or_transmission_change_nothing_but_the_cost) {
  expect_same_as_dense<ph::xy_table<double>, dense_table<double>>();
  expect_same_as_dense<diagonal_gears<float>, dense_gears<float>>();
}

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
  for (int k = 0; k < 500; ++k) {
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
  EXPECT_GT(displayed, 25);
}

const auto one = ph::scene(ph::wall(ph::half_space<2>({0.25, 0}, {-0.6, 0.8}), 1e4));
const auto corner = ph::scene(ph::wall(ph::half_space<2>({0, 0.1}, {0.6, -0.8}), 1e4),
                              ph::wall(ph::half_space<2>({0.27, 0}, {-1, 0.1}), 1e3));

template <class M>
struct absent_members : ::testing::Test {};
using devices = ::testing::Types<ph::xy_table<float>, ph::tendon_two_link<double>>;
TYPED_TEST_SUITE(absent_members, devices);

TYPED_TEST(absent_members, are_members_that_say_nothing) {
  using M = TypeParam;
  using blind = ph::sensorless_device_state<M>;
  const ph::unlimited_brakes none;
  expect_twins<M, ph::on_off_control, blind>({}, one, none, unbounded<M>());
  expect_twins<M, ph::direct_control, ph::device_state<M>>({}, one, none, unbounded<M>());
}

// As members that say nothing, or whose limits are out of reach.
TEST(several_contacts_of_absent_members, at_several_walls_change_nothing) {
  using M = ph::tendon_two_link<double>;
  using sensed = ph::device_state<M>;
  auto far = unbounded<M>();
  far.torque_limit.setConstant(1e12);
  expect_twins<M, ph::direct_control, sensed>({}, corner, ph::unlimited_brakes(), far);
  expect_twins<M, ph::velocity_direct_control, sensed>(ph::velocity_direct_control(), corner, lag_alone(),
                                                       far);
  far.torque_limit = limits_alone().torque_limit;
  expect_twins<M, ph::direct_control, sensed>({}, corner, limits_alone(), far);
}

TEST(fixed_walls, are_moving_walls_at_rest) {
  using M = ph::tendon_two_link<double>;
  const ph::half_space<2> plane({0.25, 0}, {-0.6, 0.8});
  ph::controller a(M(), ph::brakes_of<M>(), ph::scene(ph::wall(plane, 1e4)), ph::direct_control());
  ph::controller b(M(), ph::brakes_of<M>(), ph::scene(ph::wall(ph::moving(plane), 1e4)),
                   ph::direct_control());
  ph::testing::random_source random(3);
  int displayed = 0;
  for (int k = 0; k < 300; ++k) {
    const ph::device_state<M> s{0, 0.6 * random.direction<double, 2>(), random.direction<double, 2>(),
                                2 * random.direction<double, 2>()};
    const auto x = a(s), y = b(s);
    ASSERT_EQ(x.capacity, y.capacity) << k;
    ASSERT_EQ(x.alpha, y.alpha) << k;
    displayed += x.capacity.isZero(0) ? 0 : 1;
  }
  EXPECT_GT(displayed, 30);
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
