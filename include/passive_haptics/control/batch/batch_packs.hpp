/// @file
/// From arrays of states to packs, and from packs to arrays of results.
#pragma once

#include <passive_haptics/control/batch/packed_cycle.hpp>

#include <algorithm>
#include <cstring>

namespace passive_haptics::detail {

// Where W states begin in the arrays, and how many of them there are: fewer at the end.
struct whole_pack {
  std::size_t first;
};
struct rest_of_pack {
  std::size_t first;
  int count;
};

template <int W, class T>
[[gnu::always_inline]] inline pack<T, W> packed(std::span<const T> array, whole_pack at) {
  return pack<T, W>::load(array.data() + at.first);
}
// Behind the last number, the last one again.
template <int W, class T>
[[gnu::always_inline]] inline pack<T, W> packed(std::span<const T> array, rest_of_pack at) {
  pack<T, W> x;
  unrolled<W>([&](auto j) { x.v[j] = array[at.first + std::size_t(std::min<int>(j, at.count - 1))]; });
  return x;
}
template <int W, class T, std::size_t Components, class Place>
[[gnu::always_inline]] inline auto packed(const std::array<std::span<const T>, Components>& arrays,
                                          Place at) {
  vector<pack<T, W>, static_cast<int>(Components)> x;
  unrolled<static_cast<int>(Components)>([&](auto i) { x[i] = packed<W>(arrays[std::size_t(i)], at); });
  return x;
}

// W states.
template <int W, class M, class Place>
[[gnu::always_inline]] inline auto packed(const batch_states<M>& states, Place at) {
  using T = pack<typename M::scalar, W>;
  packed_state<M, T> s;
  s.q = packed<W>(states.q, at);
  s.qd = packed<W>(states.qd, at);
  s.hand_force = vector<T, M::task_dimension>::Zero();
  if (states.has_hand_force()) s.hand_force = packed<W>(states.hand_force, at);
  s.time = T(0);
  if (!states.time.empty()) s.time = packed<W>(states.time, at);
  return s;
}

template <class T, int W>
[[gnu::always_inline]] inline void store(std::span<T> array, whole_pack at, const pack<T, W>& x) {
  x.store(array.data() + at.first);
}
template <class Stored, class X, class T, int W>
[[gnu::always_inline]] inline void store(std::span<Stored> array, whole_pack at,
                                         const pack_of_choices<X, T, W>& x) {
  using integer = std::conditional_t<sizeof(Stored) == 1, std::int8_t, std::int32_t>;
  static_assert(sizeof(Stored) == sizeof(integer));
  const auto each = [&]<int... K>(std::integer_sequence<int, K...>) PASSIVE_HAPTICS_INLINE {
    return __builtin_shufflevector(x.v, x.v, K * pack_mask<T, W>::part...);
  }(std::make_integer_sequence<int, W>());
  const auto as_stored = __builtin_convertvector(each, typename pack_register<integer, W>::type);
  std::memcpy(array.data() + at.first, &as_stored, sizeof as_stored);
}
template <class Stored, class X>
[[gnu::always_inline]] inline void store(std::span<Stored> array, rest_of_pack at, const X& x) {
  for (int j = 0; j < at.count; ++j) array[at.first + std::size_t(j)] = static_cast<Stored>(x[j]);
}
// Of one state.
template <class Stored, class X>
void store(std::span<Stored> array, std::size_t k, const X& x) {
  array[k] = static_cast<Stored>(x);
}
template <class T, std::size_t Components, class Place, class X, int N>
[[gnu::always_inline]] inline void store(const std::array<std::span<T>, Components>& arrays, Place at,
                                         const vector<X, N>& x) {
  static_assert(N == static_cast<int>(Components));
  unrolled<N>([&](auto i) { store(arrays[std::size_t(i)], at, x[i]); });
}

// Stores results of the states at this place.
template <class Result, class M, class Place, class R>
[[gnu::always_inline]] inline void store(const batch_results<M>& results, Place at, const R& r) {
  store(results.capacity, at, r.capacity);
  store(results.outcome, at, r.outcome);
  if constexpr (requires(Result account) { account.torque; })
    results.for_each_of_account(r,
                                [&](const char*, const auto& arrays, const auto& x) PASSIVE_HAPTICS_INLINE {
                                  if (!is_left_out(arrays)) store(arrays, at, x);
                                });
}

}  // namespace passive_haptics::detail
