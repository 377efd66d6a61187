/// Sine and cosine in float, for one angle or two.
#pragma once

#include <passive_haptics/core/arithmetic.hpp>
#include <passive_haptics/core/scalar/quadrant.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>

namespace passive_haptics::detail {

using two_floats [[gnu::vector_size(8)]] = float;
using two_short_words [[gnu::vector_size(8)]] = std::uint32_t;

/// x = rest + tail + quadrant pi/2 with |rest| <= pi/4, a tail below its last place, and quadrant modulo 4.
template <class Floats, class Words>
struct reduced_angle {
  Floats rest, tail;
  Words quadrant;
};

/// Maximum angle [rad] for reduced(): its k has at most 7 bits.
inline constexpr float few_turns = 199;

/// For |x| <= few_turns, without a branch.
template <class Floats, class Words>
PASSIVE_HAPTICS_INLINE inline reduced_angle<Floats, Words> reduced(Floats x) {
  constexpr float two_over_pi = 0.636619772f;
  constexpr float to_integer = 12582912;  // 1.5 * 2^23: adding it rounds to an integer in the low bits
  // pi/2 in three parts, the first two with 17 bits, so that k times each is exact (Cody, Waite)
  constexpr float part_1 = 1.57078552f, part_2 = 1.08042732e-5f, part_3 = 6.07710055e-11f;
  const Floats shifted = x * two_over_pi + to_integer;
  const Floats k = shifted - to_integer;
  const Floats exact = x - k * part_1, rest = exact - k * part_2;
  return {rest, ((exact - rest) - k * part_2) - k * part_3, bit_cast<Words>(shifted)};
}

/// For |x| >= 1: m 2^e times 96 bits of 2/pi in integers, modulo 4 (Payne, Hanek). NaN if not finite.
[[gnu::noinline]] inline reduced_angle<float, std::uint32_t> reduced_in_integers(float x) {
  using short_word = std::uint32_t;
  using long_word = std::uint64_t;
  constexpr short_word two_over_pi[] = {0,          0xa2f9836e, 0x4e441529, 0xfc2757d1,
                                        0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab};
  constexpr short_word half_pi = 0xc90fdaa2;  // times 2^-31
  if (!(std::abs(x) <= std::numeric_limits<float>::max())) return {x - x, 0, 0};

  const short_word bits = bit_cast<short_word>(x), m = (bits & 0x7fffff) | 0x800000;
  const short_word first = (bits >> 23 & 0xff) - 120;  // first bit of 2/pi in use
  const auto taken = [&](short_word i) {
    const short_word* w = two_over_pi + first / 32 + i;
    return ((long_word(w[0]) << 32 | w[1]) << first % 32) >> 32;
  };
  // In right angles, modulo 4: two bits before the point, 62 after it
  const long_word turned = (m * taken(0) << 32) + m * taken(1) + (m * taken(2) >> 32);
  const short_word quadrant = short_word((turned + (long_word(1) << 61)) >> 62);
  const auto behind = std::int64_t(turned - (long_word(quadrant) << 62));

  const long_word size = behind < 0 ? -long_word(behind) : long_word(behind);
  const int zeros = std::countl_zero(size);
  const short_word rest = short_word((size << zeros >> 32) * half_pi >> 32), last_bits = 0xff;
  const float unit = bit_cast<float>(short_word(127 - 29 - zeros) << 23);
  const float signed_unit = (behind < 0) == (x < 0) ? unit : -unit;
  return {float(rest & ~last_bits) * signed_unit, float(rest & last_bits) * signed_unit,
          x < 0 ? -quadrant : quadrant};
}

/// sin and cos of a reduced angle: Cephes' polynomials (sinf.c, Moshier 1992), linear in the tail.
template <class Floats, class Words>
PASSIVE_HAPTICS_INLINE inline sine_cosine_pair<Floats> sine_cosine_of(const reduced_angle<Floats, Words>& x) {
  const Floats r = x.rest, z = r * r;
  const Floats s = (-1.9515295891e-4f * z + 8.3321608736e-3f) * z - 1.6666654611e-1f;
  const Floats c = (2.443315711809948e-5f * z - 1.388731625493765e-3f) * z + 4.166664568298827e-2f;
  const Floats half = 0.5f * z, one_less_half = 1.0f - half;
  const Floats sine = r + (r * z * s + x.tail * one_less_half);
  const Floats cosine = one_less_half + (((1.0f - one_less_half) - half) + (z * z * c - r * x.tail));
  return in_quadrant<31>(x.quadrant, sine, cosine);
}

// Within 0.9 units in the last place.
PASSIVE_HAPTICS_INLINE inline sine_cosine_pair<float> float_sine_cosine(float x) {
  using short_word = std::uint32_t;
  return sine_cosine_of(std::abs(x) <= few_turns ? reduced<float, short_word>(x) : reduced_in_integers(x));
}
PASSIVE_HAPTICS_INLINE inline std::array<sine_cosine_pair<float>, 2> float_sine_cosine(float x, float y) {
  if (!(std::abs(x) <= few_turns && std::abs(y) <= few_turns))
    return {float_sine_cosine(x), float_sine_cosine(y)};
  const auto [s, c] = sine_cosine_of(reduced<two_floats, two_short_words>(two_floats{x, y}));
  return {{{s[0], c[0]}, {s[1], c[1]}}};
}

}  // namespace passive_haptics::detail
