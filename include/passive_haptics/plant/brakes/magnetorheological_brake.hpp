/// Magnetorheological brakes with magnetic hysteresis.
#pragma once

#include <passive_haptics/brake/brake_parameters.hpp>
#include <passive_haptics/brake/models/brake_model.hpp>
#include <passive_haptics/core/scalar/first_order_lag.hpp>

#include <algorithm>
#include <cmath>

namespace passive_haptics {

/// f(m) of magnetorheological_brake: torque [N m] for a magnetisation m >= 0 relative to that of the maximum
/// current [1], torque_limit tanh(k m) / tanh(k) with k = saturation [1]. For any scalars with a tanh.
template <class S, class M>
auto saturating_torque(const S& torque_limit, const S& saturation, const M& m) {
  using std::tanh;
  return torque_limit * (tanh(saturation * m) / tanh(saturation));
}

/// Friction with a strength that follows the coil current around a hysteresis loop. With j the current
/// relative to its maximum, c = coercive_current and k = saturation:
///
///     T_b dj/dt + j = f^-1(u)                 coil, commanded through the calibrated curve f,
///     m in [j - c, j + c], moved by its ends  magnetisation: play of half-width c,
///     tau = f(m),  f(m) = torque_limit tanh(k m) / tanh(k).
///
/// The brake produces f(j - c) for rising and f(j + c) for falling currents, and keeps the remanence f(c)
/// when released: the generalised Prandtl-Ishlinskii operator with one play (Brokate and Sprekels, Hysteresis
/// and Phase Transitions, 1996). Exact for a command that is constant over a step. The defaults are assumed:
/// identify them at the bench.
template <class T>
struct magnetorheological_brake {
  using scalar = T;  ///< Scalar.

  /// Torque of the calibrated curve at maximum current [N m].
  T torque_limit = brake_parameters<T, 1>().torque_limit[0];
  T saturation = T(1.5);         ///< k [1]; a greater value flattens the end of the curve.
  T coercive_current = T(0.02);  ///< c, relative to the maximum current [1].
  T time_constant = brake_parameters<T, 1>().time_constant[0];  ///< Time constant of the coil [s].
  brake_resistance<T> residual = {};                            ///< Friction of seals, drag of fluid.

  /// State, relative to the maximum current [1].
  struct state {
    T current = T(0);        ///< j.
    T magnetisation = T(0);  ///< m >= 0.
  };

  /// f: torque [N m] for a magnetisation m >= 0.
  T torque_of(T m) const noexcept { return saturating_torque(torque_limit, saturation, m); }
  /// f^-1: magnetisation in [0, 1] for a torque [N m].
  T magnetisation_of(T torque) const noexcept {
    const T share = valid_command(torque, torque_limit) / torque_limit;
    return torque_limit > T(0) ? std::min(std::atanh(share * std::tanh(saturation)) / saturation, T(1))
                               : T(0);
  }

  /// As BrakeModel.
  brake_resistance<T> advance(T dt, T command, T /*rate*/, state& now) const noexcept {
    now.current = lagged(now.current, magnetisation_of(command), valid_time_step(dt), time_constant);
    now.magnetisation =
        std::clamp(now.magnetisation, now.current - coercive_current, now.current + coercive_current);
    return {torque_of(now.magnetisation), T(0)};
  }

  /// Maximum torque [N m], at any rate.
  T torque_limit_at(T /*rate*/) const noexcept { return torque_limit; }

  /// Exact between remanence and the maximum current.
  T command_for(T torque, T /*rate*/, const state& now) const noexcept {
    const T m = magnetisation_of(torque);
    const T ahead = m > now.magnetisation ? coercive_current : -coercive_current;
    return torque_of(std::clamp(m + ahead, T(0), T(1)));
  }

  static constexpr auto members() {
    using p = magnetorheological_brake;
    return member_table(member("torque_limit", &p::torque_limit, "N m", range::not_negative),
                        member("saturation", &p::saturation, "1", range::positive),
                        member("coercive_current", &p::coercive_current, "1", range::not_negative),
                        member("time_constant", &p::time_constant, "s", range::not_negative),
                        member("residual", &p::residual));
  }
};

}  // namespace passive_haptics
