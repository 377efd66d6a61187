// Problems of a nearest point in a cone, and what is true of their answers.
#pragma once

#include <passive_haptics/core/linear/cone.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ph = passive_haptics;

using vec = ph::vector<double, 3>;
using half_spaces = ph::matrix<double, 3, 3>;
using projection = ph::half_space_projection<double, 3, 3>;
inline constexpr double eps = std::numeric_limits<double>::epsilon();
inline const half_spaces octant = ph::identity_matrix<double, 3>();  // { p <= 0 }

// The conditions of Karush, Kuhn and Tucker, which make p the nearest point: f = p + B mu, p in the cone and
// at right angles to what holds it back, mu > 0 there and else 0.
template <int Rows, int Columns>
void expect_nearest(const ph::half_space_projection<double, Rows, Columns>& held,
                    const ph::matrix<double, Rows, Columns>& B, const ph::vector<double, Rows>& f) {
  SCOPED_TRACE(::testing::Message() << "B =\n" << B << "\nf = " << f.transpose());
  const auto& mu = held.coefficients;
  EXPECT_LE((held.point + B * mu - f).norm(), 1e-13 * (1 + B.norm() * mu.norm()));
  for (int j = 0; j < Columns; ++j) {
    const bool holds = (held.active >> j & 1u) != 0;
    const double beyond = B.col(j).dot(held.point) / B.col(j).norm();
    EXPECT_LE(holds ? std::abs(beyond) : beyond, 1e-13 * f.norm()) << "half-space " << j;
    EXPECT_TRUE(holds ? mu[j] > 0 : mu[j] == 0) << "half-space " << j;
  }
  EXPECT_EQ(held.active >> Columns, 0u);
}

// Half-spaces of lengths from 1/4 to 4 and a force of a length that is not 1.
template <int Rows, int Columns>
struct problem {
  ph::matrix<double, Rows, Columns> B;
  ph::vector<double, Rows> f;
  explicit problem(ph::testing::random_source& random) {
    for (int j = 0; j < Columns; ++j)
      B.col(j) = random.positive(0.25, 4.0) * random.direction<double, Rows>();
    f = 3 * random.direction<double, Rows>();
  }
};
