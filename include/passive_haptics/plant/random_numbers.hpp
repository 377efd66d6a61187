/// Random numbers that are equal on every platform, unlike the standard library's distributions.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace passive_haptics {

/// Bits of sequence k of a seed. Not for control loops.
inline std::mt19937_64 random_bits(std::uint64_t seed, std::uint64_t k) {
  std::seed_seq both{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(k)};
  return std::mt19937_64(both);
}

/// Uniform in [0, 1) with 53 bits. Not for control loops.
inline double uniform_number(std::mt19937_64& bits) { return static_cast<double>(bits() >> 11) * 0x1p-53; }

/// Normal with mean 0 and standard deviation 1 (Box and Muller 1958). Not for control loops.
inline double normal_number(std::mt19937_64& bits) {
  const double radius = std::sqrt(-2 * std::log(1 - uniform_number(bits)));
  return radius * std::cos(2 * std::numbers::pi * uniform_number(bits));
}

}  // namespace passive_haptics
