/// @file
/// Self-motion, n > d: what becomes of the joints that the hand does not lead, while brakes display a force.
#pragma once

#include <passive_haptics/mechanism/dynamics.hpp>

namespace passive_haptics {

/// Three readings of which forces a device with self-motion can display. J qd = v leaves n - d directions of
/// motion, N = ker J, that nobody holds.
enum class self_motion_form {
  /// The default. A light arm gives way until n - d of its brakes are at rest, and moves on so: the force is
  /// that which a hand feels from then on. Needs no inertia.
  settled,
  /// The force at the first instant, by inertia. Most of it is gone once the self-motion has given way: of 1
  /// N
  /// a hand feels 0.31 N after 50 ms with three links, 0.04 N with four (docs/results.md). Needs Dynamics.
  inertial,
  /// Brakes, with the signs of their rates now, must leave the self-motion alone. Often no force at all is
  /// left that they can display (display_class::empty_cone): of a planar arm of three links in a third of the
  /// states that move into a wall, of four links in more than half.
  kinetostatic,
};

namespace detail {
template <class M>
concept names_self_motion = requires { M::self_motion; };
}  // namespace detail

/// What a mechanism says of its self-motion, as `static constexpr self_motion_form self_motion`; settled
/// where it says nothing.
template <class M>
inline constexpr self_motion_form self_motion_of = [] {
  if constexpr (detail::names_self_motion<M>) return M::self_motion;
  else return self_motion_form::settled;
}();

/// A device whose self-motion settles while it displays a force (brake/at_rest/settled_rates.hpp).
template <class M>
concept Settles = (M::dof > M::task_dimension) && self_motion_of<M> == self_motion_form::settled;

/// A device whose brakes drive its self-motion while it displays a force (brake/force_generators.hpp).
template <class M>
concept has_inertial_forces = (M::dof > M::task_dimension) && self_motion_of<M> == self_motion_form::inertial;

/// A device whose displayable forces are given by generators, F = G t: redundant brakes, fewer brakes than
/// joints where n = d, and inertial forces. Of those that are not settled all others are the common part of
/// half-spaces.
template <class M>
concept displays_by_generators =
    has_inertial_forces<M> || (M::brake_count != M::dof && M::dof == M::task_dimension);

/// A device with self-motion and fewer brakes than joints, whose brakes leave the self-motion and the other
/// joints alone.
template <class M>
concept leaves_free_joints_alone = (M::dof > M::task_dimension) && (M::brake_count < M::dof) &&
                                   self_motion_of<M> == self_motion_form::kinetostatic;

/// The requirements of a mechanism before its forces are known: those of Mechanism, and inertia for inertial
/// forces.
template <class M, bool Explain = false>
consteval bool has_known_forces() {
  if constexpr (!Mechanism<M>) return is_mechanism<M, Explain>();
  else if constexpr (has_inertial_forces<M> && !Dynamics<M>)
    static_assert(
        !Explain,
        "passive_haptics: inertial forces need a mechanism that models Dynamics: give it mass_matrix, "
        "bias_torque and bias_acceleration (mechanism/dynamics.hpp), or leave out "
        "self_motion_form::inertial.");
  else return true;
  return Explain;
}

}  // namespace passive_haptics
