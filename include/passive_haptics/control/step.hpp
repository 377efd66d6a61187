/// @file
/// One control cycle for walls that are given, and what must hold of the types of any.
#pragma once

#include <passive_haptics/control/cycle.hpp>

namespace passive_haptics {
namespace detail {

// What must hold of the brakes of a step under this law, one short message for each.
template <class M, class L, class B>
struct law_brake_requirements {
  static_assert(ControlLaw<L>, "passive_haptics: the law must model ControlLaw (control/control_law.hpp).");
  static_assert(
      !TorqueLaw<L> || requires(const cycle_parts<M, B, L>& with, const brake_vector<M>& t) {
        limited(with, t);
      }, "passive_haptics: a TorqueLaw needs <passive_haptics/control/laws/torque_law.hpp>.");
  static_assert(
      !displays_by_generators<M> ||
          requires(const M& mechanism, const joint_vector<M>& q) { generators_of(mechanism, q); },
      "passive_haptics: redundant brakes and inertial forces need "
      "<passive_haptics/control/extensions/generator_form.hpp>.");
  static_assert(brake_requirements<B, M>::met);
  static_assert(!needs_brake_lag<L> || names_time_constant<B>,
                "passive_haptics: this law needs the brakes' lag: give the brakes a time_constant "
                "(brake_parameters), or take a law that needs none.");
  static_assert(!needs_torque_limit<L> || names_torque_limit<B>,
                "passive_haptics: this law locks brakes: give the brakes a torque_limit (brake_parameters).");
  static constexpr bool met = true;
};

// What must hold of the types of a step, one short message for each.
template <class M, class Contacts, class L, class State, class B>
struct step_requirements {
  static_assert(mechanism_requirements<M>::met);
  static_assert(law_brake_requirements<M, L, B>::met);
  static_assert(DeviceState<State, M>,
                "passive_haptics: the state must be a device_state<M>, or have its members "
                "time, q and qd with exactly its types.");
  static_assert(
      !needs_hand_force<L> || HandForceState<State, M>,
      "passive_haptics: this law needs a hand force: give the state a hand_force (device_state<M>), or "
      "take a law that needs none (no_direct_control).");
  static_assert(Contacts::dimension == M::task_dimension,
                "passive_haptics: the scene's dimension must be the mechanism's task_dimension.");
  static_assert(
      requires(const cycle_parts<M, B, L>& with, const Contacts& touched) { desired(with, touched); } ||
          !ControlLaw<L> || Contacts::dimension != M::task_dimension,
      "passive_haptics: scenes of several walls need "
      "<passive_haptics/control/extensions/several_contacts.hpp>.");
  static constexpr bool met = true;
};

}  // namespace detail

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
