/// @file
/// Complete orthogonal decomposition of a small matrix of any rank.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace passive_haptics {

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
    vector<T, most> y;
    for (int k = rank_ - 1; k >= 0; --k) {  // R y = U^T b
      y[k] = dot(u_[at(k)], b);
      for (int l = k + 1; l < rank_; ++l) y[k] -= r_(k, l) * y[l];
      y[k] /= r_(k, k);
      add_scaled(x, y[k], v_[at(k)]);
    }
    return x;
  }

  /// (A^T)^+ g: the shortest of the least-squares solutions of A^T x = g.
  vector<T, Rows> solve_transposed(const vector<T, N>& g) const {
    vector<T, Rows> x = vector<T, Rows>::Zero();
    vector<T, most> y;
    for (int k = 0; k < rank_; ++k) {  // R^T y = V^T g
      y[k] = dot(v_[at(k)], g);
      for (int l = 0; l < k; ++l) y[k] -= r_(l, k) * y[l];
      y[k] /= r_(k, k);
      add_scaled(x, y[k], u_[at(k)]);
    }
    return x;
  }

  /// A^+.
  matrix<T, N, Rows> pseudo_inverse() const {
    matrix<T, N, Rows> inverse;
    for (int j = 0; j < Rows; ++j) {
      vector<T, Rows> b;
      for (int i = 0; i < Rows; ++i) b[i] = T(i == j);
      const vector<T, N> column = solve(b);
      for (int i = 0; i < N; ++i) inverse(i, j) = column[i];
    }
    return inverse;
  }

  /// x less its part in the row space of A: A times it is 0.
  vector<T, N> without_row_space(vector<T, N> x) const {
    remove(x, v_, rank_);
    return x;
  }

  /// I - U U^T, the orthogonal projection on the b with A^T b = 0.
  matrix<T, Rows, Rows> left_null_projection() const {
    matrix<T, Rows, Rows> P = matrix<T, Rows, Rows>::Identity();
    for (int k = 0; k < rank_; ++k) {
      const vector<T, Rows>& u = u_[at(k)];
      for (int i = 0; i < Rows; ++i) {
        for (int j = 0; j < Rows; ++j) P(i, j) -= u[i] * u[j];
      }
    }
    return P;
  }

 private:
  static constexpr int most = Rows < N ? Rows : N;

  static constexpr std::size_t at(int i) { return static_cast<std::size_t>(i); }

  // x less its parts along the first `count` of these unit vectors, twice: once leaves rounding of x.
  template <int Size>
  static void remove(vector<T, Size>& x, const std::array<vector<T, Size>, at(most)>& along, int count) {
    for (int pass = 0; pass < 2; ++pass) {
      vector<T, most> part;
      for (int k = 0; k < count; ++k) part[k] = dot(along[at(k)], x);
      for (int k = 0; k < count; ++k) add_scaled(x, -part[k], along[at(k)]);
    }
  }

  void find_row_space(const matrix<T, Rows, N>& A, T tolerance) {
    std::array<vector<T, N>, at(Rows)> rest;
    T longest = T(0);
    for (int i = 0; i < Rows; ++i) {
      for (int j = 0; j < N; ++j) rest[at(i)][j] = A(i, j);
      longest = std::max(longest, norm(rest[at(i)]));
    }
    for (rank_ = 0; rank_ < most; ++rank_) {
      int pivot = -1;
      T length = tolerance * longest;
      for (int i = 0; i < Rows; ++i) {
        remove(rest[at(i)], v_, rank_);
        if (const T size = norm(rest[at(i)]); size > length) {
          length = size;
          pivot = i;
        }
      }
      if (pivot < 0) return;
      for (int j = 0; j < N; ++j) v_[at(rank_)][j] = rest[at(pivot)][j] / length;
    }
  }

  void find_column_space(const matrix<T, Rows, N>& A) {
    for (int k = 0; k < rank_; ++k) {
      vector<T, Rows>& u = u_[at(k)];
      u = product(A, v_[at(k)]);
      for (int pass = 0; pass < 2; ++pass) {
        for (int l = 0; l < k; ++l) {
          const T along = dot(u_[at(l)], u);
          r_(l, k) += along;
          add_scaled(u, -along, u_[at(l)]);
        }
      }
      r_(k, k) = norm(u);
      for (int i = 0; i < Rows; ++i) u[i] /= r_(k, k);
    }
  }

  int rank_ = 0;
  std::array<vector<T, Rows>, at(most)> u_;  // orthonormal columns of U
  std::array<vector<T, N>, at(most)> v_;     // and of V
  matrix<T, most, most> r_ = matrix<T, most, most>::Zero();
};

}  // namespace passive_haptics
