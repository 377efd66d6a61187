/// Histograms of durations.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace passive_haptics {

/// Counts durations from 1 ns to years: percentiles to 6 %, exact maximum. Fast, without allocation.
class duration_histogram {
 public:
  /// Adds a duration [ns]; negative ones count as 0.
  void add(std::int64_t duration) noexcept {
    const auto value = static_cast<std::uint64_t>(std::max<std::int64_t>(0, duration));
    ++bins_[index_of(value)];
    ++count_;
    sum_ += static_cast<double>(value);
    maximum_ = std::max(maximum_, value);
  }

  std::uint64_t count() const noexcept { return count_; }  ///< Number of durations.
  /// Maximum [ns]; 0 if empty.
  std::int64_t maximum() const noexcept { return static_cast<std::int64_t>(maximum_); }
  /// Mean [ns]; 0 if empty.
  double mean() const noexcept { return count_ == 0 ? 0 : sum_ / static_cast<double>(count_); }

  /// Upper bin limit that a share of the durations, 0 to 1, does not exceed [ns]; 0 if empty.
  std::int64_t percentile(double share) const noexcept {
    const double wanted = share * static_cast<double>(count_);
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < bins_.size(); ++i) {
      sum += bins_[i];
      if (sum > 0 && static_cast<double>(sum) >= wanted)
        return static_cast<std::int64_t>(std::min(maximum_, min_value_of(i + 1) - 1));
    }
    return maximum();
  }

  /// Number in [from, to) [ns], both powers of two.
  std::uint64_t between(std::uint64_t from, std::uint64_t to) const noexcept {
    std::uint64_t sum = 0;
    for (std::size_t i = index_of(from); i < index_of(to); ++i) sum += bins_[i];
    return sum;
  }

 private:
  static constexpr std::size_t parts = 16;  // of a power of two
  static constexpr int part_bits = 4;

  // 16 bins for whole numbers, then 16 per power of two
  static std::size_t index_of(std::uint64_t value) noexcept {
    if (value < parts) return value;
    const auto power = static_cast<int>(std::bit_width(value)) - 1;
    return static_cast<std::size_t>(power - part_bits) * parts + (value >> (power - part_bits));
  }
  static std::uint64_t min_value_of(std::size_t index) noexcept {
    if (index < 2 * parts) return index;
    return (parts + index % parts) << (index / parts - 1);
  }

  std::array<std::uint64_t, 960> bins_{};  // to 2^63
  std::uint64_t count_ = 0;
  double sum_ = 0;
  std::uint64_t maximum_ = 0;
};

}  // namespace passive_haptics
