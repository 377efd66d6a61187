/// @file
/// Force approximation beside joints that no brake sits on: they must feel nothing of the force.
#pragma once

#include <passive_haptics/force/approximation.hpp>
#include <passive_haptics/force/nearest_force.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>

#include <algorithm>

namespace passive_haptics {

/// Projection (d x d) on the forces that leave joints without a brake alone, (J N_f)^T F = 0 with N_f = ker
/// T, for m < n. Cost: an orthogonal decomposition of m x n and one of d x n.
template <class M>
  requires(M::brake_count < M::dof)
matrix<typename M::scalar, M::task_dimension, M::task_dimension> forces_of_braked_joints(
    const mechanism_pose<M>& pose) {
  using T = typename M::scalar;
  constexpr int n = M::dof, d = M::task_dimension, m = M::brake_count;
  const orthogonal_decomposition<T, m, n> by_brakes(transmission_matrix<M>(pose.transmission()), T(0));
  const matrix<T, d, n> moved = jacobian_matrix<M>(pose.jacobian()) * by_brakes.null_space();
  return orthogonal_decomposition<T, d, n>(moved, rounding_tolerance<T>(n)).left_null_projection();
}

/// Fc as approximate() gives it, among the forces that leave joints without a brake alone. within: from
/// forces_of_braked_joints. off: brakes that are off, from brakes_off.
template <class T, int D, int Brakes, class Off = all_brakes_on>
approximated_force<T, D, Brakes> approximate_within(const matrix<T, D, D>& within,
                                                    const matrix<T, D, Brakes>& E, const vector<T, Brakes>& s,
                                                    const vector<T, D>& n, T min_cosine,
                                                    const Off& off = Off()) {
  // Twice, as rounding of what is taken out of a column may be large beside what is left
  const matrix<T, D, Brakes> inside = within * matrix<T, D, Brakes>(within * E);
  const auto nearest = project_onto_half_spaces(half_spaces_of(inside, s, off), vector<T, D>(within * n));
  const vector<T, D>& Fp = nearest.point;
  const bool exact = (n - Fp).norm() <= rounding_tolerance<T>(D + Brakes);
  const T square = exact ? T(1) : Fp.squaredNorm(), least = std::max(min_cosine, rounding_tolerance<T>(D));
  if (!(square >= least * least)) return {};
  const vector<T, D> Fc = exact ? n : vector<T, D>(Fp / square);
  vector<T, Brakes> t = brake_torque(E, Fc);
  for (int i = 0; i < Brakes; ++i)
    if ((nearest.active >> i & 1u) != 0 || s[i] * t[i] > T(0) || detail::is_off(off, i)) t[i] = T(0);
  return {exact ? display_class::exact : display_class::approximate, Fc, t, square};
}

}  // namespace passive_haptics
