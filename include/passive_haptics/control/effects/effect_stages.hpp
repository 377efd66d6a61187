/// @file
/// The stages of a cycle with effects: the walls as without them, then the effects.
#pragma once

#include <passive_haptics/control/effects/walls_and_effects.hpp>
#include <passive_haptics/control/extensions/several_contacts.hpp>
#include <passive_haptics/force/torques/torques_beside.hpp>

#include <algorithm>
#include <concepts>

namespace passive_haptics {

/// The one wall that is touched, and the effects.
template <class Walls, class... Effects>
auto alone(const walls_and_effects<Walls, Effects...>& touched) {
  return walls_and_effects<decltype(alone(touched.walls)), Effects...>{alone(touched.walls), touched.effects};
}

/// What the walls want; that effects stand beside them is in the type.
template <class Forces>
struct desired_beside_effects {
  Forces walls;  ///< Of the walls.
};

/// Effects always may want something.
template <class Forces>
bool asks(const desired_beside_effects<Forces>&) {
  return true;
}

/// Fd of the walls.
template <class M, class B, class L, class Walls, class... Effects>
auto desired(const cycle_parts<M, B, L>& with, const walls_and_effects<Walls, Effects...>& touched) {
  static_assert(ScalingLaw<L>,
                "passive_haptics: with_effects needs a ScalingLaw, such as direct_control: a TorqueLaw "
                "commands the brakes itself.");
  return desired_beside_effects<decltype(desired(with, touched.walls))>{desired(with, touched.walls)};
}

/// Fc of the walls.
template <class M, class B, ScalingLaw L, class Now, class Forces, class Touched>
auto displayed(const cycle_parts<M, B, L>& with, const Now& now, const desired_beside_effects<Forces>& Fd,
               const Touched& touched, step_memory<L>& memory) {
  return displayed(with, now, Fd.walls, touched.walls, memory);
}

/// alpha of the walls. The law is not asked where no wall asks for a force.
template <class M, class B, ScalingLaw L, class Now, class Forces, class Displayed>
auto scale(const cycle_parts<M, B, L>& with, const Now& now, const desired_beside_effects<Forces>& Fd,
           const Displayed& Fc) {
  using T = typename M::scalar;
  if constexpr (std::same_as<decltype(scale(with, now, Fd.walls, Fc)), T>) {
    if (!asks(Fd.walls)) return T(1);
  }
  return scale(with, now, Fd.walls, Fc);
}

/// Torques for walls and effects, within the limits.
template <class M>
struct torques_with_effects : saturated_torque<typename M::scalar, M::brake_count> {
  task_vector<M> effect_force;    ///< Fe [N].
  joint_vector<M> effect_torque;  ///< Of effects on joints [N m].
  status outcome;                 ///< ok, or why effects could not be added.
};

namespace detail {

// Adds what the effects want: their forces, and the torques of joints.
template <class M, class Now, class Touched>
void ask_effects(const Now& now, const Touched& touched, torques_with_effects<M>& wanted) {
  using T = typename M::scalar;
  const auto Tt = [&] { return transposed_transmission(now.mechanism, now.q); };
  for_each(touched.effects, [&]<class E>(const E& effect) {
    static_assert(std::same_as<typename E::scalar, T>,
                  "passive_haptics: an effect's scalar must be the mechanism's.");
    if constexpr (Effect<E>) {
      wanted.effect_force += effect.force(as<T>(now.x), now.v, now.hand_force);
    } else if constexpr (WallEffect<E>) {
      wanted.effect_force += effect.force_at(touched.walls, now.v, now.hand_force);
    } else {
      static_assert(E::dof == M::dof,
                    "passive_haptics: an effect on joints must be of as many as the mechanism has.");
      const joint_vector<M> hand = Tt() * brake_torque(now.E, now.hand_force);
      wanted.effect_torque += effect.torque(now.q, now.qd, hand);
    }
  });
}

// What joints with a torque of their own shall have more: that, and what forces of effects want of them.
template <class M, class Now>
auto demand_of(const Now& now, const torques_with_effects<M>& wanted) {
  effect_demand<typename M::scalar, M::task_dimension, M::brake_count, M::dof> demand{
      wanted.effect_force, transposed_transmission(now.mechanism, now.q), wanted.effect_torque};
  for (int i = 0; i < M::dof; ++i)
    if (wanted.effect_torque[i] == 0) demand.joint_rows.row(i).setZero();
  demand.joint_torque += demand.joint_rows * brake_torque(now.E, wanted.effect_force);
  return demand;
}

// n_j of the walls that ask for a force, in rows.
template <class T, class Walls>
auto normals_of(const Walls& walls) {
  constexpr int d = std::remove_cvref_t<decltype(walls[0].normal)>::RowsAtCompileTime;
  matrix<T, Walls::capacity, d> normals = matrix<T, Walls::capacity, d>::Zero();
  for (int j = 0; j < walls.size(); ++j) {
    const auto Fd = force_of<T>(walls[j]);
    if (asks(Fd)) normals.row(j) = Fd.direction.transpose();
  }
  return normals;
}

}  // namespace detail

/// The torques of the walls, and beside them those of the effects (torques_beside).
template <class M, class B, class L, class Now, class Walls, class... Effects, class T, int Brakes>
torques_with_effects<M> add_effects(const cycle_parts<M, B, L>& with, const Now& now,
                                    const walls_and_effects<Walls, Effects...>& touched,
                                    const saturated_torque<T, Brakes>& td) {
  torques_with_effects<M> all{td, task_vector<M>::Zero(), joint_vector<M>::Zero(), status::result_not_finite};
  detail::ask_effects(now, touched, all);
  if (!all_finite(td.torque, all.effect_force, all.effect_torque)) return all;
  all.outcome = status::ok;
  // Nothing to add, and the least drag already, but where each brake was cut alone
  const bool least_drag = !td.limited || with.options.limits == saturation::keep_direction;
  if (least_drag && all.effect_force.isZero(T(0)) && all.effect_torque.isZero(T(0))) return all;

  const auto map = force_map_of(now);
  if (!all_finite(map.G)) {
    all.outcome = status::pose_undefined;
    return all;
  }
  const vector<T, Brakes> limit = torque_limits_of<T, Brakes>(with.brakes);
  all.torque = torques_beside(map, torques_within(now.s, limit), td.torque,
                              detail::normals_of<T>(touched.walls), detail::demand_of(now, all));
  all.limited = td.limited || (all.torque.array().abs() >= limit.array()).any();
  return all;
}

/// The account: of the walls as without effects, and what the effects want.
template <class Answer, class M, class B, class L, class Now, class Walls, class... Effects, class Forces,
          class Displayed, class Scales, class Force>
Answer account(const cycle_parts<M, B, L>& with, const Now& now,
               const walls_and_effects<Walls, Effects...>& touched, const desired_beside_effects<Forces>& Fd,
               const Displayed& Fc, const Scales& alpha, const Force& Fc_scaled,
               const torques_with_effects<M>& td, const brake_vector<M>& t, step_memory<L>& memory) {
  Answer answer;
  if (asks(Fd.walls)) {
    answer = account<Answer>(with, now, touched.walls, Fd.walls, Fc, alpha, Fc_scaled, td, t, memory);
  } else {
    answer = released<Answer>(reason<M>(now.x, touched.walls));
    answer.capacity = td.torque.cwiseAbs();
    if constexpr (requires { answer.torque; }) {
      answer.torque = t;
      answer.saturated = td.limited;
      answer.signs = now.s;
    }
  }
  if (answer.outcome == status::ok) answer.outcome = all_finite(now.v) ? td.outcome : status::pose_undefined;
  if (answer.outcome != status::ok) return released<Answer>(with, now.time, answer.outcome, memory);
  if constexpr (requires { answer.effect_force; }) {
    answer.effect_force = td.effect_force;
    answer.effect_torque = td.effect_torque;
  }
  return answer;
}

}  // namespace passive_haptics
