/// Forces F = G t of redundant brakes, or of fewer brakes than joints (n = d, m != n).
#pragma once

#include <passive_haptics/force/forms/half_space_form.hpp>

#include <algorithm>
#include <type_traits>

namespace passive_haptics {

/// Fc for a unit desired force n, F = G t: exact if n is in the cone, with the torques of least |t|.
template <class T, int D, int Brakes>
approximated_force<T, D, Brakes> approximate_by_generators(const matrix<T, D, Brakes>& G,
                                                           const vector<T, Brakes>& s, const vector<T, D>& n,
                                                           T min_cosine) {
  const auto nearest = nearest_torque(G, s, n);
  const T square = nearest.force.squaredNorm(), least = std::max(min_cosine, rounding_tolerance<T>(D));
  if (!(square >= least * least)) return {};
  // Tolerance for the remainder of n, relative to the terms of F if it is a sum
  T rounding = rounding_tolerance<T>(D + Brakes);
  if constexpr (D > 3) rounding *= T(1) + size_of_terms(G, nearest.torque);
  if ((n - nearest.force).norm() <= rounding) return {display_class::exact, n, nearest.torque, T(1)};
  return {display_class::approximate, nearest.force / square, nearest.torque / square, square};
}

/// Fc with the torques of least |t / u|, u = generator_form::units. A brake with unit 0 is off.
template <class T, int D, int Brakes, class Units>
approximated_force<T, D, Brakes> approximate_by_generators(const matrix<T, D, Brakes>& G,
                                                           const vector<T, Brakes>& s, const vector<T, D>& n,
                                                           T min_cosine, const Units& u) {
  if constexpr (std::is_same_v<Units, equal_units>) {
    return approximate_by_generators(G, s, n, min_cosine);
  } else {
    auto F = approximate_by_generators(matrix<T, D, Brakes>(G * u.asDiagonal()), s, n, min_cosine);
    F.torque = F.torque.cwiseProduct(u);
    return F;
  }
}

/// Operations on the forces of M's brakes, by generators. The others are inherited from half_space_form.
template <class M>
struct generator_form : half_space_form<M> {
  using typename half_space_form<M>::T;      ///< Scalar type.
  using typename half_space_form<M>::force;  ///< Force with its torques.
  using half_space_form<M>::d;               ///< Task dimension.
  using half_space_form<M>::m;               ///< Number of brakes.

  /// Fc for a desired force of 1 N, with the torques of least norm. Needs no start.
  template <class Device>
  static force nearest(const Device& device, const desired_force<T, d>& Fd, T min_cosine,
                       approximation_start&) {
    return approximate_by_generators(passive_haptics::force_generators(device.pose), device.s, Fd.direction,
                                     min_cosine, units(device.s, device.brakes));
  }

  /// Map F = G t.
  template <class EMatrix>
  static force_map<T, d, m> map(const mechanism_pose<M>& pose, const EMatrix&) {
    return {passive_haptics::force_generators(pose)};
  }
  /// Units of torques of least norm, from the maximum torques with signs s; equal_units without limits.
  template <class B>
  static auto units([[maybe_unused]] const brake_vector<M>& s, [[maybe_unused]] const B& brakes) {
    if constexpr (SwitchableBrakes<B, T, m>) {
      const auto box = passive_haptics::torque_box_of(s, brakes);
      return torque_units(brake_vector<M>(box.upper.cwiseMax(-box.lower)));
    } else if constexpr (LimitedBrakes<B, T, m>) {
      return torque_units(brakes.torque_limit);
    } else {
      return equal_units();
    }
  }
  /// Always true: torques in their box give a force that the brakes can produce.
  template <class Device>
  static bool is_in_cone(const Device&, const brake_vector<M>&, const brake_matrix<M>&, const force&) {
    return true;
  }
  /// Sets F to the force of its torques. Returns the magnitude of its terms [N], for rounding bounds.
  template <class Device>
  static T set_force(force& F, const Device& device, const desired_force<T, d>& Fd,
                     const approximation_start&) {
    return detail::add_up(F, device, Fd, passive_haptics::force_generators(device.pose));
  }

  /// Motions of the brakes in pose q, for design.
  template <class B>
  static detail::ways_to_move<T, d, m> motions(const M& mechanism, const joint_vector<M>& q,
                                               const brake_matrix<M>& E, const B&) {
    return {E, transposed(passive_haptics::force_generators(mechanism, q)), true};
  }
  /// Fc for a unit force n while the end effector moves with v. Sets the signs.
  template <class B>
  static force nearest(const detail::ways_to_move<T, d, m>& moving, const brake_matrix<M>&,
                       const task_vector<M>& v, const task_vector<M>& n, const B& brakes,
                       brake_vector<M>& signs, brake_set&) {
    signs = signs_within(moving.signs(moving.rates(), v), brakes);
    return approximate_by_generators(brake_matrix<M>(transposed(moving.rates())), signs, n, T(0),
                                     units(signs, brakes));
  }
};

}  // namespace passive_haptics
