/// @file
/// What is known of the hand's force without a force sensor.
#pragma once

#include <passive_haptics/core/status.hpp>
#include <passive_haptics/mechanism/mechanism.hpp>

namespace passive_haptics {

/// A hand force and how far it may be off: Fh = force + G t for some torques |t_i| <= unknown_torque_i.
///
/// A brake that holds makes whatever torque keeps it at rest, so what the hand does to it is known only up to
/// the torque that it could make.
template <class M>
struct hand_force_estimate {
  using scalar = typename M::scalar;  ///< Scalar of the mechanism.

  /// Fh [N], base frame, if brakes at rest make no torque.
  task_vector<M> force = task_vector<M>::Zero();
  /// Torques [N m] >= 0 that brakes at rest may make; 0 for brakes that slip or are released.
  brake_vector<M> unknown_torque = brake_vector<M>::Zero();
  /// G (d x m) [N per N m]: the force at the end effector that a brake's torque makes.
  brake_matrix<M> generators = brake_matrix<M>::Zero();
  /// ok; state_not_finite, time_not_rising, pose_undefined or singular_jacobian, then force is zero and
  /// nothing is known.
  status outcome = status::ok;

  /// By how much n . force may be off [N] for a unit direction n.
  scalar half_width(const task_vector<M>& n) const {
    return (generators.transpose() * n).cwiseAbs().dot(unknown_torque);
  }
};

}  // namespace passive_haptics
