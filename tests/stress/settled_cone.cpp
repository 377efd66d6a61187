// The cone of a self-motion that settles, against every set of brakes at rest in long double.
#include "effort.hpp"

#include <passive_haptics/brake/brake_parameters.hpp>
#include <passive_haptics/force/torques/settled_approximation.hpp>
#include <passive_haptics/mechanism/self_motion.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <vector>

namespace {

namespace ph = passive_haptics;
using real = long double;
using row = std::vector<real>;
using rows = std::vector<row>;

// v = J qd and w = T qd, both any matrices.
template <int N, int D, int Brakes>
struct linear_arm {
  using scalar = double;
  static constexpr int dof = N, task_dimension = D, brake_count = Brakes;
  ph::matrix<double, D, N> J;
  ph::matrix<double, Brakes, N> T;

  explicit linear_arm(ph::testing::random_source& random) {
    for (double& x : J.reshaped()) x = random.normal<double>();
    for (double& x : T.reshaped()) x = random.normal<double>();
    if (random.coin()) T.setIdentity();  // brakes on the first joints
  }
  ph::vector<double, D> position(const ph::vector<double, N>& q) const { return J * q; }
  ph::matrix<double, D, N> jacobian() const { return J; }
  ph::matrix<double, Brakes, N> transmission() const { return T; }
};

real dot(const row& a, const row& b) {
  real sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// X of A X = B by elimination with pivots; false where A is singular.
bool solve(rows A, rows& B) {
  const std::size_t n = A.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(A[i][k]) > std::abs(A[pivot][k])) pivot = i;
    if (std::abs(A[pivot][k]) < real(1e-15)) return false;
    std::swap(A[k], A[pivot]);
    std::swap(B[k], B[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k) continue;
      const real share = A[i][k] / A[k][k];
      for (std::size_t j = k; j < n; ++j) A[i][j] -= share * A[k][j];
      for (std::size_t j = 0; j < B[i].size(); ++j) B[i][j] -= share * B[k][j];
    }
  }
  for (std::size_t k = 0; k < n; ++k)
    for (real& x : B[k]) x /= A[k][k];
  return true;
}

// The share of a unit n that the nearest of the forces { sum x_i g_i : x >= 0 } has: the largest projection
// on some generators with coefficients >= 0.
real nearest_cosine(const rows& generators, const row& n) {
  real best = 0;
  const std::size_t count = generators.size();
  for (unsigned set = 1; set < (1u << count); ++set) {
    if (static_cast<std::size_t>(std::popcount(set)) > n.size()) continue;
    rows chosen;
    for (std::size_t i = 0; i < count; ++i)
      if ((set >> i & 1u) != 0) chosen.push_back(generators[i]);
    rows gram, along;
    for (const row& a : chosen) {
      row products;
      for (const row& b : chosen) products.push_back(dot(a, b));
      gram.push_back(products);
      along.push_back({dot(a, n)});
    }
    const rows wanted = along;
    if (!solve(gram, along)) continue;
    real square = 0;
    bool inside = true;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      inside = inside && along[i][0] >= 0;
      square += along[i][0] * wanted[i][0];
    }
    if (inside && square > best * best) best = std::sqrt(square);
  }
  return best;
}

// The best over all sets S of r brakes: with qd from J qd = v, T_S qd = 0, the others' torques make F = W_S^T
// t.
template <class M>
real max_cosine(const M& arm, const ph::task_vector<M>& v, const ph::task_vector<M>& n) {
  constexpr int N = M::dof, D = M::task_dimension, m = M::brake_count;
  const row wanted(n.begin(), n.end());
  real best = 0;
  for (unsigned S = 0; S < (1u << m); ++S) {
    if (std::popcount(S) != N - D) continue;
    rows A, inverse;
    for (int i = 0; i < D; ++i) {
      A.emplace_back();
      for (int k = 0; k < N; ++k) A.back().emplace_back(arm.J(i, k));
      inverse.emplace_back(static_cast<std::size_t>(D), real(0));
      inverse.back()[static_cast<std::size_t>(i)] = 1;
    }
    for (int i = 0; i < m; ++i) {
      if ((S >> i & 1u) == 0) continue;
      A.emplace_back();
      for (int k = 0; k < N; ++k) A.back().emplace_back(arm.T(i, k));
      inverse.emplace_back(static_cast<std::size_t>(D), real(0));
    }
    if (!solve(A, inverse)) continue;  // now N x D: qd of v
    rows generators;
    for (int i = 0; i < m; ++i) {
      if ((S >> i & 1u) != 0) continue;
      row W(static_cast<std::size_t>(D), real(0));
      for (int k = 0; k < N; ++k)
        for (int j = 0; j < D; ++j)
          W[std::size_t(j)] += real(arm.T(i, k)) * inverse[std::size_t(k)][std::size_t(j)];
      const bool turns_forward = dot(W, row(v.begin(), v.end())) > 0;
      for (real& x : W) x = turns_forward ? -x : x;
      generators.push_back(W);
    }
    const real cosine = nearest_cosine(generators, wanted);
    if (cosine > best) best = cosine;
  }
  return best;
}

template <class M>
class settled_cone : public ::testing::Test {};
using arms = ::testing::Types<linear_arm<4, 2, 3>, linear_arm<4, 3, 4>>;
TYPED_TEST_SUITE(settled_cone, arms);

TYPED_TEST(settled_cone, is_the_best_of_all_sets_of_brakes_at_rest) {
  using M = TypeParam;
  const std::uint64_t states = stress::effort(1000, 10000);
  ph::testing::random_source random(stress::first_seed());
  std::uint64_t exact = 0, none = 0;
  double worst = 0;
  for (std::uint64_t k = 0; k < states; ++k) {
    const M arm(random);
    const auto v = random.direction<double, M::task_dimension>();
    const auto n = random.direction<double, M::task_dimension>();
    const ph::joint_vector<M> q = ph::joint_vector<M>::Zero();
    const auto E = ph::brake_jacobian(arm, q);
    const ph::mechanism_pose<M> pose(arm, q);
    const ph::settled_rates<M> rates(pose, 1e-12);
    const ph::unlimited_brakes brakes;
    const ph::settled_forces forces(rates, E, brakes, v);
    const auto F = forces.nearest(n, 0.0);
    const double cosine = ph::is_displayed(F.display) ? F.cosine() : 0.0;
    const double expected = static_cast<double>(max_cosine(arm, v, n));
    ASSERT_NEAR(cosine, expected, 1e-9) << "state " << k;
    worst = std::max(worst, std::abs(cosine - expected));
    ASSERT_EQ(F.display == ph::display_class::exact, expected > 1 - 1e-13) << "state " << k;
    // Promises: the signs, no power from the velocity that gave them, T^T t = J^T F, F . n = 1
    ASSERT_TRUE((F.signs.array() * F.torque.array() <= 0).all());
    if (!ph::is_displayed(F.display)) {
      ++none;
      continue;
    }
    exact += F.display == ph::display_class::exact;
    const double size = 1e-9 * (1 + F.force.norm()) * (1 + F.torque.norm());
    ASSERT_LE(F.force.dot(v), size) << "state " << k;
    ASSERT_LE((arm.T.transpose() * F.torque - arm.J.transpose() * F.force).norm(), size) << "state " << k;
    ASSERT_NEAR(F.force.dot(n), 1, size) << "state " << k;
  }
  std::printf("n %d, d %d, m %d: %llu states, exact %llu, none %llu, cosine to %.1e\n", M::dof,
              M::task_dimension, M::brake_count, static_cast<unsigned long long>(states),
              static_cast<unsigned long long>(exact), static_cast<unsigned long long>(none), worst);
  EXPECT_GT(exact + none, states / 10);
}

}  // namespace
