/// Requirements of the types of a control cycle.
#pragma once

#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/control/device_state.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>

#include <type_traits>

namespace passive_haptics {
namespace detail {

template <class S>
concept gives_contacts = requires { typename S::contacts_type; };

struct nothing_given {};

template <class M, class B, class S, class L, bool Explain = false>
consteval bool are_in_order() {
  if constexpr (!names_sizes<M> && (names_torque_limit<M> || is_unlimited<M> || gives_contacts<M>))
    static_assert(
        !Explain,
        "passive_haptics: the arguments of a controller are (mechanism, brakes, scene, law), in this "
        "order: the first argument must be a mechanism.");
  else if constexpr (names_sizes<B> || gives_contacts<B>)
    static_assert(
        !Explain,
        "passive_haptics: the arguments of a controller are (mechanism, brakes, scene, law), in this "
        "order: the second argument must be brakes, for example brakes_of<mechanism>().");
  else if constexpr (names_sizes<S> || names_torque_limit<S> || is_unlimited<S> || ControlLaw<S>)
    static_assert(
        !Explain,
        "passive_haptics: the arguments of a controller are (mechanism, brakes, scene, law), in this "
        "order: the third argument must be a scene, for example scene(wall(shape, stiffness)).");
  else if constexpr (std::is_same_v<L, nothing_given>)
    static_assert(
        !Explain,
        "passive_haptics: the arguments of a controller are (mechanism, brakes, scene, law): one is "
        "missing.");
  else if constexpr (names_sizes<L> || names_torque_limit<L> || is_unlimited<L> || gives_contacts<L>)
    static_assert(
        !Explain,
        "passive_haptics: the arguments of a controller are (mechanism, brakes, scene, law), in this "
        "order: the fourth argument must be a law, for example direct_control().");
  else return true;
  return Explain;
}

template <class M, class L, class B, bool Explain = false>
consteval bool is_law_for() {
  if constexpr (!Mechanism<M>) return is_mechanism<M, Explain>();
  else if constexpr (!ControlLaw<L>)
    static_assert(!Explain,
                  "passive_haptics: the law must model ControlLaw: give it `template <class T, int D> T "
                  "scale(const contact_situation<T, D>&) const noexcept` (control/control_law.hpp).");
  else if constexpr (needs_dynamics<L> && !Dynamics<M>)
    static_assert(!Explain,
                  "passive_haptics: this law needs a mechanism that models Dynamics: give it mass_matrix, "
                  "bias_torque and bias_acceleration (mechanism/dynamics.hpp), or use direct_control.");
  else if constexpr (!BrakesFor<B, M>) return are_brakes<B, M, Explain>();
  else if constexpr (needs_brake_lag<L> && !names_time_constant<B>)
    static_assert(!Explain,
                  "passive_haptics: this law needs the brakes' lag: give the brakes a time_constant "
                  "(brake_parameters), or use a law that needs none.");
  else return true;
  return Explain;
}

template <class Contacts, class M, bool Explain = false>
consteval bool are_contacts_for() {
  if constexpr (Contacts::dimension != M::task_dimension)
    static_assert(!Explain, "passive_haptics: the scene's dimension must be the mechanism's task_dimension.");
  else return true;
  return Explain;
}

template <class M, class B, class S, class L, bool Explain = false>
consteval bool is_controller() {
  if constexpr (!are_in_order<M, B, S, L>()) return are_in_order<M, B, S, L, Explain>();
  else if constexpr (!Mechanism<M>) return is_mechanism<M, Explain>();
  else if constexpr (!gives_contacts<S>)
    static_assert(!Explain,
                  "passive_haptics: a controller needs a scene: `scene(wall(shape, stiffness))`, a world, or "
                  "with_effects(scene, effect).");
  else if constexpr (!are_contacts_for<typename S::contacts_type, M>())
    return are_contacts_for<typename S::contacts_type, M, Explain>();
  else return is_law_for<M, L, B, Explain>();
  return Explain;
}

template <class M, class Contacts, class L, class State, class B, bool Explain = false>
consteval bool is_step() {
  if constexpr (!is_law_for<M, L, B>()) return is_law_for<M, L, B, Explain>();
  else if constexpr (!DeviceState<State, M>) return is_device_state<State, M, Explain>();
  else if constexpr (needs_hand_force<L> && !HandForceState<State, M>)
    static_assert(
        !Explain,
        "passive_haptics: this law needs a hand force: give the state a hand_force (device_state<M>), "
        "or use a law that needs none (no_direct_control).");
  else return are_contacts_for<Contacts, M, Explain>();
  return Explain;
}

}  // namespace detail

}  // namespace passive_haptics
