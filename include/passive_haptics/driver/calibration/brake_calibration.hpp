/// @file
/// From the torques that a controller commands to currents.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/driver/calibration/brake_curve.hpp>
#include <passive_haptics/driver/port.hpp>

namespace passive_haptics {

/// The curve of each brake.
template <int Brakes>
using brake_curves = std::array<brake_curve, static_cast<std::size_t>(Brakes)>;

/// What is wrong with the curves, with the brake's number; empty if nothing.
template <std::size_t Brakes>
std::string validate(const std::array<brake_curve, Brakes>& curves) {
  return check_value("brakes", curves, "", range::anything);
}

/// Currents for commanded capacities, and what they come to. With hysteresis h a brake is taken for a play of
/// this width,
///
///     rising(I) <= torque <= rising(I) + h,
///
/// which keeps its torque until one side pushes it (the simplest of Prandtl's and Ishlinskii's). Its exact
/// inverse: the current for the capacity itself while that grows, for capacity - h while it falls. So a
/// capacity that trembles makes the current jump by h over the slope; and after a fall to 0 A the brake is
/// taken to hold its residual torque + h until more is commanded.
///
/// No brake is made to give more than its capacity, or its residual torque + h where that is more.
template <int Brakes>
class brake_calibration {
 public:
  /// Throws std::invalid_argument with the text of validate(curves).
  explicit brake_calibration(const brake_curves<Brakes>& curves) : curves_(require_valid(curves)) { reset(); }

  /// Currents [A], each in [0, current_limit], for capacities [N m]; 0 for one that is negative or NaN. With
  /// the brakes' temperatures [K], where they are measured: see current_of_torque.
  brake_currents<Brakes> currents(
      const vector<double, Brakes>& capacity,
      const vector<double, Brakes>& temperature = unknown_temperatures()) noexcept {
    brake_currents<Brakes> all{};
    for (int i = 0; i < Brakes; ++i) nth(all, i) = current(i, capacity[i], temperature[i]);
    return all;
  }

  /// Torques [N m] that the brakes are taken to have made of the last currents, when their lag is over.
  const vector<double, Brakes>& torque() const noexcept { return torque_; }

  /// Brakes without current and without remanence, as after a long pause.
  void reset() noexcept {
    for (int i = 0; i < Brakes; ++i) torque_[i] = nth(curves_, i).residual_torque;
    falling_ = {};
  }

  /// Of brakes whose temperature nobody measures: NaN [K].
  static vector<double, Brakes> unknown_temperatures() noexcept {
    return vector<double, Brakes>::Constant(unknown_temperature);
  }

 private:
  double current(int i, double capacity, double temperature) noexcept {
    const brake_curve& p = nth(curves_, i);
    bool& falling = nth(falling_, i);
    double& torque = torque_[i];
    const double asked = capacity > 0 ? capacity : 0;
    if (asked != torque) falling = asked < torque;
    const double coil_current = current_of_torque(p, asked - (falling ? p.hysteresis : 0), temperature);
    const double rising = torque_of_current(p, coil_current, temperature);
    // What it makes at an end of its range; within, the very number, so that the same capacity is no change
    const bool within = coil_current > 0 && coil_current < p.current_limit;
    torque = within ? asked : std::max(rising, std::min(torque, rising + p.hysteresis));
    return coil_current;
  }

  brake_curves<Brakes> curves_;
  vector<double, Brakes> torque_;
  std::array<bool, static_cast<std::size_t>(Brakes)> falling_;  // which branch each is on
};

}  // namespace passive_haptics
