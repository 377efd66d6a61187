/// @file
/// Random problems of a given condition with their solutions in 50 digits, and the error of another
/// solution.
#pragma once

#include "../../tests/unit/core/cone_oracle.hpp"
#include "ways.hpp"

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

struct problem {
  matrix J;
  vector s, Fd;                 // signs of the brakes, unit desired force
  ph::vector<real, 3> nearest;  // Fp
};

inline matrix random_rotation(ph::testing::random_source& random) {
  matrix A;
  for (int i = 0; i < 3; ++i) A.col(i) = random.normal_vector<double, 3>();
  return A.householderQr().householderQ();
}

// J = U diag(1, ..., 1/condition) V^T; the second singular value is their geometric mean.
inline std::vector<problem> random_problems(double condition, std::size_t count,
                                            ph::testing::random_source& random) {
  const vector sigma(1, std::pow(condition, -0.5), std::pow(condition, -1.0));
  std::vector<problem> all(count);
  for (problem& p : all) {
    p.J = random_rotation(random) * sigma.asDiagonal() * random_rotation(random).transpose();
    for (double& sign : p.s) sign = random.coin() ? 1 : -1;
    p.Fd = random.direction<double, 3>();
    const auto nearest = oracle::project<double, 3, 3>(p.J * p.s.asDiagonal(), p.Fd);
    for (int i = 0; i < 3; ++i) p.nearest[i] = nearest.point[static_cast<std::size_t>(i)];
  }
  return all;
}

// The worst of many solutions, relative to |Fd| = 1.
struct quality {
  double worst_error = 0;             // |F - Fp|
  double worst_violation = 0;         // of s_i b_i . F <= 0, relative to |b_i|, with b_i = J e_i
  double worst_torque_violation = 0;  // of s_i t_i <= 0 by the returned torques, relative to |t|
};

// The errors of solutions, in 50 digits. A solution without its force makes J^-T t.
inline quality quality_of(const std::vector<answer>& answers, const std::vector<problem>& problems) {
  using vec = ph::vector<real, 3>;
  quality q;
  const auto keep_worst = [](double& worst, const real& found) {
    worst = std::max(worst, static_cast<double>(found));
  };
  for (std::size_t k = 0; k < problems.size(); ++k) {
    const problem& p = problems[k];
    const ph::matrix<real, 3, 3> J = p.J.cast<real>();
    const vec returned = answers[k].torque.cast<real>();
    const vec F = answers[k].force.allFinite() ? vec(answers[k].force.cast<real>())
                                               : vec(J.transpose().inverse() * returned);
    const vec t = J.transpose() * F;
    const real size = returned.norm();
    keep_worst(q.worst_error, vec(F - p.nearest).norm());
    for (int i = 0; i < 3; ++i) {
      const real wrong_torque = p.s[i] * returned[i];
      keep_worst(q.worst_violation, p.s[i] * t[i] / J.col(i).norm());
      if (wrong_torque > 0) keep_worst(q.worst_torque_violation, wrong_torque / size);
    }
  }
  return q;
}

}  // namespace benchmarks
