/// Dynamically consistent inverse of the Jacobian (Khatib 1987).
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/linear/cholesky.hpp>
#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>

#include <limits>

namespace passive_haptics {

/// Task force that accelerates the end effector like the joint torques tau (n): F = (J M^-1 J^T)^-1 J M^-1
/// tau. Equals J^-T tau for n = d; for n > d it excludes the effect of tau on the self-motion. Solves L^-1
/// J^T F = L^-1 tau with M = L L^T by least squares. Cost: a Cholesky decomposition of n x n and an
/// orthogonal decomposition of n x d. Source: Khatib, A unified approach for motion and force control, IEEE
/// J. Robotics and Automation 3 (1), 1987.
template <class T, int N, int D>
class dynamically_consistent_inverse {
 public:
  /// J (d x n) and M (n x n) in one pose. Rows of L^-1 J^T below this relative tolerance count as 0.
  dynamically_consistent_inverse(const matrix<T, D, N>& J, const matrix<T, N, N>& M, T tolerance = T(0))
      : mass_(M), A_(mass_.half_solve(transposed(J))), decomposition_(A_, tolerance) {}

  bool defined() const { return all_finite(A_); }  ///< True if J and M are finite and M is positive definite.
  /// True if J has full row rank, so that the inverse exists.
  bool exists() const { return decomposition_.rank() == D; }

  /// Forces [N] by columns for joint torques [N m] by columns; NaN if there is no inverse.
  template <int C>
  matrix<T, D, C> forces(const matrix<T, N, C>& torques) const {
    if (!exists()) return matrix<T, D, C>::Constant(std::numeric_limits<T>::quiet_NaN());
    return decomposition_.solve(mass_.half_solve(torques));
  }

 private:
  cholesky<T, N> mass_;
  matrix<T, N, D> A_;  // L^-1 J^T
  orthogonal_decomposition<T, N, D> decomposition_;
};

}  // namespace passive_haptics
