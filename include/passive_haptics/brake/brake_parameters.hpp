/// @file
/// Limits, dead bands and lags of the brakes.
#pragma once

#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/core/validate.hpp>

#include <string>

namespace passive_haptics {

/// The m brakes of a device, each value on the brake's own axis. For a sliding brake read N for N m and m/s for rad/s.
template <class T, int Brakes>
struct brake_parameters {
  /// Largest torque [N m]. The paper prints none; 1 N m is a small magnetic-particle brake.
  vector<T, Brakes> torque_limit = vector<T, Brakes>::Constant(T(1));
  /// Karnopp dead band: a slower brake counts as at rest [rad/s].
  vector<T, Brakes> rate_dead_band = vector<T, Brakes>::Constant(T(0.02));
  /// A smaller hand torque counts as none [N m]; far below any force sensor, so that no denormal is computed with.
  vector<T, Brakes> torque_dead_band = vector<T, Brakes>::Constant(T(1e-9));
  /// Time constant of the first-order response [s]; section 5.1: about 20 ms.
  vector<T, Brakes> time_constant = vector<T, Brakes>::Constant(T(0.020));
};

/// The brakes of mechanism M.
template <class M>
using brakes_of = brake_parameters<typename M::scalar, M::brake_count>;

/// What is wrong with the parameters; empty if nothing.
template <class T, int Brakes>
std::string validate(const brake_parameters<T, Brakes>& p) {
  return detail::first_complaint(
      detail::check_each_not_negative("torque_limit", "N m", p.torque_limit),
      detail::check_each_not_negative("rate_dead_band", "rad/s", p.rate_dead_band),
      detail::check_each_not_negative("torque_dead_band", "N m", p.torque_dead_band),
      detail::check_each_not_negative("time_constant", "s", p.time_constant));
}

}  // namespace passive_haptics
