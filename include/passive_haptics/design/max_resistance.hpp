/// Parts of displayable() and sink_slope(): maximum normal force by virtual work, and checks of arguments.
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/status.hpp>
#include <passive_haptics/design/hybrid_brakes.hpp>
#include <passive_haptics/force/forms/form_of.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace passive_haptics::detail {

// Maximum power t . w of torques in the box at rates w. Rates of rounding size count as 0.
template <class T, int Brakes>
T max_resistance(const torque_box<T, Brakes>& box, const vector<T, Brakes>& w) {
  const T rounding = rounding_tolerance<T>(Brakes) * w.cwiseAbs().maxCoeff();
  T sum = T(0);
  for (int i = 0; i < Brakes; ++i)
    if (std::abs(w[i]) > rounding) sum += w[i] * (w[i] > T(0) ? box.upper[i] : box.lower[i]);
  return sum;
}

// Maximum k for which the brakes can produce torques k t.
template <class B, class T, int Brakes>
T max_share(const vector<T, Brakes>& t, const B& brakes) {
  const vector<T, Brakes> bound = passive_haptics::torque_bounds_of(brakes, t);
  const auto shares = bound.array() / t.array().abs();
  return (t.array() != T(0)).select(shares, std::numeric_limits<T>::infinity()).minCoeff();
}

// Maximum n . F of torques in a box against the easiest motion. Infinite if there is no motion.
template <class Motions, class T, int D, int Brakes>
T max_force_of_box(const Motions& motions, const torque_box<T, Brakes>& box, const vector<T, D>& n) {
  T least = std::numeric_limits<T>::infinity();
  motions.for_each_way(n,
                       [&](const vector<T, Brakes>& w) { least = std::min(least, max_resistance(box, w)); });
  return least;
}

// Maximum n . F of these brakes and motors while the end effector moves with v.
template <class Motions, class T, int D, int Brakes>
T max_force_in_motion(const Motions& motions, const vector<T, D>& v, const vector<T, D>& n,
                      const hybrid_brake_parameters<T, Brakes>& brakes) {
  T max_force = T(0);
  motions.for_each([&](const auto& W) {
    const auto box = passive_haptics::torque_box_of(motions.signs(W, v), brakes);
    max_force = std::max(max_force, max_force_of_box(motions, box, n));
  });
  return max_force;
}

// Unit vector of a direction along a wall; 0 if it has no such part.
template <class T, int D>
vector<T, D> along_wall(const vector<T, D>& direction, const vector<T, D>& n) {
  const vector<T, D> v = direction_of(direction), along = v - n.dot(v) * n;
  return along.norm() > rounding_tolerance<T>(D) ? direction_of(along) : vector<T, D>(vector<T, D>::Zero());
}

// Joint positions beyond it, at which adjacent numbers are 1e-4 rad or m apart, have no meaningful sine.
template <class T>
inline constexpr T max_joint_position = T(1e-4) / std::numeric_limits<T>::epsilon();

// Error status of q, direction, normal or brakes, else ok.
template <class M>
status outcome_of(const joint_vector<M>& q, const task_vector<M>& direction, const task_vector<M>& normal,
                  const hybrid_brakes<M>& brakes) {
  if (!all_finite(q, direction)) return status::state_not_finite;
  if (!(q.cwiseAbs().maxCoeff() <= max_joint_position<typename M::scalar>)) return status::pose_undefined;
  if (!all_finite(normal) || normal.isZero(0)) return status::contact_invalid;
  return brakes.is_valid() ? status::ok : status::parameters_invalid;
}

}  // namespace passive_haptics::detail
