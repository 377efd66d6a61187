// slow, optimised, no sanitizers
// The torques of redundant brakes: they make the nearest force, none shorter does, neighbours are neighbours.
#include "min_torque_oracle.hpp"

#include <passive_haptics/force/forms/generator_form.hpp>

#include <gtest/gtest.h>
#include <Eigen/QR>

#include <algorithm>
#include <random>

namespace ph = passive_haptics;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

template <int D, int M>
struct problem {
  ph::matrix<double, D, M> G;
  ph::vector<double, M> s;
  ph::vector<double, D> f;

  ph::matrix<double, D, M> generators() const { return G * (-s).asDiagonal(); }
};

// Of a condition; f any unit force or one in the cone.
template <int D, int M>
problem<D, M> draw(std::mt19937_64& engine, double condition) {
  std::normal_distribution<double> gauss;
  problem<D, M> p;
  ph::matrix<double, D, D> A;
  for (auto& x : A.reshaped()) x = gauss(engine);
  for (auto& x : p.G.reshaped()) x = gauss(engine);
  for (int k = 0; k < D; ++k) p.G.row(k) *= std::pow(condition, static_cast<double>(k) / (D - 1));
  p.G = Eigen::HouseholderQR<Eigen::MatrixXd>(A).householderQ() * Eigen::MatrixXd(p.G);
  for (auto& x : p.s) x = gauss(engine) > 0 ? 1 : -1;
  for (auto& x : p.f) x = gauss(engine);
  if (engine() % 2 == 0) {
    ph::vector<double, M> t;
    for (auto& x : t) x = std::abs(gauss(engine));
    p.f = p.generators() * t;
  }
  p.f.normalize();
  return p;
}

template <class V>
oracle::wide_column wide(const V& v) {
  return {v.data(), v.data() + v.size()};
}

double distance(oracle::wide_column a, const oracle::wide_column& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return static_cast<double>(sqrt(oracle::inner(a, a)));
}

template <int D, int M>
void expect_min_torques(int cases) {
  std::mt19937_64 engine(100 * D + M);
  for (const double condition : {1.0, 1e2, 1e3, 1e4, 1e6, 1e8, 1e10}) {
    double worst_force = 0, worst_made = 0, worst_torque = 0;
    for (int k = 0; k < cases; ++k) {
      SCOPED_TRACE(::testing::Message() << D << " x " << M << ", condition " << condition << ", case " << k);
      const auto p = draw<D, M>(engine, condition);
      const ph::matrix<double, D, M> V = p.generators();
      const auto ours = ph::nearest_torque(p.G, p.s, p.f);
      const auto best = oracle::min_torque_of(V, p.f);
      const oracle::wide_column force(best.force.begin(), best.force.end());
      oracle::wide_column made(D, 0), x = wide(ours.torque);
      for (int i = 0; i < M; ++i) {
        ASSERT_LE(p.s[i] * ours.torque[i], 0);
        x[static_cast<std::size_t>(i)] *= -p.s[i];
        for (int j = 0; j < D; ++j)
          made[static_cast<std::size_t>(j)] += x[static_cast<std::size_t>(i)] * oracle::wide(V(j, i));
      }
      const double size = static_cast<double>(sqrt(oracle::inner(best.x, best.x)));
      const double terms = 1 + (V.cwiseAbs() * ours.torque.cwiseAbs()).norm();
      worst_force = std::max(worst_force, distance(wide(ours.force), force));
      worst_made = std::max(worst_made, distance(made, wide(ours.force)) / terms);
      const double error = size > 0 ? distance(x, best.x) / size / best.condition : 0;
      worst_torque = std::max(worst_torque, error);
    }
    std::printf(
        "%d x %d, condition %.0e: force %.1e; of eps: made %.1f of its terms, torque %.1f of condition\n", D,
        M, condition, worst_force, worst_made / eps, worst_torque / eps);
    EXPECT_LE(worst_made, 16 * eps);
    // Two and three brakes are exact; four in space as sharp as the angles between the generators
    const bool exact = D == 2 || M == 3;
    EXPECT_LE(worst_force, exact ? 1e-15 : 8 * eps * condition + 1e-15);
    if (exact || condition < 1e7) {
      EXPECT_LE(worst_torque, 64 * eps);
    }
  }
}

// Pose and force drift by a nanoradian a step, by less where that is not short against the angles of the
// generators; some of them over a generator: torques change by no more than the condition allows.
template <int D, int M>
void expect_no_jumps(unsigned seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> gauss;
  for (const double condition : {1.0, 1e2, 1e4, 1e6, 1e8, 1e10}) {
    double worst = 0;
    for (int path = 0; path < 200; ++path) {
      auto p = draw<D, M>(engine, condition);
      if (path % 2 == 0) p.f = p.generators().col(0).normalized();
      ph::matrix<double, D, M> drift;
      ph::vector<double, D> turn;
      for (auto& x : drift.reshaped()) x = gauss(engine);
      for (auto& x : turn) x = gauss(engine);
      // |V_S^+| (|dF| + |dV| |x|) for the worst set S of generators
      const ph::matrix<double, D, M> V = p.generators();
      const double sine = oracle::project(V, p.f).min_angle;
      const double step = std::min(1e-9, sine / 100);
      const double inverse = 1 / sine / V.colwise().norm().minCoeff();
      ph::vector<double, M> last = ph::vector<double, M>::Zero();
      for (int k = -20; k <= 20; ++k) {
        const ph::matrix<double, D, M> G = p.G.array() * (1 + k * step * drift.array());
        const ph::vector<double, D> f = (p.f + k * step * turn).normalized();
        const ph::vector<double, M> t = ph::nearest_torque(G, p.s, f).torque;
        if (k > -20) {
          const double bound = step * inverse * (1 + V.norm() * std::max(t.norm(), last.norm()));
          worst = std::max(worst, (t - last).norm() / bound);
        }
        last = t;
      }
    }
    std::printf("%d x %d, condition %.0e: torques change by %.1f of what it allows\n", D, M, condition,
                worst);
    EXPECT_LE(worst, 32);
  }
}

}  // namespace

TEST(min_torque, is_the_best_of_all_sets_of_brakes_in_50_digits) {
  expect_min_torques<2, 3>(200);
  expect_min_torques<2, 4>(80);
  expect_min_torques<2, 6>(24);
  expect_min_torques<2, 8>(8);
  expect_min_torques<3, 3>(200);
  expect_min_torques<3, 4>(80);
  expect_min_torques<3, 6>(24);
  expect_min_torques<3, 8>(8);
}

TEST(min_torque, changes_no_more_than_its_condition_along_a_path) {
  expect_no_jumps<2, 3>(1);
  expect_no_jumps<2, 4>(2);
  expect_no_jumps<2, 8>(3);
  expect_no_jumps<3, 4>(4);
  expect_no_jumps<3, 6>(5);
}
