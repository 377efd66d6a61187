/// The nearest force that the brakes can produce.
#pragma once

#include <passive_haptics/brake/torque_interval.hpp>
#include <passive_haptics/core/linear/cone.hpp>

namespace passive_haptics {

/// Nearest displayable force to Fd.
template <class T, int D, int Brakes>
struct nearest_force_result {
  vector<T, D> force;     ///< Fp [N], in the cone to rounding; Fp . Fd = |Fp|^2.
  half_space_set active;  ///< Released brakes: their half-spaces are active, t_i = 0.
};

/// B in C = { F : B^T F <= 0 }, with the columns s_i E_i.
template <class T, int D, int Brakes>
matrix<T, D, Brakes> half_spaces_of(const matrix<T, D, Brakes>& E, const vector<T, Brakes>& s) {
  matrix<T, D, Brakes> B;
  unrolled<Brakes>([&](auto i) { unrolled<D>([&](auto k) { B(k, i) = s[i] * E(k, i); }); });
  return B;
}

/// B with half-spaces +-E_i for each brake that is off (brakes_off); other second columns are 0.
template <class T, int D, int Brakes>
matrix<T, D, 2 * Brakes> half_spaces_of(const matrix<T, D, Brakes>& E, const vector<T, Brakes>& s,
                                        const vector<T, Brakes>& off) {
  const vector<T, Brakes> first = (off.array() != T(0)).select(off, s);
  matrix<T, D, 2 * Brakes> B;
  B.template leftCols<Brakes>() = half_spaces_of(E, first);
  B.template rightCols<Brakes>() = half_spaces_of(E, vector<T, Brakes>(-off));
  return B;
}

/// B if all brakes are on.
template <class T, int D, int Brakes>
matrix<T, D, Brakes> half_spaces_of(const matrix<T, D, Brakes>& E, const vector<T, Brakes>& s,
                                    const all_brakes_on&) {
  return half_spaces_of(E, s);
}

/// Projection of Fd on C = { F : s_i (E^T F)_i <= 0 }, the forces of brakes with signs s. E (d x m) from
/// brake_jacobian; J may be singular, and n > d is allowed (C then does not affect the self-motion). Brakes
/// with s_i = 0 impose no constraint. The square of Fd must not overflow or underflow. Cost:
/// core/linear/cone.hpp.
template <class T, int D, int Brakes>
nearest_force_result<T, D, Brakes> nearest_force(const matrix<T, D, Brakes>& E, const vector<T, Brakes>& s,
                                                 const vector<T, D>& Fd) {
  const auto projection = project_onto_half_spaces(half_spaces_of(E, s), Fd);
  return {projection.point, projection.active};
}

/// Nearest force for a diagonal E: each axis separately and exactly.
template <class T, int D>
nearest_force_result<T, D, D> nearest_force(const diagonal_matrix<T, D>& E, const vector<T, D>& s,
                                            const vector<T, D>& Fd) {
  nearest_force_result<T, D, D> result{Fd, 0};
  for (int i = 0; i < D; ++i) {
    if (!(s[i] * E.diagonal()[i] * Fd[i] > T(0))) continue;
    result.force[i] = T(0);
    result.active |= 1u << i;
  }
  return result;
}

}  // namespace passive_haptics
