/// @file
/// Sine and cosine of one angle at once.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>

namespace passive_haptics {

/// sin and cos of an angle.
template <class T>
struct sine_cosine_pair {
  T sine;    ///< sin
  T cosine;  ///< cos
};

namespace detail {

// Two doubles in one register, and their bits.
using two_doubles [[gnu::vector_size(16)]] = double;
using two_words [[gnu::vector_size(16)]] = std::uint64_t;

// The same number in both lanes.
constexpr two_doubles twice(double number) { return two_doubles{number, number}; }

// What a sine and a cosine are made of.
struct sine_cosine_numbers {
  two_doubles two_over_pi = twice(0.63661977236758134308);
  // 1.5 * 2^52: adding it rounds to an integer in the low bits
  two_doubles to_integer = twice(6755399441055744.0);
  // pi/2 in three parts of 33 bits, so that k times the first two is exact (Cody, Waite; e_rem_pio2.c)
  two_doubles part_1 = twice(1.57079632673412561417), part_2 = twice(6.07710050630396597660e-11),
              part_3 = twice(2.02226624879595063154e-21);
  // Of k_sin.c and k_cos.c
  two_doubles S1 = twice(-1.66666666666666324348e-01), S2 = twice(8.33333333332248946124e-03),
              S3 = twice(-1.98412698298579493134e-04), S4 = twice(2.75573137070700676789e-06),
              S5 = twice(-2.50507602534068634195e-08), S6 = twice(1.58969099521155010221e-10);
  two_doubles C1 = twice(4.16666666666666019037e-02), C2 = twice(-1.38888888888741095749e-03),
              C3 = twice(2.48015872894767294178e-05), C4 = twice(-2.75573143513906633035e-07),
              C5 = twice(2.08757232129817482790e-09), C6 = twice(-1.13596475577881948265e-11);
};
inline constexpr sine_cosine_numbers all_numbers;

/// sin and cos in double for |x| <= 1e5, without a branch: x = r + k pi/2 with |r| <= pi/4, then fdlibm's
/// polynomials (k_sin.c, k_cos.c, Sun Microsystems 1993) and the quadrant k mod 4. Of one double and its
/// bits, or of two at once.
template <class Doubles, class Words>
[[gnu::always_inline]] inline sine_cosine_pair<Doubles> reduced_sine_cosine(Doubles x) {
  const sine_cosine_numbers* n = &all_numbers;
  asm("" : "+r"(n));  // or g++ makes each pair of numbers anew from one: a third more instructions
  const auto of = [](const two_doubles& number) {
    if constexpr (std::same_as<Doubles, double>) return number[0];
    else return number;
  };
  const Doubles shifted = x * of(n->two_over_pi) + of(n->to_integer);
  const auto quadrant = std::bit_cast<Words>(shifted);
  const Doubles k = shifted - of(n->to_integer);
  const Doubles r = ((x - k * of(n->part_1)) - k * of(n->part_2)) - k * of(n->part_3);

  const Doubles z = r * r, w = z * z;
  const Doubles s =
      (of(n->S1) + z * of(n->S2)) + w * ((of(n->S3) + z * of(n->S4)) + w * (of(n->S5) + z * of(n->S6)));
  const Doubles c =
      (of(n->C1) + z * of(n->C2)) + w * ((of(n->C3) + z * of(n->C4)) + w * (of(n->C5) + z * of(n->C6)));
  const Doubles half = 0.5 * z, one_less_half = 1.0 - half;
  const Doubles sine = r + r * z * s;
  const Doubles cosine = one_less_half + (((1.0 - one_less_half) - half) + w * c);

  // An odd quadrant swaps the two; the sine's sign is bit 1 of the quadrant, the cosine's that of the one
  // after
  const Words sine_bits = std::bit_cast<Words>(sine), cosine_bits = std::bit_cast<Words>(cosine);
  const Words swapped = (sine_bits ^ cosine_bits) & -(quadrant & 1);
  const auto with_sign = [](Words bits, Words sign_in_bit_1) {
    return std::bit_cast<Doubles>(bits ^ ((sign_in_bit_1 & 2) << 62));
  };
  return {with_sign(sine_bits ^ swapped, quadrant), with_sign(cosine_bits ^ swapped, quadrant + 1)};
}

}  // namespace detail

/// sin x and cos x of x [rad]. float and double within 2 units in the last place for |x| <= 1e5 rad, beyond,
/// for NaN and for other types the C library's.
template <std::floating_point T>
[[gnu::always_inline]] inline sine_cosine_pair<T> sine_cosine(T x) {
  if constexpr (sizeof(T) <= sizeof(double)) {
    if (std::abs(x) <= T(1e5)) {
      const auto [s, c] = detail::reduced_sine_cosine<double, std::uint64_t>(x);
      return {static_cast<T>(s), static_cast<T>(c)};
    }
  }
  return {std::sin(x), std::cos(x)};
}

/// The same of two angles, for the time of one.
template <std::floating_point T>
[[gnu::always_inline]] inline std::array<sine_cosine_pair<T>, 2> sine_cosine(T x, T y) {
  if constexpr (sizeof(T) <= sizeof(double)) {
    if (std::abs(x) <= T(1e5) && std::abs(y) <= T(1e5)) {
      const auto [s, c] = detail::reduced_sine_cosine<detail::two_doubles, detail::two_words>(
          detail::two_doubles{static_cast<double>(x), static_cast<double>(y)});
      return {{{static_cast<T>(s[0]), static_cast<T>(c[0])}, {static_cast<T>(s[1]), static_cast<T>(c[1])}}};
    }
  }
  return {{{std::sin(x), std::cos(x)}, {std::sin(y), std::cos(y)}}};
}

/// sin x and cos x of a scalar that brings its own, such as one that carries derivatives.
template <class S>
  requires(!std::floating_point<S>)
sine_cosine_pair<S> sine_cosine(S x) {
  using std::cos, std::sin;
  return {sin(x), cos(x)};
}

/// The same of N angles, floating-point numbers two by two.
template <class S, int N>
std::array<sine_cosine_pair<S>, static_cast<std::size_t>(N)> sine_cosine(const vector<S, N>& angles) {
  std::array<sine_cosine_pair<S>, static_cast<std::size_t>(N)> all;
  const auto at = [&](int i) -> sine_cosine_pair<S>& { return all[static_cast<std::size_t>(i)]; };
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
