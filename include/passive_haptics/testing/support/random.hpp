/// Seeded random data for property suites.
#pragma once

#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/plant/random_numbers.hpp>

#include <cmath>
#include <cstdint>
#include <random>

namespace passive_haptics::testing {

/// Random numbers, equal on every platform for a seed. Not for control loops.
class random_source {
 public:
  explicit random_source(std::uint64_t seed) : bits_(seed) {}  ///< Starts the sequence of `seed`.

  /// Uniform in [low, high).
  template <class T>
  T uniform(T low, T high) {
    const double unit = uniform_number(bits_);
    return static_cast<T>(static_cast<double>(low) + unit * static_cast<double>(high - low));
  }

  /// Either sign, log-uniform magnitude between low and high (both > 0).
  template <class T>
  T wide(T low, T high) {
    const T magnitude = positive(low, high);
    return coin() ? magnitude : -magnitude;
  }

  /// Log-uniform between low and high (both > 0).
  template <class T>
  T positive(T low, T high) {
    return static_cast<T>(
        std::exp(uniform(std::log(static_cast<double>(low)), std::log(static_cast<double>(high)))));
  }

  /// Normal with mean 0 and standard deviation 1.
  template <class T>
  T normal() {
    return static_cast<T>(normal_number(bits_));
  }

  bool coin() { return (bits_() & 1u) != 0; }  ///< True with probability 1/2.

  /// Uniform entries between those of low and high.
  template <class T, int N>
  vector<T, N> between(const vector<T, N>& low, const vector<T, N>& high) {
    return vector<T, N>::NullaryExpr([&](Eigen::Index i) { return uniform(low[i], high[i]); });
  }

  /// Normal entries.
  template <class T, int N>
  vector<T, N> normal_vector() {
    return vector<T, N>::NullaryExpr([&] { return normal<T>(); });
  }

  /// Uniformly distributed unit vector.
  template <class T, int N>
  vector<T, N> direction() {
    return as<T>(vector<double, N>(normal_vector<double, N>().normalized()));
  }

  /// Uniformly distributed orthonormal columns.
  template <int N, int Count = N>
  matrix<double, N, Count> orthogonal_directions() {
    matrix<double, N, Count> all;
    for (int i = 0; i < Count; ++i) {
      vector<double, N> x = direction<double, N>();
      orthogonalise(x, all, i);
      all.col(i) = x.normalized();
    }
    return all;
  }

 private:
  std::mt19937_64 bits_;
};

}  // namespace passive_haptics::testing
