/// Conversion of commanded torques to currents.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/driver/calibration/brake_curve.hpp>
#include <passive_haptics/driver/port.hpp>

namespace passive_haptics {

/// The curve of each brake.
template <int Brakes>
using brake_curves = std::array<brake_curve, static_cast<std::size_t>(Brakes)>;

/// Returns an error text with the brake's number, empty if there is none.
template <std::size_t Brakes>
std::string validate(const std::array<brake_curve, Brakes>& curves) {
  return check_value("brakes", curves, "", range::anything);
}

/// Converts commanded capacities to currents, and predicts the torques. Hysteresis h is modelled as a play of
/// this width (Prandtl-Ishlinskii),
///
///     rising(I) <= torque <= rising(I) + h,
///
/// and inverted exactly: rising capacities get the current for the capacity, falling ones that for capacity -
/// h. After a fall to 0 A the brake is assumed to hold its residual torque + h until more is commanded. No
/// brake produces more than its capacity, or its residual torque + h if that is more.
template <int Brakes>
class brake_calibration {
 public:
  /// Throws std::invalid_argument with the text of validate(curves).
  explicit brake_calibration(const brake_curves<Brakes>& curves) : curves_(require_valid(curves)) { reset(); }

  /// Returns the currents [A] in [0, current_limit] for capacities [N m]; 0 for a negative or NaN capacity.
  /// temperature [K]: see current_of_torque.
  brake_currents<Brakes> currents(
      const vector<double, Brakes>& capacity,
      const vector<double, Brakes>& temperature = unknown_temperatures()) noexcept {
    brake_currents<Brakes> all{};
    for (int i = 0; i < Brakes; ++i) nth(all, i) = current(i, capacity[i], temperature[i]);
    return all;
  }

  /// Predicted torques [N m] for the last currents, after the lag.
  const vector<double, Brakes>& torque() const noexcept { return torque_; }

  /// Resets to brakes without current and remanence.
  void reset() noexcept {
    for (int i = 0; i < Brakes; ++i) torque_[i] = nth(curves_, i).residual_torque;
    falling_ = {};
  }

  /// NaN [K], for brakes without a temperature sensor.
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
    // At the ends of its range as predicted; else exactly `asked`, so that an equal capacity is no change
    const bool within = coil_current > 0 && coil_current < p.current_limit;
    torque = within ? asked : std::max(rising, std::min(torque, rising + p.hysteresis));
    return coil_current;
  }

  brake_curves<Brakes> curves_;
  vector<double, Brakes> torque_;
  std::array<bool, static_cast<std::size_t>(Brakes)> falling_;  // branch of each brake
};

}  // namespace passive_haptics
