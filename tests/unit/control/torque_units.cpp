// Torques of least norm in the units of the brakes' limits: a polar arm, equal limits, edges.
#include "../support.hpp"
#include "polar_arm.hpp"

#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/force/forms/form_of.hpp>
#include <passive_haptics/force/torques/torques_beside.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <limits>

namespace {

using three = ph::vector<double, 3>;
using pair_of_coordinates = ph::vector<double, 2>;

// Torques per newton wanted, of one cycle; 0 where nothing is displayed.
template <class M, class B>
ph::brake_vector<M> torques_for(const M& mechanism, const B& brakes, const ph::device_state<M>& state,
                                const ph::point<2>& n) {
  ph::contacts<2, 1> touched;
  touched.push_back({.normal = n, .depth = 1e-3, .stiffness = 1e3});
  ph::step_memory<ph::no_direct_control> memory;
  const auto result = ph::step(mechanism, brakes, touched, ph::no_direct_control(), state, memory);
  EXPECT_EQ(result.outcome, ph::status::ok);
  return result.cone_coefficients;
}

ph::device_state<polar_arm> random_polar_state(ph::testing::random_source& random) {
  return {0,
          {random.uniform(-3.0, 3.0), random.uniform(0.1, 0.3)},
          {random.uniform(-2.0, 2.0), random.uniform(-0.3, 0.3)},
          {0, 0}};
}

ph::brakes_of<polar_arm> polar_brakes(const three& limit) {
  ph::brakes_of<polar_arm> brakes;
  brakes.torque_limit = limit;
  brakes.rate_dead_band.setZero();
  return brakes;
}

// One force, with torques of the least norm in parts of the limits, so that it can be larger before a limit.
TEST(torque_units, are_the_limits) {
  const polar_arm arm;
  const three limit(0.5, 20, 5);  // N m, N, N
  ph::testing::random_source random(21);
  int shown = 0;
  for (int k = 0; k < 500; ++k) {
    const auto state = random_polar_state(random);
    const ph::point<2> n = random.direction<double, 2>();
    const three t = torques_for(arm, polar_brakes(limit), state, n);
    const three least = torques_for(arm, polar_brakes({1, 1, 1}), state, n);  // |t| in SI units
    ASSERT_EQ(t.isZero(0), least.isZero(0)) << "the cone is that of the signs";
    shown += !t.isZero(0);
    const auto G = ph::force_generators(arm, state.q);
    ASSERT_LE((G * t - G * least).norm(), 1e-12 * (G * t).norm());
    ASSERT_LE(t.cwiseQuotient(limit).norm(), least.cwiseQuotient(limit).norm() * (1 + 1e-12));
    ASSERT_LE(least.norm(), t.norm() * (1 + 1e-12));
  }
  EXPECT_GT(shown, 350);
}

// Whatever unit the slide has, metres or millimetres.
TEST(torque_units, do_not_depend_on_the_units_of_a_brake) {
  ph::testing::random_source random(3);
  for (int k = 0; k < 500; ++k) {
    const ph::matrix<double, 2, 3> G =
        ph::matrix<double, 2, 3>::NullaryExpr([&] { return random.normal<double>(); });
    const three limit(random.positive(0.1, 10.0), random.positive(0.1, 10.0), random.positive(0.1, 10.0)),
        milli(1, 1e-3, 1e3);
    const three s(1, -1, random.coin() ? 1 : 0);
    const pair_of_coordinates n = random.direction<double, 2>();
    const auto F = ph::approximate_by_generators(G, s, n, 0.02, ph::torque_units(limit));
    const three limit_in_milli = limit.cwiseQuotient(milli);
    const ph::matrix<double, 2, 3> in_milli = G * milli.asDiagonal();
    const auto same = ph::approximate_by_generators(in_milli, s, n, 0.02, ph::torque_units(limit_in_milli));
    ASSERT_EQ(F.display, same.display);
    ASSERT_LE((same.torque.cwiseProduct(milli) - F.torque).cwiseQuotient(limit).norm(),
              1e-11 * F.torque.cwiseQuotient(limit).norm());
  }
}

TEST(torque_units, of_limits_that_are_0_or_infinite) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(ph::torque_units(three(0.3, 0.3, 0.3)), three(1, 1, 1));
  EXPECT_EQ(ph::torque_units(three(1, 4, 2)), three(0.25, 1, 0.5));
  EXPECT_EQ(ph::torque_units(three(0, 4, 2)), three(0, 1, 0.5)) << "a limit of 0 is a brake that is off";
  EXPECT_EQ(ph::torque_units(three(0, 0, 0)), three(0, 0, 0));
  EXPECT_EQ(ph::torque_units(three(1, inf, 0)), three(1, 1, 0)) << "one without a limit: the least |t|";
  const auto units = ph::form_of<polar_arm>::units(three(1, 1, 1), ph::unlimited_brakes());
  static_assert(std::is_same_v<decltype(units), const ph::equal_units>);

  const polar_arm arm;
  ph::testing::random_source random(5);
  int shown = 0;
  for (int k = 0; k < 200; ++k) {
    const auto state = random_polar_state(random);
    const ph::point<2> n = random.direction<double, 2>();
    ph::switchable_brakes<polar_arm> off = polar_brakes({0.5, 20, 5});
    off.switch_off(2);
    const three t = torques_for(arm, polar_brakes({0.5, 20, 0}), state, n),
                same = torques_for(arm, off, state, n);
    ASSERT_EQ(t, same) << "a limit of 0 is a brake that is off";
    ASSERT_EQ(t[2], 0.0);
    shown += t.isZero(0) ? 0 : 1;
    ASSERT_TRUE(torques_for(arm, polar_brakes({0, 0, 0}), state, n).isZero(0));
  }
  EXPECT_GT(shown, 50);
}

// The force is the nearest one, whatever the limits, which only choose between the torques that make it.
TEST(torque_units, of_limits_of_any_ratio_lose_no_brake) {
  const three wide(7e162, 1.7e-312, 9e271);
  EXPECT_EQ(ph::torque_units(wide), three(1e-8, 1e-8, 1));
  ph::testing::random_source random(6);
  int shown = 0;
  for (int k = 0; k < 300; ++k) {
    const ph::matrix<double, 2, 3> G =
        ph::matrix<double, 2, 3>::NullaryExpr([&] { return random.normal<double>(); });
    const three s(1, -1, random.coin() ? 1 : 0);
    const pair_of_coordinates n = random.direction<double, 2>();
    const auto expected = ph::approximate_by_generators(G, s, n, 0.02);
    const auto F = ph::approximate_by_generators(G, s, n, 0.02, ph::torque_units(wide));
    ASSERT_EQ(F.display, expected.display);
    ASSERT_LE((F.force - expected.force).norm(), 1e-13 * expected.force.norm());
    ASSERT_LE((G * F.torque - F.force).norm(), 1e-12 * (G.norm() * F.torque.norm() + 1));
    ASSERT_TRUE((s.array() * F.torque.array() <= 0).all());
    shown += ph::is_displayed(F.display);
  }
  EXPECT_GT(shown, 150);
}

// A one-way brake counts with what it can make in its way.
TEST(torque_units, of_an_interval_are_those_of_the_way_in_which_a_brake_can_push) {
  ph::switchable_brakes<polar_arm> brakes = polar_brakes({4, 4, 4});
  brakes.torque_lower = {-1, -2, 0};
  brakes.torque_upper = {2, 4, 4};
  EXPECT_EQ(ph::form_of<polar_arm>::units(three(1, 1, 1), brakes), three(0.5, 1, 0));
  EXPECT_EQ(ph::form_of<polar_arm>::units(three(-1, -1, -1), brakes), three(0.5, 1, 1));
  EXPECT_EQ(ph::form_of<polar_arm>::units(three(0, 0, -1), brakes), three(0.5, 1, 1));
}

// Of three brakes at rest any t with G t = F will do: t = u y, y = (G u)^+ F.
three min_share(const ph::matrix<double, 2, 3>& G, const three& limit, const pair_of_coordinates& F) {
  const ph::matrix<double, 2, 3> V = G * limit.asDiagonal();
  return limit.cwiseProduct(three(ph::orthogonal_decomposition<double, 2, 3>(V, 1e-14).pseudo_inverse() * F));
}

TEST(torque_units, hold_at_several_walls_and_under_effects) {
  const polar_arm arm;
  const three limit(0.5, 20, 5), none = three::Zero();
  ph::testing::random_source random(6);
  for (int k = 0; k < 200; ++k) {
    const auto G = ph::force_generators(arm, random_polar_state(random).q);
    const ph::force_map<double, 2, 3> map{G};
    const auto box = ph::torques_within<double, 3>(none, limit);
    const auto u = ph::torque_units(limit);
    const pair_of_coordinates F = 0.2 * random.direction<double, 2>();
    const three expected = min_share(G, limit, F);
    ASSERT_LT(expected.cwiseQuotient(limit).cwiseAbs().maxCoeff(), 1.0);
    const auto x = F[0] < 0 ? pair_of_coordinates(-1, 0) : pair_of_coordinates(1, 0),
               y = F[1] < 0 ? pair_of_coordinates(0, -1) : pair_of_coordinates(0, 1);
    const auto walls = ph::contact_forces<double, 2, 3, 2>(
        map, box, {{{x, std::abs(F[0]), true}, {y, std::abs(F[1]), false}}}, 2, G, u);
    ASSERT_LE((walls.torque - expected).cwiseQuotient(limit).norm(), 1e-12);

    const ph::effect_demand<double, 2, 3, 2> wanted{F, ph::matrix<double, 2, 3>::Zero(), {0, 0}};
    const ph::matrix<double, 1, 2> no_wall = ph::matrix<double, 1, 2>::Zero();
    const three beside = ph::torques_beside(map, box, none, no_wall, wanted, u);
    ASSERT_LE((beside - expected).cwiseQuotient(limit).norm(), 1e-12);
    const three plain = ph::torques_beside(map, box, none, no_wall, wanted);
    ASSERT_LE((plain - min_share(G, {1, 1, 1}, F)).norm(), 1e-12) << "without units the least |t|";
  }
}

}  // namespace
