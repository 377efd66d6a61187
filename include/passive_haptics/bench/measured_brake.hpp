/// Parameters of controller, driver and simulation from bench results.
#pragma once

#include <passive_haptics/bench/magnetorheological_loop.hpp>
#include <passive_haptics/brake/brake_parameters.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/driver/calibration/brake_calibration.hpp>
#include <passive_haptics/plant/brakes/coulomb_brake.hpp>

#include <array>
#include <limits>
#include <string>

namespace passive_haptics {

/// Results of one brake's tests; default-constructed: no test. Use measured_brake_of().
struct measured_brake {
  estimate time_constant;       ///< Rising torque, or coil of a magnetorheological brake [s].
  estimate fall_time_constant;  ///< Falling torque [s].
  current_ramp ramp;            ///< With the delays of both.
  /// For the device's encoder on this axis: rate_dead_band(resolution, window, period) [rad/s].
  double rate_dead_band = std::numeric_limits<double>::quiet_NaN();
};

namespace detail {

inline std::string check_measured(const char* name, const estimate& found, const char* fix) {
  const std::string error = check_value(name, found.value, "", range::positive);
  if (!error.empty()) return std::string(error).append(": ").append(fix);
  if (!(found.standard_error < found.value))
    return error_text(std::string(name).append(".standard_error"), found.standard_error,
                      std::string("less than the value: ").append(fix));
  return check_time_constant(name, found.value);
}

}  // namespace detail

/// Returns an error text with what to do, empty if there is none.
inline std::string validate(const measured_brake& found) {
  const char *const step_up = "record a larger step up, and pass its fit_step_response",
                    *const step_down = "record a larger step down, and pass its fit_step_response";
  if (std::string text = detail::check_measured("time_constant [s]", found.time_constant, step_up);
      !text.empty())
    return text;
  if (std::string text =
          detail::check_measured("fall_time_constant [s]", found.fall_time_constant, step_down);
      !text.empty())
    return text;
  if (const std::string text = validate(found.ramp); !text.empty()) return std::string("ramp.").append(text);
  const std::string error = check_value("rate_dead_band", found.rate_dead_band, "rad/s", range::positive);
  if (error.empty()) return {};
  return std::string(error).append(": pass rate_dead_band(resolution, window, period) of its encoder");
}

/// Combines a step up, a step down and a ramp. rate_dead_band: see the member [rad/s]. Throws
/// std::invalid_argument with the text of validate(), or if the steps are not one up and one down.
inline measured_brake measured_brake_of(const step_response& up, const step_response& down,
                                        const current_ramp& ramp, double rate_dead_band) {
  detail::refuse_unless(up.change.value > 0, "up.change [N m]", up.change.value,
                        "> 0: pass the step up first, then the step down");
  detail::refuse_unless(down.change.value < 0, "down.change [N m]", down.change.value,
                        "< 0: pass the step up first, then the step down");
  return require_valid(measured_brake{up.time_constant, down.time_constant, ramp, rate_dead_band});
}

/// Results of a brake with hysteresis. Throws std::invalid_argument with the text of validate().
inline measured_brake measured_brake_of(const magnetorheological_identification& found,
                                        double rate_dead_band) {
  return require_valid(
      measured_brake{found.rising.time_constant, found.falling.time_constant, found.ramp, rate_dead_band});
}

/// Returns an error text with the brake's number, empty if there is none.
template <std::size_t Brakes>
std::string validate(const std::array<measured_brake, Brakes>& found) {
  for (std::size_t i = 0; i < Brakes; ++i)
    if (const std::string text = validate(found[i]); !text.empty())
      return detail::indexed("brakes[", i, "].").append(text);
  return {};
}

/// One result for each brake of mechanism M.
template <class M>
using measured_brakes_of = std::array<measured_brake, static_cast<std::size_t>(M::brake_count)>;

/// Brake parameters for a controller of mechanism M: torque_limit of the rising branch at the maximum
/// current; time_constant of the rise, because a law that relies on the fall bounces (docs/results.md);
/// rate_dead_band. Throws std::invalid_argument with the text of validate(found). For rate-dependent torque
/// use rate_limited_brakes.
template <class M>
brakes_of<M> measured_brakes(const measured_brakes_of<M>& found) {
  require_valid(found);
  using T = typename M::scalar;
  brakes_of<M> brakes;
  for (int i = 0; i < M::brake_count; ++i) {
    const measured_brake& one = nth(found, i);
    brakes.torque_limit[i] = static_cast<T>(one.ramp.rising.back().value);
    brakes.time_constant[i] = static_cast<T>(one.time_constant.value);
    brakes.rate_dead_band[i] = static_cast<T>(one.rate_dead_band);
  }
  return require_valid(brakes);
}

/// Curves for a brake_calibration. Throws std::invalid_argument with the text of validate(found).
template <std::size_t Brakes>
std::array<brake_curve, Brakes> measured_curves(const std::array<measured_brake, Brakes>& found) {
  require_valid(found);
  std::array<brake_curve, Brakes> curves;
  for (std::size_t i = 0; i < Brakes; ++i) curves[i] = found[i].ramp.curve();
  return curves;
}

/// The brake for a simulation, without hysteresis. Its command is the torque of the curve without the
/// residual torque [N m], so its gain is 1. Throws std::invalid_argument with the text of validate(found).
inline coulomb_brake<double> simulated_brake(const measured_brake& found) {
  require_valid(found);
  const double residual = found.ramp.curve().residual_torque, rise = found.time_constant.value;
  return {.torque_limit = found.ramp.rising.back().value - residual,
          .time_constant = rise,
          .fall_ratio = found.fall_time_constant.value / rise,
          .residual = {.strength = residual}};
}

}  // namespace passive_haptics
