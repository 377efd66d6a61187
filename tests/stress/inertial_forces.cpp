// Inertial forces at the edge of what can be displayed: desired forces whose cos(gamma) falls to rounding.
#include "broken_law.hpp"
#include "devices.hpp"

#include <passive_haptics/control/direct_control.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace stress {

template <class Chain>
struct inertial_forces : ::testing::Test {};
using inertial_arms =
    ::testing::Types<chains::irregular_chain<double, 4, 2>, chains::irregular_chain<double, 4, 3>,
                     chains::irregular_chain<float, 4, 3>, chains::irregular_chain<float, 7, 3>>;
TYPED_TEST_SUITE(inertial_forces, inertial_arms);

TYPED_TEST(inertial_forces, are_in_the_cone_at_any_angle) {
  using M = ph::inertial_mechanism<typename TypeParam::mechanism>;
  using T = typename M::scalar;
  constexpr int d = M::task_dimension, states = 2000, halvings = 40;
  constexpr unsigned seed = 7;
  const M arm(TypeParam::make());
  ph::brakes_of<M> brakes;
  brakes.rate_dead_band.setZero();
  ph::step_options<T> options;
  options.min_cosine = T(0);
  ph::testing::random_source random(seed);
  T least_cosine = T(1);
  for (int k = 0; k < states; ++k) {
    ph::device_state<M> state;
    state.time = 0;
    state.q = random.template between<T, M::dof>(TypeParam::lower(), TypeParam::upper());
    for (T& rate : state.qd) rate = random.uniform(T(-1), T(1));
    state.hand_force = T(5) * random.template direction<T, d>();
    const auto pressed_along = [&](const ph::point<d>& n) {
      ph::contacts<d, 1> touched;
      touched.push_back(ph::contact<d>{.normal = n.normalized(), .depth = 1e-4, .stiffness = 1e4});
      ph::step_memory<ph::direct_control> memory;
      return ph::step(arm, brakes, touched, ph::direct_control(), state, memory, options);
    };
    // Towards the angle at which nothing is displayed any more
    ph::point<d> shown = random.template direction<double, d>();
    ph::point<d> dark = 1e-3 * random.template direction<double, d>() - shown;
    if (!ph::is_displayed(pressed_along(shown).display)) std::swap(shown, dark);
    for (int i = 0; i < halvings; ++i) {
      const ph::point<d> n = 0.5 * (shown + dark);
      const auto result = pressed_along(n);
      const char* broken = broken_law(arm, brakes, state, 1, result);
      ASSERT_EQ(broken, nullptr) << broken << ": seed " << seed << ", state " << k << ", cos(gamma) "
                                 << result.approximation_cosine;
      if (!ph::is_displayed(result.display)) {
        dark = n;
      } else {
        shown = n;
        least_cosine = std::min(least_cosine, result.approximation_cosine);
      }
    }
  }
  std::printf("least cos(gamma) displayed: %.1e\n", static_cast<double>(least_cosine));
  EXPECT_LT(least_cosine, T(256) * std::numeric_limits<T>::epsilon());
}

}  // namespace stress
