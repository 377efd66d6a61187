/// Numerical derivatives for tests.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <cmath>
#include <limits>
#include <type_traits>

namespace passive_haptics::testing {

/// Step of central_difference that balances truncation and rounding in T: eps^(1/7).
template <class T>
T difference_step() {
  return std::pow(std::numeric_limits<T>::epsilon(), T(1) / T(7));
}

/// Accuracy of central_difference with that step, relative to f and its derivatives: eps^(6/7).
template <class T>
T difference_accuracy() {
  return std::pow(std::numeric_limits<T>::epsilon(), T(6) / T(7));
}

/// df/ds at s = 0 by the central difference of sixth order; f maps T to T, a vector or a matrix. Truncation
/// h^6 f^(7) / 140, rounding about eps |f| / h. Six evaluations.
template <class T, class F>
auto central_difference(F&& f, T h) {
  using value = std::remove_cvref_t<decltype(f(h))>;
  const auto rise = [&](T s) -> value { return f(s) - f(-s); };
  return value((rise(h) * T(45) - rise(T(2) * h) * T(9) + rise(T(3) * h)) / (T(60) * h));
}

}  // namespace passive_haptics::testing
