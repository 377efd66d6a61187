/// @file
/// Several touched walls at once: the stages of a cycle that differ. Each wall keeps its own Fd and alpha,
/// and one set of torques meets them in order of priority (force/torques/contact_forces.hpp).
#pragma once

#include <passive_haptics/control/account.hpp>
#include <passive_haptics/control/extensions/force_map.hpp>
#include <passive_haptics/force/torques/contact_forces.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace passive_haptics {

/// Fd of each touched wall.
template <class T, int D, int Capacity>
struct desired_forces {
  const contacts<D, Capacity>& touched;  ///< The walls.
  int governing;                         ///< Wall that asks for the largest force; -1 if there is none.

  /// Number of walls.
  int size() const { return touched.size(); }
  /// Of contact j.
  desired_force<T, D> operator[](int j) const { return force_of<T>(touched[j]); }
};

/// alpha of each touched wall, and whether it is met before the others.
template <class T, int Capacity>
struct contact_scales {
  vector<T, Capacity> alpha = vector<T, Capacity>::Ones();       ///< Of contact j.
  std::array<bool, static_cast<std::size_t>(Capacity)> first{};  ///< It is being left, and the law gives way.
};

/// What can be displayed of several forces. It depends on each one's alpha, so it is found in alpha * Fc.
template <class M, class Box, class Forces>
struct displayable_forces {
  const Forces& Fd;                                                      ///< The desired forces.
  force_map<typename M::scalar, M::task_dimension, M::brake_count> map;  ///< F = G t.
  Box box;  ///< Torques that the brakes can make.
};

/// True if one of the walls asks for a force.
template <class T, int D, int Capacity>
bool asks(const desired_forces<T, D, Capacity>& Fd) {
  return Fd.governing >= 0 && asks(Fd[Fd.governing]);
}

/// Fd of each wall.
template <class M, class B, ScalingLaw L, int D, int N>
  requires(N > 1)
auto desired(const cycle_parts<M, B, L>&, const contacts<D, N>& touched) {
  return desired_forces<typename M::scalar, D, N>{touched, governing_contact(touched)};
}

/// What is needed to find Fc of several walls.
template <class M, class B, ScalingLaw L, class Now, class T, int D, int N>
auto displayed(const cycle_parts<M, B, L>& with, const Now& now, const desired_forces<T, D, N>& Fd,
               const auto& /*touched*/, step_memory<L>&) {
  using box = torque_box<T, M::brake_count>;
  return displayable_forces<M, box, desired_forces<T, D, N>>{
      Fd, force_map_of(now), torques_within(now.s, torque_limits_of<T, M::brake_count>(with.brakes))};
}

/// alpha of each wall.
template <class M, class B, ScalingLaw L, class Now, class Box, class T, int D, int N>
auto scale(const cycle_parts<M, B, L>& with, const Now& now, const desired_forces<T, D, N>& Fd,
           const displayable_forces<M, Box, desired_forces<T, D, N>>&) {
  contact_scales<T, N> all;
  for (int j = 0; j < Fd.size(); ++j) {
    const auto one = Fd[j];
    const T leaving = outward(one, now.v);
    all.first[static_cast<std::size_t>(j)] = gives_way<L> && leaving > T(0);
    if (asks(one))
      all.alpha[j] =
          with.law.scale(contact_situation<T, D>{one.direction, one.magnitude, leaving, now.hand_force});
  }
  return all;
}

/// Fc' = alpha Fc, the force that meets alpha_j Fd_j in order of priority, within the limits.
template <class M, class Box, class T, int D, int N>
auto operator*(const contact_scales<T, N>& scales,
               const displayable_forces<M, Box, desired_forces<T, D, N>>& Fc) {
  std::array<contact_demand<T, D>, static_cast<std::size_t>(N)> demands;
  int count = 0;
  for (int j = 0; j < Fc.Fd.size(); ++j) {
    const auto Fd = Fc.Fd[j];
    if (!asks(Fd)) continue;
    demands[static_cast<std::size_t>(count++)] = {Fd.direction, scales.alpha[j] * Fd.magnitude,
                                                  scales.first[static_cast<std::size_t>(j)]};
  }
  const auto answer = contact_forces<T, D, M::brake_count, N>(Fc.map, Fc.box, demands, count);
  return approximated_force<T, D, M::brake_count>{display_class::approximate, answer.force, answer.torque};
}

namespace detail {

// Whether what is commanded is Fc itself: no wall's force is scaled or comes first, no limit is met.
template <class M, class T, int N>
bool is_whole(const contact_scales<T, N>& scales, int count, const torque_box<T, M::brake_count>& box,
              const brake_vector<M>& t) {
  bool whole = true;
  for (int j = 0; j < count; ++j)
    whole = whole && scales.alpha[j] == T(1) && !scales.first[static_cast<std::size_t>(j)];
  for (int i = 0; i < M::brake_count; ++i)
    whole = whole && (t[i] == T(0) || (t[i] > box.lower[i] && t[i] < box.upper[i]));
  return whole;
}

// Fc of several walls before alpha and limits; exact where each gets all that it asks for.
template <class M, class Box, class T, int D, int N, class Now>
auto unscaled(const Now& now, displayable_forces<M, Box, desired_forces<T, D, N>> Fc,
              const contact_scales<T, N>& scales, approximated_force<T, D, M::brake_count> F) {
  if (!is_whole<M>(scales, Fc.Fd.size(), Fc.box, F.torque)) {
    constexpr T infinity = std::numeric_limits<T>::infinity();
    Fc.box = torques_within(now.s, brake_vector<M>(brake_vector<M>::Constant(infinity)));
    F = contact_scales<T, N>() * Fc;
  }
  const T size = F.force.norm(), tolerance = rounding_tolerance<T>(M::brake_count + N) * size;
  bool met = true;
  for (int j = 0; j < Fc.Fd.size(); ++j) {
    const auto Fd = Fc.Fd[j];
    if (asks(Fd)) met = met && std::abs(Fd.magnitude - Fd.direction.dot(F.force)) <= tolerance;
  }
  if (met) F.display = display_class::exact;
  else if (!(size > T(0))) F.display = display_class::none;
  F.cosine_squared = cosine_squared(F.force, Fc.Fd[Fc.Fd.governing].direction);
  return F;
}

// Whether brakes of these signs can make the force, to rounding: s_i t_i <= 0 for t = E^T F.
template <class Now, class T, int D, int Brakes>
bool is_in_cone(const Now& now, const approximated_force<T, D, Brakes>& F) {
  const matrix<T, D, Brakes> E(now.E);
  const vector<T, Brakes> t = E.transpose() * F.force;
  const T tolerance = rounding_tolerance<T>(1) * F.force.norm();
  bool all = true;
  for (int i = 0; i < Brakes; ++i) all = all && now.s[i] * t[i] <= tolerance * E.col(i).norm();
  return all;
}

}  // namespace detail

/// The account of several walls. Its classes and alpha are those of the wall that asks for most, display is
/// exact where each wall gets all that it asks for, and each has a report.
template <class Answer, class M, class B, class L, class Now, int D, int N, class T, class Forces,
          class Force>
Answer account(const cycle_parts<M, B, L>& with, const Now& now, const contacts<D, N>& touched,
               const desired_forces<T, D, N>& Fd, const Forces& Fc, const contact_scales<T, N>& scales,
               const Force& Fc_scaled, const saturated_torque<T, M::brake_count>& td,
               const brake_vector<M>& t, step_memory<L>& memory) {
  vector<T, N> leaving = vector<T, N>::Zero(), magnitude = vector<T, N>::Zero();
  for (int j = 0; j < Fd.size(); ++j) {
    leaving[j] = outward(Fd[j], now.v);
    magnitude[j] = Fd[j].magnitude;
  }
  const bool are_shares = (scales.alpha.array() >= T(0) && scales.alpha.array() <= T(1)).all();
  status outcome = check_command<T>(touched, leaving, are_shares, magnitude);
  if (outcome == status::ok && !all_finite(Fc.map.G)) outcome = status::pose_undefined;
  if (outcome != status::ok) return released<Answer>(outcome);

  const auto summary = [&](const Force& F) {
    const int j = Fd.governing;
    return account<Answer>(with, now, touched, Fd[j], F, scales.alpha[j], Fc_scaled, td, t, memory);
  };
  if constexpr (!requires(Answer answer) { answer.contacts; }) {
    return summary(Fc_scaled);
  } else {
    Force whole = detail::unscaled(now, Fc, scales, Fc_scaled);
    // At a pose where rounding decides what brakes without limits could do, what is commanded is told
    if (!displays_by_generators<M> && !detail::is_in_cone(now, whole))
      whole = {display_class::approximate, Fc_scaled.force, Fc_scaled.torque,
               cosine_squared(Fc_scaled.force, Fd[Fd.governing].direction)};
    Answer answer =
        all_finite(Fc_scaled.torque) ? summary(whole) : released<Answer>(status::result_not_finite);
    if (answer.outcome != status::ok) return answer;
    answer.saturated =
        (td.torque.array().abs() >= torque_limits_of<T, M::brake_count>(now.brakes).array()).any();
    answer.contact_count = Fd.size();
    for (int j = 0; j < Fd.size(); ++j) {
      const auto k = static_cast<std::size_t>(j);
      const T wanted = asks(Fd[j]) ? scales.alpha[j] * Fd[j].magnitude : T(0);
      answer.contacts[k] = {touched[j].wall, wanted, Fd[j].direction.dot(Fc_scaled.force), scales.first[k]};
    }
    return answer;
  }
}

}  // namespace passive_haptics
