/// @file
/// Numerical derivatives to check analytical ones against.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace passive_haptics::testing {

/// Step of central_difference that balances its truncation against rounding in T: eps^(1/7).
template <class T>
T difference_step() {
  return std::pow(std::numeric_limits<T>::epsilon(), T(1) / T(7));
}

/// Accuracy of central_difference with that step, relative to the size of f and of its derivatives:
/// eps^(6/7).
template <class T>
T difference_accuracy() {
  return std::pow(std::numeric_limits<T>::epsilon(), T(6) / T(7));
}

/// df/ds at s = 0 of f(-3h), f(-2h), f(-h), f(h), f(2h), f(3h).
template <class T>
T difference_quotient(const std::array<T, 6>& f, T h) {
  return ((f[3] - f[2]) * T(45) - (f[4] - f[1]) * T(9) + (f[5] - f[0])) / (T(60) * h);
}

/// The same, entry by entry.
template <class T, int R, int C>
matrix<T, R, C> difference_quotient(const std::array<matrix<T, R, C>, 6>& f, T h) {
  matrix<T, R, C> derivative;
  for (int i = 0; i < R; ++i) {
    for (int j = 0; j < C; ++j) {
      std::array<T, 6> entry;
      for (std::size_t k = 0; k < 6; ++k) entry[k] = f[k](i, j);
      derivative(i, j) = difference_quotient(entry, h);
    }
  }
  return derivative;
}

/// df/ds at s = 0 by the central difference of sixth order; f maps a T to a T, a vector or a matrix.
/// Truncation h^6 f^(7) / 140, rounding about eps |f| / h. Six evaluations.
template <class T, class F>
auto central_difference(F&& f, T h) {
  using value = decltype(f(h));
  return difference_quotient(
      std::array<value, 6>{f(T(-3) * h), f(T(-2) * h), f(-h), f(h), f(T(2) * h), f(T(3) * h)}, h);
}

}  // namespace passive_haptics::testing
