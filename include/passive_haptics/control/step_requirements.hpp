/// @file
/// What must hold of the types of a control cycle.
#pragma once

#include <passive_haptics/control/cycle_inputs.hpp>
#include <passive_haptics/control/ways/one_wall.hpp>

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

// In place of an argument that was not given.
struct nothing_given {};

// What must hold of the order of a controller's arguments.
template <class M, class B, class S, class L>
struct controller_order {
  static_assert(names_sizes<M> || !(names_torque_limit<M> || is_unlimited<M> || gives_contacts<M>),
                "passive_haptics: the arguments of a controller are (mechanism, brakes, scene, law), in this "
                "order: the first one is no mechanism.");
  static_assert(!(names_sizes<B> || gives_contacts<B>),
                "passive_haptics: the arguments of a controller are (mechanism, brakes, scene, law), in this "
                "order: the second one is no brakes, such as brakes_of<mechanism>().");
  static_assert(!(names_sizes<S> || names_torque_limit<S> || is_unlimited<S> || ControlLaw<S>),
                "passive_haptics: the arguments of a controller are (mechanism, brakes, scene, law), in this "
                "order: the third one is no scene, such as scene(wall(shape, stiffness)).");
  static_assert(!std::is_same_v<L, nothing_given>,
                "passive_haptics: the arguments of a controller are (mechanism, brakes, scene, law): one is "
                "missing.");
  static_assert(!(names_sizes<L> || names_torque_limit<L> || is_unlimited<L> || gives_contacts<L>),
                "passive_haptics: the arguments of a controller are (mechanism, brakes, scene, law), in this "
                "order: the fourth one is no law, such as direct_control().");
  static constexpr bool met = true;
};

// Whether the header that defines this type is included.
template <class X>
concept is_included = requires { sizeof(X); };

// What must hold of the brakes of a step under this law, one short message for each.
template <class M, class L, class B>
struct law_brake_requirements {
  static_assert(law_spelling<L>::met);
  static_assert(ControlLaw<L>,
                "passive_haptics: the law must model ControlLaw: give it `template <class T, int D> T "
                "scale(const contact_situation<T, D>&) const noexcept` (control/control_law.hpp).");
  static_assert(
      !TorqueLaw<L> ||
          is_included<torques_of_law<brake_command<M>, cycle_setup<M, B, L>, contacts<M::task_dimension, 1>>>,
      "passive_haptics: a TorqueLaw needs <passive_haptics/control/ways/torque_law.hpp>.");
  static_assert(self_motion_requirements<M>::met);
  static_assert(!displays_by_generators<M> || is_included<display_form<M>>,
                "passive_haptics: redundant brakes, fewer brakes than joints and inertial forces need "
                "<passive_haptics/control/ways/generator_form.hpp>.");
  static_assert(!Settles<M> || is_included<display_form<M>>,
                "passive_haptics: mechanisms with dof > task_dimension need "
                "<passive_haptics/control/ways/settled_form.hpp>.");
  static_assert(!leaves_free_joints_alone<M> || is_included<display_form<M>>,
                "passive_haptics: kinetostatic(mechanism) with fewer brakes than joints needs "
                "<passive_haptics/control/ways/free_joints_form.hpp>.");
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
  static_assert(state_spelling<State>::met);
  static_assert(
      DeviceState<State, M>,
      "passive_haptics: the state must be a device_state<M>, or have its members time (seconds, as a "
      "floating-point number), q and qd with exactly its types.");
  static_assert(
      !needs_hand_force<L> || HandForceState<State, M>,
      "passive_haptics: this law needs a hand force: give the state a hand_force (device_state<M>), or "
      "take a law that needs none (no_direct_control).");
  static_assert(Contacts::dimension == M::task_dimension,
                "passive_haptics: the scene's dimension must be the mechanism's task_dimension.");
  static_assert(
      is_included<way_of<brake_command<M>, cycle_setup<M, B, L>, Contacts>> || !ControlLaw<L> ||
          Contacts::dimension != M::task_dimension,
      "passive_haptics: scenes of several walls need <passive_haptics/control/ways/several_walls.hpp>.");
  static constexpr bool met = true;
};

}  // namespace detail

}  // namespace passive_haptics
