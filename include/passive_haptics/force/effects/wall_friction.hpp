/// Friction on a wall: dry and viscous resistance to tangential motion.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/force/effects/resistance.hpp>

#include <type_traits>

namespace passive_haptics {

/// Parameters of wall friction.
template <class T>
struct wall_friction_parameters {
  T coefficient = T(0);                                  ///< mu >= 0: ratio of dry friction to normal force.
  T viscosity = T(0);                                    ///< b >= 0 [N s/m].
  T velocity_dead_band = default_velocity_dead_band<T>;  ///< Speed counted as at rest [m/s], > 0.

  static constexpr const char* type_name = "wall_friction";  ///< For errors.
  static constexpr auto members() {
    using p = wall_friction_parameters;
    return member_table(member("coefficient", &p::coefficient, "", range::not_negative),
                        member("viscosity", &p::viscosity, "N s/m", range::not_negative),
                        member("velocity_dead_band", &p::velocity_dead_band, "m/s", range::positive));
  }
};

/// Force of the hand on a wall with unit normal n [N]: max(0, -n . Fh). Use this as the load of wall_friction
/// instead of k depth, which a stiff wall demands but brakes do not display.
template <class T, int D>
T pressing_force(const vector<T, D>& n, const std::type_identity_t<vector<T, D>>& hand_force) {
  const T pressing = -n.dot(hand_force);
  return pressing > T(0) ? pressing : T(0);
}

/// Friction [N] on a handle at a wall with unit normal n and load >= 0 [N], base frame:
///
///   F = -mu load v_t / |v_t| - b v_t,    v_t = (I - n n^T) v
///
/// The dry part is resistance(): inside the dead band it holds against the tangential hand force. v [m/s] is
/// relative to the wall, v - contact.wall_velocity, and F . v <= 0 for this v. If the hand force is unknown,
/// pass zero; the handle then creeps in the dead band. Source: S. E. Salcudean, T. D. Vlaar, On the emulation
/// of stiff walls and static friction with a magnetically levitated input/output device, ASME J. Dynamic
/// Systems, Measurement, and Control 119(1), 1997.
template <class T, int D>
vector<T, D> wall_friction(const wall_friction_parameters<T>& p, const vector<T, D>& n,
                           std::type_identity_t<T> load, const std::type_identity_t<vector<T, D>>& v,
                           const std::type_identity_t<vector<T, D>>& hand_force = vector<T, D>::Zero()) {
  const vector<T, D> v_t = v - n * n.dot(v);
  const vector<T, D> push = hand_force - n * n.dot(hand_force);
  return resistance<T, D>(p.coefficient * load, v_t, p.velocity_dead_band, push) - p.viscosity * v_t;
}

}  // namespace passive_haptics
