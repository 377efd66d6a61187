// slow
// Optional members of brakes, mechanisms, walls and states: their absence changes no result.
#include "../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <algorithm>
#include <limits>

namespace {

using pair = ph::vector<double, 2>;

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

// The same table without the hints: a transmission on the diagonal, dense matrices that depend on the pose.
struct geared_table : ph::xy_table<double> {
  ph::diagonal_matrix<double, 2> transmission() const { return {4.0, -0.3}; }
};
struct dense_table {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 2;
  pair position(const pair& q) const { return q; }
  ph::matrix<double, 2, 2> jacobian(const pair&) const { return ph::matrix<double, 2, 2>::Identity(); }
  ph::matrix<double, 2, 2> transmission(const pair&) const {
    return ph::matrix_of<2, 2>(4.0, 0.0, 0.0, -0.3);
  }
};

TEST(hints, of_a_diagonal_jacobian_and_transmission_change_nothing_but_the_cost) {
  ph::testing::random_source random(21);
  for (int k = 0; k < 200; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed 21, trial " << k);
    const pair q = random.normal_vector<double, 2>(), hand = random.normal_vector<double, 2>();
    pair qd = random.normal_vector<double, 2>();
    if (k % 3 == 0) qd[k % 2] = 0;
    const ph::contact<2> wall{.normal = random.direction<double, 2>(), .depth = 1e-4, .stiffness = 1e4};
    const auto a =
        step_once<ph::direct_control>(geared_table(), {}, state_of<geared_table>(q, qd, hand), wall);
    const auto b = step_once<ph::direct_control>(dense_table(), {}, state_of<dense_table>(q, qd, hand), wall);
    EXPECT_EQ(a.display, b.display);
    EXPECT_EQ(a.power, b.power);
    EXPECT_EQ(a.signs, b.signs);
    const double size = 1 / std::max(1e-3, a.approximation_cosine);
    expect_near(a.capacity, b.capacity, size * size);
    expect_near(a.torque, b.torque, size * size);
    EXPECT_NEAR(a.alpha, b.alpha, ph::rounding_tolerance<double>(2));
  }
}

using twin_arm = ph::tendon_two_link<double>;

// Brakes with members that say nothing, except limits.
ph::brakes_of<twin_arm> dull_brakes(double limit) {
  ph::brakes_of<twin_arm> brakes;
  brakes.torque_limit.setConstant(limit);
  brakes.rate_dead_band.setZero();
  brakes.torque_dead_band.setZero();
  return brakes;
}

template <class State, class Law, class Scene, class Some>
void expect_twins(const Law& law, const Scene& scene, const Some& some, const ph::brakes_of<twin_arm>& all) {
  constexpr unsigned seed = 8;
  ph::testing::random_source random(seed);
  ph::controller a(twin_arm(), some, scene, law), lean = a;
  ph::controller b(twin_arm(), all, scene, law);
  int displayed = 0;
  for (int k = 0; k < 300; ++k) {
    State s{k * 1e-3, 0.6 * random.direction<double, 2>(), random.direction<double, 2>()};
    if constexpr (requires { s.hand_force; }) s.hand_force = 2 * random.direction<double, 2>();
    else if (k % 5 == 0) s.qd[k % 2] = 0;  // with a hand force, it alone decides at rest
    const auto x = a(s), y = b(s);
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", state " << k);
    ASSERT_EQ(x.outcome, y.outcome);
    ASSERT_EQ(x.capacity, y.capacity);
    ASSERT_EQ(x.torque, y.torque);
    ASSERT_EQ(x.signs, y.signs);
    ASSERT_EQ(x.display, y.display);
    ASSERT_EQ(x.power, y.power);
    ASSERT_EQ(x.alpha, y.alpha);
    ASSERT_EQ(lean.command(s).capacity, x.capacity);
    displayed += !x.capacity.isZero(0);
  }
  EXPECT_GT(displayed, 15);
}

TEST(absent_members, are_members_that_say_nothing) {
  using blind = ph::sensorless_device_state<twin_arm>;
  using sensed = ph::device_state<twin_arm>;
  const ph::wall first(ph::half_space<2>({0.25, 0}, {-0.6, 0.8}), 1e4),
      second(ph::half_space<2>({0.27, 0}, {-1, 0.1}), 1e3);
  expect_twins<blind>(ph::on_off_control(), ph::scene(first), ph::unlimited_brakes(),
                      dull_brakes(std::numeric_limits<double>::max()));
  expect_twins<sensed>(ph::velocity_direct_control(), ph::scene(first, second), lag_alone(),
                       dull_brakes(1e12));
  expect_twins<sensed>(ph::direct_control(), ph::scene(first, second), limits_alone(), dull_brakes(1));
}

TEST(brakes_that_tell_a_part, are_checked_for_what_they_tell) {
  using M = ph::xy_table<double>;
  const auto make = [](const auto& brakes) {
    ph::controller control(M(), brakes, ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}))),
                           ph::no_direct_control());
  };
  EXPECT_EQ(thrown_by([&] { make(ph::unlimited_brakes()); }), "nothing");
  EXPECT_EQ(thrown_by([&] { make(limits_alone()); }), "nothing");
  EXPECT_EQ(thrown_by([&] { make(limits_alone{{1, -2}}); }),
            "passive_haptics: torque_limit[1] [N m] = -2: expected a finite number >= 0");
  EXPECT_EQ(validate(ph::unlimited_brakes()), "");
  EXPECT_EQ(ph::check_brakes(dead_bands_alone{{-1, 0}}),
            "rate_dead_band[0] [rad/s] = -1: expected a finite number >= 0");
  ph::step_memory<ph::no_direct_control> memory;
  const ph::sensorless_device_state<M> s{0, {0, 0}, {1, -1}};
  ph::contacts<2, 1> touched;
  touched.push_back({.normal = {0, 1}, .depth = 1e-3, .stiffness = 1e3});
  EXPECT_EQ(ph::step(M(), limits_alone{{1, -2}}, touched, ph::no_direct_control(), s, memory).outcome,
            ph::status::parameters_invalid);
  EXPECT_EQ(ph::step(M(), ph::unlimited_brakes(), touched, ph::no_direct_control(), s, memory).capacity,
            pair(0, 1));
}

}  // namespace
