/// Sine and cosine of the same angle.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/core/scalar/double_sine_cosine.hpp>
#include <passive_haptics/core/scalar/float_sine_cosine.hpp>

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>

namespace passive_haptics {

/// sin x and cos x of x [rad]. float: within 0.9 units in the last place for every finite x, without double.
/// double: within 2 units for |x| <= 1e5 rad. Otherwise those of the C library. NaN if not finite.
template <std::floating_point T>
PASSIVE_HAPTICS_INLINE inline sine_cosine_pair<T> sine_cosine(T x) {
  if constexpr (std::same_as<T, float>) return detail::float_sine_cosine(x);
  else if constexpr (sizeof(T) == sizeof(double)) {
    if (std::abs(x) <= T(1e5)) {
      const auto [s, c] = detail::reduced_sine_cosine<double, std::uint64_t>(x);
      return {static_cast<T>(s), static_cast<T>(c)};
    }
  }
  return {std::sin(x), std::cos(x)};
}

/// Sines and cosines of two angles [rad], in the time of one.
template <std::floating_point T>
PASSIVE_HAPTICS_INLINE inline std::array<sine_cosine_pair<T>, 2> sine_cosine(T x, T y) {
  if constexpr (std::same_as<T, float>) return detail::float_sine_cosine(x, y);
  else if constexpr (sizeof(T) == sizeof(double)) {
    if (std::abs(x) <= T(1e5) && std::abs(y) <= T(1e5)) {
      const auto [s, c] = detail::reduced_sine_cosine<detail::two_doubles, detail::two_words>(
          detail::two_doubles{static_cast<double>(x), static_cast<double>(y)});
      return {{{static_cast<T>(s[0]), static_cast<T>(c[0])}, {static_cast<T>(s[1]), static_cast<T>(c[1])}}};
    }
  }
  return {{{std::sin(x), std::cos(x)}, {std::sin(y), std::cos(y)}}};
}

/// For scalars with their own sin and cos, such as dual_number.
template <class S>
  requires(!std::floating_point<S>)
sine_cosine_pair<S> sine_cosine(S x) {
  using std::cos, std::sin;
  return {sin(x), cos(x)};
}

/// Sines and cosines of N angles [rad], floating-point numbers in pairs.
template <class S, int N>
std::array<sine_cosine_pair<S>, static_cast<std::size_t>(N)> sine_cosine(const vector<S, N>& angles) {
  std::array<sine_cosine_pair<S>, static_cast<std::size_t>(N)> all;
  const auto at = [&](int i) -> sine_cosine_pair<S>& { return nth(all, i); };
  if constexpr (std::floating_point<S>) {
    unrolled<N / 2>([&](int k) {
      const auto [first, second] = sine_cosine(angles[2 * k], angles[2 * k + 1]);
      at(2 * k) = first;
      at(2 * k + 1) = second;
    });
    if constexpr (N % 2 == 1) at(N - 1) = sine_cosine(angles[N - 1]);
  } else {
    for (int i = 0; i < N; ++i) at(i) = sine_cosine(angles[i]);
  }
  return all;
}

}  // namespace passive_haptics
