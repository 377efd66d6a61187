/// @file
/// Eddy currents: drag, and nothing at rest.
#pragma once

#include <passive_haptics/brake/brake_parameters.hpp>
#include <passive_haptics/brake/models/brake_model.hpp>
#include <passive_haptics/core/scalar/first_order_lag.hpp>

#include <cmath>

namespace passive_haptics {

/// A conductor that turns in the field of a coil. The command u <= peak_torque is the torque at the critical
/// rate w_c; at others it is
///
///     2 e / (|w| / w_c + w_c / |w|),  T_b de/dt + e = u,
///
/// so drag e 2 / w_c at low rates, and no torque at rest: the brake never sticks. Beyond w_c the torque
/// falls, as the eddy currents weaken the field. Wouterse, Critical torque and speed of eddy current brake
/// with widely separated soft iron poles, IEE Proceedings B 138(4), 1991. Exact for a command that is
/// constant over a step.
///
/// Default torque and rate: the axial-flux brake of Lubin and Rezzoug, 3-D analytical model for axial-flux
/// eddy-current couplings and brakes under steady-state conditions, IEEE Trans. Magnetics 51(10), 2015, with
/// a gap of 3 mm; this curve is within 4 % of theirs up to twice the critical rate. Its field is of permanent
/// magnets: the lag is assumed, that of brake_parameters.
template <class T>
struct eddy_current_brake {
  using scalar = T;  ///< Scalar.

  T peak_torque = T(27.76);    ///< At the critical rate, at the greatest current [N m].
  T critical_rate = T(102.1);  ///< w_c, of the greatest torque [rad/s].
  /// Time constant of the field [s].
  T time_constant = brake_parameters<T, 1>().time_constant[0];
  /// Friction of seals, drag of bearings.
  brake_resistance<T> residual = {};

  /// What it remembers.
  struct state {
    T excitation = T(0);  ///< e [N m].
  };

  /// Drag [N m s] of an excitation e [N m] at this rate.
  T drag_of(T excitation, T rate) const noexcept {
    const T ratio = valid_rate(rate) / critical_rate;
    return excitation * T(2) / (critical_rate * (T(1) + ratio * ratio));
  }
  /// Torque [N m] of an excitation e [N m] at this rate.
  T torque_of(T excitation, T rate) const noexcept {
    return drag_of(excitation, rate) * std::abs(valid_rate(rate));
  }

  /// See BrakeModel.
  brake_resistance<T> advance(T dt, T command, T rate, state& now) const noexcept {
    now.excitation =
        lagged(now.excitation, valid_command(command, peak_torque), valid_time_step(dt), time_constant);
    return {T(0), drag_of(now.excitation, rate)};
  }

  /// In proportion to the rate where it is low [N m].
  T torque_limit_at(T rate) const noexcept { return torque_of(peak_torque, rate); }

  /// Exact within the limit, at this rate.
  T command_for(T torque, T rate, const state&) const noexcept {
    return valid_command(torque / torque_of(T(1), rate), peak_torque);
  }

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = eddy_current_brake;
    return member_table(member("peak_torque", &p::peak_torque, "N m", range::not_negative),
                        member("critical_rate", &p::critical_rate, "rad/s", range::positive),
                        member("time_constant", &p::time_constant, "s", range::not_negative),
                        member("residual", &p::residual));
  }
  /// The drag at rest does not overflow.
  error_message rules() const {
    return check_value("2 peak_torque / critical_rate", drag_of(peak_torque, T(0)), "N m s", range::finite);
  }
};

}  // namespace passive_haptics
