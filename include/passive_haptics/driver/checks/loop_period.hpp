/// The period of a loop.
#pragma once

#include <passive_haptics/core/text.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

namespace passive_haptics {

/// The period of a loop [s]: a given value, or the median of its first spacings, which is robust to a pause.
class loop_period {
 public:
  explicit loop_period(double given) : given_(given) {}  ///< given [s]; 0: measured.

  /// Adds the time since the previous cycle [s].
  void add(double spacing) noexcept {
    if (count_ < spacings_.size()) spacings_[count_++] = spacing;
  }
  /// Period [s]; 0 if none was given and there is no spacing yet.
  double value() const noexcept {
    if (given_ > 0 || count_ == 0) return given_;
    auto sorted = spacings_;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(count_ / 2);
    std::nth_element(sorted.begin(), middle, sorted.begin() + static_cast<std::ptrdiff_t>(count_));
    return *middle;
  }
  /// Error text if a counter of this width can wrap undetected within the period; empty otherwise.
  std::string error(double wrap_time, int counter_bits) const {
    if (value() < wrap_time) return {};
    return detail::error_text(
        "period [s]", value(),
        detail::indexed("less than ", wrap_time, ", within which a counter of ") +
            detail::indexed(
                "", counter_bits,
                " bits can wrap unseen: shorten it, lower encoders.max_rate or use a wider counter"));
  }

 private:
  double given_;
  std::array<double, 20> spacings_{};
  std::size_t count_ = 0;
};

}  // namespace passive_haptics
