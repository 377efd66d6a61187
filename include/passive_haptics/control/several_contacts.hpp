/// @file
/// Several touched walls at once: the law's share of each, met in order of priority within the torque limits.
#pragma once

#include <passive_haptics/control/one_contact.hpp>
#include <passive_haptics/force/torques/contact_forces.hpp>

namespace passive_haptics {

/// F = G t in the form that fits the mechanism.
template <class M, class EMatrix, class B>
auto force_map_of(const brake_situation<M, EMatrix, B>& now) {
  using T = typename M::scalar;
  using map = force_map<T, M::task_dimension, M::brake_count>;
  if constexpr (detail::has_inertial_forces<M>) {
    return map{inertial_force_generators(now.mechanism, now.q), {}, false};
  } else if constexpr (M::brake_count > M::dof) {
    return map{force_generators(now.mechanism, now.q), {}, false};
  } else {
    return invert_brake_jacobian(matrix<T, M::task_dimension, M::brake_count>(now.E));
  }
}

/// Torques td [N m] commanded for several contacts (force/torques/contact_forces.hpp), with a_j = alpha_j k_j
/// depth_j. Contacts being left under a law that gives way come first. Notes each contact's report in
/// `result`; its classes and scale are those of the contact that asks for the largest force, display is exact
/// where all that is wanted is met.
template <step_knowledge Known = step_knowledge{}, class M, class EMatrix, class Contacts, class L, class B>
brake_vector<M> display_several(const brake_situation<M, EMatrix, B>& now, const Contacts& touched,
                                const L& law, typename L::memory& memory,
                                step_result_of_contacts<M, Contacts::capacity>& result) {
  using T = typename M::scalar;
  constexpr int D = M::task_dimension;
  result.outcome = check_contacts<T>(touched);
  if (result.outcome == status::ok && !all_finite(now.E, now.w)) result.outcome = status::pose_undefined;
  if (result.outcome != status::ok) return brake_vector<M>::Zero();

  std::array<contact_demand<T, D>, static_cast<std::size_t>(Contacts::capacity)> demands;
  const int governing = governing_contact(touched);
  T outward_power = T(0);
  T largest = T(0);
  for (int j = 0; j < touched.size(); ++j) {
    const auto [n, magnitude] = force_of<T>(touched[j]);
    const T outward = brake_torque(now.E, n).dot(now.w);
    T leaving = outward;
    if constexpr (Known.walls_move) leaving -= n.dot(touched[j].wall_velocity.template cast<T>());
    const bool pressed = magnitude > T(0);
    const T alpha =
        pressed ? law.scale(contact_situation<T, D>{n, magnitude, leaving, now.hand_force}, memory) : T(1);
    if (!(alpha >= T(0) && alpha <= T(1))) result.outcome = status::scale_out_of_range;
    if (j == governing) {
      result.alpha = alpha;
      outward_power = outward;
    }
    const T force = pressed ? alpha * magnitude : T(0);
    demands[static_cast<std::size_t>(j)] = {n, force, gives_way<L> && leaving > T(0)};
    largest = std::max(largest, force);
  }
  result.stages.add(stage::law);

  const auto map = force_map_of(now);
  if (!all_finite(map.G)) result.outcome = status::pose_undefined;
  if (result.outcome != status::ok) return brake_vector<M>::Zero();
  const auto answer = contact_forces<T, D, M::brake_count, Contacts::capacity>(
      map, torques_within(now.s, torque_limits_of<T, M::brake_count>(now.brakes)), demands, touched.size());
  result.stages.add(stage::projection);

  bool met = true;
  result.contact_count = touched.size();
  for (int j = 0; j < touched.size(); ++j) {
    const auto k = static_cast<std::size_t>(j);
    const T missing = std::abs(demands[k].force - answer.displayed[k]);
    met = met && missing <= rounding_tolerance<T>(M::brake_count + Contacts::capacity) * largest;
    result.contacts[k] = {touched[j].wall, demands[k].force, answer.displayed[k], demands[k].first};
  }
  const T size = answer.force.norm();
  result.display =
      met ? display_class::exact : (size > T(0) ? display_class::approximate : display_class::none);
  result.power = classify_power(outward_power, met);
  const T along = result.desired_force.normalized().dot(answer.force);
  result.approximation_cosine = size > T(0) ? along / size : T(met ? 1 : 0);
  result.control_force = answer.force;
  result.cone_coefficients = answer.torque;
  if constexpr (LimitedBrakes<B, T, M::brake_count>)
    result.saturated = (answer.torque.cwiseAbs().array() >= now.brakes.torque_limit.array()).any();
  return answer.torque;
}

}  // namespace passive_haptics
