/// Encoders and brakes for a board without them.
#pragma once

#include <serial/serial_protocol.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace firmware {

/// Brakes without lag, and encoders on axes that a hand moves back and forth, slower the more its brake
/// resists; after a delay it returns to its path. Then it rests for a while, so that a host finds the home
/// pose.
class simulated_axes {
 public:
  static constexpr double hand_rate = 20'000;    ///< Encoder without brake [counts/s].
  static constexpr double hand_frequency = 0.5;  ///< Back and forth [Hz].
  static constexpr double hand_lag = 0.1;        ///< Time to return to its path [s].
  static constexpr double moves = 4, rests = 2;  ///< Durations, alternating [s].
  static constexpr double holding = 5000;        ///< Current that stops the hand [serial::current_unit].

  void set_current(std::size_t i, std::uint16_t current) { current_[i] = current; }
  /// Of brake i [serial::current_unit].
  std::uint16_t current(std::size_t i) const { return current_[i]; }
  std::int32_t read_encoder(std::size_t i) const {
    return static_cast<std::int32_t>(static_cast<std::int64_t>(std::floor(position_[i])));
  }

  /// Advances by dt [s].
  void advance(double dt) {
    time_ += dt;
    if (std::fmod(time_, moves + rests) > moves) return;
    const double w = 2 * std::numbers::pi * hand_frequency, comes_back = std::min(1.0, dt / hand_lag);
    for (std::size_t i = 0; i < position_.size(); ++i) {
      const auto phase = static_cast<double>(i);
      const double path = hand_rate / w * (std::sin(w * time_ + phase) - std::sin(phase));
      const double free = std::max(0.0, 1 - current_[i] / holding);
      position_[i] += free * comes_back * (path - position_[i]);
    }
  }

 private:
  double time_ = 0;                                               // [s]
  std::array<double, example::serial::max_channels> position_{};  // [counts]
  std::array<std::uint16_t, example::serial::max_channels> current_{};
};

}  // namespace firmware
