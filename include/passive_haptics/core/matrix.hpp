/// Fixed-size vectors and matrices, and concepts that compare their scalar, rows and columns exactly
/// (std::convertible_to accepts any fixed-size Eigen expression in unevaluated contexts).
#pragma once

#include <passive_haptics/core/arithmetic.hpp>
#include <passive_haptics/core/eager_operators.hpp>
#include <passive_haptics/core/flatten.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>

#if !EIGEN_VERSION_AT_LEAST(3, 4, 0)
#error "passive_haptics needs Eigen 3.4 or newer: this file includes an older one, look at the compiler's -I."
#endif

namespace passive_haptics {

/// Column vector of N scalars.
template <class T, int N>
using vector = Eigen::Matrix<T, N, 1>;

/// R x C matrix.
template <class T, int R, int C>
using matrix = Eigen::Matrix<T, R, C>;

/// N x N diagonal matrix.
template <class T, int N>
using diagonal_matrix = Eigen::DiagonalMatrix<T, N>;

/// An R x C matrix of T in Eigen's default storage; not an expression, which could refer to temporaries.
template <class X, class T, int R, int C>
concept ExactMatrix = std::same_as<std::remove_cvref_t<X>, matrix<T, R, C>>;

/// A column vector of exactly N scalars T.
template <class X, class T, int N>
concept ExactVector = ExactMatrix<X, T, N, 1>;

/// An N x N diagonal matrix of T.
template <class X, class T, int N>
concept ExactDiagonal = std::same_as<std::remove_cvref_t<X>, diagonal_matrix<T, N>>;

/// Returns A^T. (A.transpose() makes g++ 12 warn of uninitialised memory inside Eigen.)
template <class T, int R, int C>
matrix<T, C, R> transposed(const matrix<T, R, C>& A) {
  matrix<T, C, R> At;
  for (int i = 0; i < R; ++i) At.col(i) = A.row(i);
  return At;
}

/// Returns column j of A.
template <class T, int R, int C>
vector<T, R> column(const matrix<T, R, C>& A, int j) {
  return A.col(j);
}

/// Returns row i of A as a column vector.
template <class T, int R, int C>
vector<T, C> row_of(const matrix<T, R, C>& A, int i) {
  vector<T, C> a;
  unrolled<C>([&](auto j) { a[j] = A(i, j); });
  return a;
}

/// Sets row i of A to x.
template <class T, int R, int C>
void set_row(matrix<T, R, C>& A, int i, const vector<T, C>& x) {
  unrolled<C>([&](auto j) { A(i, j) = x[j]; });
}

/// Element-wise product a_i b_i.
template <class T, int N>
vector<T, N> entrywise_product(const vector<T, N>& a, const vector<T, N>& b) {
  return a.cwiseProduct(b);
}

/// Returns diag(d) A.
template <class T, int R, int C>
matrix<T, R, C> scaled_rows(const vector<T, R>& d, matrix<T, R, C> A) {
  for (int i = 0; i < R; ++i) {
    for (int j = 0; j < C; ++j) A(i, j) *= d[i];
  }
  return A;
}

/// Element-wise absolute values.
template <class T, int R, int C>
matrix<T, R, C> absolute(const matrix<T, R, C>& A) {
  return A.cwiseAbs();
}

/// Appends rows of zeros to A, for `Rows` rows in total.
template <int Rows, class T, int R, int C>
matrix<T, Rows, C> padded(const matrix<T, R, C>& A) {
  static_assert(R <= Rows);
  matrix<T, Rows, C> tall = matrix<T, Rows, C>::Zero();
  tall.template topRows<R>() = A;
  return tall;
}

/// Converts each entry to To.
template <class To, class T, int N>
vector<To, N> as(const vector<T, N>& x) {
  vector<To, N> y;
  unrolled<N>([&](auto i) { y[i] = static_cast<To>(x[i]); });
  return y;
}

/// |x| without overflow or underflow of its square. (Eigen's stableNorm is slow to compile.)
template <class T, int N>
T length_of(const vector<T, N>& x) {
  using std::abs, std::sqrt;
  using real = std::numeric_limits<T>;
  if (const T square = x.squaredNorm(); square > real::min() / real::epsilon() && square <= real::max())
    return sqrt(square);
  T largest(0);
  for (int i = 0; i < N; ++i) {
    if (!(abs(x[i]) <= largest)) largest = abs(x[i]);
  }
  if (!(largest > T(0) && largest <= real::max())) return largest;
  const vector<T, N> scaled = x / largest;
  return largest * sqrt(scaled.squaredNorm());
}

/// x / |x| for a finite x, without overflow or underflow of its square; 0 for x = 0.
template <class T, int N>
vector<T, N> direction_of(const vector<T, N>& x) {
  using std::abs, std::sqrt;
  T largest(0);
  for (int i = 0; i < N; ++i) largest = std::max(largest, abs(x[i]));
  if (!(largest > T(0))) return x;
  const vector<T, N> scaled = x / largest;
  return scaled / sqrt(scaled.squaredNorm());
}

/// Returns ||A| |x||, the magnitude of the terms of A x: the rounding error of A x is a few eps times this.
template <class T, int Rows, int Columns>
T size_of_terms(const matrix<T, Rows, Columns>& A, const vector<T, Columns>& x) {
  return vector<T, Rows>(absolute(A) * absolute(x)).norm();
}

/// Returns the scalar a x b.
template <class T>
T cross_in_plane(const vector<T, 2>& a, const vector<T, 2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// Returns a x b. (Eigen's cross requires a complex conjugate, which not every scalar has.)
template <class T>
vector<T, 3> cross(const vector<T, 3>& a, const vector<T, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Determinant of a 2 x 2 or 3 x 3 matrix. (Eigen's is in <Eigen/LU>.)
template <class T, int N>
T determinant(const matrix<T, N, N>& A) {
  if constexpr (N == 2) return cross_in_plane<T>(A.col(0), A.col(1));
  else return A.col(0).dot(cross<T>(A.col(1), A.col(2)));
}

/// Matrix of these entries, row by row. (Eigen's nested-list constructor costs 70 instructions for 2 x 2.)
template <int R, int C, class T, class... Rest>
matrix<T, R, C> matrix_of(T first, Rest... rest) {
  static_assert(1 + sizeof...(Rest) == static_cast<std::size_t>(R * C));
  matrix<T, R, C> A;
  int k = 0;
  const auto append = [&](T entry) {
    A(k / C, k % C) = entry;
    ++k;
  };
  append(first);
  (append(rest), ...);
  return A;
}

/// The N x N identity.
template <class T, int N>
matrix<T, N, N> identity_matrix() {
  return matrix<T, N, N>::Identity();
}

}  // namespace passive_haptics
