// slow
// Friction of several brakes at once. The laws of friction are those of a convex program's solution, so rates
// that fulfil them are the right ones.
#include <passive_haptics/plant/box_friction.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace ph = passive_haptics;

namespace {

// m brakes on n joints: A = B B^T has rank n; regular for m <= n, as 0.05 is added to its diagonal.
template <class T, int N, int Brakes>
void expect_laws_of_friction(unsigned seed) {
  constexpr bool redundant = Brakes > N;
  using vec = ph::vector<T, Brakes>;
  using mat = ph::matrix<T, Brakes, Brakes>;
  ph::testing::random_source random(seed);
  int sticking = 0, slipping = 0;
  for (int k = 0; k < 100; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", trial " << k);
    ph::matrix<T, Brakes, N> B;
    for (int j = 0; j < N; ++j) B.col(j) = random.normal_vector<T, Brakes>();
    const mat A = B * B.transpose() + T(redundant ? 0 : 0.05) * mat::Identity();
    const vec w0 = k % 10 == 1 ? vec(vec::Zero()) : vec(B * random.normal_vector<T, N>());
    vec limit;
    for (T& x : limit) x = k % 10 == 2 ? T(1e3) : random.positive(T(0.03), T(10));
    if (k % 5 == 0) limit[0] = T(0);
    if (k % 10 == 3) limit.setZero();
    const auto result = [&] {
      if constexpr (redundant) return ph::solve_redundant_box_friction<T, Brakes>(A, w0, limit);
      else return ph::solve_box_friction<T, Brakes>(A, w0, limit);
    }();
    ASSERT_TRUE(result.solved);
    const vec w = w0 + A * result.impulse;
    const T rounding = ph::rounding_tolerance<T>(16 * Brakes) * (w0.norm() + A.norm() * limit.norm());
    for (int i = 0; i < Brakes; ++i) {
      EXPECT_LE(std::abs(result.impulse[i]), limit[i]);
      EXPECT_LE(result.impulse[i] * w[i], rounding * limit[i]) << "brake " << i << " would drive";
      const bool rests = std::abs(w[i]) <= rounding;
      if (!rests) {
        EXPECT_EQ(std::abs(result.impulse[i]), limit[i]) << "brake " << i << " slips at " << w[i];
      }
      if (!redundant && result.sticks[static_cast<std::size_t>(i)]) {
        EXPECT_TRUE(rests) << "brake " << i;
      }
      ++(rests ? sticking : slipping);
    }
    if (k % 10 == 1) {
      EXPECT_TRUE(result.impulse.isZero(T(0))) << "nothing moves";
    }
  }
  EXPECT_GT(sticking, 20);
  EXPECT_GT(slipping, 20);
}

TEST(box_friction, fulfils_the_laws_of_friction) {
  expect_laws_of_friction<double, 2, 2>(31);
  expect_laws_of_friction<float, 3, 3>(32);
  expect_laws_of_friction<double, 4, 4>(33);
  expect_laws_of_friction<double, 2, 4>(41);
  expect_laws_of_friction<float, 2, 3>(42);
}

}  // namespace
