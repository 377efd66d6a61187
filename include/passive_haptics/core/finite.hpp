/// Test for NaN and infinity in scalars and matrices.
#pragma once

#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/core/matrix.hpp>

#include <concepts>

namespace passive_haptics {

namespace detail {

// 0, or NaN after a multiplication by NaN or infinity: one multiplication per number.
template <class T>
struct zero {
  T value = T(0);
};
template <class T, std::floating_point X>
auto operator*(zero<T> so_far, X x) {
  return zero<decltype(so_far.value * x)>{so_far.value * x};
}
template <class T, class X, int R, int C>
auto operator*(zero<T> so_far, const matrix<X, R, C>& x) {
  zero<decltype(so_far.value * X())> all{so_far.value};
  unrolled<C>([&](auto j) {
    zero<X> column;  // one chain per column, so that columns do not wait for each other
    unrolled<R>([&](auto i) { column = column * x(i, j); });
    all = all * column.value;
  });
  return all;
}
template <class T, class X, int N>
auto operator*(zero<T> so_far, const vector<X, N>& x) {
  zero<decltype(so_far.value * X())> all{so_far.value};
  unrolled<N>([&](auto i) { all = all * x[i]; });
  return all;
}
template <class T, class X, int N>
auto operator*(zero<T> so_far, const diagonal_matrix<X, N>& x) {
  return so_far * vector<X, N>(x.diagonal());
}

template <class X>
struct scalar_of {
  using type = typename X::Scalar;
};
template <std::floating_point X>
struct scalar_of<X> {
  using type = X;
};

}  // namespace detail

/// True if all arguments (numbers, vectors, matrices) are finite.
template <class First, class... Rest>
bool all_finite(const First& first, const Rest&... rest) {
  const detail::zero<typename detail::scalar_of<First>::type> nothing;
  return ((nothing * first) * ... * rest).value == 0;
}

}  // namespace passive_haptics
