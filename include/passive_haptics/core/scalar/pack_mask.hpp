/// @file
/// Truths and choices of W states: what comparing packs gives.
#pragma once

#include <passive_haptics/core/arithmetic.hpp>
#include <passive_haptics/core/flatten.hpp>

#include <concepts>
#include <cstdint>
#include <type_traits>

namespace passive_haptics {
namespace detail {
// W numbers in a register.
template <class T, int W>
struct pack_register {
  using type [[gnu::vector_size(W * sizeof(T))]] = T;
};
}  // namespace detail

/// W truths, one for each state.
template <class T, int W>
struct pack_mask {
  /// Of the size of T; but in registers of 16 bytes, where g++ 12 calculates integers of 64 bits one by one.
  using integer = std::conditional_t<sizeof(T) == 4 || W * sizeof(T) == 16, std::int32_t, std::int64_t>;
  static constexpr int part = sizeof(T) / sizeof(integer);               ///< Integers of a state.
  using bits = typename detail::pack_register<integer, W * part>::type;  ///< A register of them.
  bits m;  ///< The truths: all bits of a state set where it is true.

  pack_mask() = default;
  /// Of bits that are all set or all clear.
  [[gnu::always_inline]] explicit pack_mask(bits b) : m(b) {}
  /// W times the same truth.
  [[gnu::always_inline]] pack_mask(bool b) : m(detail::repeated<bits>(-static_cast<integer>(b))) {}

  /// Truth of state k.
  [[gnu::always_inline]] bool operator[](int k) const { return m[k * part] != 0; }
  /// @cond
  [[gnu::always_inline]] friend pack_mask operator!(pack_mask a) { return pack_mask(~a.m); }
  [[gnu::always_inline]] friend pack_mask operator&(pack_mask a, pack_mask b) { return pack_mask(a.m & b.m); }
  [[gnu::always_inline]] friend pack_mask operator|(pack_mask a, pack_mask b) { return pack_mask(a.m | b.m); }
  [[gnu::always_inline]] pack_mask& operator&=(pack_mask b) { return *this = *this & b; }
  [[gnu::always_inline]] pack_mask& operator|=(pack_mask b) { return *this = *this | b; }
  /// @endcond
};

/// True if it is true of no state.
template <class T, int W>
[[gnu::always_inline]] inline bool none(pack_mask<T, W> where) {
#if defined(__AVX__)
  if constexpr (std::same_as<T, double> && W == 4) {
    using doubles = typename detail::pack_register<double, W>::type;
    return __builtin_ia32_movmskpd256(detail::bit_cast<doubles>(where.m)) == 0;
  }
#endif
  constexpr int count = sizeof(where.m) / sizeof(std::int64_t);
  const auto all = detail::bit_cast<typename detail::pack_register<std::int64_t, count>::type>(where.m);
  std::int64_t any = 0;
  unrolled<count>([&](auto k) { any |= all[k]; });
  return any == 0;
}

/// An enumerator of X, a truth or a whole number, for each of W states.
template <class X, class T, int W>
struct pack_of_choices {
  using mask = pack_mask<T, W>;  ///< What a comparison gives.
  typename mask::bits v;         ///< The enumerators as integers, each `part` times.

  pack_of_choices() = default;
  /// Of integers.
  [[gnu::always_inline]] explicit pack_of_choices(typename mask::bits integers) : v(integers) {}
  /// W times the same one.
  [[gnu::always_inline]] pack_of_choices(X x)
      : v(detail::repeated<typename mask::bits>(static_cast<typename mask::integer>(x))) {}
  /// That of state k.
  [[gnu::always_inline]] X operator[](int k) const { return static_cast<X>(v[k * mask::part]); }
  /// Where it is x.
  [[gnu::always_inline]] friend mask operator==(pack_of_choices a, X x) {
    return mask(a.v == pack_of_choices(x).v);
  }
};

/// Truth a where it is true, else b.
template <class T, int W>
[[gnu::always_inline]] inline pack_mask<T, W> select(pack_mask<T, W> where, pack_mask<T, W> a,
                                                     std::type_identity_t<pack_mask<T, W>> b) {
  return (where & a) | ((!where) & b);
}
/// Enumerator a where it is true, else b.
template <class X, class T, int W>
  requires std::is_enum_v<X> || std::integral<X>
[[gnu::always_inline]] inline pack_of_choices<X, T, W> select(pack_mask<T, W> where, X a, X b) {
  return select(where, pack_of_choices<X, T, W>(a), b);
}
/// Enumerator a where it is true, else b.
template <class X, class T, int W>
[[gnu::always_inline]] inline pack_of_choices<X, T, W> select(
    pack_mask<T, W> where, pack_of_choices<X, T, W> a, std::type_identity_t<pack_of_choices<X, T, W>> b) {
  return pack_of_choices<X, T, W>((where.m & a.v) | (~where.m & b.v));
}
/// Enumerator a where it is true, else b.
template <class X, class T, int W>
  requires std::is_enum_v<X> || std::integral<X>
[[gnu::always_inline]] inline pack_of_choices<X, T, W> select(pack_mask<T, W> where, X a,
                                                              pack_of_choices<X, T, W> b) {
  return select(where, pack_of_choices<X, T, W>(a), b);
}

}  // namespace passive_haptics
