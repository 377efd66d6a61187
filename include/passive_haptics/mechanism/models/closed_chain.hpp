/// @file
/// What a closed kinematic chain can say beside its Jacobian: its inverse, and how near a singularity is.
#pragma once

#include <passive_haptics/mechanism/mechanism.hpp>

#include <concepts>

namespace passive_haptics {

/// How far a closed chain A v = B qd is from its two kinds of singularity (Gosselin and Angeles 1990), each
/// in [0, 1]: 1 is best, 0 singular. NaN where the loop cannot be closed.
template <class T>
struct chain_conditioning {
  /// Serial, B singular: a leg stretched or folded, the handle loses a direction and a force in it stays in
  /// the structure. The least over the legs of |cos| of the angle between the distal link and its elbow's
  /// velocity; in the plane that is |sin| of the angle between proximal and distal link.
  T type_1;
  /// Parallel, A singular: the distal links aligned (plane), coplanar or parallel (space); with all brakes
  /// locked the handle still moves, J is unbounded. |det| of the distal links' unit vectors. Near the
  /// edge of where the loop closes it falls as the root of the way in q, so q in double determines it to
  /// 1e-8.
  T type_2;
};

/// A mechanism that is a closed chain, n = d.
///
/// Minimal complete definition, beside that of Mechanism:
///   - `matrix<scalar, n, n> inverse_jacobian(q) const`: qd = inverse_jacobian v; finite where J is unbounded
///     (type 2), unbounded where J is singular (type 1);
///   - `chain_conditioning<scalar> conditioning(q) const`.
///
/// Laws: inverse_jacobian J = 1 away from singularities; a figure is 0 exactly where its singularity is.
template <class M>
concept ClosedChain =
    Mechanism<M> && M::dof == M::task_dimension && requires(const M mechanism, const joint_vector<M> q) {
      { mechanism.inverse_jacobian(q) } -> ExactMatrix<typename M::scalar, M::dof, M::task_dimension>;
      { mechanism.conditioning(q) } -> std::same_as<chain_conditioning<typename M::scalar>>;
    };

}  // namespace passive_haptics
