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

template <class M>
using honey_of = ph::viscous_field<typename M::scalar, M::task_dimension>;

template <class M>
honey_of<M> honey(double viscosity) {
  using T = typename M::scalar;
  return honey_of<M>({.viscosity = T(viscosity) * ph::task_vector<M>::Ones().asDiagonal().toDenseMatrix()});
}

// A redundant device: three tendons on two joints.
template <class T>
struct three_tendons : custom::sizes<T, 2, 2> {
  static constexpr int brake_count = 3;
  ph::vector<T, 2> position(const ph::vector<T, 2>& q) const { return {q[0] - q[1] / 4, q[1]}; }
  ph::matrix<T, 2, 2> jacobian() const { return ph::matrix_of<2, 2>(T(1), T(-0.25), T(0), T(1)); }
  ph::matrix<T, 3, 2> transmission() const {
    return ph::matrix_of<3, 2>(T(1), T(0.2), T(-0.4), T(1), T(-1), T(-0.7));
  }
};

// A cycle at a random state in contact with random walls, with effects and without.
template <class M>
struct random_cycle {
  static constexpr int d = M::task_dimension;
  using T = typename M::scalar;

  M mechanism;
  ph::brakes_of<M> brakes;
  ph::device_state<M> state;
  ph::contacts<d, 2> touched;

  random_cycle(random_source& random, int walls, bool limited) {
    brakes.rate_dead_band.setConstant(T(1e-9));  // all slip
    brakes.torque_limit.setConstant(limited ? random.positive(T(0.1), T(3)) : T(1e6));
    state.time = 0;
    for (int i = 0; i < M::dof; ++i) {
      state.q[i] = random.uniform(T(0.3), T(2));
      state.qd[i] = random.wide(T(0.01), T(3));
    }
    state.hand_force = random.positive(T(0.1), T(10)) * random.direction<T, d>();
    for (int j = 0; j < walls; ++j) {
      ph::contact<d> c = asking_for<d>(random.positive(0.1, 100.0) * random.direction<double, d>());
      c.wall_number = 4 + j;
      touched.push_back(c);
    }
  }

  auto alone() const { return step(touched); }
  template <class... Effects>
  auto with(const Effects&... effects) const {
    return step(ph::with_effects(touched, effects...));
  }

  // F = G t of the torques that are commanded; all brakes slip.
  auto map() const {
    if constexpr (M::brake_count != M::dof) {
      return ph::force_generators(mechanism, state.q);
    } else {
      const auto E = ph::brake_jacobian(mechanism, state.q);
      return ph::invert_brake_jacobian(ph::matrix<T, d, M::brake_count>(E)).G;
    }
  }

 private:
  template <class Walls>
  auto step(const Walls& walls) const {
    ph::step_memory<ph::direct_control> memory;
    return ph::step(mechanism, brakes, walls, ph::direct_control(), state, memory);
  }
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
    return ph::task_vector<M>(-W.transpose() * result.settled_signs.cwiseProduct(result.capacity));
  } else {
    return ph::task_vector<M>(cycle.map() * result.torque);
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

// Square in the plane and in space, with self-motion, with more brakes than joints.
template <class T>
struct effects_in_a_cycle : ::testing::Test {};
using mechanisms = ::testing::Types<ph::tendon_two_link<double>, custom::spatial_arm<double>,
                                    custom::planar_arm<double>, three_tendons<double>>;
TYPED_TEST_SUITE(effects_in_a_cycle, mechanisms);

// Never more than brakes can: s_i t_i <= 0 and the limits exactly, so that the power is never positive.
TYPED_TEST(effects_in_a_cycle, only_resist) {
  using M = TypeParam;
  using T = typename M::scalar;
  for_random_cycles<M>(0, 2, [](const auto& cycle, random_source& random) {
    constexpr int d = M::task_dimension;
    const ph::guide<T, d> rail({.direction = random.direction<T, d>(), .stiffness = T(300)});
    const ph::rough_walls<T, d> rough({.coefficient = T(0.4)});
    const ph::end_stops<T, M::dof> stops(
        {.upper = ph::vector<T, M::dof>::Constant(T(1)), .stiffness = ph::vector<T, M::dof>::Constant(T(5))});
    const auto result = cycle.with(honey<M>(5), rail, rough, stops);
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
  using T = typename M::scalar;
  int left = 0, kept = 0, changed = 0;
  for_random_cycles<M>(1, 2, [&](const auto& cycle, random_source&) {
    const auto without = cycle.alone();
    const auto result = cycle.with(honey<M>(20));
    ASSERT_EQ(result.outcome, without.outcome);
    if (ph::Settles<M> && !ph::is_displayed(without.display)) return;  // no signs are known
    const ph::task_vector<M> before = force_of(cycle, without), now = force_of(cycle, result);
    const double size =
        static_cast<double>(1 + cycle.map().norm() * (without.torque.norm() + result.torque.norm()));
    for (const auto& c : cycle.touched) {
      const ph::task_vector<M> n = ph::as<T>(c.normal);
      EXPECT_NEAR(n.dot(now), n.dot(before), 1e3 * std::numeric_limits<T>::epsilon() * size);
      left += n.dot(ph::task_vector<M>(ph::jacobian(cycle.mechanism, cycle.state.q) * cycle.state.qd)) > 0;
      kept += n.dot(before) > 0;
    }
    changed += (now - before).norm() > T(1e-3) * before.norm();
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

// Alone they are displayed as nearly as the brakes can; no law is asked.
TYPED_TEST(effects_in_a_cycle, alone_are_the_nearest_force) {
  using M = TypeParam;
  using T = typename M::scalar;
  if constexpr (M::dof == M::task_dimension) {
    int exact = 0;
    for_random_cycles<M>(0, 0, [&](const auto& cycle, random_source&) {
      const auto result = cycle.with(honey<M>(5));
      const auto G = cycle.map();
      const ph::task_vector<M> v = ph::jacobian(cycle.mechanism, cycle.state.q) * cycle.state.qd;
      expect_near(result.effect_force, ph::task_vector<M>(T(-5) * v), static_cast<double>(5 * v.norm()));
      const auto box = ph::torques_within(result.signs, cycle.brakes.torque_limit);
      const auto nearest = ph::nearest_torque(G, box, result.effect_force);
      expect_near(ph::task_vector<M>(G * result.torque), nearest.force,
                  static_cast<double>(G.norm() * result.effect_force.norm()), 1e3);
      expect_near(result.torque, nearest.torque, static_cast<double>(G.norm() * result.effect_force.norm()),
                  1e3);
      exact += (nearest.force - result.effect_force).norm() <= T(1e-4) * v.norm();
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
  using M = TypeParam;
  using T = typename M::scalar;
  for_random_cycles<M>(1, 1, [&](const auto& cycle, random_source&) {
    const auto without = cycle.alone();
    const double size = static_cast<double>(1 + without.torque.norm());
    const double loss = 1e3 * std::numeric_limits<T>::epsilon() * static_cast<double>(1 + cycle.map().norm());
    const double faint = static_cast<double>((cycle.with(honey<M>(1e-9)).torque - without.torque).norm());
    EXPECT_LE(faint, 1e-6 * size + loss * size * size);
    EXPECT_EQ(cycle.with(honey<M>(0)).torque, without.torque);
  });
}

// Neighbouring viscosities have neighbouring torques, through every change of what is at a bound.
TYPED_TEST(effects_in_a_cycle, are_continuous_in_what_they_want) {
  using M = TypeParam;
  random_source random(seed);
  for (int k = 0; k < 10; ++k) {
    const random_cycle<M> cycle(random, 1, true);
    const double v = ph::task_vector<M>(ph::jacobian(cycle.mechanism, cycle.state.q) * cycle.state.qd).norm();
    const double steepest = 1 / std::max(1e-3, cycle.map().col(0).norm());
    ph::brake_vector<M> before = cycle.alone().torque;
    for (int step = 1; step <= 200; ++step) {
      const ph::brake_vector<M> now = cycle.with(honey<M>(0.1 * step)).torque;
      ASSERT_LE((now - before).norm(), 0.1 * v * 5 * (1 + steepest))
          << "seed " << seed << ", trial " << k << ", step " << step;
      before = now;
    }
  }
}

}  // namespace
