/// Coulomb friction with a first-order lag, as in section 5.1.
#pragma once

#include <passive_haptics/brake/brake_parameters.hpp>
#include <passive_haptics/brake/models/brake_model.hpp>
#include <passive_haptics/core/scalar/first_order_lag.hpp>

#include <array>

namespace passive_haptics {

/// Coulomb friction of strength tau under the command u [N m],
///
///     T_b dtau/dt + tau = min(gain u, torque_limit),
///
/// with T_b = time_constant for rising tau and fall_ratio time_constant for falling tau. Exact for a command
/// that is constant over a step. The default is a small magnetic-particle brake with the lag of section 5.1.
template <class T>
struct coulomb_brake {
  using scalar = T;  ///< Scalar.

  T torque_limit = brake_parameters<T, 1>().torque_limit[0];    ///< Maximum torque [N m].
  T time_constant = brake_parameters<T, 1>().time_constant[0];  ///< Time constant of a rising strength [s].
  /// Time constant of a falling strength, relative to a rising one [1]; above 1 with remanence.
  T fall_ratio = T(1);
  T gain = T(1);  ///< Actual torque per commanded torque [1]; 1 without calibration error.
  brake_resistance<T> residual = {};  ///< Friction of seals, drag of bearings or fluid.

  /// State.
  struct state {
    T strength = T(0);  ///< [N m]
  };

  /// As BrakeModel.
  brake_resistance<T> advance(T dt, T command, T /*rate*/, state& now) const noexcept {
    const T target = valid_command(gain * command, torque_limit);
    const T lag = target < now.strength ? fall_ratio * time_constant : time_constant;
    now.strength = lagged(now.strength, target, valid_time_step(dt), lag);
    return {now.strength, T(0)};
  }

  /// Maximum torque [N m], at any rate.
  T torque_limit_at(T /*rate*/) const noexcept { return torque_limit; }

  /// Exact within the limit.
  T command_for(T torque, T /*rate*/, const state&) const noexcept {
    return valid_command(torque, torque_limit) / gain;
  }

  static constexpr auto members() {
    using p = coulomb_brake;
    return member_table(member("torque_limit", &p::torque_limit, "N m", range::not_negative),
                        member("time_constant", &p::time_constant, "s", range::not_negative),
                        member("fall_ratio", &p::fall_ratio, "1", range::positive),
                        member("gain", &p::gain, "1", range::positive), member("residual", &p::residual));
  }
};

/// A magnetic-particle brake of 7.5 N m: MAGPOWR GBA, Maxcess Designer's Notebook 2015, page 119 (rated
/// torque, time constant of the torque after a step, drag torque without excitation).
template <class T>
constexpr coulomb_brake<T> magnetic_particle_brake() {
  return {.torque_limit = T(7.5), .time_constant = T(0.22), .residual = {.strength = T(0.09)}};
}

/// One brake model for each brake of mechanism M.
template <class M, class Model = coulomb_brake<typename M::scalar>>
using brake_models_of = std::array<Model, static_cast<std::size_t>(M::brake_count)>;

/// Brakes with the limits and lags of their controller's parameters, gain 1 and no residual resistance.
template <class T, int Brakes>
std::array<coulomb_brake<T>, static_cast<std::size_t>(Brakes)> ideal_brakes(
    const brake_parameters<T, Brakes>& believed) {
  std::array<coulomb_brake<T>, static_cast<std::size_t>(Brakes)> real;
  for (std::size_t i = 0; i < real.size(); ++i) {
    real[i].torque_limit = believed.torque_limit[static_cast<int>(i)];
    real[i].time_constant = believed.time_constant[static_cast<int>(i)];
  }
  return real;
}

}  // namespace passive_haptics
