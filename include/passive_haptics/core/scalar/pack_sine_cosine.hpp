/// @file
/// Sines and cosines of packs.
#pragma once

#include <passive_haptics/core/scalar/pack.hpp>
#include <passive_haptics/core/scalar/sine_cosine.hpp>

#include <array>
#include <cstdint>

namespace passive_haptics {
namespace detail {

template <int W>
[[gnu::always_inline]] inline sine_cosine_pair<pack<double, W>> packed_sine_cosine(pack<double, W> x) {
  using numbers = typename pack<double, W>::numbers;
  using words = typename pack_register<std::uint64_t, W>::type;
  const auto [s, c] = reduced_sine_cosine<numbers, words>(x.v);
  return {pack<double, W>(s), pack<double, W>(c)};
}

// One by one, in pairs as of single numbers.
template <int W>
[[gnu::noinline, gnu::cold]] std::array<sine_cosine_pair<pack<double, W>>, 2> sine_cosine_of_each(
    const pack<double, W>& x, const pack<double, W>& y) {
  std::array<sine_cosine_pair<pack<double, W>>, 2> all;
  for (int k = 0; k < W; ++k) {
    const auto [first, second] = sine_cosine(x[k], y[k]);
    all[0].sine.v[k] = first.sine;
    all[0].cosine.v[k] = first.cosine;
    all[1].sine.v[k] = second.sine;
    all[1].cosine.v[k] = second.cosine;
  }
  return all;
}

}  // namespace detail

/// Sines and cosines of two angles of W states: those of two single angles, to the last bit where the
/// compiler contracts no product and sum (it does with -mfma).
template <int W>
[[gnu::always_inline]] inline std::array<sine_cosine_pair<pack<double, W>>, 2> sine_cosine(
    pack<double, W> x, pack<double, W> y) {
  if (none(!((abs(x) <= 1e5) & (abs(y) <= 1e5))))
    return {detail::packed_sine_cosine(x), detail::packed_sine_cosine(y)};
  return detail::sine_cosine_of_each(x, y);
}

}  // namespace passive_haptics
