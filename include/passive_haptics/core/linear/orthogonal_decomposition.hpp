/// @file
/// Complete orthogonal decomposition of a small matrix of any rank.
#pragma once

#include <passive_haptics/core/matrix.hpp>

namespace passive_haptics {

/// Takes from x its parts along the first `count` columns of Q, which are orthonormal, and returns how much
/// of each that was, the others 0.
///
/// Classical Gram-Schmidt, twice: once leaves rounding of x, twice is enough (Kahan). Exact where the columns
/// are units of the base frame. What grows and shrinks by a column a step has a form of its own
/// (updatable_qr.hpp).
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
/// numerical rank: gives least-squares solutions of least norm for any A. Zero rows cost little: a matrix
/// with fewer rows is filled up with them.
///
/// By Gram-Schmidt with reorthogonalisation over pivoted rows (V) and then over columns (U): no products of A
/// with itself, everything on the stack, quick to compile. A row that is shorter than `tolerance` times the
/// longest after the others were taken out of it counts as dependent.
template <class T, int Rows, int N>
class orthogonal_decomposition {
 public:
  /// Decomposes A.
  orthogonal_decomposition(const matrix<T, Rows, N>& A, T tolerance) {
    find_row_space(A, tolerance);
    find_column_space(A);
  }

  /// Numerical rank r.
  int rank() const { return rank_; }

  /// A^+ b: the shortest of the least-squares solutions of A x = b.
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

  /// A^+ B, column by column.
  template <int C>
    requires(C > 1)
  matrix<T, N, C> solve(const matrix<T, Rows, C>& B) const {
    matrix<T, N, C> X;
    for (int j = 0; j < C; ++j) X.col(j) = solve(vector<T, Rows>(B.col(j)));
    return X;
  }

  /// (A^T)^+ g: the shortest of the least-squares solutions of A^T x = g.
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

  /// A^+.
  matrix<T, N, Rows> pseudo_inverse() const {
    return solve(matrix<T, Rows, Rows>(matrix<T, Rows, Rows>::Identity()));
  }

  /// x less its part in the row space of A: A times it is 0.
  vector<T, N> without_row_space(vector<T, N> x) const {
    orthogonalise(x, v_, rank_);
    return x;
  }

  /// b less its part in the column space of A: A^T times it is 0.
  vector<T, Rows> without_column_space(vector<T, Rows> b) const {
    orthogonalise(b, u_, rank_);
    return b;
  }

  /// Orthonormal x with A x = 0 in the first N - r columns; the others are 0. Each begins as that unit vector
  /// of which most is left, so that a few roundings of A change little of them.
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

  /// I - U U^T, the orthogonal projection on the b with A^T b = 0.
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
  matrix<T, Rows, max_rank> u_;      // the first r columns: orthonormal columns of U
  matrix<T, N, max_rank> v_;         // and of V
  matrix<T, max_rank, max_rank> r_;  // R
};

}  // namespace passive_haptics
