// Brakes that are off or work one way, at random, and the torques that they can make.
#pragma once

#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/control/step_result.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ph = passive_haptics;

template <class M>
ph::switchable_brakes<M> random_brakes(ph::testing::random_source& random) {
  ph::switchable_brakes<M> brakes;
  for (int i = 0; i < M::brake_count; ++i) {
    brakes.torque_limit[i] = random.positive(0.1, 10.0);
    switch (static_cast<int>(random.uniform(0.0, 6.0))) {
      case 0: brakes.switch_off(i); break;
      case 1: brakes.make_positive(i); break;
      case 2: brakes.make_negative(i); break;
      case 3: brakes.torque_limit[i] = 0; break;
      default: brakes.switch_on(i);
    }
  }
  return brakes;
}

// The rates w of a result's brakes decide which torques are possible, unless a self-motion settles.
template <class M>
void expect_within_intervals(const ph::switchable_brakes<M>& brakes, const ph::step_result<M>& result,
                             const ph::brake_vector<M>& w) {
  ph::brake_vector<M> signs_of_cone = result.signs;
  if constexpr (ph::Settles<M>) signs_of_cone = result.settled_signs;
  for (int i = 0; i < M::brake_count; ++i) {
    SCOPED_TRACE(::testing::Message() << "brake " << i);
    const double lower = std::max(-brakes.torque_limit[i], brakes.torque_lower[i]),
                 upper = std::min(brakes.torque_limit[i], brakes.torque_upper[i]);
    ASSERT_LE(result.signs[i] * result.torque[i], 0.0);
    ASSERT_LE(signs_of_cone[i] * result.cone_coefficients[i], 0.0);
    ASSERT_GE(result.torque[i], lower);
    ASSERT_LE(result.torque[i], upper);
    ASSERT_TRUE(lower < 0 || result.cone_coefficients[i] >= 0);
    ASSERT_TRUE(upper > 0 || result.cone_coefficients[i] <= 0);
    const bool slips = std::abs(w[i]) > brakes.rate_dead_band[i] && !ph::Settles<M>;
    ASSERT_LE(result.capacity[i], !slips ? std::max(-lower, upper) : w[i] > 0 ? -lower : upper);
    ASSERT_TRUE(!slips || result.torque[i] * w[i] <= 0);
  }
}
