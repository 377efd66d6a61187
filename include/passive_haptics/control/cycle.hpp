/// @file
/// The control cycle: section 4 of the paper, for any device, law and walls.
#pragma once

#include <passive_haptics/brake/passive_constraint.hpp>
#include <passive_haptics/control/account.hpp>
#include <passive_haptics/control/stages.hpp>
#include <passive_haptics/core/flatten.hpp>

#include <type_traits>

namespace passive_haptics {

/// What the brakes are told about the walls that are touched: section 4. at: the pose; x: the end effector
/// [m]. Answer: what is wanted to know of the cycle; what that lacks is not computed.
template <class Answer, class M, class B, class L, class State, class Pose, class Walls>
PASSIVE_HAPTICS_PART Answer respond(const cycle_parts<M, B, L>& with, const State& state, const Pose& at,
                                    const point<M::task_dimension>& x, const Walls& touched,
                                    step_memory<L>& memory) {
  const M& mechanism = with.mechanism;

  // The force that the walls ask for
  const auto Fd = desired(with, touched);
  if (!asks(Fd)) return released<Answer>(with, state.time, reason<M>(x, touched), memory);

  // What the brakes can do: v = E w, t = E^T F, and the sign of each
  const auto E = with.brake_jacobian(jacobian(mechanism, at), mechanism, state.q);
  const brake_vector<M> w = brake_rates(mechanism, state.q, state.qd);
  const task_vector<M> v = times(E, w), Fh = hand_force<M>(state);
  const brake_vector<M> th = hand_torque<M, B>(state, E);
  const brake_vector<M> s = brake_signs(w, th, with.brakes);
  const brake_situation<M, decltype(E), B> now{mechanism, with.brakes, state.time, state.q, state.qd, x,
                                               E,         w,           v,          s,       Fh};

  // Direct control, steps 1 to 4
  const auto Fc = displayed(with, now, Fd, touched, memory);
  const auto alpha = scale(with, now, Fd, Fc);
  const auto Fc_scaled = alpha * Fc;
  const auto td = add_effects(with, now, touched, commanded(with, alpha, Fc, Fc_scaled));

  // What the mechanism will feel
  const brake_vector<M> t = passive_torque(td.torque, w, th, s, with.brakes);
  return account<Answer>(with, now, touched, Fd, Fc, alpha, Fc_scaled, td, t, memory);
}

/// One control cycle: where the device is, what it touches, what its brakes are told. scene: of a controller,
/// or the walls touched.
template <class Answer, class M, class B, class L, class State, class S>
PASSIVE_HAPTICS_PART Answer cycle(const cycle_parts<M, B, L>& with, S& scene, const State& state,
                                  step_memory<L>& memory) {
  const auto at = pose(with.mechanism, state.q);
  const auto x = as<double>(with.mechanism.position(at));
  if (!may_be_shown<M>(scene, x)) return released<Answer>(with, state.time, status::pose_undefined, memory);

  const auto& touched = walls_at(scene, x, state.time);
  if (const status s = status_of(scene); s != status::ok)
    return released<Answer>(with, state.time, s, memory);
  if constexpr (ScalingLaw<L> && std::remove_cvref_t<decltype(touched)>::capacity > 1)
    if (touched.size() == 1) return respond<Answer>(with, state, at, x, alone(touched), memory);
  return respond<Answer>(with, state, at, x, touched, memory);
}

/// What step() and a controller call: the cycle, but for a state or parameters that are not valid.
/// parameters: of brakes and options, from check_parameters.
template <class Answer, class M, class B, class L, class State, class S>
PASSIVE_HAPTICS_PART Answer run_cycle(const cycle_parts<M, B, L>& with, status parameters, S& scene,
                                      const State& state, step_memory<L>& memory) {
  status given = check_state<M>(state);
  if (given == status::ok) given = parameters;
  return given == status::ok ? cycle<Answer>(with, scene, state, memory)
                             : released<Answer>(with, state.time, given, memory);
}

}  // namespace passive_haptics
