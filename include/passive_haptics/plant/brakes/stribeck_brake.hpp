/// Dry friction with a higher torque at rest than in slip.
#pragma once

#include <passive_haptics/plant/brakes/coulomb_brake.hpp>

#include <cmath>

namespace passive_haptics {

/// A coulomb_brake with a strength that falls from rest to slip,
///
///     tau g(w),  g(w) = 1 + (static_ratio - 1) exp(-(w / stribeck_rate)^2),
///
/// where tau is its lagged command: the steady curve of Canudas de Wit, Olsson, Astrom and Lischinsky, A new
/// model for control of systems with friction, IEEE Trans. Automatic Control 40(3), 1995. Defaults by its
/// simulations, at a radius of 20 mm; not measured on a brake. Presliding (micrometres) is not modelled.
template <class T>
struct stribeck_brake {
  using scalar = T;                                ///< Scalar.
  using state = typename coulomb_brake<T>::state;  ///< As the Coulomb friction.

  coulomb_brake<T> coulomb = {};  ///< Friction in fast slip.
  T static_ratio = T(1.5);        ///< Strength at rest relative to fast slip [1].
  T stribeck_rate = T(0.05);      ///< Rate at which 1/e of the difference remains [rad/s].

  /// g(w) [1].
  T factor(T rate) const noexcept {
    const T ratio = valid_rate(rate) / stribeck_rate;
    return T(1) + (static_ratio - T(1)) * std::exp(-ratio * ratio);
  }

  /// As BrakeModel.
  brake_resistance<T> advance(T dt, T command, T rate, state& now) const noexcept {
    return {factor(rate) * coulomb.advance(dt, command, rate, now).strength, T(0)};
  }

  /// torque_limit g(w) [N m].
  T torque_limit_at(T rate) const noexcept { return factor(rate) * coulomb.torque_limit; }

  /// Exact within the limit, at this rate.
  T command_for(T torque, T rate, const state& now) const noexcept {
    return coulomb.command_for(torque / factor(rate), rate, now);
  }

  const brake_resistance<T>& residual() const { return coulomb.residual; }  ///< As the Coulomb friction.

  static constexpr auto members() {
    using p = stribeck_brake;
    return member_table(member("coulomb", &p::coulomb),
                        member("static_ratio", &p::static_ratio, "1", range::at_least(1)),
                        member("stribeck_rate", &p::stribeck_rate, "rad/s", range::positive));
  }
  /// Requires that the strength at rest does not overflow.
  error_message rules() const {
    return check_value("static_ratio torque_limit", torque_limit_at(T(0)), "N m", range::finite);
  }
};

}  // namespace passive_haptics
