// slow, no sanitizers
// Sink slopes against the definition in 50 digits: the forces at all slopes at which a brake turns, one after
// the other.
#include <passive_haptics/design/sink_slope.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include "../high_precision.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

namespace ph = passive_haptics;

namespace {

using tendon_device = ph::tendon_two_link<double>;
using real = high_precision::real;
using planar_vector = ph::vector<double, 2>;

// The exact slope, and the least relative distance between the push and the sums that it is compared with.
struct exact_slope {
  double slope = std::numeric_limits<double>::infinity(), margin = 1;
};

exact_slope slope_of(const tendon_device& arm, const planar_vector& q, const planar_vector& t,
                     const planar_vector& n, const planar_vector& limit, double push) {
  const auto J = high_precision::gradient<2, 2>([&](const auto& x) { return arm.position(x); },
                                                high_precision::exact(q));
  const auto T = high_precision::exact(arm.transmission());
  const high_precision::vec<2> out = high_precision::exact(n) / high_precision::exact(n).norm();
  high_precision::vec<2> along = high_precision::exact(t);
  along -= out.dot(along) * out;
  along /= along.norm();
  // G^T = T J^-1 by Cramer's rule
  const real det = J(0, 0) * J(1, 1) - J(0, 1) * J(1, 0);
  high_precision::mat<2, 2> inverse;
  inverse << J(1, 1) / det, -J(0, 1) / det, -J(1, 0) / det, J(0, 0) / det;
  const high_precision::vec<2> a = T * (inverse * along), b = T * (inverse * out);
  std::array<std::pair<real, real>, 2> brakes;
  for (int i = 0; i < 2; ++i) {
    const real slope = a[i] / b[i];
    brakes[static_cast<std::size_t>(i)] = {slope > 0 ? slope : real(0), abs(b[i]) * limit[i]};
  }
  std::sort(brakes.begin(), brakes.end());
  exact_slope found;
  real force = 0;
  for (const auto& [slope, more] : brakes) {
    force += more;
    found.margin = std::min(found.margin, std::abs(static_cast<double>(force / push - 1)));
    if (force >= push && !std::isfinite(found.slope)) found.slope = static_cast<double>(slope);
  }
  return found;
}

TEST(sink_slope, is_that_of_50_digits_to_rounding_times_the_condition) {
  const tendon_device arm;
  ph::testing::random_source random(31);
  double worst = 0;
  int held = 0, sinking = 0, lost = 0;
  for (int k = 0; k < 2000; ++k) {
    const planar_vector q(random.uniform(-3.0, 3.0), random.wide(1e-5, 3.1)),
        t = random.direction<double, 2>(), n = random.direction<double, 2>(),
        limit(random.positive(0.1, 10.0), random.positive(0.1, 10.0));
    const double push = random.positive(0.1, 1000.0);
    const auto exact = slope_of(arm, q, t, n, limit, push);
    // Rates of joints are off by eps times the condition of J, and the along direction by eps over its part
    const ph::matrix<double, 2, 2> J = arm.jacobian(q);
    const double across = std::abs(ph::cross_in_plane(t, n)), eps = std::numeric_limits<double>::epsilon();
    const double rounding = 64 * eps * (J.squaredNorm() / std::abs(J.determinant()) + 1 / across);
    if (exact.margin < 4 * rounding) continue;
    const double slope = ph::sink_slope(arm, q, t, n, limit, push).slope;
    ASSERT_EQ(std::isfinite(slope), std::isfinite(exact.slope)) << "seed 31, pose " << k;
    held += exact.slope == 0;
    lost += !std::isfinite(exact.slope);
    if (!std::isfinite(slope)) continue;
    // Beside a rate out of the wall that vanishes a slope is steep, and its angle is what rounding moves
    const double error = std::abs(std::atan(slope) - std::atan(exact.slope)) / rounding;
    worst = std::max(worst, error);
    sinking += exact.slope > 0;
    EXPECT_LE(error, 1) << "seed 31, pose " << k << ": " << slope << " for " << exact.slope;
  }
  std::printf("%d held, %d sinking, %d lost, worst error %.2g of its bound\n", held, sinking, lost, worst);
  EXPECT_GT(held, 300);
  EXPECT_GT(sinking, 300);
  EXPECT_GT(lost, 100);
}

}  // namespace
