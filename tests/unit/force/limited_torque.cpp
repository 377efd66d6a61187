// slow, no sanitizers
// Redundant brakes within torque limits: the nearest force by the least torques, at any condition.
#include "priorities_oracle.hpp"

#include <passive_haptics/force/torques/nearest_torque.hpp>

#include <gtest/gtest.h>
#include <Eigen/QR>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <random>

namespace ph = passive_haptics;

namespace {

using real = boost::multiprecision::cpp_bin_float_50;
constexpr double one_rounding = std::numeric_limits<double>::epsilon();

template <int D, int M>
void expect_nearest_within_limits(int cases) {
  std::mt19937_64 engine(10 * D + M);
  std::normal_distribution<double> gauss;
  for (const double condition : {1.0, 1e2, 1e4, 1e6, 1e8, 1e10}) {
    double farther = 0, longer = 0;
    for (int k = 0; k < cases; ++k) {
      ph::matrix<double, D, D> A;
      ph::matrix<double, D, M> G;
      ph::vector<double, M> s, limit, t;
      ph::vector<double, D> f;
      for (auto& x : A.reshaped()) x = gauss(engine);
      for (auto& x : G.reshaped()) x = gauss(engine);
      for (auto& x : s) x = gauss(engine) > 0 ? 1 : -1;
      for (auto& x : limit) x = std::exp(gauss(engine));
      for (auto& x : t) x = std::abs(std::sin(gauss(engine)));
      for (auto& x : f) x = gauss(engine);
      for (int i = 0; i < D; ++i) G.row(i) *= std::pow(condition, static_cast<double>(i) / (D - 1));
      G = Eigen::HouseholderQR<Eigen::MatrixXd>(A).householderQ() * Eigen::MatrixXd(G);
      if (k % 2 == 0) f = -G * s.cwiseProduct(limit).cwiseProduct(t);
      if (k % 2 == 0) limit /= f.norm();
      f.normalize();
      const auto box = ph::torques_within(s, limit);
      const auto ours = ph::nearest_torque(G, box, f);

      std::vector<oracle::level<real>> levels(2);
      oracle::list<real> lower, upper, torque;
      for (int i = 0; i < D; ++i) {
        levels[0].rows.emplace_back(G.row(i).begin(), G.row(i).end());
        levels[0].targets.push_back(f[i]);
      }
      for (int i = 0; i < M; ++i) {
        levels[1].rows.emplace_back(M, real(0));
        levels[1].rows.back()[static_cast<std::size_t>(i)] = 1;
        levels[1].targets.push_back(0);
        lower.push_back(box.lower[i]);
        upper.push_back(box.upper[i]);
        torque.push_back(ours.torque[i]);
        ASSERT_TRUE(box.lower[i] <= ours.torque[i] && ours.torque[i] <= box.upper[i]);
      }
      const auto best =
          oracle::costs(levels, oracle::solve_by_faces<real>(levels, lower, upper, real(1e-32)));
      const auto here = oracle::costs(levels, torque);
      farther = std::max(farther, static_cast<double>(here[0] - best[0]));
      longer = std::max(longer, static_cast<double>((here[1] - best[1]) / best[1]));
    }
    std::printf("%d x %d, seed %d, condition %.0e: of eps condition, farther by %.1f, longer by %.1f\n", D, M,
                10 * D + M, condition, farther / one_rounding / condition, longer / one_rounding / condition);
    EXPECT_LE(farther, 64 * one_rounding * condition);
    EXPECT_LE(longer, 64 * one_rounding * condition);
  }
}

}  // namespace

TEST(limited_torque, makes_the_nearest_force_with_the_least_norm_in_50_digits) {
  expect_nearest_within_limits<2, 3>(100);
  expect_nearest_within_limits<2, 4>(40);
  expect_nearest_within_limits<3, 4>(40);
  expect_nearest_within_limits<3, 5>(10);
}
