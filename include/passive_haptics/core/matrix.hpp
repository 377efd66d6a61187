/// @file
/// Fixed-size vectors and matrices, and concepts that check their shape exactly.
///
/// Eigen converts any fixed-size expression to any other in an unevaluated context, so
/// std::convertible_to checks nothing; these concepts compare scalar, rows and columns.
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

/// Column of N scalars.
template <class T, int N>
using vector = Eigen::Matrix<T, N, 1>;

/// R x C matrix.
template <class T, int R, int C>
using matrix = Eigen::Matrix<T, R, C>;

/// N x N diagonal matrix.
template <class T, int N>
using diagonal_matrix = Eigen::DiagonalMatrix<T, N>;

/// An R x C matrix of T in Eigen's default storage. A value, no expression: that could refer to temporaries
/// which are gone.
template <class X, class T, int R, int C>
concept ExactMatrix = std::same_as<std::remove_cvref_t<X>, matrix<T, R, C>>;

/// A column of exactly N scalars T.
template <class X, class T, int N>
concept ExactVector = ExactMatrix<X, T, N, 1>;

/// An N x N Eigen::DiagonalMatrix of T.
template <class X, class T, int N>
concept ExactDiagonal = std::same_as<std::remove_cvref_t<X>, diagonal_matrix<T, N>>;

/// A^T as a value. (Made from A.transpose() it has g++ 12 warn of uninitialised memory inside Eigen.)
template <class T, int R, int C>
matrix<T, C, R> transposed(const matrix<T, R, C>& A) {
  matrix<T, C, R> At;
  for (int i = 0; i < R; ++i) At.col(i) = A.row(i);
  return At;
}

/// Column j of A as a value.
template <class T, int R, int C>
vector<T, R> column(const matrix<T, R, C>& A, int j) {
  return A.col(j);
}

/// Row i of A as a value, upright.
template <class T, int R, int C>
vector<T, C> row_of(const matrix<T, R, C>& A, int i) {
  vector<T, C> a;
  unrolled<C>([&](auto j) { a[j] = A(i, j); });
  return a;
}

/// Makes x row i of A.
template <class T, int R, int C>
void set_row(matrix<T, R, C>& A, int i, const vector<T, C>& x) {
  unrolled<C>([&](auto j) { A(i, j) = x[j]; });
}

/// a_i b_i
template <class T, int N>
vector<T, N> entrywise_product(const vector<T, N>& a, const vector<T, N>& b) {
  return a.cwiseProduct(b);
}

/// diag(d) A: row i times d_i.
template <class T, int R, int C>
matrix<T, R, C> scaled_rows(const vector<T, R>& d, matrix<T, R, C> A) {
  for (int i = 0; i < R; ++i) {
    for (int j = 0; j < C; ++j) A(i, j) *= d[i];
  }
  return A;
}

/// |a_ij|
template <class T, int R, int C>
matrix<T, R, C> absolute(const matrix<T, R, C>& A) {
  return A.cwiseAbs();
}

/// A with rows of zeros under it, `Rows` rows in all.
template <int Rows, class T, int R, int C>
matrix<T, Rows, C> padded(const matrix<T, R, C>& A) {
  static_assert(R <= Rows);
  matrix<T, Rows, C> tall = matrix<T, Rows, C>::Zero();
  tall.template topRows<R>() = A;
  return tall;
}

/// x, each entry converted to To.
template <class To, class T, int N>
vector<To, N> as(const vector<T, N>& x) {
  vector<To, N> y;
  unrolled<N>([&](auto i) { y[i] = static_cast<To>(x[i]); });
  return y;
}

/// |x|, also where its square overflows or is denormal; not finite where a number of x is not. (Eigen's
/// stableNorm takes the compiler as long as a law.)
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

/// x / |x| of a finite x of any length but 0, also where its square or its length overflows or is denormal; 0
/// of 0.
template <class T, int N>
vector<T, N> direction_of(const vector<T, N>& x) {
  using std::abs, std::sqrt;
  T largest(0);
  for (int i = 0; i < N; ++i) largest = std::max(largest, abs(x[i]));
  if (!(largest > T(0))) return x;
  const vector<T, N> scaled = x / largest;
  return scaled / sqrt(scaled.squaredNorm());
}

/// Length of |A| |x|, of what adds up to A x: the rounding of A x is some eps times this, however short A x
/// is.
template <class T, int Rows, int Columns>
T size_of_terms(const matrix<T, Rows, Columns>& A, const vector<T, Columns>& x) {
  return vector<T, Rows>(absolute(A) * absolute(x)).norm();
}

/// a x b, a number.
template <class T>
T cross_in_plane(const vector<T, 2>& a, const vector<T, 2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// a x b. (Eigen's cross needs a complex conjugate of its scalar, which not every scalar has.)
template <class T>
vector<T, 3> cross(const vector<T, 3>& a, const vector<T, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// det A of 2 x 2 or 3 x 3. (Eigen's is in <Eigen/LU>.)
template <class T, int N>
T determinant(const matrix<T, N, N>& A) {
  if constexpr (N == 2) return cross_in_plane<T>(A.col(0), A.col(1));
  else return A.col(0).dot(cross<T>(A.col(1), A.col(2)));
}

/// The matrix of these entries, row by row. (Eigen's constructor from nested lists costs 70 instructions for
/// 2 x 2.)
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

/// The N x N identity as a value.
template <class T, int N>
matrix<T, N, N> identity_matrix() {
  return matrix<T, N, N>::Identity();
}

}  // namespace passive_haptics
