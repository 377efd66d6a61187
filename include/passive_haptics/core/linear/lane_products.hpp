/// @file
/// What lanes come to together: sums, truths, and products of small matrices and vectors.
#pragma once

#include <passive_haptics/core/linear/lanes.hpp>

namespace passive_haptics {

/// x_0 + ... + x_{N-1}
template <class T, int N>
T sum(const lanes<T, N>& x) {
  T all = x[0];
  unrolled<N - 1>([&](auto i) { all += x[i + 1]; });
  return all;
}

/// (x_0 + x_1, y_0 + y_1), added crosswise.
template <class T>
lanes<T, 2> sums(const lanes<T, 2>& x, const lanes<T, 2>& y) {
  if constexpr (lanes<T, 2>::width != 2) return lanes<T, 2>([&](int i) { return sum(i == 0 ? x : y); });
  else
    return lanes<T, 2>::each([&](auto k) {
      return __builtin_shufflevector(x.p[k], y.p[k], 0, 2) + __builtin_shufflevector(x.p[k], y.p[k], 1, 3);
    });
}

/// The least of x_0, ..., x_{N-1}.
template <class T, int N>
T least(const lanes<T, N>& x) {
  T most = x[0];
  unrolled<N - 1>([&](auto i) { most = x[i + 1] < most ? x[i + 1] : most; });
  return most;
}

/// Whether it is true of some.
template <class T, int N>
bool any(const lane_mask<T, N>& x) {
  bool some = false;
  unrolled<N>([&](auto i) { some |= x[i]; });
  return some;
}

/// Bit i is truth i.
template <class T, int N>
[[gnu::always_inline]] inline unsigned bits(const lane_mask<T, N>& x) {
  unsigned all = 0;
  if constexpr (lane_mask<T, N>::width == 4) {
    unrolled<lane_mask<T, N>::count>([&](auto k) {
      auto some = x.p[k] & typename detail::truths_of<T>::type{1, 2, 4, 8};
      some |= __builtin_shufflevector(some, some, 2, 3, 0, 1);
      some |= __builtin_shufflevector(some, some, 1, 0, 3, 2);
      all |= static_cast<unsigned>(some[0]) << 4 * k;
    });
    if constexpr (N % 4 != 0) all &= (1u << N) - 1;  // what is beyond N is of no interest
  } else {
    unrolled<N>([&](auto i) { all |= static_cast<unsigned>(x[i]) << i; });
  }
  return all;
}

/// Row i of A.
template <class T, int R, int C>
lanes<T, C> row(const matrix<T, R, C>& A, int i) {
  return lanes<T, C>([&](int j) { return A(i, j); });
}

/// A x
template <class T, int R, int C>
vector<T, R> times(const matrix<T, R, C>& A, const vector<T, C>& x) {
  const auto column = [&](int j) { return lanes<T, R>([&](int i) { return A(i, j); }); };
  lanes<T, R> y = column(0) * x[0];
  unrolled<C - 1>([&](auto j) { y = y + column(j + 1) * x[j + 1]; });
  return y;
}

/// A^T x
template <class T, int R, int C>
vector<T, C> transposed_times(const matrix<T, R, C>& A, const vector<T, R>& x) {
  lanes<T, C> y = row(A, 0) * x[0];
  unrolled<R - 1>([&](auto i) { y = y + row(A, i + 1) * x[i + 1]; });
  return y;
}

/// A B
template <class T, int R, int K, int C>
matrix<T, R, C> times(const matrix<T, R, K>& A, const matrix<T, K, C>& B) {
  matrix<T, R, C> AB;
  unrolled<R>([&](auto i) {
    const vector<T, C> y = transposed_times(B, vector<T, K>(A.row(i)));
    unrolled<C>([&](auto j) { AB(i, j) = y[j]; });
  });
  return AB;
}

/// A B where one is diagonal.
template <class A, class B>
auto times(const A& a, const B& b) {
  return (a * b).eval();
}

}  // namespace passive_haptics
