/// @file
/// Brake torques whose force comes nearest to a desired one: the generator form.
#pragma once

#include <passive_haptics/core/linear/prioritised_least_squares.hpp>

#include <limits>

namespace passive_haptics {

/// Torques that brakes of signs s may have: s_i t_i <= 0 and |t_i| <= limit_i.
template <class T, int Brakes>
struct torque_box {
  vector<T, Brakes> lower;  ///< [N m]
  vector<T, Brakes> upper;  ///< [N m]
};

/// The box of torques for signs s (-1, 0 or 1; 0 restricts only by the limit) and limits [N m], which may be
/// infinite.
template <class T, int Brakes>
torque_box<T, Brakes> torques_within(const vector<T, Brakes>& s, const vector<T, Brakes>& limit) {
  const vector<T, Brakes> none = vector<T, Brakes>::Zero();
  return {(s.array() < T(0)).select(none, -limit), (s.array() > T(0)).select(none, limit)};
}

/// Nearest force and the torques that make it.
template <class T, int D, int Brakes>
struct nearest_torque_result {
  vector<T, Brakes>
      torque;          ///< t [N m], in the box exactly; of the least norm among those that make the force.
  vector<T, D> force;  ///< Fp = G t [N].
};

/// The force F = G t nearest to Fd over torques t in the box, by the torques of least norm: they are unique,
/// so that neighbouring states get neighbouring torques. G (d x m) from force_generators. With infinite
/// limits F is the projection of Fd on the cone of displayable forces (generator form); with finite ones it
/// is the nearest force within the torque limits. Cost: core/linear/prioritised_least_squares.hpp.
template <class T, int D, int Brakes>
nearest_torque_result<T, D, Brakes> nearest_torque(const matrix<T, D, Brakes>& G,
                                                   const torque_box<T, Brakes>& box, const vector<T, D>& Fd) {
  using solver = prioritised_least_squares<T, Brakes, (D > Brakes ? D : Brakes)>;
  solver t(box.lower, box.upper);
  typename solver::rows A = solver::rows::Zero();
  typename solver::targets b = solver::targets::Zero();
  A.template topRows<D>() = G;
  b.template head<D>() = Fd;
  t.minimise(A, b);
  if constexpr (Brakes > D) t.minimise(solver::rows::Identity(), solver::targets::Zero());
  return {t.solution(), G * t.solution()};
}

}  // namespace passive_haptics
