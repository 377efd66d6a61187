/// @file
/// What torques in a box make against the ways into a wall, by virtual work: the parts of displayable().
#pragma once

#include <passive_haptics/brake/at_rest/settled_rates.hpp>
#include <passive_haptics/core/linear/cone.hpp>
#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/force/torques/nearest_torque.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace passive_haptics::detail {

// s of rates w = A v. A rate of the size that rounding of A and E makes it is none: E w = v.
template <class T, int Brakes, int D>
vector<T, Brakes> signs_in_motion(const matrix<T, Brakes, D>& A, const matrix<T, D, Brakes>& E,
                                  const vector<T, D>& v) {
  const vector<T, Brakes> w = A * v;
  const T terms = v.norm() + (E.cwiseAbs() * w.cwiseAbs()).norm();
  const vector<T, Brakes> rounding = rounding_tolerance<T>(D + Brakes) * terms * A.rowwise().norm();
  return (w.array().abs() > rounding.array()).select(w.array().sign(), T(0));
}

// Largest power t . w of torques in the box at rates w. A rate of rounding size is none.
template <class T, int Brakes>
T largest_resistance(const torque_box<T, Brakes>& box, const vector<T, Brakes>& w) {
  const T rounding = rounding_tolerance<T>(Brakes) * w.cwiseAbs().maxCoeff();
  T sum = T(0);
  for (int i = 0; i < Brakes; ++i)
    if (std::abs(w[i]) > rounding) sum += w[i] * (w[i] > T(0) ? box.upper[i] : box.lower[i]);
  return sum;
}

// visit(w) for rates w with E w = n, none if the end effector cannot move so. Among all such rates, one of
// these is the least sum of w_i, each times a constant of its sign: it is least where as many rates as can be
// are 0, so sets of moving brakes are tried.
template <class T, int D, int Brakes, class Visit>
void for_each_way(const matrix<T, D, Brakes>& E, const vector<T, D>& n, const Visit& visit) {
  const T tolerance = rounding_tolerance<T>(D + Brakes);
  for (half_space_set moving = 1; moving < (half_space_set{1} << Brakes); ++moving) {
    matrix<T, D, Brakes> moved = E;
    for (int i = 0; i < Brakes; ++i)
      if ((moving >> i & 1u) == 0) moved.col(i).setZero();
    const vector<T, Brakes> w = orthogonal_decomposition<T, D, Brakes>(moved, tolerance).solve(n);
    const T rounding = tolerance * (T(1) + (moved.cwiseAbs() * w.cwiseAbs()).norm());
    if ((moved * w - n).norm() <= rounding) visit(w);
  }
}

// visit(w) for rates w of a device with self-motion whose end effector moves along n: W_S n of each set,
// which has as many brakes at rest as can be. None if the structure holds it.
template <class M, class Visit>
void for_each_way(const settled_rates<M>& rates, const task_vector<M>& n, const Visit& visit) {
  using T = typename M::scalar;
  if (rates.held_by_structure(n).norm() > rounding_tolerance<T>(M::dof + M::brake_count)) return;
  rates.for_each([&](brake_set, const typename settled_rates<M>::rate_map& W) {
    visit(brake_vector<M>(W * n));
    return false;
  });
}

// Largest k for which the brakes can make torques k t.
template <class B, class T, int Brakes>
T largest_share(const vector<T, Brakes>& t, const B& brakes) {
  const vector<T, Brakes> bound = passive_haptics::torque_bounds_of(brakes, t);
  const auto shares = bound.array() / t.array().abs();
  return (t.array() != T(0)).select(shares, std::numeric_limits<T>::infinity()).minCoeff();
}

}  // namespace passive_haptics::detail
