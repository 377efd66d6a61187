/// @file
/// Products of small matrices and vectors, a number in each lane.
#pragma once

#include <passive_haptics/core/linear/lanes.hpp>

namespace passive_haptics {

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
