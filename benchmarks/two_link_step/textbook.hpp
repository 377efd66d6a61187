// The control cycle from the textbook: reference forces G = J^-T T^T (4)-(6) by a linear solver of Eigen,
// then the nearest of them (Fig. 3). As one writes it with care: J is factorised once, T is constant, so that
// its inverse is given, and sines are the library's, so that ways differ in their algebra alone.
#pragma once

#include "by_hand.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

namespace textbook {

using vector = Eigen::Vector2d;
using matrix = Eigen::Matrix2d;

struct inverse {
  static matrix solve(const matrix& A, const matrix& B) { return A.inverse() * B; }
};

struct partial_lu {
  static matrix solve(const matrix& A, const matrix& B) { return A.partialPivLu().solve(B); }
};

struct damped_svd {
  static matrix solve(const matrix& A, const matrix& B) {
    constexpr double damping = 1e-4;  // of the largest singular value
    const Eigen::JacobiSVD<matrix> svd(A, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Array2d s = svd.singularValues(), floor = Eigen::Array2d::Constant(damping * s[0]);
    return svd.matrixV() * (s / (s.square() + floor.square())).matrix().asDiagonal() *
           svd.matrixU().transpose() * B;
  }
};

template <class Solver>
by_hand::command step(const by_hand::device& d, const by_hand::wall& wall, const by_hand::measurement& at) {
  const auto [first, second] = passive_haptics::sine_cosine(at.q1, at.q1 + at.q2);
  const vector link_2 = d.length_2 * vector(second.cosine, second.sine);
  const vector x = d.length_1 * vector(first.cosine, first.sine) + link_2;
  const vector n(wall.nx, wall.ny);
  const double depth = wall.offset - n.dot(x);
  if (!(depth > 0)) return {0, 0, by_hand::region::free};
  const double Fd = wall.stiffness * depth;

  matrix J, T, T_inverse;
  J << -x[1], -link_2[1], x[0], link_2[0];
  T << 1, 0, 1, d.per_reduction_2;
  T_inverse << 1, 0, -d.reduction_2, d.reduction_2;
  const vector qd(at.qd1, at.qd2), w = T * qd, Fh(at.fx, at.fy);
  const matrix G = Solver::solve(J.transpose(), T.transpose());
  const matrix E_transposed = T_inverse.transpose() * J.transpose();
  const vector t = E_transposed * n, th = E_transposed * Fh;
  vector s;
  for (int i = 0; i < 2; ++i) s[i] = std::copysign(1.0, std::abs(w[i]) > d.rate_dead_band ? w[i] : th[i]);

  vector command = t;
  by_hand::region where = by_hand::region::exact;
  if ((s.array() * t.array() > 0).any()) {
    double nearest = 0;
    for (int i = 0; i < 2; ++i) {
      const vector R = -s[i] * G.col(i);
      const double along = n.dot(R), cosine = along / R.norm();
      if (!(cosine > nearest)) continue;
      nearest = cosine;
      command.setZero();
      command[i] = 1 / along;
    }
    if (!(nearest > 0)) return {0, 0, by_hand::region::none};
    where = by_hand::region::approximate;
  }
  const double wanted = n.dot(J * qd) > 0 ? std::clamp(-Fh.dot(n), 0.0, Fd) : Fd;
  const vector capacity = (command.cwiseAbs() * wanted).cwiseMin(d.torque_limit);
  return {capacity[0], capacity[1], where};
}

}  // namespace textbook
