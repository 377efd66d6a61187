/// Common part of closed chains with legs that meet at the handle.
#pragma once

#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/mechanism/models/distal_links.hpp>

namespace passive_haptics {

/// Base of a Model with N legs in N dimensions and `distal_links<T, N> legs(q) const`.
template <class Model, class T, int N>
class leg_chain {
 public:
  using scalar = T;                         ///< Scalar type.
  static constexpr int dof = N;             ///< Joints n.
  static constexpr int task_dimension = N;  ///< Task dimensions d.

  /// All legs.
  PASSIVE_HAPTICS_PART distal_links<T, N> pose(const vector<T, N>& q) const {
    return static_cast<const Model&>(*this).legs(q);
  }

  const vector<T, N>& position(const distal_links<T, N>& at) const { return at.handle; }  ///< Handle [m].

  /// J = A^-1 B [m/rad].
  matrix<T, N, N> jacobian(const distal_links<T, N>& at) const { return at.jacobian(); }

  matrix<T, N, N> jacobian(const vector<T, N>& q) const { return pose(q).jacobian(); }  ///< J [m/rad]

  /// J^-1 = B^-1 A [rad/m], finite at singularities of type 2.
  matrix<T, N, N> inverse_jacobian(const vector<T, N>& q) const { return pose(q).inverse_jacobian(); }

  /// Distance of q from singularities.
  chain_conditioning<T> conditioning(const vector<T, N>& q) const { return pose(q).conditioning(); }

  /// Jd qd [m/s^2].
  vector<T, N> bias_acceleration(const distal_links<T, N>& at, const vector<T, N>& qd) const {
    return at.bias_acceleration(at.jacobian(), qd);
  }
  /// Jd qd in pose q.
  vector<T, N> bias_acceleration(const vector<T, N>& q, const vector<T, N>& qd) const {
    return bias_acceleration(pose(q), qd);
  }

 protected:
  leg_chain() = default;
  leg_chain(const leg_chain&) = default;             ///< Only for derived classes.
  leg_chain& operator=(const leg_chain&) = default;  ///< Only for derived classes.
};

}  // namespace passive_haptics
