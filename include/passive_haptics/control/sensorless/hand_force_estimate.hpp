/// Estimate of the hand force without a force sensor.
#pragma once

#include <passive_haptics/core/status.hpp>
#include <passive_haptics/mechanism/mechanism.hpp>

namespace passive_haptics {

/// A hand force and its uncertainty: Fh = force + G t for some torques |t_i| <= unknown_torque_i. A holding
/// brake may have any torque up to its strength, so the hand torque on it is only known up to that.
template <class M>
struct hand_force_estimate {
  using scalar = typename M::scalar;  ///< Scalar type.

  task_vector<M> force = task_vector<M>::Zero();  ///< Fh [N], base frame, if brakes at rest have no torque.
  /// Possible torques [N m] >= 0 of brakes at rest; 0 for brakes that slip or are released.
  brake_vector<M> unknown_torque = brake_vector<M>::Zero();
  /// G (d x m) [N per N m]: force at the end effector per brake torque.
  brake_matrix<M> generators = brake_matrix<M>::Zero();
  /// ok; or state_not_finite, time_not_rising, pose_undefined or singular_jacobian, with zero force.
  status outcome = status::ok;

  /// Uncertainty of n . force [N] for a unit direction n.
  scalar half_width(const task_vector<M>& n) const {
    return (generators.transpose() * n).cwiseAbs().dot(unknown_torque);
  }
};

}  // namespace passive_haptics
