// slow
// Effects in a control cycle: walls first, then the effects with what the brakes can do besides.
#include "../../property/custom_mechanisms.hpp"
#include "../support.hpp"

#include <passive_haptics/control/pipelines/with_effects.hpp>
#include <passive_haptics/force/effects/end_stops.hpp>
#include <passive_haptics/force/effects/guide.hpp>
#include <passive_haptics/force/effects/rough_walls.hpp>
#include <passive_haptics/force/effects/viscous_field.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace {

using ph::testing::random_source;
constexpr unsigned seed = 20040628;

using pair = ph::vector<double, 2>;

ph::viscous_field<double, 2> honey(double viscosity) {
  return ph::viscous_field<double, 2>({.viscosity = viscosity * ph::matrix<double, 2, 2>::Identity()});
}

// A redundant device: three tendons on two joints.
struct three_tendons : custom::sizes<double, 2, 2> {
  static constexpr int brake_count = 3;
  pair position(const pair& q) const { return {q[0] - q[1] / 4, q[1]}; }
  ph::matrix<double, 2, 2> jacobian() const { return ph::matrix_of<2, 2>(1.0, -0.25, 0.0, 1.0); }
  ph::matrix<double, 3, 2> transmission() const {
    return ph::matrix_of<3, 2>(1.0, 0.2, -0.4, 1.0, -1.0, -0.7);
  }
};

// A cycle at a random state in contact with random walls, with effects and without.
template <class M>
struct random_cycle {
  M mechanism;
  ph::brakes_of<M> brakes;
  ph::device_state<M> state;
  ph::contacts<2, 2> touched;

  random_cycle(random_source& random, int walls, bool limited) {
    brakes.rate_dead_band.setConstant(1e-9);  // all slip
    brakes.torque_limit.setConstant(limited ? random.positive(0.1, 3.0) : 1e6);
    state.time = 0;
    for (int i = 0; i < M::dof; ++i) {
      state.q[i] = random.uniform(0.3, 2.0);
      state.qd[i] = random.wide(0.01, 3.0);
    }
    state.hand_force = random.positive(0.1, 10.0) * random.direction<double, 2>();
    for (int j = 0; j < walls; ++j) {
      auto c = asking_for<2>(random.positive(0.1, 100.0) * random.direction<double, 2>());
      c.wall_number = 4 + j;
      touched.push_back(c);
    }
  }

  template <class Walls>
  auto step(const Walls& walls) const {
    ph::step_memory<ph::direct_control> memory;
    return ph::step(mechanism, brakes, walls, ph::direct_control(), state, memory);
  }
  template <class... Effects>
  auto with(const Effects&... effects) const {
    return step(ph::with_effects(touched, effects...));
  }
  pair velocity() const { return ph::velocity(mechanism, state.q, state.qd); }
  auto map() const { return ph::force_map_of(mechanism, state.q).G; }
};

// The force of a result's torques; where a self-motion settles, that by the brakes which do not come to rest.
template <class Cycle, class Result>
auto force_of(const Cycle& cycle, const Result& result) {
  using M = decltype(cycle.mechanism);
  if constexpr (ph::Settles<M>) {
    ph::brake_set held = 0;
    for (int i = 0; i < M::brake_count; ++i) held |= result.settled_signs[i] == 0 ? 1u << i : 0u;
    typename ph::settled_rates<M>::rate_map W;
    if (!ph::settled_rates<M>({cycle.mechanism, cycle.state.q}).find(held, W)) W.setZero();
    return pair(-W.transpose() * result.settled_signs.cwiseProduct(result.capacity));
  } else {
    return pair(cycle.map() * result.torque);
  }
}

// check(cycle, random) with from `first` to `last` walls.
template <class M, class Check>
void for_random_cycles(int first, int last, Check&& check) {
  random_source random(seed);
  for (int k = 0; k < 300; ++k) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", trial " + std::to_string(k));
    check(random_cycle<M>(random, first + k / 2 % (last - first + 1), k % 2 == 1), random);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

// Square, with self-motion, with more brakes than joints. (The property suite of effects has devices in
// space.)
template <class T>
struct effects_in_a_cycle : ::testing::Test {};
using mechanisms = ::testing::Types<ph::tendon_two_link<double>, custom::planar_arm<double>, three_tendons>;
TYPED_TEST_SUITE(effects_in_a_cycle, mechanisms);

// Never more than brakes can: s_i t_i <= 0 and the limits exactly, so that the power is never positive.
TYPED_TEST(effects_in_a_cycle, only_resist) {
  using M = TypeParam;
  for_random_cycles<M>(0, 2, [](const auto& cycle, random_source& random) {
    const ph::guide<double, 2> rail({.direction = random.direction<double, 2>(), .stiffness = 300});
    const ph::rough_walls<double, 2> rough({.coefficient = 0.4});
    const ph::joint_vector<M> ones = ph::joint_vector<M>::Ones();
    const ph::end_stops<double, M::dof> stops({.upper = ones, .stiffness = 5 * ones});
    const auto result = cycle.with(honey(5), rail, rough, stops);
    ASSERT_EQ(result.outcome, ph::status::ok);
    const auto w = ph::brake_rates(cycle.mechanism, cycle.state.q, cycle.state.qd);
    for (int i = 0; i < M::brake_count; ++i) {
      ASSERT_LE(result.signs[i] * result.torque[i], 0);
      ASSERT_LE(result.torque[i] * w[i], 0);
      ASSERT_LE(result.capacity[i], cycle.brakes.torque_limit[i]);
      ASSERT_EQ(result.capacity[i], std::abs(result.torque[i]));
    }
    const bool any = (result.capacity.array() >= cycle.brakes.torque_limit.array()).any();
    EXPECT_TRUE(result.saturated || !any);
  });
}

// What the walls display and what is told of them is as without effects, left or not, at a limit or not.
TYPED_TEST(effects_in_a_cycle, leave_walls_their_normal_forces) {
  using M = TypeParam;
  int left = 0, kept = 0, changed = 0;
  for_random_cycles<M>(1, 2, [&](const auto& cycle, random_source&) {
    const auto without = cycle.step(cycle.touched);
    const auto result = cycle.with(honey(20));
    ASSERT_EQ(result.outcome, without.outcome);
    if (ph::Settles<M> && !ph::is_displayed(without.display)) return;  // no signs are known
    const pair before = force_of(cycle, without), now = force_of(cycle, result);
    const double size = 1 + cycle.map().norm() * (without.torque.norm() + result.torque.norm());
    for (const auto& c : cycle.touched) {
      EXPECT_NEAR(c.normal.dot(now), c.normal.dot(before), 2e-13 * size);
      left += c.normal.dot(cycle.velocity()) > 0;
      kept += c.normal.dot(before) > 0;
    }
    changed += (now - before).norm() > 1e-3 * before.norm();
    EXPECT_EQ(result.wall_number, without.wall_number);
    EXPECT_EQ(result.alpha, without.alpha);
    EXPECT_EQ(result.power, without.power);
    EXPECT_EQ(result.display, without.display);
    EXPECT_EQ(result.desired_force, without.desired_force);
    EXPECT_EQ(result.control_force, without.control_force);
  });
  EXPECT_GT(left, 100);
  EXPECT_GT(kept, 20);
  EXPECT_GT(changed, 20);
}

// In free space they are displayed as nearly as the brakes can.
TYPED_TEST(effects_in_a_cycle, in_free_space_are_the_nearest_force) {
  using M = TypeParam;
  if constexpr (M::dof == M::task_dimension) {
    int exact = 0;
    for_random_cycles<M>(0, 0, [&](const auto& cycle, random_source&) {
      const auto result = cycle.with(honey(5));
      const auto G = cycle.map();
      const pair wanted = -5 * cycle.velocity();
      expect_near(result.effect_force, wanted, wanted.norm());
      const auto box = ph::torques_within(result.signs, cycle.brakes.torque_limit);
      const auto nearest = ph::nearest_torque(G, box, result.effect_force);
      expect_near(pair(G * result.torque), nearest.force, G.norm() * wanted.norm(), 1e3);
      expect_near(result.torque, nearest.torque, G.norm() * wanted.norm(), 1e3);
      exact += (nearest.force - wanted).norm() <= 2e-5 * wanted.norm();
      EXPECT_EQ(result.wall_number, -1);
      EXPECT_EQ(result.power, ph::power_class::none);
      EXPECT_EQ(result.display, ph::display_class::exact);
      EXPECT_TRUE(result.desired_force.isZero(0));
    });
    EXPECT_GT(exact, 10);
  }
}

// As effects fade, the torques become those without any: beside one wall, where drag is least by itself.
TYPED_TEST(effects_in_a_cycle, fade_into_none) {
  for_random_cycles<TypeParam>(1, 1, [&](const auto& cycle, random_source&) {
    const auto without = cycle.step(cycle.touched).torque;
    const double size = 1 + without.norm(), loss = 2e-13 * (1 + cycle.map().norm());
    EXPECT_LE((cycle.with(honey(1e-9)).torque - without).norm(), 1e-6 * size + loss * size * size);
    EXPECT_EQ(cycle.with(honey(0)).torque, without);
  });
}

// Neighbouring viscosities have neighbouring torques, through every change of what is at a bound.
TYPED_TEST(effects_in_a_cycle, are_continuous_in_what_they_want) {
  random_source random(seed);
  for (int k = 0; k < 10; ++k) {
    const random_cycle<TypeParam> cycle(random, 1, true);
    const double steepest = 1 / std::max(1e-3, cycle.map().col(0).norm());
    auto before = cycle.step(cycle.touched).torque;
    for (int step = 1; step <= 200; ++step) {
      const auto now = cycle.with(honey(0.1 * step)).torque;
      ASSERT_LE((now - before).norm(), 0.5 * cycle.velocity().norm() * (1 + steepest))
          << "seed " << seed << ", trial " << k << ", step " << step;
      before = now;
    }
  }
}

}  // namespace
