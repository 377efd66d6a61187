/// @file
/// What torques in a box make at most against a wall, by virtual work: the parts of displayable().
#pragma once

#include <passive_haptics/brake/at_rest/settled_rates.hpp>
#include <passive_haptics/core/linear/orthogonal_decomposition.hpp>
#include <passive_haptics/core/linear/space_cone.hpp>
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

// Least of it over all rates w with E w = n: a sum of w_i, each times a constant of its sign, is least where
// as many as can be are 0, so sets of moving brakes are tried.
template <class T, int D, int Brakes>
T least_resistance(const matrix<T, D, Brakes>& E, const torque_box<T, Brakes>& box, const vector<T, D>& n) {
  const T tolerance = rounding_tolerance<T>(D + Brakes);
  T least = std::numeric_limits<T>::infinity();  // the end effector cannot move so
  for (half_space_set moving = 1; moving < (half_space_set{1} << Brakes); ++moving) {
    matrix<T, D, Brakes> moved = E;
    for (int i = 0; i < Brakes; ++i)
      if ((moving >> i & 1u) == 0) moved.col(i).setZero();
    const vector<T, Brakes> w = orthogonal_decomposition<T, D, Brakes>(moved, tolerance).solve(n);
    const T rounding = tolerance * (T(1) + (moved.cwiseAbs() * w.cwiseAbs()).norm());
    if ((moved * w - n).norm() <= rounding) least = std::min(least, largest_resistance(box, w));
  }
  return least;
}

// Largest k for which the brakes can make torques k t.
template <class B, class T, int Brakes>
T largest_share(const vector<T, Brakes>& t, const B& brakes) {
  const vector<T, Brakes> bound = passive_haptics::torque_bounds_of(brakes, t);
  const auto shares = bound.array() / t.array().abs();
  return (t.array() != T(0)).select(shares, std::numeric_limits<T>::infinity()).minCoeff();
}

// Largest n . F of torques in a box, of a device with self-motion: what they make against the easiest way
// into the wall. Like any least sum of |w_i| it has as many brakes at rest as can be: it is W_S n of some
// set.
template <class M>
typename M::scalar strongest_with_self_motion(const settled_rates<M>& rates,
                                              const torque_box<typename M::scalar, M::brake_count>& box,
                                              const task_vector<M>& n) {
  using T = typename M::scalar;
  T least = std::numeric_limits<T>::infinity();
  if (rates.held_by_structure(n).norm() > rounding_tolerance<T>(M::dof + M::brake_count)) return least;
  rates.for_each([&](brake_set, const typename settled_rates<M>::rate_map& W) {
    least = std::min(least, largest_resistance<T, M::brake_count>(box, W * n));
    return false;
  });
  return least;
}

}  // namespace passive_haptics::detail
