/// @file
/// Sine and cosine of one angle at once.
#pragma once

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

/// sin and cos in double for |x| <= 1e5, without a branch: x = r + k pi/2 with |r| <= pi/4, then fdlibm's polynomials
/// (k_sin.c, k_cos.c, Sun Microsystems 1993) and the quadrant k mod 4.
inline sine_cosine_pair<double> reduced_sine_cosine(double x) {
  constexpr double two_over_pi = 0.63661977236758134308;
  // pi/2 in three parts of 33 bits, so that k times the first two is exact (Cody, Waite; e_rem_pio2.c)
  constexpr double part_1 = 1.57079632673412561417, part_2 = 6.07710050630396597660e-11,
                   part_3 = 2.02226624879595063154e-21;
  constexpr double to_integer =
      6755399441055744.0;  // 1.5 * 2^52: adding it rounds to an integer in the low bits
  const double shifted = x * two_over_pi + to_integer;
  const auto quadrant = std::bit_cast<std::uint64_t>(shifted);
  const double k = shifted - to_integer;
  const double r = ((x - k * part_1) - k * part_2) - k * part_3;

  const double z = r * r, w = z * z;
  const double s = (-1.66666666666666324348e-01 + z * 8.33333333332248946124e-03) +
                   w * ((-1.98412698298579493134e-04 + z * 2.75573137070700676789e-06) +
                        w * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10));
  const double c = (4.16666666666666019037e-02 + z * -1.38888888888741095749e-03) +
                   w * ((2.48015872894767294178e-05 + z * -2.75573143513906633035e-07) +
                        w * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11));
  const double half = 0.5 * z, one_less_half = 1.0 - half;
  const double sine = r + r * z * s;
  const double cosine = one_less_half + (((1.0 - one_less_half) - half) + w * c);

  const bool swapped = (quadrant & 1) != 0;
  const auto with_sign = [](double value, std::uint64_t sign_in_bit_1) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) ^ ((sign_in_bit_1 & 2) << 62));
  };
  return {with_sign(swapped ? cosine : sine, quadrant), with_sign(swapped ? sine : cosine, quadrant + 1)};
}

}  // namespace detail

/// sin x and cos x of x [rad]. float and double within 2 units in the last place for |x| <= 1e5 rad, beyond, for NaN and for other types the C library's.
template <std::floating_point T>
[[gnu::always_inline]] inline sine_cosine_pair<T> sine_cosine(T x) {
  if constexpr (sizeof(T) <= sizeof(double)) {
    if (std::abs(x) <= T(1e5)) {
      const auto [s, c] = detail::reduced_sine_cosine(static_cast<double>(x));
      return {static_cast<T>(s), static_cast<T>(c)};
    }
  }
  return {std::sin(x), std::cos(x)};
}

}  // namespace passive_haptics
