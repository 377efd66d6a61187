/// @file
/// Inverse kinematics by damped steps of the Jacobian, for chains without a closed form here.
#pragma once

#include <passive_haptics/core/linear/cholesky.hpp>
#include <passive_haptics/core/status.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>
#include <passive_haptics/mechanism/models/inverse_kinematics.hpp>

#include <algorithm>

namespace explorer {

namespace ph = passive_haptics;

/// Joint positions near q that put the handle at x [m]: q += J^T (J J^T + l^2 1)^-1 e, the damping l of the
/// size of the error e. Steps that do not help are halved. `size` is a length of the device [m]: the point is
/// reached to 1e-9 of it.
template <class M>
ph::joint_solution<double, M::dof> numeric_inverse(const M& model, const ph::task_vector<M>& x,
                                                   const ph::joint_vector<M>& from, double size) {
  constexpr int d = M::task_dimension, max_steps = 60;
  constexpr double exactness = 1e-9, max_step = 0.3;  // [1], [rad]
  if (!x.allFinite()) return {from, ph::status::state_not_finite};
  ph::joint_vector<M> q = from;
  ph::task_vector<M> e = x - model.position(q);
  double step = 1;
  for (int k = 0; k < max_steps && e.norm() > exactness * size && step > 1e-6; ++k) {
    const ph::jacobian_matrix<M> J(ph::jacobian(model, q));
    const double damping = std::min(0.1 * size, e.norm());
    const ph::matrix<double, d, d> A =
        J * J.transpose() + damping * damping * ph::matrix<double, d, d>::Identity();
    ph::joint_vector<M> change = J.transpose() * ph::cholesky<double, d>(A).solve(e);
    const double length = change.norm();
    if (length > max_step) change *= max_step / length;
    const ph::joint_vector<M> next = q + step * change;
    const ph::task_vector<M> left = x - model.position(next);
    if (left.norm() < e.norm()) {
      q = next, e = left;
      step = std::min(1.0, 2 * step);
    } else {
      step /= 2;
    }
  }
  return {q, e.norm() <= exactness * size ? ph::status::ok : ph::status::out_of_reach};
}

}  // namespace explorer
