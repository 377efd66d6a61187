// slow, optimised, no sanitizers
// The torques of redundant brakes: they make the nearest force, none shorter does, neighbours are neighbours.
#include "../core/cone_oracle.hpp"
#include "priorities_oracle.hpp"

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

// Against the best face of the box: the force is as near, and no shorter torques make it. Without limits two
// and three brakes are exact; four in space as sharp as the angles between the generators.
template <int D, int M>
void expect_nearest(int cases, bool limited) {
  std::mt19937_64 engine(100 * D + M);
  std::normal_distribution<double> gauss;
  const bool exact = !limited && (D == 2 || M == 3);
  for (const double condition : {1.0, 1e2, 1e4, 1e6, 1e8, 1e10}) {
    const double sharp = 64 * eps * condition;
    for (int k = 0; k < cases; ++k) {
      SCOPED_TRACE(::testing::Message() << D << " x " << M << ", condition " << condition << ", case " << k);
      const auto p = draw<D, M>(engine, condition);
      ph::vector<double, M> limit = ph::vector<double, M>::Constant(HUGE_VAL);
      if (limited) {
        const double size = p.G.norm();
        for (auto& x : limit) x = std::exp(gauss(engine)) / size;
      }
      const auto box = ph::torques_within(p.s, limit);
      const auto ours = limited ? ph::nearest_torque(p.G, box, p.f) : ph::nearest_torque(p.G, p.s, p.f);
      ASSERT_TRUE(
          (box.lower.array() <= ours.torque.array() && ours.torque.array() <= box.upper.array()).all());
      const double terms = 1 + (p.G.cwiseAbs() * ours.torque.cwiseAbs()).norm();
      ASSERT_LE((p.G * ours.torque - ours.force).norm(), 32 * eps * terms);

      using oracle::real;
      std::vector<oracle::level<real>> levels(2);
      oracle::list<real> lower, upper, torque;
      for (int i = 0; i < D; ++i) {
        levels[0].rows.emplace_back(p.G.row(i).begin(), p.G.row(i).end());
        levels[0].targets.push_back(p.f[i]);
      }
      for (int i = 0; i < M; ++i) {
        levels[1].rows.emplace_back(M, real(0));
        levels[1].rows.back()[static_cast<std::size_t>(i)] = 1;
        levels[1].targets.push_back(0);
        lower.push_back(box.lower[i]);
        upper.push_back(box.upper[i]);
        torque.push_back(ours.torque[i]);
      }
      const auto best =
          oracle::costs(levels, oracle::solve_by_faces<real>(levels, lower, upper, real(1e-32)));
      const auto here = oracle::costs(levels, torque);
      const double missing = (p.f - ours.force).norm();
      ASSERT_LE(missing - static_cast<double>(best[0]), exact ? 1e-15 : sharp);
      if (limited || exact || condition < 1e7) {
        ASSERT_LE(static_cast<double>(here[1] - best[1]), sharp * static_cast<double>(best[1]));
      }
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
    for (int path = 0; path < 60; ++path) {
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
    EXPECT_LE(worst, 32);
  }
}

}  // namespace

TEST(nearest_torque, is_the_best_of_all_sets_of_brakes_in_50_digits) {
  expect_nearest<2, 4>(30, false);
  expect_nearest<3, 3>(60, false);
  expect_nearest<3, 4>(30, false);
}

TEST(nearest_torque, within_limits_is_the_best_of_all_faces_in_50_digits) {
  expect_nearest<2, 4>(30, true);
  expect_nearest<3, 4>(30, true);
}

TEST(nearest_torque, changes_no_more_than_its_condition_along_a_path) {
  expect_no_jumps<2, 4>(2);
  expect_no_jumps<3, 4>(4);
}
