// Controllers taken through every way of a cycle, which allocates nothing.
#pragma once

#include "allocations.hpp"

#include <passive_haptics/passive_haptics.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

namespace {

namespace ph = passive_haptics;

// The ways a cycle can take, by their diagnostics.
struct ways {
  bool free = false, fault = false, exact = false, approximate = false, none = false, saturated = false,
       held = false;
};

template <class M, class Law, class Scene, class State>
void run(const M& mechanism, Scene scene, Law law, ways& seen) {
  using T = typename M::scalar;
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(T(0.5));
  ph::controller control(mechanism, brakes, std::move(scene), law);
  State state;
  for (int k = 0; k < 3000; ++k) {
    state.time = k * 1e-3;
    for (int i = 0; i < M::dof; ++i) {
      state.q[i] = static_cast<T>(std::sin(0.01 * k * (i + 1)));
      state.qd[i] = k % 7 == 0 ? T(0) : static_cast<T>(std::cos(0.37 * k + i));
    }
    if constexpr (requires { state.hand_force; })
      state.hand_force.setConstant(static_cast<T>(std::sin(0.11 * k)));
    if (k % 100 == 99) state.q[0] = std::numeric_limits<T>::quiet_NaN();
    ph::step_result<M> result;
    ASSERT_EQ(allocations_in([&] { result = control(state); }), 0) << "cycle " << k;
    const bool touches = result.outcome == ph::status::ok && result.wall_number >= 0;
    seen.fault |= result.outcome != ph::status::ok;
    seen.free |= result.outcome == ph::status::ok && result.wall_number < 0;
    seen.exact |= touches && result.display == ph::display_class::exact;
    seen.approximate |= touches && result.display == ph::display_class::approximate;
    seen.none |= touches && result.display == ph::display_class::none;
    seen.saturated |= result.saturated;
  }
}

// Between a plane and a round room of this size [m].
template <class M>
void run_all(const M& mechanism, double size) {
  constexpr int d = M::task_dimension;
  ph::point<d> low = ph::point<d>::Zero(), up = ph::point<d>::UnitX();
  low[0] = size / 3;
  const auto walls = ph::scene(ph::wall(ph::half_space<d>(low, up), 1e3),
                               ph::wall(ph::ball<d>(low, size, ph::filling::hollow), 2e3));
  const ph::held_scene held(walls, 0.01);
  ways seen;
  run<M, ph::direct_control, decltype(walls), ph::device_state<M>>(mechanism, walls, {}, seen);
  run<M, ph::direct_control, decltype(held), ph::device_state<M>>(mechanism, held, {}, seen);
  run<M, ph::no_direct_control, decltype(walls), ph::sensorless_device_state<M>>(mechanism, walls, {}, seen);
  EXPECT_TRUE(seen.free && seen.fault && seen.saturated);
  EXPECT_TRUE(seen.exact && seen.approximate && seen.none);
}

}  // namespace
