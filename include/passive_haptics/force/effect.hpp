/// The Effect concept: a force that resists motion, so that brakes can produce it.
#pragma once

#include <passive_haptics/scene/contacts.hpp>

#include <type_traits>

namespace passive_haptics {

/// A desired force in addition to those of walls; see control/pipelines/with_effects.hpp.
///
/// Minimal complete definition:
///   - `scalar` and `static constexpr int dimension` (d);
///   - `vector<scalar, d> force(x, v, hand_force) const`: force on the handle [N] at position x [m], velocity
///     v [m/s] and hand force [N] (zero if unknown), all in the base frame.
///
/// Laws: with hand_force = 0, F . v <= 0 for all x and v, and F = 0 for v = 0: an effect is passive. With a
/// hand force, the same holds outside the dead bands of the effect; inside, it may hold against the hand with
/// a power of at most |F| times the dead band. The sum of two effects is an effect.
template <class E>
concept Effect = requires(const E effect, const vector<typename E::scalar, E::dimension> u) {
  { effect.force(u, u, u) } -> ExactVector<typename E::scalar, E::dimension>;
};

/// An effect of the touched walls, such as friction. Requires the members of Effect, but instead of force():
///   - `vector<scalar, d> force_at(touched, v, hand_force) const`, a template over contacts: any type with
///     `size()` and `[j]`, which returns a contact<d>.
///
/// Laws: those of Effect, with velocities relative to each wall.
template <class E>
concept WallEffect = requires(const E effect, const contacts<E::dimension, 1> touched,
                              const vector<typename E::scalar, E::dimension> u) {
  { effect.force_at(touched, u, u) } -> ExactVector<typename E::scalar, E::dimension>;
};

/// An effect on the joints. Minimal complete definition:
///   - `scalar` and `static constexpr int dof` (n);
///   - `vector<scalar, n> torque(q, qd, hand_torque) const`: desired joint torques [N m] at positions q
///     [rad], rates qd [rad/s] and the hand torques J^T Fh [N m].
///
/// Laws: without a hand torque, t_i qd_i <= 0 for each joint, and t = 0 at rest.
template <class E>
concept JointEffect = requires(const E effect, const vector<typename E::scalar, E::dof> u) {
  { effect.torque(u, u, u) } -> ExactVector<typename E::scalar, E::dof>;
};

/// Sum of the forces of one or more effects [N]. Arguments as for Effect::force.
template <Effect First, Effect... Rest>
vector<typename First::scalar, First::dimension> total_force(
    const std::type_identity_t<vector<typename First::scalar, First::dimension>>& x,
    const std::type_identity_t<vector<typename First::scalar, First::dimension>>& v,
    const std::type_identity_t<vector<typename First::scalar, First::dimension>>& hand_force,
    const First& first, const Rest&... rest) {
  vector<typename First::scalar, First::dimension> sum = first.force(x, v, hand_force);
  ((sum += rest.force(x, v, hand_force)), ...);
  return sum;
}

}  // namespace passive_haptics
