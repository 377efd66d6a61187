/// Cholesky decomposition of a small symmetric matrix.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <cmath>

namespace passive_haptics {

/// Decomposition A = L D L^T of a symmetric positive definite A, from its lower triangle, with a unit lower
/// triangular L and a diagonal D. Without pivoting. If A is singular, solve() sets the unknown of a zero
/// pivot to 0; NaN in A gives NaN. Plain loops compile much faster than Eigen's decompositions. Cost: N^3/6.
template <class T, int N>
class cholesky {
 public:
  /// Decomposes A.
  explicit cholesky(const matrix<T, N, N>& A) : l_(A) {
    for (int j = 0; j < N; ++j) {
      for (int k = 0; k < j; ++k) {
        const T scaled = l_(j, k) * pivot_[k];
        for (int i = j; i < N; ++i) l_(i, j) -= l_(i, k) * scaled;
      }
      pivot_[j] = l_(j, j);
      for (int i = j + 1; i < N; ++i) l_(i, j) = over_pivot(l_(i, j), j);
    }
  }

  /// True if all pivots are positive; false for NaN.
  bool is_positive_definite() const {
    bool is_positive = true;
    for (int i = 0; i < N; ++i) is_positive = is_positive && pivot_[i] > T(0);
    return is_positive;
  }

  /// Returns A^-1 B.
  template <int C>
  matrix<T, N, C> solve(const matrix<T, N, C>& B) const {
    matrix<T, N, C> X = lower_solve(B);
    for (int c = 0; c < C; ++c) {
      for (int i = 0; i < N; ++i) X(i, c) = over_pivot(X(i, c), i);
      for (int i = N; i-- > 0;) {
        for (int k = i + 1; k < N; ++k) X(i, c) -= l_(k, i) * X(k, c);
      }
    }
    return X;
  }

  /// Returns X = (L D^1/2)^-1 B, so X^T X = B^T A^-1 B. NaN or infinite if A is not positive definite.
  template <int C>
  matrix<T, N, C> half_solve(const matrix<T, N, C>& B) const {
    matrix<T, N, C> X = lower_solve(B);
    for (int i = 0; i < N; ++i) {
      const T root = std::sqrt(pivot_[i]);
      for (int c = 0; c < C; ++c) X(i, c) /= root;
    }
    return X;
  }

  /// Returns y = (L D^1/2)^T x, so |y|^2 = x^T A x, for a positive definite A.
  vector<T, N> half_product(const vector<T, N>& x) const {
    vector<T, N> y = x;
    for (int i = 0; i < N; ++i) {
      for (int k = i + 1; k < N; ++k) y[i] += l_(k, i) * x[k];
      y[i] *= std::sqrt(pivot_[i]);
    }
    return y;
  }

 private:
  T over_pivot(T x, int i) const { return pivot_[i] == T(0) ? x * T(0) : x / pivot_[i]; }  // keeps NaN

  // L^-1 B
  template <int C>
  matrix<T, N, C> lower_solve(matrix<T, N, C> X) const {
    for (int c = 0; c < C; ++c) {
      for (int i = 0; i < N; ++i) {
        for (int k = 0; k < i; ++k) X(i, c) -= l_(i, k) * X(k, c);
      }
    }
    return X;
  }

  matrix<T, N, N> l_;  // strictly below the diagonal
  vector<T, N> pivot_;
};

}  // namespace passive_haptics
