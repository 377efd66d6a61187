/// @file
/// What a law that commands torques itself wants, made what the brakes can do.
#pragma once

#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/control/one_contact.hpp>

#include <algorithm>

namespace passive_haptics {

/// Torques td [N m] that a TorqueLaw commands, within the limits and none that would have to drive. Notes in
/// `result` the account: power of the governing contact, and how much of what the law wanted is commanded.
template <class M, class EMatrix, class Contacts, class L, class B>
brake_vector<M> command_torques(const brake_situation<M, EMatrix, B>& now, const Contacts& touched,
                                const L& law, typename L::memory& memory, step_result<M>& result) {
  using T = typename M::scalar;
  constexpr int m = M::brake_count;
  static_assert(
      requires { law.torque(now, touched, memory); },
      "passive_haptics: torque() of this law takes brakes_of<M> alone; let it take a brake_situation<M, "
      "E, B> of any brakes B, or give the step brakes_of<M>.");
  result.outcome = check_contacts<T>(touched);
  if (result.outcome == status::ok && !all_finite(now.E, now.w)) result.outcome = status::pose_undefined;
  if (result.outcome != status::ok) return brake_vector<M>::Zero();

  const brake_vector<M> wanted = law.torque(now, touched, memory);
  result.stages.add(stage::law);
  if (!all_finite(wanted)) result.outcome = status::result_not_finite;
  if (result.outcome != status::ok) return brake_vector<M>::Zero();

  brake_vector<M> td = brake_vector<M>::Zero();
  bool opposes = true;
  unrolled<m>([&](auto i) {
    const T limit = torque_limit_of<T>(now.brakes, i);
    if (std::abs(wanted[i]) > limit) result.saturated = true;
    if (now.s[i] * wanted[i] <= T(0)) td[i] = std::clamp(wanted[i], -limit, limit);
    else opposes = false;
  });
  const vector<T, M::task_dimension> n = as<T>(touched[governing_contact(touched)].normal);
  result.power = classify_power(dot(brake_torque(now.E, n), now.w), opposes && !result.saturated);
  result.display = opposes && !result.saturated ? display_class::exact : display_class::approximate;
  result.cone_coefficients = td;
  return td;
}

}  // namespace passive_haptics
