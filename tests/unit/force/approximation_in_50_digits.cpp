// slow, no sanitizers
// The approximation of two brakes in the plane, which takes no branch, against 50 digits: however flat the
// cone and however near an edge the desired force.
#include "../../stress/effort.hpp"
#include "../core/adversarial_cones.hpp"
#include "../core/cone_oracle.hpp"

#include <passive_haptics/force/approximation.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace ph = passive_haptics;

namespace {

template <class T>
struct approximation_in_the_plane : ::testing::Test {
  static constexpr double eps = static_cast<double>(std::numeric_limits<T>::epsilon());

  // How far Fp = Fc cos^2 gamma is from the nearest force, and its torques from E^T Fp over |E_i|.
  struct error {
    double force, torque;
  };
  static error error_of(const ph::approximated_force<T, 2, 2>& F, const ph::matrix<T, 2, 2>& E,
                        const oracle::column& nearest) {
    using oracle::real;
    const real square = F.cosine_squared;
    const oracle::column off{square * F.force[0] - nearest[0], square * F.force[1] - nearest[1]};
    real torque = 0;
    for (int i = 0; i < 2; ++i) {
      const oracle::column e = oracle::half_space(E, i);
      const real wrong = abs(square * F.torque[i] - oracle::dot(e, nearest)), length = oracle::norm(e);
      if (length > 0) torque = std::max<real>(torque, wrong / length);
    }
    return {static_cast<double>(oracle::norm(off)) / eps, static_cast<double>(torque) / eps};
  }
};

using scalars = ::testing::Types<double, float>;
TYPED_TEST_SUITE(approximation_in_the_plane, scalars);

// Of columns of E that are not parallel to rounding.
TYPED_TEST(approximation_in_the_plane, is_exact_to_rounding_within_rounding_of_an_edge) {
  using T = TypeParam;
  using oracle::real;
  const std::uint64_t seed = stress::first_seed(), count = stress::effort(1000, 100000);
  adversarial::cones<T, 2, 2> cones(seed);
  ph::testing::random_source random(seed);
  const T min_cosine = T(0.02);
  std::uint64_t displayed = 0;
  for (std::uint64_t k = 0, checked = 0; checked < count; ++k) {
    const auto [E, n] = cones.draw();
    const real area = abs(real(E(0, 0)) * E(1, 1) - real(E(1, 0)) * E(0, 1));
    if (!(area > real(50 * this->eps) * E.col(0).norm() * E.col(1).norm())) continue;
    ++checked;
    ph::vector<T, 2> s;
    for (int i = 0; i < 2; ++i) s[i] = random.uniform(0.0, 1.0) < 0.1 ? T(0) : (random.coin() ? T(1) : T(-1));
    const ph::matrix<T, 2, 2> B = E * s.asDiagonal();
    const auto F = ph::approximate(E, s, n, min_cosine);
    const oracle::column nearest = oracle::nearest_point(B, n, 0);
    const double cosine = static_cast<double>(oracle::norm(nearest));
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", problem " << k << "\nE =\n"
                                      << E << "\ns = " << s.transpose() << "\nn = " << n.transpose());
    for (int i = 0; i < 2; ++i) ASSERT_LE(s[i] * F.torque[i], 0);
    if (F.display == ph::display_class::none) {
      ASSERT_LE(cosine, static_cast<double>(min_cosine) + 4 * this->eps);
      continue;
    }
    ASSERT_GE(cosine, static_cast<double>(min_cosine) - 4 * this->eps);
    ++displayed;
    const auto off = this->error_of(F, E, nearest);
    ASSERT_LE(off.force, 4);
    ASSERT_LE(off.torque, 4);
  }
  EXPECT_GT(displayed, count / 2);
}

}  // namespace
