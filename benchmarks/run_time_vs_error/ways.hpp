/// @file
/// Ways to the nearest displayable force Fp of a desired force, for as many brakes as task dimensions.
#pragma once

#include <passive_haptics/force/approximation.hpp>

#include <Eigen/Dense>

#include <limits>

namespace benchmarks {

namespace ph = passive_haptics;

template <class T, int D>
struct answer {
  ph::vector<T, D> force;   // Fp [N]
  ph::vector<T, D> torque;  // of the brakes [N m]
};

// ---- ours: half-spaces, no inverse

struct half_spaces {
  template <class T, int D>
  answer<T, D> operator()(const ph::matrix<T, D, D>& J, const ph::vector<T, D>& s,
                          const ph::vector<T, D>& Fd) const {
    const ph::vector<T, D> t = ph::brake_torque(J, Fd);
    if (ph::producible(s, t)) return {Fd, t};
    const auto nearest = ph::nearest_force(J, s, Fd);
    ph::vector<T, D> tp = ph::brake_torque(J, nearest.force);
    for (int i = 0; i < D; ++i) {
      if ((nearest.active >> i & 1u) != 0 || s[i] * tp[i] > T(0)) tp[i] = T(0);
    }
    return {nearest.force, tp};
  }
};

// ---- the paper's way: reference forces G = J^-T, then the nearest of them (Fig. 3)

// In space the nearest force may also lie on a face between two reference forces. Of the feet of Fd on rays
// and faces of the cone the longest is the nearest.
template <class T, int D>
answer<T, D> nearest_of_reference_forces(const ph::matrix<T, D, D>& J, const ph::matrix<T, D, D>& G,
                                         const ph::vector<T, D>& s, const ph::vector<T, D>& Fd) {
  using force = ph::vector<T, D>;
  answer<T, D> best{force::Zero(), force::Zero()};
  T longest = T(0);
  for (int i = 0; i < D; ++i) {
    const force along = -s[i] * G.col(i);
    const T length = along.norm(), component = along.dot(Fd) / length;
    if (!(component > longest)) continue;
    longest = component;
    best.force = component / length * along;
    best.torque = -s[i] * component / length * force::Unit(i);
  }
  if constexpr (D == 3) {
    for (int i = 0; i < D; ++i) {
      const int a = (i + 1) % D, b = (i + 2) % D;
      const force normal = G.col(a).cross(G.col(b)).normalized();
      const force foot = Fd - normal.dot(Fd) * normal;
      force t = J.transpose() * foot;  // coefficients on the reference forces
      t[i] = T(0);
      if (!ph::producible(s, t) || !(foot.norm() > longest)) continue;
      longest = foot.norm();
      best = {foot, t};
    }
  }
  return best;
}

template <class Inverse>
struct reference_forces_by {
  template <class T, int D>
  answer<T, D> operator()(const ph::matrix<T, D, D>& J, const ph::vector<T, D>& s,
                          const ph::vector<T, D>& Fd) const {
    const ph::vector<T, D> t = J.transpose() * Fd;
    if (ph::producible(s, t)) return {Fd, t};
    const ph::matrix<T, D, D> Jt = ph::transposed(J);
    return nearest_of_reference_forces<T, D>(J, Inverse::of(Jt), s, Fd);
  }
};

struct explicit_inverse {
  template <class Square>
  static Square of(const Square& Jt) {
    return Jt.inverse();
  }
};

template <template <class> class Decomposition>
struct solving {
  template <class Square>
  static Square of(const Square& Jt) {
    return Decomposition<Square>(Jt).solve(Square(Square::Identity()));
  }
};
template <class Square>
using partial_lu = Eigen::PartialPivLU<Square>;
template <class Square>
using pivoted_qr = Eigen::ColPivHouseholderQR<Square>;
template <class Square>
using orthogonal = Eigen::CompleteOrthogonalDecomposition<Square>;

// Damped only where a singular value falls under a threshold: Chiaverini, Singularity-robust task-priority
// redundancy resolution for real-time kinematic control of robot manipulators, IEEE Trans. Robotics and
// Automation 13 (3), 1997.
struct damped_svd {
  static constexpr double threshold = 1e-3;    // of the largest singular value
  static constexpr double max_damping = 1e-3;  // the same
  template <class Square>
  static Square of(const Square& Jt) {
    using T = typename Square::Scalar;
    const Eigen::JacobiSVD<Square> svd(Jt, Eigen::ComputeFullU | Eigen::ComputeFullV);
    auto sigma = svd.singularValues();
    const T low = static_cast<T>(threshold) * sigma[0], most = static_cast<T>(max_damping) * sigma[0];
    const T share = sigma[sigma.size() - 1] / low;
    const T square = share < T(1) ? (T(1) - share * share) * most * most : T(0);
    sigma = sigma.array() / (sigma.array().square() + square);
    return svd.matrixV() * sigma.asDiagonal() * svd.matrixU().transpose();
  }
};

// ---- each joint for itself: torques of the wrong sign are left out

struct clamped_torques {
  template <class T, int D>
  answer<T, D> operator()(const ph::matrix<T, D, D>& J, const ph::vector<T, D>& s,
                          const ph::vector<T, D>& Fd) const {
    const ph::vector<T, D> t = J.transpose() * Fd;
    const ph::vector<T, D> none = ph::vector<T, D>::Zero();
    return {ph::vector<T, D>::Constant(
                std::numeric_limits<T>::quiet_NaN()),  // it does not know what force this makes
            (s.array() * t.array() > T(0)).select(none, t)};
  }
};

}  // namespace benchmarks
