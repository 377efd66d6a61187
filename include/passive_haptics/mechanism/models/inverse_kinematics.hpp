/// Inverse kinematics: its result, and two planar links, for mechanisms with two-link legs.
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/matrix.hpp>
#include <passive_haptics/core/status.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace passive_haptics {

/// Joint positions for a point, or of the nearest pose with status::out_of_reach.
template <class T, int Dof>
struct joint_solution {
  vector<T, Dof> q;             ///< Joint positions [rad or m]; NaN if the point is not finite.
  status outcome = status::ok;  ///< ok, out_of_reach or state_not_finite.
};

/// Branch of a two-link arm, seen from the base towards the handle.
enum class elbow {
  left,   ///< q2 <= 0: the elbow is left of the line from base to handle.
  right,  ///< q2 >= 0: the elbow is right of it.
};

/// Joint positions (q1 from the x axis, q2 from link 1) for the end of links l1, l2 [m] at x [m]. If x is out
/// of reach, the arm points at it. At x = 0 (l1 = l2) q1 is arbitrary; the direction 0 is used.
template <class T>
joint_solution<T, 2> two_link_inverse(T l1, T l2, const vector<T, 2>& x, elbow branch) {
  const T r = std::hypot(x[0], x[1]);
  const T outside = (l1 + l2 - r) * (l1 + l2 + r);     // 0 if straight
  const T inside = (r - (l1 - l2)) * (r + (l1 - l2));  // 0 if folded
  if (!all_finite(x))
    return {vector<T, 2>::Constant(std::numeric_limits<T>::quiet_NaN()), status::state_not_finite};
  const T bend = T(2) * std::atan2(std::sqrt(std::max(outside, T(0))), std::sqrt(std::max(inside, T(0))));
  const T q2 = branch == elbow::left ? -bend : bend;
  const T q1 = std::atan2(x[1], x[0]) - std::atan2(l2 * std::sin(q2), l1 + l2 * std::cos(q2));
  return {{q1, q2}, outside < T(0) || inside < T(0) ? status::out_of_reach : status::ok};
}

namespace detail {

template <class T>
T principal_angle(T angle) {
  return std::remainder(angle, T(2) * std::numbers::pi_v<T>);
}

}  // namespace detail
}  // namespace passive_haptics
