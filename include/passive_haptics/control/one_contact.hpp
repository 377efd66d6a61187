/// @file
/// One touched wall: force approximation, the law's share of it, the torque limits.
#pragma once

#include <passive_haptics/brake/force_generators.hpp>
#include <passive_haptics/control/brake_situation.hpp>
#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/control/step_options.hpp>
#include <passive_haptics/control/step_result.hpp>
#include <passive_haptics/force/desired_force.hpp>
#include <passive_haptics/mechanism/inertial.hpp>

#include <type_traits>

namespace passive_haptics {

/// What is known of a step at compile time, so that what is not needed is not computed.
struct step_knowledge {
  bool walls_move = true;  ///< Contacts may have a wall_velocity.
  bool account = true;     ///< More than capacity and outcome of the result is read.
};

/// What the brakes can display of a unit force n with torques t = E^T n, in the form that fits the mechanism:
/// half-spaces, or generators for redundant brakes and inertial forces.
template <bool WithCosine = true, class M, class EMatrix, class B>
auto approximate_with(const brake_situation<M, EMatrix, B>& now, const task_vector<M>& n,
                      const brake_vector<M>& t, typename M::scalar min_cosine, half_space_set& active) {
  using T = typename M::scalar;
  if constexpr (detail::has_inertial_forces<M>) {
    return approximate_by_generators(inertial_force_generators(now.mechanism, now.q), now.s, n, min_cosine);
  } else if constexpr (M::brake_count > M::dof) {
    return approximate_by_generators(force_generators(now.mechanism, now.q), now.s, n, min_cosine);
  } else if constexpr (ExactDiagonal<EMatrix, T, M::dof> && !StickingBrakes<B, T, M::brake_count>) {
    // s = sgn(w): no sign is made a number only to be multiplied
    return detail::approximate_axes<WithCosine>(n, t, min_cosine, [&](int i) {
      return now.w[i] > T(0) ? t[i] > T(0) : (now.w[i] < T(0) && t[i] < T(0));
    });
  } else {
    return approximate<WithCosine>(now.E, now.s, n, t, min_cosine, active);
  }
}

/// Whether NaN or infinity stands in one of these contacts, or a force overflows T.
template <class T, class Contacts>
status check_contacts(const Contacts& touched) {
  for (int j = 0; j < touched.size(); ++j) {
    const auto [n, magnitude] = force_of<T>(touched[j]);
    if (!all_finite(magnitude, n, as<T>(touched[j].wall_velocity))) return status::contact_not_finite;
  }
  return status::ok;
}

/// Torques td [N m] commanded for one contact: E^T Fc, scaled by the law and within the limits. Notes in
/// `result` what it found. Section 4, steps 1 to 4. Where walls cannot move, nothing is computed of their
/// velocity.
template <step_knowledge Known = step_knowledge{}, class M, class EMatrix, int D, class L, class B>
brake_vector<M> display_one(const brake_situation<M, EMatrix, B>& now, const contact<D>& touched,
                            const L& law, step_memory<L>& memory,
                            const step_options<typename M::scalar>& options, step_result<M>& result) {
  using T = typename M::scalar;
  const desired_force<T, D> Fd = force_of<T>(touched);
  const vector<T, D>& n = Fd.direction;
  const T magnitude = Fd.magnitude;
  const brake_vector<M> t = brake_torque(now.E, n);
  const T outward = dot(t, now.w);  // n . v = n . E w
  T leaving = T(0);
  if constexpr (needs_normal_velocity<L>)
    leaving = Known.walls_move ? outward - dot(n, as<T>(touched.wall_velocity)) : outward;
  // NaN or infinity in the contact, E or w reaches one of these
  bool finite = all_finite(magnitude, t);
  if constexpr (needs_normal_velocity<L>) finite = all_finite(magnitude, t, leaving);
  if constexpr (!needs_normal_velocity<L> && Known.walls_move)
    finite = finite && all_finite(as<T>(touched.wall_velocity));
  if constexpr (!needs_normal_velocity<L> && detail::has_exact_transmission<M>)
    finite = finite && all_finite(now.w);
  if (!finite) {
    result.outcome = all_finite(magnitude, n, as<T>(touched.wall_velocity)) ? status::pose_undefined
                                                                            : status::contact_not_finite;
    return brake_vector<M>::Zero();
  }

  const auto Fc = approximate_with<Known.account>(now, n, t, options.min_cosine, memory.active);
  result.display = Fc.display;
  if constexpr (Known.account) {
    result.power = classify_power(outward, Fc.display == display_class::exact);
    result.approximation_cosine = Fc.cosine;
  }
  if (Fc.display != display_class::exact) result.stages.add(stage::projection);
  if constexpr (M::dof > M::task_dimension && !detail::has_inertial_forces<M>) {
    if (Fc.display == display_class::none && cone_is_zero(now.E, now.s))
      result.display = display_class::empty_cone;
  }
  if (!is_displayed(Fc.display)) {
    if constexpr (std::is_empty_v<B>)  // the step has checked no parameters; a NaN angle displays nothing
      if (!all_finite(options.min_cosine)) result.outcome = status::parameters_invalid;
    return brake_vector<M>::Zero();
  }

  const T alpha = law.scale(contact_situation<T, D>{n, magnitude, leaving, now.hand_force}, memory.law);
  result.stages.add(stage::law);
  if (!(alpha >= T(0) && alpha <= T(1))) result.outcome = status::scale_out_of_range;
  result.alpha = alpha;
  result.control_force = scaled(magnitude, Fc.force);
  result.cone_coefficients = scaled(magnitude, Fc.torque);

  if constexpr (LimitedBrakes<B, T, M::brake_count>) {
    const auto command = saturate(Fc.torque, alpha * magnitude, now.brakes.torque_limit, options.limits);
    result.saturated = command.limited;
    return command.torque;
  } else {
    return scaled(alpha * magnitude, Fc.torque);
  }
}

}  // namespace passive_haptics
