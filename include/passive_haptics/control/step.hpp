/// @file
/// One control cycle for walls that are given.
#pragma once

#include <passive_haptics/control/cycle.hpp>
#include <passive_haptics/control/step_requirements.hpp>

namespace passive_haptics {

/// One control cycle of a mechanism in contact: from what is touched and how the device moves to what the
/// brakes are told (cycle.hpp). Pure apart from memory; never throws, allocates, locks or reads a clock.
///
/// If the state has no hand force, a brake at rest has sign 0: it may hold either way.
///
/// B: brakes_of<M>, or any type with some of its members (brake/brake_concepts.hpp). Without a torque_limit
/// nothing is cut; without a rate_dead_band s = sgn(w) and no hand torque is computed.
///
/// Errors: NaN or infinity in what is read, invalid parameters, a pose without a finite Jacobian or a law's
/// scale outside [0, 1] gives zero capacity and the reason in outcome. Cost: nothing but checks and a pose in
/// free space; no projection where Fd can be displayed exactly. A constant transmission is inverted each
/// time; a controller keeps its inverse.
template <class M, class Contacts, class L, class State, class B = brakes_of<M>>
PASSIVE_HAPTICS_FLATTEN step_result_for<M, Contacts> step(
    const M& mechanism, const B& brakes, const Contacts& touched, const L& law, const State& state,
    step_memory<L>& memory,
    const step_options<typename M::scalar>& options = step_options<typename M::scalar>()) noexcept {
  static_assert(detail::step_requirements<M, contacts_of<Contacts>, L, State, B>::met);
  const brake_jacobian_evaluator<M> brake_jacobian(mechanism);
  const cycle_parts<M, B, L> with{mechanism, brakes, law, brake_jacobian, options};
  return run_cycle<step_result_for<M, Contacts>>(with, check_parameters<L>(brakes, options), touched, state,
                                                 memory);
}

}  // namespace passive_haptics
