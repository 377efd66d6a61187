/// Sums and products of small matrices, evaluated immediately.
///
/// Eigen's operators return expressions with a type each, which are slow to compile. At these sizes, plain
/// values cost the same number of instructions. In the library, these operators are preferred if both
/// operands are matrices; otherwise Eigen's are used. Write x.array() for an expression in a single pass.
#pragma once

#include <passive_haptics/core/flatten.hpp>

#include <Eigen/Core>

#include <concepts>

namespace passive_haptics {

namespace detail {
template <class X, class T>
concept scales = std::same_as<X, T> || std::integral<X>;
}  // namespace detail

/// A + B
template <class T, int R, int C>
  requires(R > 0 && C > 0)
PASSIVE_HAPTICS_INLINE inline Eigen::Matrix<T, R, C> operator+(const Eigen::Matrix<T, R, C>& A,
                                                               const Eigen::Matrix<T, R, C>& B) {
  return A.operator+(B);
}

/// A - B
template <class T, int R, int C>
  requires(R > 0 && C > 0)
PASSIVE_HAPTICS_INLINE inline Eigen::Matrix<T, R, C> operator-(const Eigen::Matrix<T, R, C>& A,
                                                               const Eigen::Matrix<T, R, C>& B) {
  return A.operator-(B);
}

/// -A
template <class T, int R, int C>
  requires(R > 0 && C > 0)
PASSIVE_HAPTICS_INLINE inline Eigen::Matrix<T, R, C> operator-(const Eigen::Matrix<T, R, C>& A) {
  return A.operator-();
}

/// a A
template <class T, int R, int C, detail::scales<T> X>
  requires(R > 0 && C > 0)
PASSIVE_HAPTICS_INLINE inline Eigen::Matrix<T, R, C> operator*(const X& a, const Eigen::Matrix<T, R, C>& A) {
  return A.operator*(static_cast<T>(a));
}

/// A a
template <class T, int R, int C, detail::scales<T> X>
  requires(R > 0 && C > 0)
PASSIVE_HAPTICS_INLINE inline Eigen::Matrix<T, R, C> operator*(const Eigen::Matrix<T, R, C>& A, const X& a) {
  return A.operator*(static_cast<T>(a));
}

/// A / a
template <class T, int R, int C, detail::scales<T> X>
  requires(R > 0 && C > 0)
PASSIVE_HAPTICS_INLINE inline Eigen::Matrix<T, R, C> operator/(const Eigen::Matrix<T, R, C>& A, const X& a) {
  return A.operator/(static_cast<T>(a));
}

/// A B
template <class T, int R, int K, int C>
  requires(R > 0 && K > 0 && C > 0)
PASSIVE_HAPTICS_INLINE inline Eigen::Matrix<T, R, C> operator*(const Eigen::Matrix<T, R, K>& A,
                                                               const Eigen::Matrix<T, K, C>& B) {
  return A.operator*(B);
}

}  // namespace passive_haptics
