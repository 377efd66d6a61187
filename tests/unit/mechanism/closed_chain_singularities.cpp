// slow, optimised, no sanitizers
// Closed chains near their singularities, which 50 digits find.
#include "closed_chain_oracles.hpp"

#include <cmath>

namespace {

using namespace closed_chains;

template <class Case>
struct singular_chain : closed_chain<Case> {};
TYPED_TEST_SUITE(singular_chain, cases);

// The root of f between a (f > 0) and b (f < 0), to 45 digits.
template <class F>
real root(F&& f, real a, real b) {
  for (int k = 0; k < 160; ++k) {
    const real middle = (a + b) / 2;
    (f(middle) > 0 ? a : b) = middle;
  }
  return (a + b) / 2;
}

TYPED_TEST(singular_chain, near_type_1_conditioning_falls_linearly_and_only_the_inverse_is_unbounded) {
  constexpr int N = TestFixture::dof;
  int found = 0;
  for (int k = 0; k < 20000 && found < 5; ++k) {
    // Two poses between which leg 1 passes the singularity, all else well away from one
    ph::vector<double, N> q = this->closed_pose(0.2), end = q;
    const auto drive = [&](const real& q0) {
      vec<N> at = exact(q);
      at[0] = q0;
      const vec<N> tangent = derivative([&](const real& s) { return this->truth.elbow(0, q0 + s); });
      return real((this->handle(at) - this->truth.elbow(0, q0)).dot(tangent));
    };
    end[0] += this->random.coin() ? 1.0 : -1.0;
    if (!(this->chain.conditioning(end).type_2 > 0.2)) continue;
    const real from = drive(q[0]), to = drive(end[0]);
    if (!(from * to < 0)) continue;
    const real singular =
        root([&](const real& s) { return real(drive(s) * (from > 0 ? 1 : -1)); }, q[0], end[0]);
    vec<N> at = exact(q);
    at[0] = singular;
    const figures<N> there = conditioning(this->truth, this->handle(at), at);
    if (!(there.type_2 > 0.2) || !(there.legs.template tail<N - 1>().minCoeff() > 0.1)) continue;
    ++found;
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", singular at q = " << at.transpose());

    at[0] = singular + real(1e-20);
    const double slope = double(conditioning(this->truth, this->handle(at), at).legs[0] / real(1e-20));
    for (const double side : {-1.0, 1.0}) {
      for (double away = 1e-3; away > 0.5e-12; away /= 10) {
        q[0] = double(singular + real(side * away));
        const double really = double(abs(real(q[0]) - singular));
        const auto c = this->chain.conditioning(q);
        ASSERT_NEAR(c.type_1, slope * really, 100 * really * really + 64 * eps) << "away " << side * away;
        ASSERT_GT(c.type_2, 0.15);
        // J loses column 1; row 1 of its inverse has length 1 / (type_1 lever)
        const double lever = double((this->truth.elbow(0, 0) - this->truth.elbow(0, real(pi))).norm()) / 2;
        const auto J = this->chain.jacobian(q);
        ASSERT_LE(J.col(0).norm(), 10 * lever * c.type_1);
        ASSERT_LE(J.norm(), 20 * lever);
        ASSERT_NEAR(this->chain.inverse_jacobian(q).row(0).norm() * c.type_1 * lever, 1, 1e-12);
      }
    }
  }
  EXPECT_EQ(found, 5);
}

TYPED_TEST(singular_chain, near_type_2_the_inverse_jacobian_stays_finite_and_beyond_it_there_is_no_pose) {
  constexpr int N = TestFixture::dof;
  int found = 0;
  for (int k = 0; k < 20000 && found < 5; ++k) {
    ph::vector<double, N> q = this->closed_pose(0.1), end = q;
    const auto slack = [&](const real& q0) {
      vec<N> at = exact(q);
      at[0] = q0;
      return this->truth.slack(at);
    };
    end[0] += this->random.coin() ? 0.5 : -0.5;
    if (!(slack(end[0]) < 0)) continue;
    const real edge = root(slack, q[0], end[0]);
    const double inside = end[0] > q[0] ? -1 : 1;
    vec<N> at = exact(q);
    at[0] = edge + real(inside) * real(1e-24);
    const figures<N> there = conditioning(this->truth, this->handle(at), at);
    if (!(there.legs.minCoeff() > 0.05)) continue;
    ++found;
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", edge at q = " << at.transpose());

    // The figure is |sin| of an angle that grows as the root of the way: its square is linear in q
    const double slope = double(there.type_2 * there.type_2 / real(1e-24));
    for (double away = 1e-4; away > 0.5e-12; away /= 10) {
      q[0] = double(edge + real(inside * away));
      const double really = double(abs(real(q[0]) - edge));
      const auto c = this->chain.conditioning(q);
      ASSERT_NEAR(c.type_2 * c.type_2, slope * really, slope * (50 * really * std::sqrt(really) + 64 * eps))
          << "away " << away;
      const auto inverse = this->chain.inverse_jacobian(q);
      ASSERT_TRUE(ph::all_finite(inverse));
      ASSERT_LE(inverse.norm(), 16 / (this->length() * c.type_1));
      // J grows as 1 / type_2
      const double growth = this->chain.jacobian(q).norm() * c.type_2;
      ASSERT_TRUE(growth > 1e-4 && growth < 1) << growth;

      q[0] = double(edge - real(inside * away));
      ASSERT_TRUE(std::isnan(this->chain.position(q)[0]));
      ASSERT_FALSE(ph::all_finite(this->chain.jacobian(q)));
      ASSERT_TRUE(std::isnan(this->chain.conditioning(q).type_2));
    }
  }
  EXPECT_EQ(found, 5);
}

}  // namespace
