/// Limits, dead bands and lags of the brakes.
#pragma once

#include <passive_haptics/brake/brake_concepts.hpp>

namespace passive_haptics {

/// The m brakes of a device, on their own axes. For a sliding brake, read N for N m and m/s for rad/s.
template <class T, int Brakes>
struct brake_parameters {
  /// Maximum torque [N m]. The paper gives none; 1 N m is a small magnetic-particle brake.
  vector<T, Brakes> torque_limit = vector<T, Brakes>::Constant(T(1));
  /// Karnopp dead band: rate below which a brake is at rest [rad/s].
  vector<T, Brakes> rate_dead_band = vector<T, Brakes>::Constant(T(0.02));
  /// Hand torques below this are ignored [N m]. Far below the resolution of force sensors; avoids denormals.
  vector<T, Brakes> torque_dead_band = vector<T, Brakes>::Constant(T(1e-9));
  /// Time constant of the first-order response [s]; section 5.1: about 20 ms.
  vector<T, Brakes> time_constant = vector<T, Brakes>::Constant(T(0.020));

  static constexpr auto members() {
    using p = brake_parameters;
    return member_table(
        member("torque_limit", &p::torque_limit, "N m", range::not_negative)
            .remark_at_zero("the brake is off"),
        member("rate_dead_band", &p::rate_dead_band, "rad/s", range::not_negative),
        member("torque_dead_band", &p::torque_dead_band, "N m", range::not_negative),
        member("time_constant", &p::time_constant, "s", range::not_negative).suspicious_above(1));
  }
};

/// Brakes with dead bands and explicitly without a torque limit.
template <class T, int Brakes>
struct unlimited_brake_parameters {
  static constexpr bool unlimited = true;  ///< Explicitly without a torque_limit.
  /// As in brake_parameters [rad/s].
  vector<T, Brakes> rate_dead_band = brake_parameters<T, Brakes>().rate_dead_band;
  /// As in brake_parameters [N m].
  vector<T, Brakes> torque_dead_band = brake_parameters<T, Brakes>().torque_dead_band;
};

/// The brakes of mechanism M.
template <class M>
using brakes_of = brake_parameters<typename M::scalar, M::brake_count>;

}  // namespace passive_haptics
