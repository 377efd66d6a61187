/// @file
/// Random problems of a given condition with their solutions in 50 digits, and the error of another
/// solution.
#pragma once

#include "../../tests/unit/core/cone_oracle.hpp"
#include "ways.hpp"

#include <passive_haptics/testing/support/percentile.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <boost/multiprecision/eigen.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace benchmarks {

using real = oracle::real;  // 50 digits
constexpr std::array conditions{1.0, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12, 1e14};

template <int D>
struct problem {
  ph::matrix<double, D, D> J;
  ph::vector<double, D> s, Fd;  // signs of the brakes, unit desired force
  ph::vector<real, D> nearest;  // Fp
};

template <int D>
ph::matrix<double, D, D> random_rotation(ph::testing::random_source& random) {
  ph::matrix<double, D, D> A;
  for (int i = 0; i < D; ++i) A.col(i) = random.normal_vector<double, D>();
  return A.householderQr().householderQ();
}

// J = U diag(1, ..., 1/condition) V^T; in space the third singular value is their geometric mean.
template <int D>
std::vector<problem<D>> random_problems(double condition, int count, ph::testing::random_source& random) {
  std::vector<problem<D>> all;
  while (static_cast<int>(all.size()) < count) {
    ph::vector<double, D> sigma;
    for (int i = 0; i < D; ++i) sigma[i] = std::pow(condition, -static_cast<double>(i) / (D - 1));
    problem<D> p;
    p.J = random_rotation<D>(random) * sigma.asDiagonal() * random_rotation<D>(random).transpose();
    for (int i = 0; i < D; ++i) p.s[i] = random.coin() ? 1 : -1;
    p.Fd = random.direction<double, D>();
    const auto nearest = oracle::project<double, D, D>(p.J * p.s.asDiagonal(), p.Fd);
    for (int i = 0; i < D; ++i) p.nearest[i] = nearest.point[static_cast<std::size_t>(i)];
    all.push_back(p);
  }
  return all;
}

// Of many solutions. All relative to |Fd| = 1.
struct quality {
  double worst_error, median_error;  // |F - Fp|
  double worst_violation;            // of s_i b_i . F <= 0, relative to |b_i|, with b_i = J e_i
  double worst_torque_violation;     // of s_i t_i <= 0 by the returned torques, relative to |t|
};

// The errors of solutions, in 50 digits. A solution without its force makes J^-T t.
template <int D>
quality quality_of(const std::vector<answer<long double, D>>& answers,
                   const std::vector<problem<D>>& problems) {
  using vec = ph::vector<real, D>;
  quality q{};
  std::vector<double> errors;
  for (std::size_t k = 0; k < problems.size(); ++k) {
    const problem<D>& p = problems[k];
    const ph::matrix<real, D, D> J = p.J.template cast<real>();
    const vec returned = answers[k].torque.template cast<real>();
    const vec F = answers[k].force.allFinite() ? vec(answers[k].force.template cast<real>())
                                               : vec(J.transpose().inverse() * returned);
    const vec t = J.transpose() * F;
    const real size = returned.norm();
    errors.push_back(static_cast<double>(vec(F - p.nearest).norm()));
    for (int i = 0; i < D; ++i) {
      const real wrong = p.s[i] * t[i] / J.col(i).norm(), wrong_torque = p.s[i] * returned[i];
      q.worst_violation = std::max(q.worst_violation, static_cast<double>(wrong));
      if (wrong_torque > 0)
        q.worst_torque_violation =
            std::max(q.worst_torque_violation, static_cast<double>(wrong_torque / size));
    }
  }
  const auto ascending = ph::testing::sorted(std::move(errors));
  q.worst_error = ascending.back();
  q.median_error = ph::testing::percentile(ascending, 0.5);
  return q;
}

}  // namespace benchmarks
