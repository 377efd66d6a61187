/// @file
/// Sums and products of small matrices, evaluated at once.
///
/// Eigen's operators return expressions, each of a type of its own, which costs a compiler some milliseconds,
/// and a nested one as many again. At sizes like these a value takes a control cycle no more instructions,
/// and all functions share its type. Inside the library these operators are preferred where both sides are
/// matrices; elsewhere Eigen's are found. Where one pass over the numbers counts, x.array() is an expression.
#pragma once

#include <Eigen/Core>

#include <concepts>

namespace passive_haptics {

namespace detail {
// A number that scales matrices of T; others are left to Eigen.
template <class X, class T>
concept scales = std::same_as<X, T> || std::integral<X>;
}  // namespace detail

/// A + B
template <class T, int R, int C>
  requires(R > 0 && C > 0)
[[gnu::always_inline]] inline Eigen::Matrix<T, R, C> operator+(const Eigen::Matrix<T, R, C>& A,
                                                               const Eigen::Matrix<T, R, C>& B) {
  return A.operator+(B);
}

/// A - B
template <class T, int R, int C>
  requires(R > 0 && C > 0)
[[gnu::always_inline]] inline Eigen::Matrix<T, R, C> operator-(const Eigen::Matrix<T, R, C>& A,
                                                               const Eigen::Matrix<T, R, C>& B) {
  return A.operator-(B);
}

/// -A
template <class T, int R, int C>
  requires(R > 0 && C > 0)
[[gnu::always_inline]] inline Eigen::Matrix<T, R, C> operator-(const Eigen::Matrix<T, R, C>& A) {
  return A.operator-();
}

/// a A
template <class T, int R, int C, detail::scales<T> X>
  requires(R > 0 && C > 0)
[[gnu::always_inline]] inline Eigen::Matrix<T, R, C> operator*(const X& a, const Eigen::Matrix<T, R, C>& A) {
  return A.operator*(static_cast<T>(a));
}

/// A a
template <class T, int R, int C, detail::scales<T> X>
  requires(R > 0 && C > 0)
[[gnu::always_inline]] inline Eigen::Matrix<T, R, C> operator*(const Eigen::Matrix<T, R, C>& A, const X& a) {
  return A.operator*(static_cast<T>(a));
}

/// A / a
template <class T, int R, int C, detail::scales<T> X>
  requires(R > 0 && C > 0)
[[gnu::always_inline]] inline Eigen::Matrix<T, R, C> operator/(const Eigen::Matrix<T, R, C>& A, const X& a) {
  return A.operator/(static_cast<T>(a));
}

/// A B
template <class T, int R, int K, int C>
  requires(R > 0 && K > 0 && C > 0)
[[gnu::always_inline]] inline Eigen::Matrix<T, R, C> operator*(const Eigen::Matrix<T, R, K>& A,
                                                               const Eigen::Matrix<T, K, C>& B) {
  return A.operator*(B);
}

}  // namespace passive_haptics
