/// Sine and cosine in double, for one angle or two.
#pragma once

#include <passive_haptics/core/arithmetic.hpp>
#include <passive_haptics/core/scalar/quadrant.hpp>

#include <concepts>
#include <cstdint>

namespace passive_haptics::detail {

using two_doubles [[gnu::vector_size(16)]] = double;
using two_words [[gnu::vector_size(16)]] = std::uint64_t;

constexpr two_doubles twice(double number) { return two_doubles{number, number}; }

struct sine_cosine_numbers {
  two_doubles two_over_pi = twice(0.63661977236758134308);
  // 1.5 * 2^52: adding it rounds to an integer in the low bits
  two_doubles to_integer = twice(6755399441055744.0);
  // pi/2 in three parts of 33 bits, so that k times the first two is exact (Cody, Waite; e_rem_pio2.c)
  two_doubles part_1 = twice(1.57079632673412561417), part_2 = twice(6.07710050630396597660e-11),
              part_3 = twice(2.02226624879595063154e-21);
  // From k_sin.c and k_cos.c
  two_doubles S1 = twice(-1.66666666666666324348e-01), S2 = twice(8.33333333332248946124e-03),
              S3 = twice(-1.98412698298579493134e-04), S4 = twice(2.75573137070700676789e-06),
              S5 = twice(-2.50507602534068634195e-08), S6 = twice(1.58969099521155010221e-10);
  two_doubles C1 = twice(4.16666666666666019037e-02), C2 = twice(-1.38888888888741095749e-03),
              C3 = twice(2.48015872894767294178e-05), C4 = twice(-2.75573143513906633035e-07),
              C5 = twice(2.08757232129817482790e-09), C6 = twice(-1.13596475577881948265e-11);
};
inline constexpr sine_cosine_numbers all_numbers;

/// sin and cos for |x| <= 1e5, without a branch: x = r + k pi/2 with |r| <= pi/4, then fdlibm's polynomials
/// (k_sin.c, k_cos.c, Sun Microsystems 1993) and the quadrant k mod 4. For one double and its bits, or two.
template <class Doubles, class Words>
PASSIVE_HAPTICS_INLINE inline sine_cosine_pair<Doubles> reduced_sine_cosine(Doubles x) {
  const sine_cosine_numbers* n = &all_numbers;
  asm("" : "+r"(n));  // prevents g++ from rebuilding each pair, which takes a third more instructions
  const auto of = [](const two_doubles& number) {
    if constexpr (std::same_as<Doubles, double>) return number[0];
    else return number;
  };
  const Doubles shifted = x * of(n->two_over_pi) + of(n->to_integer);
  const auto quadrant = bit_cast<Words>(shifted);
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
  return in_quadrant<63>(quadrant, sine, cosine);
}

}  // namespace passive_haptics::detail
