/// Constraint of legs that meet at the handle: distal links of constant length.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/mechanism/models/closed_chain.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace passive_haptics {

/// N legs in N dimensions, each with a lever a_i from its base joint to its elbow, which rotates at the rate
/// qd_i, and a distal link r_i from the elbow to the handle. As |r_i| is constant,
///
///     A v = B qd,   A = [r_i^T],   B = diag(r_i . a'_i),   a'_i = da_i / dq_i,   a''_i = -a_i.
template <class T, int N>
struct distal_links {
  matrix<T, N, N> link;     ///< A [m]: row i is r_i^T.
  matrix<T, N, N> lever;    ///< Column i is a_i [m].
  matrix<T, N, N> tangent;  ///< Column i is a'_i [m/rad].
  vector<T, N> handle;      ///< Handle [m].
  T lengths;                ///< prod |r_i| [m^N], the scale of det A.

  /// Diagonal of B [m^2/rad].
  vector<T, N> drive() const { return link.cwiseProduct(tangent.transpose()).rowwise().sum(); }

  /// J = A^-1 B [m/rad]; not finite if A is singular to rounding.
  matrix<T, N, N> jacobian() const { return solved(drive()); }

  /// J^-1 = B^-1 A [rad/m]; not finite if B is singular.
  matrix<T, N, N> inverse_jacobian() const { return drive().cwiseInverse().asDiagonal() * link; }

  /// Minimum of |B_ii| / (|r_i| |a'_i|), and |det A| / prod |r_i|.
  chain_conditioning<T> conditioning() const {
    const vector<T, N> length = link.rowwise().norm();
    const matrix<T, N, N> unit = link.array().colwise() / length.array();
    const vector<T, N> arm = tangent.colwise().norm();
    const vector<T, N> sines = drive().cwiseAbs().cwiseQuotient(length).cwiseQuotient(arm);
    const T least = sines.template minCoeff<Eigen::PropagateNaN>();
    // In this order std::min keeps a NaN
    return {std::min(least, T(1)), std::min(std::abs(determinant(unit)), T(1))};
  }

  /// Jd qd [m/s^2] from the second derivative, r_i . (xdd + a_i qd_i^2) + |v - a'_i qd_i|^2 = 0.
  vector<T, N> bias_acceleration(const matrix<T, N, N>& J, const vector<T, N>& qd) const {
    const vector<T, N> v = J * qd;
    vector<T, N> right;
    for (int i = 0; i < N; ++i)
      right[i] = -qd[i] * qd[i] * link.row(i).dot(lever.col(i)) - (v - qd[i] * tangent.col(i)).squaredNorm();
    return solved(right).rowwise().sum();
  }

 private:
  // A^-1 diag(b) by Cramer's rule.
  matrix<T, N, N> solved(const vector<T, N>& b) const {
    static_assert(N == 2 || N == 3);
    if constexpr (N == 2) {
      const T inverse = inverse_of(determinant(link));
      const T b0 = b[0] * inverse, b1 = b[1] * inverse;
      return matrix_of<2, 2>(b0 * link(1, 1), -b1 * link(0, 1), -b0 * link(1, 0), b1 * link(0, 0));
    } else {
      const vector<T, 3> r1 = link.row(0), r2 = link.row(1), r3 = link.row(2);
      matrix<T, 3, 3> X;
      X << cross(r2, r3), cross(r3, r1), cross(r1, r2);
      return X * (b * inverse_of(r1.dot(X.col(0)))).asDiagonal();
    }
  }

  // 1 / det A; NaN if det A is only rounding.
  T inverse_of(T det) const {
    const bool regular = std::abs(det) > rounding_tolerance<T>(N) * lengths;
    return regular ? T(1) / det : std::numeric_limits<T>::quiet_NaN();
  }
};

}  // namespace passive_haptics
