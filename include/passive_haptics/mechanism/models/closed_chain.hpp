/// The ClosedChain concept: inverse Jacobian and distance from singularities.
#pragma once

#include <passive_haptics/mechanism/mechanism.hpp>

#include <concepts>

namespace passive_haptics {

/// Distance of a closed chain A v = B qd from its singularities (Gosselin and Angeles 1990), from 0
/// (singular) to 1. NaN if the loop cannot be closed.
template <class T>
struct chain_conditioning {
  /// Serial, B singular: a leg is stretched or folded, so that the structure carries forces in one direction.
  /// Minimum over the legs of |cos| between distal link and elbow velocity; planar: |sin| between proximal
  /// and distal link.
  T type_1;
  /// Parallel, A singular: the distal links are aligned (planar), coplanar or parallel (spatial), so that the
  /// handle moves even with locked brakes and J is unbounded. |det| of the unit vectors of the distal links.
  /// Falls like a square root near the edge of the workspace, so double determines it to 1e-8.
  T type_2;
};

/// A closed chain, n = d.
///
/// Minimal complete definition, in addition to that of Mechanism:
///   - `matrix<scalar, n, n> inverse_jacobian(q) const`: qd = inverse_jacobian v; finite if J is unbounded
///     (type 2), unbounded if J is singular (type 1);
///   - `chain_conditioning<scalar> conditioning(q) const`.
///
/// Laws: inverse_jacobian J = 1 away from singularities; a figure is 0 exactly at its singularity.
template <class M>
concept ClosedChain =
    Mechanism<M> && M::dof == M::task_dimension && requires(const M mechanism, const joint_vector<M> q) {
      { mechanism.inverse_jacobian(q) } -> ExactMatrix<typename M::scalar, M::dof, M::task_dimension>;
      { mechanism.conditioning(q) } -> std::same_as<chain_conditioning<typename M::scalar>>;
    };

}  // namespace passive_haptics
