/// @file
/// Friction on a wall: dry and viscous resistance to motion along it.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/force/effects/resistance.hpp>

#include <type_traits>

namespace passive_haptics {

/// How rough a wall is.
template <class T>
struct wall_friction_parameters {
  T coefficient = T(0);                                  ///< mu >= 0: dry friction over normal force.
  T viscosity = T(0);                                    ///< b >= 0 [N s/m].
  T velocity_dead_band = default_velocity_dead_band<T>;  ///< Slower counts as at rest [m/s], > 0.

  static constexpr const char* type_name = "wall_friction";  ///< In errors.
  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = wall_friction_parameters;
    return member_table(member("coefficient", &p::coefficient, "", range::not_negative),
                        member("viscosity", &p::viscosity, "N s/m", range::not_negative),
                        member("velocity_dead_band", &p::velocity_dead_band, "m/s", range::positive));
  }
};

/// Force with which the hand presses on a wall of unit normal n [N]: max(0, -n . Fh).
///
/// The load for wall_friction. k depth is none: of the 5e4 N that a stiff wall demands, brakes display what
/// the hand presses.
template <class T, int D>
T pressing_force(const vector<T, D>& n, const std::type_identity_t<vector<T, D>>& hand_force) {
  const T pressing = -n.dot(hand_force);
  return pressing > T(0) ? pressing : T(0);
}

/// Friction [N] on a handle at a wall with unit normal n that carries a load >= 0 [N]. Base frame.
///
///   F = -mu load v_t / |v_t| - b v_t,    v_t = (I - n n^T) v
///
/// where the dry part is resistance(): inside the dead band it holds against the hand force along the wall. v
/// [m/s] is relative to the wall, v - contact.wall_velocity; F . v <= 0 with that v. A wall that moves would
/// drag the handle along, which no brake does. Where no hand force is known pass zero: the handle then creeps
/// in the dead band. Reference: S. E. Salcudean, T. D. Vlaar, On the emulation of stiff walls and static
/// friction with a magnetically levitated input/output device, ASME J. Dynamic Systems, Measurement, and
/// Control 119(1), 1997.
template <class T, int D>
vector<T, D> wall_friction(const wall_friction_parameters<T>& p, const vector<T, D>& n,
                           std::type_identity_t<T> load, const std::type_identity_t<vector<T, D>>& v,
                           const std::type_identity_t<vector<T, D>>& hand_force = vector<T, D>::Zero()) {
  const vector<T, D> v_t = v - n * n.dot(v);
  const vector<T, D> push = hand_force - n * n.dot(hand_force);
  return resistance<T, D>(p.coefficient * load, v_t, p.velocity_dead_band, push) - p.viscosity * v_t;
}

}  // namespace passive_haptics
