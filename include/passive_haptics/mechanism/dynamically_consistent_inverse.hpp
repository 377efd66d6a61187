/// @file
/// The dynamically consistent inverse: task force equivalent to joint torques (Khatib 1987).
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/linear/cholesky.hpp>
#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>

#include <limits>

namespace passive_haptics {

/// F = (J M^-1 J^T)^-1 J M^-1 tau: the force that accelerates the end effector as joint torques tau (n) do.
/// It is J^-T tau for n = d; for n > d what tau does to the self-motion is left out.
///
/// With M = L L^T it is the least-squares solution of L^-1 J^T F = L^-1 tau, so no Gram matrix is made. Cost:
/// a Cholesky of n x n and an orthogonal decomposition of n x d. Reference: Khatib, A unified approach for
/// motion and force control, IEEE J. Robotics and Automation 3 (1), 1987.
template <class T, int N, int D>
class dynamically_consistent_inverse {
 public:
  /// Of J (d x n) and M (n x n) in one pose. Rows of L^-1 J^T that are rounding by this tolerance count as 0.
  dynamically_consistent_inverse(const matrix<T, D, N>& J, const matrix<T, N, N>& M, T tolerance = T(0))
      : mass_(M), A_(mass_.half_solve(transposed(J))), decomposition_(A_, tolerance) {}

  /// Whether J and M were finite and M positive definite.
  bool defined() const { return all_finite(A_); }
  /// Whether J has full row rank, so that there is an inverse.
  bool exists() const { return decomposition_.rank() == D; }

  /// The forces [N], one a column, for joint torques by columns [N m]; NaN where there is no inverse.
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
