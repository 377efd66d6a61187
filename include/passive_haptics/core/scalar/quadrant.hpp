/// Quadrant selection for sines of double and float.
#pragma once

#include <passive_haptics/core/arithmetic.hpp>
#include <passive_haptics/core/flatten.hpp>

namespace passive_haptics {

/// sin and cos of an angle.
template <class T>
struct sine_cosine_pair {
  T sine;    ///< sin
  T cosine;  ///< cos
};

namespace detail {

/// sin and cos of r + quadrant pi/2 from those of r, without a branch. SignBit: highest bit of a word.
template <int SignBit, class Reals, class Words>
PASSIVE_HAPTICS_INLINE inline sine_cosine_pair<Reals> in_quadrant(Words quadrant, Reals sine, Reals cosine) {
  // An odd quadrant swaps them. The signs are bit 1 of quadrant (sine) and quadrant + 1 (cosine)
  const Words sine_bits = bit_cast<Words>(sine), cosine_bits = bit_cast<Words>(cosine);
  const Words swapped = (sine_bits ^ cosine_bits) & -(quadrant & 1);
  const auto with_sign = [](Words bits, Words sign_in_bit_1) {
    return bit_cast<Reals>(bits ^ ((sign_in_bit_1 & 2) << (SignBit - 1)));
  };
  return {with_sign(sine_bits ^ swapped, quadrant), with_sign(cosine_bits ^ swapped, quadrant + 1)};
}

}  // namespace detail
}  // namespace passive_haptics
