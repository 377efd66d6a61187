/// @file
/// The forces of other than n brakes where n = d, F = G t: redundant brakes, and fewer brakes than joints.
#pragma once

#include <passive_haptics/force/forms/half_space_form.hpp>

#include <algorithm>
#include <type_traits>

namespace passive_haptics {

/// Fc for a unit desired force n in generator form, F = G t: exact if n is in the cone, the torques those of
/// the least |t|.
template <class T, int D, int Brakes>
approximated_force<T, D, Brakes> approximate_by_generators(const matrix<T, D, Brakes>& G,
                                                           const vector<T, Brakes>& s, const vector<T, D>& n,
                                                           T min_cosine) {
  const auto nearest = nearest_torque(G, s, n);
  const T square = nearest.force.squaredNorm(), least = std::max(min_cosine, rounding_tolerance<T>(D));
  if (!(square >= least * least)) return {};
  // What is left of n, against the size of the terms that were added up where F is their sum
  T rounding = rounding_tolerance<T>(D + Brakes);
  if constexpr (D > 3) rounding *= T(1) + size_of_terms(G, nearest.torque);
  if ((n - nearest.force).norm() <= rounding) return {display_class::exact, n, nearest.torque, T(1)};
  return {display_class::approximate, nearest.force / square, nearest.torque / square, square};
}

/// Fc with the torques of the least |t / u|, u being generator_form::units. A brake whose unit is 0 is
/// off; its torque is 0 exactly.
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

/// The operations on the forces of M's brakes, by generators. Not listed: those that it shares with
/// half-spaces, as its signs are those of now, too.
template <class M>
struct generator_form : half_space_form<M> {
  using typename half_space_form<M>::T;      ///< Scalar.
  using typename half_space_form<M>::force;  ///< With the torques that produce it.
  using half_space_form<M>::d;               ///< Task dimensions,
  using half_space_form<M>::m;               ///< brakes.

  /// Fc for a desired force of 1 N, of the torques of least norm. Needs no start.
  template <class Device>
  static force nearest(const Device& device, const desired_force<T, d>& Fd, T min_cosine,
                       approximation_start&) {
    return approximate_by_generators(passive_haptics::force_generators(device.pose), device.s, Fd.direction,
                                     min_cosine, units(device.s, device.brakes));
  }

  /// F = G t.
  template <class EMatrix>
  static force_map<T, d, m> map(const mechanism_pose<M>& pose, const EMatrix&) {
    return {passive_haptics::force_generators(pose)};
  }
  /// Units of torques of least norm: shares of what each brake can make with its sign s_i. equal_units if no
  /// limit is named that could make a difference.
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
  /// True: a force of torques in their box is one that the brakes can make.
  template <class Device>
  static bool is_in_cone(const Device&, const brake_vector<M>&, const brake_matrix<M>&, const force&) {
    return true;
  }
  /// Sets F to the force of its torques. Returns the size of what adds up to it [N]: that of its rounding.
  template <class Device>
  static T set_force(force& F, const Device& device, const desired_force<T, d>& Fd,
                     const approximation_start&) {
    return detail::add_up(F, device, Fd, passive_haptics::force_generators(device.pose));
  }

  /// The motions of the brakes in pose q, for design.
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
