/// @file
/// Complete orthogonal decomposition of a small matrix of any rank.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <algorithm>

namespace passive_haptics {

/// A = U R V^T with orthonormal columns of U (rows x r) and V (N x r), R (r x r) upper triangular and r the numerical
/// rank: gives least-squares solutions of least norm for any A. Zero rows cost little: a matrix with fewer rows is filled up with them.
///
/// By Gram-Schmidt with reorthogonalisation over pivoted rows (V) and then over columns (U): no products of A with
/// itself, everything on the stack, quick to compile. A row that is shorter than `tolerance` times the longest after
/// the others were taken out of it counts as dependent.
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
    vector<T, most> y = vector<T, most>::Zero();
    for (int k = rank_ - 1; k >= 0; --k) {  // R y = U^T b
      T rest = u_.col(k).dot(b);
      for (int l = k + 1; l < rank_; ++l) rest -= r_(k, l) * y[l];
      y[k] = rest / r_(k, k);
    }
    return v_ * y;
  }

  /// (A^T)^+ g: the shortest of the least-squares solutions of A^T x = g.
  vector<T, Rows> solve_transposed(const vector<T, N>& g) const {
    vector<T, most> y = vector<T, most>::Zero();
    for (int k = 0; k < rank_; ++k) {  // R^T y = V^T g
      T rest = v_.col(k).dot(g);
      for (int l = 0; l < k; ++l) rest -= r_(l, k) * y[l];
      y[k] = rest / r_(k, k);
    }
    return u_ * y;
  }

  /// x less its part in the row space of A: A times it is 0.
  vector<T, N> without_row_space(vector<T, N> x) const {
    for (int pass = 0; pass < 2; ++pass) x -= v_ * (v_.transpose() * x);
    return x;
  }

  /// U U^T, the orthogonal projection on the column space of A.
  matrix<T, Rows, Rows> column_projection() const { return u_ * u_.transpose(); }

 private:
  static constexpr int most = Rows < N ? Rows : N;

  void find_row_space(const matrix<T, Rows, N>& A, T tolerance) {
    matrix<T, Rows, N> rest = A;
    T longest = T(0);
    for (int i = 0; i < Rows; ++i) longest = std::max(longest, A.row(i).norm());
    for (rank_ = 0; rank_ < most; ++rank_) {
      int pivot = -1;
      T length = tolerance * longest;
      for (int i = 0; i < Rows; ++i) {
        for (int pass = 0; pass < 2 && rank_ > 0; ++pass) {
          rest.row(i) -= (rest.row(i) * v_) * v_.transpose();
        }
        if (const T norm = rest.row(i).norm(); norm > length) {
          length = norm;
          pivot = i;
        }
      }
      if (pivot < 0) return;
      v_.col(rank_) = rest.row(pivot).transpose() / length;
    }
  }

  void find_column_space(const matrix<T, Rows, N>& A) {
    for (int k = 0; k < rank_; ++k) {
      vector<T, Rows> c = vector<T, Rows>::Zero();
      for (int i = 0; i < Rows; ++i) c[i] = A.row(i).dot(v_.col(k));
      for (int pass = 0; pass < 2; ++pass) {
        for (int l = 0; l < k; ++l) {
          const T along = u_.col(l).dot(c);
          r_(l, k) += along;
          c -= along * u_.col(l);
        }
      }
      r_(k, k) = c.norm();
      u_.col(k) = c / r_(k, k);
    }
  }

  int rank_ = 0;
  matrix<T, Rows, most> u_ = matrix<T, Rows, most>::Zero();
  matrix<T, N, most> v_ = matrix<T, N, most>::Zero();
  matrix<T, most, most> r_ = matrix<T, most, most>::Zero();
};

}  // namespace passive_haptics
