/// @file
/// One number for each of W states, in a register of the target: the scalar of formulas for many states.
#pragma once

#include <passive_haptics/core/arithmetic.hpp>
#include <passive_haptics/core/scalar/pack_mask.hpp>

#include <Eigen/Core>

#include <cmath>
#include <concepts>
#include <cstring>
#include <type_traits>

namespace passive_haptics {

/// Numbers T that a register of the target holds, by the compiler's flags: 16 bytes, 32 with -mavx2. (In
/// wider packs g++ 12 keeps each number in memory.)
template <class T>
inline constexpr int native_pack_width =
#if defined(__AVX2__)
    32 / sizeof(T);
#else
    16 / sizeof(T);
#endif

/// W numbers, one for each state. Has the arithmetic and the comparisons of T, each in one instruction; a
/// choice is made by select. A formula over packs has no branch on a number.
template <class T, int W>
struct pack {
  using mask = pack_mask<T, W>;                                ///< What a comparison gives.
  using numbers = typename detail::pack_register<T, W>::type;  ///< A register.
  numbers v;                                                   ///< The numbers.

  pack() = default;
  /// Of a register.
  [[gnu::always_inline]] explicit pack(numbers x) : v(x) {}
  /// W times the same number.
  [[gnu::always_inline]] pack(T x) : v(detail::repeated<numbers>(x)) {}

  /// x[0], ..., x[W - 1], at any address.
  [[gnu::always_inline]] static pack load(const T* x) {
    pack a;
    std::memcpy(&a.v, x, sizeof(numbers));
    return a;
  }
  /// Stores x[0], ..., x[W - 1].
  [[gnu::always_inline]] void store(T* x) const { std::memcpy(x, &v, sizeof(numbers)); }
  /// The number of state k.
  [[gnu::always_inline]] T operator[](int k) const { return v[k]; }

  /// @cond
  [[gnu::always_inline]] static mask test(auto truths) {
    return mask(detail::bit_cast<typename mask::bits>(truths));
  }
  [[gnu::always_inline]] friend pack operator+(pack a) { return a; }
  [[gnu::always_inline]] friend pack operator-(pack a) { return pack(-a.v); }
  [[gnu::always_inline]] friend pack operator+(pack a, pack b) { return pack(a.v + b.v); }
  [[gnu::always_inline]] friend pack operator-(pack a, pack b) { return pack(a.v - b.v); }
  [[gnu::always_inline]] friend pack operator*(pack a, pack b) { return pack(a.v * b.v); }
  [[gnu::always_inline]] friend pack operator/(pack a, pack b) { return pack(a.v / b.v); }
  [[gnu::always_inline]] pack& operator+=(pack b) { return *this = *this + b; }
  [[gnu::always_inline]] pack& operator-=(pack b) { return *this = *this - b; }
  [[gnu::always_inline]] pack& operator*=(pack b) { return *this = *this * b; }
  [[gnu::always_inline]] pack& operator/=(pack b) { return *this = *this / b; }
  [[gnu::always_inline]] friend mask operator<(pack a, pack b) { return test(a.v < b.v); }
  [[gnu::always_inline]] friend mask operator<=(pack a, pack b) { return test(a.v <= b.v); }
  [[gnu::always_inline]] friend mask operator>(pack a, pack b) { return test(a.v > b.v); }
  [[gnu::always_inline]] friend mask operator>=(pack a, pack b) { return test(a.v >= b.v); }
  [[gnu::always_inline]] friend mask operator==(pack a, pack b) { return test(a.v == b.v); }
  [[gnu::always_inline]] friend mask operator!=(pack a, pack b) { return test(a.v != b.v); }
  /// @endcond
};

/// a where it is true, else b.
template <class T, int W>
[[gnu::always_inline]] inline pack<T, W> select(pack_mask<T, W> where, std::type_identity_t<pack<T, W>> a,
                                                std::type_identity_t<pack<T, W>> b) {
  // g++ 12 would choose doubles of 16 bytes one by one
  if constexpr (sizeof(where.m) == 16) return pack<T, W>(detail::merged(where.m, a.v, b.v));
  else return pack<T, W>(where.m ? a.v : b.v);
}
/// The smaller of each two; a where one is NaN.
template <class T, int W>
[[gnu::always_inline]] inline pack<T, W> min(pack<T, W> a, std::type_identity_t<pack<T, W>> b) {
  return pack<T, W>(b.v < a.v ? b.v : a.v);
}
/// The larger of each two; a where one is NaN.
template <class T, int W>
[[gnu::always_inline]] inline pack<T, W> max(pack<T, W> a, std::type_identity_t<pack<T, W>> b) {
  return pack<T, W>(a.v < b.v ? b.v : a.v);
}
/// y with the sign of x.
template <class T, int W>
[[gnu::always_inline]] inline pack<T, W> copysign(pack<T, W> y, pack<T, W> x) {
  using numbers = typename pack<T, W>::numbers;
  return pack<T, W>(detail::merged(detail::bit_cast<typename pack_mask<T, W>::bits>(-numbers{}), x.v, y.v));
}
/// |x|
template <class T, int W>
[[gnu::always_inline]] inline pack<T, W> abs(pack<T, W> x) {
  return copysign(x, pack<T, W>(T(0)));
}
/// |x|^2
template <class T, int W>
[[gnu::always_inline]] inline pack<T, W> abs2(pack<T, W> x) {
  return x * x;
}
/// The root; NaN of numbers < 0.
template <class T, int W>
[[gnu::always_inline]] inline pack<T, W> sqrt(pack<T, W> x) {
  if constexpr (std::same_as<T, double>) {  // without a branch: std::sqrt has one, to set errno where x < 0
    Eigen::Matrix<T, W, 1> y;
    x.store(y.data());
    y = y.cwiseSqrt();
    return pack<T, W>::load(y.data());
  } else {  // Eigen's of four floats is an approximation
    pack<T, W> root;
    unrolled<W>([&](auto k) { root.v[k] = std::sqrt(x.v[k]); });
    return root;
  }
}

namespace detail {
template <class T, int W>
struct scalar_parts<pack<T, W>> {
  using number = T;
  using truth = pack_mask<T, W>;
  template <class X>
  using choice = pack_of_choices<X, T, W>;
};
}  // namespace detail
}  // namespace passive_haptics

/// @cond
// Vectors of packs are Eigen's.
template <class T, int W>
struct Eigen::NumTraits<passive_haptics::pack<T, W>> : Eigen::NumTraits<T> {
  using Real = passive_haptics::pack<T, W>;
  using NonInteger = passive_haptics::pack<T, W>;
  using Nested = passive_haptics::pack<T, W>;
  using Literal = passive_haptics::pack<T, W>;
};
// A pack and a number make a pack.
template <class T, int W, class Operation>
struct Eigen::ScalarBinaryOpTraits<passive_haptics::pack<T, W>, T, Operation> {
  using ReturnType = passive_haptics::pack<T, W>;
};
// A number and a pack make a pack.
template <class T, int W, class Operation>
struct Eigen::ScalarBinaryOpTraits<T, passive_haptics::pack<T, W>, Operation> {
  using ReturnType = passive_haptics::pack<T, W>;
};
/// @endcond
