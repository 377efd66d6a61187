// Each effect without a force sensor, alone and on a wall: it holds a hand that pushes, and lets it back out.
#pragma once

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/pipelines/with_effects.hpp>
#include <passive_haptics/control/sensorless/sensorless_controller.hpp>
#include <passive_haptics/force/effects/detents.hpp>
#include <passive_haptics/force/effects/end_stops.hpp>
#include <passive_haptics/force/effects/guide.hpp>
#include <passive_haptics/force/effects/rough_walls.hpp>
#include <passive_haptics/force/effects/viscous_field.hpp>
#include <passive_haptics/plant/simulated_device.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace {

namespace ph = passive_haptics;

// A hand at x that pushes along u, out of each effect, and presses on a wall with the normal n [N].
template <class M>
struct pushing_hand {
  ph::joint_vector<M> q;
  ph::task_vector<M> x, u, n;
  double push, press, hold;  // [N], [N], [s]
};

template <class M>
ph::end_stops<double, M::dof> stops_around(const M& device, const pushing_hand<M>& h) {
  const ph::matrix<double, M::task_dimension, M::dof> J = ph::jacobian(device, h.q);
  const ph::joint_vector<M> out = J.transpose() * h.u;
  ph::end_stops_parameters<double, M::dof> p;
  for (int i = 0; i < M::dof; ++i) {
    (out[i] > 0 ? p.upper[i] : p.lower[i]) = h.q[i];
    p.stiffness[i] = 2000 * J.col(i).squaredNorm();
  }
  return ph::end_stops<double, M::dof>(p);
}

// A force, friction of the wall and end stops, of which a test sets one: a single type, so that the loop is
// compiled once.
template <class M>
struct one_effect {
  using scalar = double;
  static constexpr int dimension = M::task_dimension;
  using V = ph::task_vector<M>;

  std::function<V(const V&, const V&, const V&)> of = [](auto&&...) -> V { return V::Zero(); };
  ph::rough_walls<double, dimension> rough{{.coefficient = 0}};
  ph::end_stops<double, M::dof> stops{{}};
  enum { anywhere, on_walls, on_joints } acts = anywhere;
  double fastest = 1.5;  // creep [mm/s]

  V force(const V& x, const V& v, const V& hand_force) const { return of(x, v, hand_force); }
};

template <class M, class E>
one_effect<M> of_force(const E& effect, double fastest = 1.5) {
  one_effect<M> one;
  one.of = [effect](const auto&... now) { return effect.force(now...); };
  one.fastest = fastest;
  return one;
}

// The effects of the library, each with as much as holds the push or slows it down to 0.1 m/s; in space two.
template <class M>
std::vector<one_effect<M>> effects_for(const M& device, const pushing_hand<M>& h) {
  constexpr int d = M::task_dimension;
  using guide = ph::guide<double, d>;
  one_effect<M> rough, stopped;
  rough.acts = one_effect<M>::on_walls;
  rough.rough = ph::rough_walls<double, d>({.coefficient = 1.5 * h.push / h.press});
  std::vector<one_effect<M>> all{
      of_force<M>(
          guide({.along = ph::guide_along::plane, .point = h.x, .direction = h.u, .stiffness = 2000})),
      rough};
  if (d == 3) return all;
  stopped.stops = stops_around(device, h);
  stopped.acts = one_effect<M>::on_joints;
  all.push_back(stopped);
  all.push_back(
      of_force<M>(ph::detents<double, d>({.origin = h.x, .direction = h.u, .spacing = 0.02, .strength = 6})));
  all.push_back(of_force<M>(guide({.point = h.x, .direction = h.n, .stiffness = 2000})));
  all.push_back(of_force<M>(
      ph::viscous_field<double, d>({.viscosity = 10 * h.push * ph::identity_matrix<double, d>()}), 110));
  return all;
}

struct hold_and_release {
  double creep = 0;  // while it is pushed [mm/s]
  double back = -1;  // from the reversal until it has moved back by 1 mm, or out of the wall [s]; -1: never
};

// Pushes out of the effect for the time, then pulls back with as much: off the wall if there is one.
template <class M, class Scene>
hold_and_release hold_and_pull_back(const M& device, const pushing_hand<M>& h, const Scene& scene,
                                    bool on_wall) {
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(3);
  ph::sensorless_controller control(device, brakes, scene, ph::direct_control());
  ph::simulated_device<M> plant(device, brakes, 0.3, h.q);
  const int reversal = static_cast<int>(1000 * h.hold), settled = reversal / 2;
  double from = 0, at = 0;
  hold_and_release found;
  for (int k = 0; k < reversal + 1500; ++k) {
    const double s = h.u.dot(plant.position() - h.x), height = h.n.dot(plant.position() - h.x);
    if (k == settled) from = s;
    if (k == reversal) at = s, found.creep = 1e6 * (at - from) / (reversal - settled);
    if (k > reversal && (on_wall ? height > 0 : s < at - 1e-3)) {
      found.back = 1e-3 * (k - reversal);
      break;
    }
    const auto told = control(ph::sensorless_device_state<M>{1e-3 * k, plant.q(), plant.qd()});
    EXPECT_EQ(told.outcome, ph::status::ok);
    const ph::task_vector<M> out = on_wall ? h.n : ph::task_vector<M>(-h.u);
    const ph::task_vector<M> force = k < reversal
                                         ? ph::task_vector<M>(h.push * h.u - (on_wall ? h.press : 0) * h.n)
                                         : ph::task_vector<M>(h.push * out);
    for (int i = 0; i < 10; ++i)
      plant.advance(1e-4, told.capacity, ph::task_vector<M>(force - 5 * plant.velocity()));
  }
  return found;
}

template <class Case>
struct effects_without_a_sensor : ::testing::Test {};
TYPED_TEST_SUITE_P(effects_without_a_sensor);

// Within max_release_time, and the time to fall out of the wall. Off a wall the hand does not push along.
TYPED_TEST_P(effects_without_a_sensor, hold_a_push_and_let_the_hand_back) {
  using M = typename TypeParam::mechanism;
  constexpr int d = M::task_dimension;
  const M device = TypeParam::make();
  const double stated = ph::max_release_time(ph::release_probe_parameters());
  int hands = 0;
  for (unsigned seed = 1; hands < 5; ++seed) {
    ph::testing::random_source random(seed);
    const ph::joint_vector<M> q = random.between<double, M::dof>(TypeParam::lower(), TypeParam::upper());
    const ph::matrix<double, d, d> J = ph::jacobian(device, q);
    const double size = J.norm() / std::sqrt(d);
    if (std::abs(J.determinant()) < 0.5 * std::pow(size, d)) continue;  // badly conditioned: it creeps
    ++hands;
    const auto axes = random.orthogonal_directions<d>();
    const pushing_hand<M> h{q,
                            device.position(q),
                            axes.col(0),
                            axes.col(1),
                            random.uniform(1.0, 3.0),
                            random.uniform(1.0, 3.0),
                            random.uniform(0.8, 1.6)};
    int number = 0;
    for (const auto& effect : effects_for(device, h)) {
      SCOPED_TRACE(::testing::Message() << "seed " << seed << ", effect " << number++);
      for (const bool on_wall : {false, true}) {
        if (effect.acts == effect.on_walls && !on_wall) continue;
        const ph::point<d> surface = on_wall ? h.x : ph::point<d>(h.x - h.n);
        const auto scene = ph::with_effects(ph::scene(ph::wall(ph::half_space<d>(surface, h.n), 1e4)), effect,
                                            effect.rough, effect.stops);
        const auto found = hold_and_pull_back(device, h, scene, on_wall);
        EXPECT_LE(found.creep, effect.fastest);
        if (effect.acts == effect.on_joints && on_wall)
          continue;  // the way off the wall may be one into the stop
        EXPECT_GE(found.back, 0) << "locked";
        EXPECT_LE(found.back, on_wall ? stated + 0.1 : stated);
      }
    }
  }
}

REGISTER_TYPED_TEST_SUITE_P(effects_without_a_sensor, hold_a_push_and_let_the_hand_back);

}  // namespace
