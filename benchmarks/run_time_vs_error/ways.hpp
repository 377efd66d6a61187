/// @file
/// Ways to the nearest displayable force Fp of a desired force, for three brakes in three dimensions.
#pragma once

#include <passive_haptics/force/approximation.hpp>

#include <Eigen/Dense>

#include <limits>

namespace benchmarks {

namespace ph = passive_haptics;
using matrix = ph::matrix<double, 3, 3>;
using vector = ph::vector<double, 3>;

struct answer {
  vector force;   // Fp [N]
  vector torque;  // of the brakes [N m]
};

// ---- ours: half-spaces, no inverse

struct half_spaces {
  answer operator()(const matrix& J, const vector& s, const vector& Fd) const {
    const vector t = ph::brake_torque(J, Fd);
    if (ph::producible(s, t)) return {Fd, t};
    const auto nearest = ph::nearest_force(J, s, Fd);
    vector tp = ph::brake_torque(J, nearest.force);
    for (int i = 0; i < 3; ++i)
      if ((nearest.active >> i & 1u) != 0 || s[i] * tp[i] > 0) tp[i] = 0;
    return {nearest.force, tp};
  }
};

// ---- the paper's way: reference forces G = J^-T, then the nearest of them (Fig. 3)

// In space the nearest force may also lie on a face between two reference forces. Of the feet of Fd on rays
// and faces of the cone the longest is the nearest.
inline answer nearest_of_reference_forces(const matrix& J, const matrix& G, const vector& s,
                                          const vector& Fd) {
  answer best{vector::Zero(), vector::Zero()};
  double longest = 0;
  for (int i = 0; i < 3; ++i) {
    const vector along = -s[i] * G.col(i);
    const double length = along.norm(), component = along.dot(Fd) / length;
    if (!(component > longest)) continue;
    longest = component;
    best.force = component / length * along;
    best.torque = -s[i] * component / length * vector::Unit(i);
  }
  for (int i = 0; i < 3; ++i) {
    const int a = (i + 1) % 3, b = (i + 2) % 3;
    const vector normal = G.col(a).cross(G.col(b)).normalized();
    const vector foot = Fd - normal.dot(Fd) * normal;
    vector t = J.transpose() * foot;  // coefficients on the reference forces
    t[i] = 0;
    if (!ph::producible(s, t) || !(foot.norm() > longest)) continue;
    longest = foot.norm();
    best = {foot, t};
  }
  return best;
}

template <class Inverse>
struct reference_forces_by {
  answer operator()(const matrix& J, const vector& s, const vector& Fd) const {
    const vector t = J.transpose() * Fd;
    if (ph::producible(s, t)) return {Fd, t};
    return nearest_of_reference_forces(J, Inverse::of(ph::transposed(J)), s, Fd);
  }
};

struct explicit_inverse {
  static matrix of(const matrix& Jt) { return Jt.inverse(); }
};

template <class Decomposition>
struct solving {
  static matrix of(const matrix& Jt) { return Decomposition(Jt).solve(matrix(matrix::Identity())); }
};

// Damped only where a singular value falls under a threshold: Chiaverini, Singularity-robust task-priority
// redundancy resolution for real-time kinematic control of robot manipulators, IEEE Trans. Robotics and
// Automation 13 (3), 1997.
struct damped_svd {
  static constexpr double threshold = 1e-3;    // of the largest singular value
  static constexpr double max_damping = 1e-3;  // the same
  static matrix of(const matrix& Jt) {
    const Eigen::JacobiSVD<matrix> svd(Jt, Eigen::ComputeFullU | Eigen::ComputeFullV);
    auto sigma = svd.singularValues();
    const double low = threshold * sigma[0], most = max_damping * sigma[0], share = sigma[2] / low;
    const double square = share < 1 ? (1 - share * share) * most * most : 0;
    sigma = sigma.array() / (sigma.array().square() + square);
    return svd.matrixV() * sigma.asDiagonal() * svd.matrixU().transpose();
  }
};

// ---- each joint for itself: torques of the wrong sign are left out

struct clamped_torques {
  answer operator()(const matrix& J, const vector& s, const vector& Fd) const {
    const vector t = J.transpose() * Fd;
    // It does not know what force this makes
    return {vector::Constant(std::numeric_limits<double>::quiet_NaN()),
            (s.array() * t.array() > 0).select(vector(vector::Zero()), t)};
  }
};

}  // namespace benchmarks
