/// Current limits of a brake's coil and amplifier.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/driver/port.hpp>

#include <algorithm>

namespace passive_haptics {

/// Limits of the current of each of N brakes.
template <int N>
struct current_limits {
  brake_currents<N> max_current = same_for_each<N>(1);  ///< Absolute maximum [A].
  brake_currents<N> continuous = same_for_each<N>(1);   ///< Allowed indefinitely [A].
  brake_currents<N> heat = same_for_each<N>(10);        ///< Allowed integral of I^2 - continuous^2 [A^2 s].
  brake_currents<N> max_rise_rate{};                    ///< [A/s], 0 for no limit. Falls are not limited.

  static constexpr auto members() {
    using p = current_limits;
    return member_table(
        member("max_current", &p::max_current, "A", range::positive),
        member("continuous", &p::continuous, "A", range::positive),
        member("heat", &p::heat, "A^2 s", range::positive).suspicious_below(1e-6).suspicious_above(1e6),
        member("max_rise_rate", &p::max_rise_rate, "A/s", range::not_negative));
  }
};

/// Clamps currents, limits their rise, and lowers them for warm coils: I^2 t as of a fuse that recovers.
template <int N>
class current_limiter {
 public:
  /// Throws std::invalid_argument with the text of validate(limits).
  explicit current_limiter(const current_limits<N>& limits) : limits_(require_valid(limits)) {}

  /// Returns the allowed currents for `wanted` (each finite and >= 0) [A], `dt` [s] after the previous call.
  brake_currents<N> operator()(const brake_currents<N>& wanted, double dt) noexcept {
    warm_ = false;
    for (std::size_t i = 0; i < flowing_.size(); ++i) {
      const double continuous = limits_.continuous[i];
      heat_[i] = std::max(0.0, heat_[i] + (flowing_[i] * flowing_[i] - continuous * continuous) * dt);
      double limit = limits_.max_current[i];
      // Hysteresis: stays lowered until half of the heat is gone
      hot_[i] = heat_[i] > (hot_[i] ? 0.5 : 1.0) * limits_.heat[i];
      if (hot_[i] && continuous < limit) limit = cooling * continuous;
      if (limits_.max_rise_rate[i] > 0) limit = std::min(limit, flowing_[i] + limits_.max_rise_rate[i] * dt);
      warm_ = warm_ || (hot_[i] && wanted[i] > cooling * continuous);
      flowing_[i] = std::min(wanted[i], limit);
    }
    return flowing_;
  }

  bool lowered_by_heat() const noexcept { return warm_; }  ///< True if heat lowered the last currents.
  const brake_currents<N>& flowing() const noexcept { return flowing_; }  ///< The last currents [A].
  void release() noexcept { flowing_ = {}; }  ///< Sets the currents to 0; keeps the heat of the coils.

 private:
  static constexpr double cooling = 0.95;  // fraction of the continuous current at which a coil cools

  current_limits<N> limits_;
  brake_currents<N> flowing_{};
  brake_currents<N> heat_{};
  std::array<bool, static_cast<std::size_t>(N)> hot_{};
  bool warm_ = false;
};

}  // namespace passive_haptics
