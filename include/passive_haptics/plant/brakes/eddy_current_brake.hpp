/// Eddy-current brakes: drag, and no torque at rest.
#pragma once

#include <passive_haptics/brake/brake_parameters.hpp>
#include <passive_haptics/brake/models/brake_model.hpp>
#include <passive_haptics/core/scalar/first_order_lag.hpp>

#include <cmath>

namespace passive_haptics {

/// A conductor that rotates in the field of a coil. The command u <= peak_torque is the torque at the
/// critical rate w_c; the torque at a rate w is
///
///     2 e / (|w| / w_c + w_c / |w|),  T_b de/dt + e = u,
///
/// that is a drag of 2 e / w_c at low rates, and no torque at rest: the brake never sticks. Wouterse,
/// Critical torque and speed of eddy current brake with widely separated soft iron poles, IEE Proceedings B
/// 138(4), 1991. Exact for a command that is constant over a step.
///
/// Default torque and rate: Lubin and Rezzoug, 3-D analytical model for axial-flux eddy-current couplings and
/// brakes under steady-state conditions, IEEE Trans. Magnetics 51(10), 2015, gap 3 mm; within 4 % of their
/// curve up to twice the critical rate. The lag is assumed.
template <class T>
struct eddy_current_brake {
  using scalar = T;  ///< Scalar.

  T peak_torque = T(27.76);    ///< At the critical rate and maximum current [N m].
  T critical_rate = T(102.1);  ///< w_c, rate of the maximum torque [rad/s].
  T time_constant = brake_parameters<T, 1>().time_constant[0];  ///< Time constant of the field [s].
  brake_resistance<T> residual = {};                            ///< Friction of seals, drag of bearings.

  /// State.
  struct state {
    T excitation = T(0);  ///< e [N m].
  };

  /// Drag [N m s] for an excitation e [N m] at this rate.
  T drag_of(T excitation, T rate) const noexcept {
    const T ratio = valid_rate(rate) / critical_rate;
    return excitation * T(2) / (critical_rate * (T(1) + ratio * ratio));
  }
  /// Torque [N m] for an excitation e [N m] at this rate.
  T torque_of(T excitation, T rate) const noexcept {
    return drag_of(excitation, rate) * std::abs(valid_rate(rate));
  }

  /// As BrakeModel.
  brake_resistance<T> advance(T dt, T command, T rate, state& now) const noexcept {
    now.excitation =
        lagged(now.excitation, valid_command(command, peak_torque), valid_time_step(dt), time_constant);
    return {T(0), drag_of(now.excitation, rate)};
  }

  /// Maximum torque [N m], proportional to low rates.
  T torque_limit_at(T rate) const noexcept { return torque_of(peak_torque, rate); }

  /// Exact within the limit, at this rate.
  T command_for(T torque, T rate, const state&) const noexcept {
    return valid_command(torque / torque_of(T(1), rate), peak_torque);
  }

  static constexpr auto members() {
    using p = eddy_current_brake;
    return member_table(member("peak_torque", &p::peak_torque, "N m", range::not_negative),
                        member("critical_rate", &p::critical_rate, "rad/s", range::positive),
                        member("time_constant", &p::time_constant, "s", range::not_negative),
                        member("residual", &p::residual));
  }
  /// Requires that the drag at rest does not overflow.
  error_message rules() const {
    return check_value("2 peak_torque / critical_rate", drag_of(peak_torque, T(0)), "N m s", range::finite);
  }
};

}  // namespace passive_haptics
