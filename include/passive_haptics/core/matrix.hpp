/// @file
/// Fixed-size vectors and matrices, and concepts that check their shape exactly.
///
/// Eigen converts any fixed-size expression to any other in an unevaluated context, so
/// std::convertible_to checks nothing; these concepts compare scalar, rows and columns.
#pragma once

#include <passive_haptics/core/arithmetic.hpp>

#include <Eigen/Core>

#include <concepts>
#include <type_traits>

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

/// An R x C matrix of T in Eigen's default storage: a value, not an expression (which could refer to dead
/// temporaries).
template <class X, class T, int R, int C>
concept ExactMatrix = std::same_as<std::remove_cvref_t<X>, matrix<T, R, C>>;

/// A column of exactly N scalars T.
template <class X, class T, int N>
concept ExactVector = ExactMatrix<X, T, N, 1>;

/// An N x N Eigen::DiagonalMatrix of T.
template <class X, class T, int N>
concept ExactDiagonal = std::same_as<std::remove_cvref_t<X>, diagonal_matrix<T, N>>;

/// A^T as a value. (Constructing it from A.transpose() makes g++ 12 warn of uninitialised memory inside Eigen.)
template <class T, int R, int C>
matrix<T, C, R> transposed(const matrix<T, R, C>& A) {
  matrix<T, C, R> At;
  for (int i = 0; i < R; ++i) At.col(i) = A.row(i);
  return At;
}

/// True if no entry is NaN or infinite.
template <class Derived>
bool all_finite(const Eigen::DenseBase<Derived>& x) {
  return x.allFinite();
}

/// True if no diagonal entry is NaN or infinite.
template <class T, int N>
bool all_finite(const diagonal_matrix<T, N>& x) {
  return x.diagonal().allFinite();
}

}  // namespace passive_haptics
