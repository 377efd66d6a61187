/// @file
/// What must hold of the types of a control cycle.
#pragma once

#include <passive_haptics/control/stages.hpp>

namespace passive_haptics {
namespace detail {

template <class S>
concept gives_contacts = requires { typename S::contacts_type; };
template <class S, int D>
concept has_another_dimension = requires { requires S::dimension != D; };

// What must hold of a controller's scene, one short message for each.
template <class S, class M>
struct scene_requirements {
  static_assert(gives_contacts<S>,
                "passive_haptics: a controller needs a scene: `scene(wall(shape, stiffness))`, a world, or "
                "with_effects(scene, effect).");
  static_assert(!has_another_dimension<S, M::task_dimension>,
                "passive_haptics: the scene's dimension must be the mechanism's task_dimension.");
  static constexpr bool met = true;
};

// Whether step 1 of a cycle is there, or is not by generators. A concept, as that asks for the last part only
// where the others do not hold.
template <class M, class B, class L>
concept has_generator_form =
    !displays_by_generators<M> || !ScalingLaw<L> ||
    requires(const cycle_parts<M, B, L>& with, const brake_situation<M, brake_matrix<M>, B>& now,
             const desired_force<typename M::scalar, M::task_dimension>& Fd,
             step_memory<L>& memory) { displayed(with, now, Fd, Fd, memory); };

// What must hold of the brakes of a step under this law, one short message for each.
template <class M, class L, class B>
struct law_brake_requirements {
  static_assert(ControlLaw<L>,
                "passive_haptics: the law must model ControlLaw: give it `template <class T, int D> T "
                "scale(const contact_situation<T, D>&) const noexcept` (control/control_law.hpp).");
  static_assert(
      !TorqueLaw<L> || requires(const cycle_parts<M, B, L>& with, const brake_vector<M>& t) {
        limited(with, t);
      }, "passive_haptics: a TorqueLaw needs <passive_haptics/control/laws/torque_law.hpp>.");
  static_assert(self_motion_requirements<M>::met);
  static_assert(has_generator_form<M, B, L>,
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

}  // namespace passive_haptics
