/// Brakes that can be off or one-way, for a control cycle.
#pragma once

#include <passive_haptics/brake/brake_parameters.hpp>

#include <limits>

namespace passive_haptics {

/// The m brakes of a device, each of which may be off or one-way. For a controller or a step:
///
///     ph::switchable_brakes<device> brakes;  // all on
///     brakes.switch_off(1);                  // its clutch is released
///     control.set_brakes(brakes);            // from the next cycle on
template <class T, int Brakes>
struct switchable_brake_parameters {
  static constexpr T unbounded = std::numeric_limits<T>::infinity();  ///< Infinity, for no bound [N m].

  vector<T, Brakes> torque_limit = brake_parameters<T, Brakes>().torque_limit;  ///< As in brake_parameters.
  /// Minimum torque on the brake's own axis, signed [N m], <= 0; -inf means -torque_limit.
  vector<T, Brakes> torque_lower = vector<T, Brakes>::Constant(-unbounded);
  /// Maximum torque on the brake's own axis, signed [N m], >= 0; inf means torque_limit.
  vector<T, Brakes> torque_upper = vector<T, Brakes>::Constant(unbounded);
  vector<T, Brakes> rate_dead_band = brake_parameters<T, Brakes>().rate_dead_band;      ///< As there.
  vector<T, Brakes> torque_dead_band = brake_parameters<T, Brakes>().torque_dead_band;  ///< As there.
  vector<T, Brakes> time_constant = brake_parameters<T, Brakes>().time_constant;        ///< As there.

  switchable_brake_parameters() = default;  ///< Default values; all brakes are on.
  /// These brakes; all are on.
  switchable_brake_parameters(const brake_parameters<T, Brakes>& brakes)
      : torque_limit(brakes.torque_limit),
        rate_dead_band(brakes.rate_dead_band),
        torque_dead_band(brakes.torque_dead_band),
        time_constant(brakes.time_constant) {}

  void switch_on(int i) noexcept { set_bounds(i, -unbounded, unbounded); }  ///< Brake i works both ways.
  void switch_off(int i) noexcept { set_bounds(i, T(0), T(0)); }            ///< Brake i has no torque.
  void make_positive(int i) noexcept { set_bounds(i, T(0), unbounded); }    ///< Torque >= 0, against w < 0.
  void make_negative(int i) noexcept { set_bounds(i, -unbounded, T(0)); }   ///< Torque <= 0, against w > 0.

  static constexpr auto members() {
    using p = switchable_brake_parameters;
    return member_table(
        member("torque_limit", &p::torque_limit, "N m", range::not_negative)
            .remark_at_zero("the brake is off"),
        member("torque_lower", &p::torque_lower, "N m", lower_torques),
        member("torque_upper", &p::torque_upper, "N m", upper_torques),
        member("rate_dead_band", &p::rate_dead_band, "rad/s", range::not_negative),
        member("torque_dead_band", &p::torque_dead_band, "N m", range::not_negative),
        member("time_constant", &p::time_constant, "s", range::not_negative).suspicious_above(1));
  }

 private:
  void set_bounds(int i, T lower, T upper) noexcept {
    torque_lower[i] = lower;
    torque_upper[i] = upper;
  }
};

/// The brakes of mechanism M, each on, off or one-way.
template <class M>
using switchable_brakes = switchable_brake_parameters<typename M::scalar, M::brake_count>;

}  // namespace passive_haptics
