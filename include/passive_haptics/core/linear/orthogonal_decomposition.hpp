/// Complete orthogonal decomposition of a small matrix of any rank.
#pragma once

#include <passive_haptics/core/matrix.hpp>

namespace passive_haptics {

/// Subtracts from x its projections on the first `count` columns of Q, which are orthonormal, and returns
/// their coefficients; the others are 0. Classical Gram-Schmidt, performed twice (Kahan). Exact if the
/// columns are unit vectors of the base frame.
template <class T, int N, int Columns>
vector<T, Columns> orthogonalise(vector<T, N>& x, const matrix<T, N, Columns>& Q, int count) {
  vector<T, Columns> parts = vector<T, Columns>::Zero(), part;
  for (int pass = 0; pass < 2; ++pass) {
    for (int k = 0; k < count; ++k) part[k] = Q.col(k).dot(x);
    for (int k = 0; k < count; ++k) {
      x -= part[k] * Q.col(k);
      parts[k] += part[k];
    }
  }
  return parts;
}

/// A = U R V^T with orthonormal columns of U (rows x r) and V (N x r), R (r x r) upper triangular and r the
/// numerical rank. Gives least-norm least-squares solutions for any A. Padding with rows of zeros costs
/// little. Uses Gram-Schmidt with reorthogonalisation over pivoted rows (V) and then over columns (U): no A^T
/// A, no heap. A row counts as dependent if its remainder is shorter than `tolerance` times the longest row.
template <class T, int Rows, int N>
class orthogonal_decomposition {
 public:
  /// Decomposes A.
  orthogonal_decomposition(const matrix<T, Rows, N>& A, T tolerance) {
    find_row_space(A, tolerance);
    find_column_space(A);
  }

  int rank() const { return rank_; }  ///< Numerical rank r.

  /// Returns A^+ b, the least-norm least-squares solution of A x = b.
  vector<T, N> solve(const vector<T, Rows>& b) const {
    vector<T, N> x = vector<T, N>::Zero();
    vector<T, max_rank> y;
    for (int k = rank_ - 1; k >= 0; --k) {  // R y = U^T b
      y[k] = u_.col(k).dot(b);
      for (int l = k + 1; l < rank_; ++l) y[k] -= r_(k, l) * y[l];
      y[k] /= r_(k, k);
      x += y[k] * v_.col(k);
    }
    return x;
  }

  /// Returns A^+ B.
  template <int C>
    requires(C > 1)
  matrix<T, N, C> solve(const matrix<T, Rows, C>& B) const {
    matrix<T, N, C> X;
    for (int j = 0; j < C; ++j) X.col(j) = solve(vector<T, Rows>(B.col(j)));
    return X;
  }

  /// Returns (A^T)^+ g, the least-norm least-squares solution of A^T x = g.
  vector<T, Rows> solve_transposed(const vector<T, N>& g) const {
    vector<T, Rows> x = vector<T, Rows>::Zero();
    vector<T, max_rank> y;
    for (int k = 0; k < rank_; ++k) {  // R^T y = V^T g
      y[k] = v_.col(k).dot(g);
      for (int l = 0; l < k; ++l) y[k] -= r_(l, k) * y[l];
      y[k] /= r_(k, k);
      x += y[k] * u_.col(k);
    }
    return x;
  }

  /// Returns A^+.
  matrix<T, N, Rows> pseudo_inverse() const {
    return solve(matrix<T, Rows, Rows>(matrix<T, Rows, Rows>::Identity()));
  }

  /// Returns the component of x in the null space of A.
  vector<T, N> without_row_space(vector<T, N> x) const {
    orthogonalise(x, v_, rank_);
    return x;
  }

  /// Returns the component of b in the null space of A^T.
  vector<T, Rows> without_column_space(vector<T, Rows> b) const {
    orthogonalise(b, u_, rank_);
    return b;
  }

  /// Orthonormal basis of the null space of A in the first N - r columns; the others are 0. Each column
  /// starts from the unit vector with the largest remainder, so that rounding in A changes the basis little.
  matrix<T, N, N> null_space() const {
    matrix<T, N, N> basis = matrix<T, N, N>::Zero(), rest;
    for (int i = 0; i < N; ++i) rest.col(i) = without_row_space(vector<T, N>::Unit(i));
    for (int k = 0; k < N - rank_; ++k) {
      int longest = 0;
      rest.colwise().squaredNorm().maxCoeff(&longest);
      basis.col(k) = rest.col(longest).normalized();
      for (int i = 0; i < N; ++i) {
        vector<T, N> x = rest.col(i);
        orthogonalise(x, basis, k + 1);
        rest.col(i) = x;
      }
    }
    return basis;
  }

  /// Returns I - U U^T, the orthogonal projection on the null space of A^T.
  matrix<T, Rows, Rows> left_null_projection() const {
    matrix<T, Rows, Rows> P = matrix<T, Rows, Rows>::Identity();
    for (int k = 0; k < rank_; ++k) P -= u_.col(k) * u_.col(k).transpose();
    return P;
  }

 private:
  static constexpr int max_rank = Rows < N ? Rows : N;

  void find_row_space(const matrix<T, Rows, N>& A, T tolerance) {
    matrix<T, N, Rows> rest = transposed(A);
    const T longest = rest.colwise().norm().maxCoeff();
    if (longest == T(0)) return;
    for (rank_ = 0; rank_ < max_rank; ++rank_) {
      int pivot = -1;
      T length = tolerance * longest;
      for (int i = 0; i < Rows; ++i) {
        rest.col(i) = without_row_space(rest.col(i));
        if (const T size = rest.col(i).norm(); size > length) {
          length = size;
          pivot = i;
        }
      }
      if (pivot < 0) return;
      v_.col(rank_) = rest.col(pivot) / length;
    }
  }

  void find_column_space(const matrix<T, Rows, N>& A) {
    for (int k = 0; k < rank_; ++k) {
      vector<T, Rows> u = A * v_.col(k);
      r_.col(k) = orthogonalise(u, u_, k);
      r_(k, k) = u.norm();
      u_.col(k) = u / r_(k, k);
    }
  }

  int rank_ = 0;
  matrix<T, Rows, max_rank> u_;  // r orthonormal columns of U
  matrix<T, N, max_rank> v_;     // and of V
  matrix<T, max_rank, max_rank> r_;
};

}  // namespace passive_haptics
