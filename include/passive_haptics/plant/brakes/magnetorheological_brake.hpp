/// @file
/// Magnetorheological fluid, whose magnetic circuit has hysteresis.
#pragma once

#include <passive_haptics/brake/brake_parameters.hpp>
#include <passive_haptics/brake/models/brake_model.hpp>
#include <passive_haptics/core/scalar/first_order_lag.hpp>

#include <algorithm>
#include <cmath>

namespace passive_haptics {

/// f(m) of a magnetorheological_brake: torque [N m] of a magnetisation m >= 0 for the greatest current [1],
/// torque_limit tanh(k m) / tanh(k) with k = saturation [1]. Of any scalars that have a tanh.
template <class S, class M>
auto saturating_torque(const S& torque_limit, const S& saturation, const M& m) {
  using std::tanh;
  return torque_limit * (tanh(saturation * m) / tanh(saturation));
}

/// Friction whose strength follows the coil current around a loop. With j the current for the greatest one,
/// c = coercive_current and k = saturation:
///
///     T_b dj/dt + j = f^-1(u)                 the coil, commanded through the calibrated curve f,
///     m in [j - c, j + c], moved by its ends  the magnetisation: a play of half-width c,
///     tau = f(m),  f(m) = torque_limit tanh(k m) / tanh(k).
///
/// So on the way up a brake makes f(j - c), on the way down f(j + c), and it keeps f(c) when it is released:
/// remanence. The loop closes as the iron saturates. A play under a curve is the generalised Prandtl-
/// Ishlinskii operator with one play (Brokate and Sprekels, Hysteresis and Phase Transitions, 1996); it is
/// independent of the rate, the lag makes the loop wider at higher frequencies. Exact for a command that is
/// constant over a step.
///
/// The defaults are assumed, of no published device: identify them at the bench. Other models beside a
/// measured clutch: Actuators 12(5), 190, 2023; this one was not compared with its loops.
template <class T>
struct magnetorheological_brake {
  using scalar = T;  ///< Scalar.

  /// Torque of the calibrated curve at the greatest current [N m].
  T torque_limit = brake_parameters<T, 1>().torque_limit[0];
  T saturation = T(1.5);         ///< k [1]; the greater, the flatter the curve ends.
  T coercive_current = T(0.02);  ///< c, for the greatest current [1].
  /// Time constant of the coil [s].
  T time_constant = brake_parameters<T, 1>().time_constant[0];
  /// Friction of seals, drag of the fluid.
  brake_resistance<T> residual = {};

  /// What it remembers, for the greatest current [1].
  struct state {
    T current = T(0);        ///< j.
    T magnetisation = T(0);  ///< m; never < 0, as j is not.
  };

  /// f: torque [N m] of a magnetisation m >= 0.
  T torque_of(T m) const noexcept { return saturating_torque(torque_limit, saturation, m); }
  /// f^-1: magnetisation in [0, 1] of a torque [N m].
  T magnetisation_of(T torque) const noexcept {
    const T share = valid_command(torque, torque_limit) / torque_limit;
    return torque_limit > T(0) ? std::min(std::atanh(share * std::tanh(saturation)) / saturation, T(1))
                               : T(0);
  }

  /// See BrakeModel.
  brake_resistance<T> advance(T dt, T command, T /*rate*/, state& now) const noexcept {
    now.current = lagged(now.current, magnetisation_of(command), valid_time_step(dt), time_constant);
    now.magnetisation =
        std::clamp(now.magnetisation, now.current - coercive_current, now.current + coercive_current);
    return {torque_of(now.magnetisation), T(0)};
  }

  /// Largest torque [N m], equal at every rate.
  T torque_limit_at(T /*rate*/) const noexcept { return torque_limit; }

  /// Exact between what remanence keeps and the greatest current can reach.
  T command_for(T torque, T /*rate*/, const state& now) const noexcept {
    const T m = magnetisation_of(torque);
    const T ahead = m > now.magnetisation ? coercive_current : -coercive_current;
    return torque_of(std::clamp(m + ahead, T(0), T(1)));
  }

  /// The table of core/parameters.hpp.
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
