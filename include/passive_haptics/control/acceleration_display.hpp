/// @file
/// How the brakes accelerate the end effector, and the torques that give walls the normal accelerations they want.
#pragma once

#include <passive_haptics/control/brake_situation.hpp>
#include <passive_haptics/force/contact_forces.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>

#include <Eigen/Cholesky>

namespace passive_haptics {

/// xdd = free + G t: the end effector's acceleration under brake torques t.
template <class T, int D, int Brakes>
struct acceleration_map {
  vector<T, D> free;       ///< J M^-1 (J^T Fh - c) + Jd qd [m/s^2]
  matrix<T, D, Brakes> G;  ///< J M^-1 T^T [m/s^2 per N m]
  matrix<T, D, D>
      mobility;  ///< J M^-1 J^T [1/kg]: G t is the acceleration that the force mobility^-1 G t would give.
};

/// The acceleration map of a mechanism with inertia, the hand doing Fh to it. Cost: a Cholesky of n x n.
template <class M, class EMatrix>
auto accelerations(const brake_situation<M, EMatrix>& now) {
  static_assert(Dynamics<M>,
                "passive_haptics: this law needs a mechanism that models Dynamics (mechanism/dynamics.hpp).");
  using T = typename M::scalar;
  constexpr int n = M::dof, d = M::task_dimension, m = M::brake_count;
  const matrix<T, d, n> J(jacobian(now.mechanism, now.q));
  matrix<T, n, m> Tt = matrix<T, n, m>::Identity();
  if constexpr (detail::has_exact_transmission<M>)
    Tt = transposed(matrix<T, m, n>(transmission(now.mechanism, now.q)));
  const Eigen::LLT<matrix<T, n, n>> mass(now.mechanism.mass_matrix(now.q));
  const joint_vector<M> drive =
      transposed_product(J, now.hand_force) - now.mechanism.bias_torque(now.q, now.qd);
  acceleration_map<T, d, m> map;
  map.free = product(J, joint_vector<M>(mass.solve(drive))) + now.mechanism.bias_acceleration(now.q, now.qd);
  map.G = J * mass.solve(Tt);
  map.mobility = J * mass.solve(transposed(J));
  return map;
}

/// mobility^-1 G [N per N m]: the forces at the end effector that do what brake torques do; G itself at a singular pose.
template <class T, int D, int Brakes>
matrix<T, D, Brakes> equivalent_forces(const acceleration_map<T, D, Brakes>& map) {
  const matrix<T, D, Brakes> forces = map.mobility.ldlt().solve(map.G);
  return all_finite(forces) ? forces : map.G;
}

}  // namespace passive_haptics
