/// @file
/// What the brakes of a simulated device really do, whatever its controller believes.
#pragma once

#include <passive_haptics/brake/brake_parameters.hpp>
#include <passive_haptics/brake/models/first_order_lag.hpp>

namespace passive_haptics {

/// The m real brakes of a simulated device, each value on the brake's own axis. Brake i resists with
///
///     (strength_i + residual_torque_i) of Coulomb friction  +  viscous_drag_i w_i,
///     lag_i d strength_i / dt + strength_i = min(gain_i capacity_i, torque_limit_i),
///     lag_i = time_constant_i where the strength rises, fall_ratio_i time_constant_i where it falls.
///
/// For a sliding brake read N for N m and m/s for rad/s.
template <class T, int Brakes>
struct simulated_brakes {
  /// Largest torque that can be commanded [N m]; that of brake_parameters.
  vector<T, Brakes> torque_limit = vector<T, Brakes>::Constant(T(1));
  /// Time constant of the first-order response [s]; section 5.1: about 20 ms.
  vector<T, Brakes> time_constant = vector<T, Brakes>::Constant(T(0.020));
  /// Time constant of a falling strength for that of a rising one [1]; remanence makes it more than 1.
  vector<T, Brakes> fall_ratio = vector<T, Brakes>::Ones();
  /// Real torque for each commanded one [1]; 1 is a brake calibrated without error.
  vector<T, Brakes> gain = vector<T, Brakes>::Ones();
  /// Friction that is there without current, as of seals or remanence [N m].
  vector<T, Brakes> residual_torque = vector<T, Brakes>::Zero();
  /// Viscous drag, as of bearings or the brake's fluid [N m s].
  vector<T, Brakes> viscous_drag = vector<T, Brakes>::Zero();

  /// Strength [N m] that commanded capacities [N m] end in; a capacity that is negative or NaN releases its
  /// brake.
  vector<T, Brakes> strength(const vector<T, Brakes>& capacity) const {
    return (capacity.array() > T(0)).select(gain.cwiseProduct(capacity).cwiseMin(torque_limit), T(0));
  }

  /// Strength [N m] a time dt [s] later, under a command that ends in `target` [N m]; exact for a constant
  /// one.
  vector<T, Brakes> strength_after(T dt, const vector<T, Brakes>& strength,
                                   const vector<T, Brakes>& target) const {
    vector<T, Brakes> after;
    for (int i = 0; i < Brakes; ++i) {
      const T lag = target[i] < strength[i] ? fall_ratio[i] * time_constant[i] : time_constant[i];
      after[i] = lagged(strength[i], target[i], dt, lag);
    }
    return after;
  }

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = simulated_brakes;
    return member_table(
        member("torque_limit", &p::torque_limit, "N m", range::not_negative, plausible(0.01, 1000)),
        member("time_constant", &p::time_constant, "s", range::not_negative, plausible(0, 1)),
        member("fall_ratio", &p::fall_ratio, "1", range::positive, plausible(0.1, 10)),
        member("gain", &p::gain, "1", range::not_negative, plausible(0.1, 10)),
        member("residual_torque", &p::residual_torque, "N m", range::not_negative, plausible(0, 10)),
        member("viscous_drag", &p::viscous_drag, "N m s", range::not_negative, plausible(0, 10)));
  }
};

/// The real brakes of mechanism M.
template <class M>
using simulated_brakes_of = simulated_brakes<typename M::scalar, M::brake_count>;

/// Brakes that are what their controller believes: its limits and lags, gain 1, nothing residual, no drag.
template <class T, int Brakes>
simulated_brakes<T, Brakes> ideal_brakes(const brake_parameters<T, Brakes>& believed) {
  simulated_brakes<T, Brakes> real;
  real.torque_limit = believed.torque_limit;
  real.time_constant = believed.time_constant;
  return real;
}

}  // namespace passive_haptics
