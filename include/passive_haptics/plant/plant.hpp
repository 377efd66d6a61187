/// @file
/// The Plant concept: a device in a simulation that a hand and brakes can move.
#pragma once

#include <passive_haptics/core/explain.hpp>
#include <passive_haptics/mechanism/mechanism.hpp>
#include <passive_haptics/plant/energy_balance.hpp>

#include <concepts>
#include <type_traits>
#include <utility>

namespace passive_haptics {

/// The mechanism of a plant.
template <class P>
using mechanism_of = std::remove_cvref_t<decltype(std::declval<const P&>().mechanism())>;

namespace detail {

template <class P>
concept names_mechanism = requires { typename mechanism_of<P>; } && Mechanism<mechanism_of<P>>;
template <class P, class M = mechanism_of<P>>
concept advances_plant = requires(P& plant, typename M::scalar dt, const brake_vector<M> capacity,
                                  const task_vector<M> force) { plant.advance(dt, capacity, force); };
template <class P, class M = mechanism_of<P>>
concept reads_plant = requires(const P& plant) {
  { plant.q() } -> std::convertible_to<joint_vector<M>>;
  { plant.qd() } -> std::convertible_to<joint_vector<M>>;
  { plant.position() } -> std::convertible_to<task_vector<M>>;
  { plant.velocity() } -> std::convertible_to<task_vector<M>>;
  { plant.sensed_force() } -> std::convertible_to<task_vector<M>>;
  { plant.brake_force() } -> std::convertible_to<task_vector<M>>;
  { plant.rates() } -> std::convertible_to<brake_vector<M>>;
  { plant.brake_torque() } -> std::convertible_to<brake_vector<M>>;
  { plant.brake_power() } -> std::convertible_to<brake_vector<M>>;
  { plant.min_mass() } -> std::convertible_to<typename M::scalar>;
};
template <class P>
concept balances_energy = requires(const P& plant) {
  { plant.energy() } -> std::convertible_to<energy_balance>;
};

}  // namespace detail

/// The requirements of Plant, one message for each: `static_assert(is_plant<P, explain>())`.
template <class P, bool Explain = false>
consteval bool is_plant() {
  if constexpr (!detail::names_mechanism<P>)
    static_assert(!Explain, "passive_haptics: a plant needs `const M& mechanism() const` of a Mechanism M.");
  else if constexpr (!detail::advances_plant<P>)
    static_assert(!Explain,
                  "passive_haptics: a plant needs `void advance(scalar dt, const brake_vector<M>& capacity, "
                  "const task_vector<M>& muscle_force)`.");
  else if constexpr (!detail::reads_plant<P>)
    static_assert(!Explain,
                  "passive_haptics: a plant needs the readings of moving_device (q, qd, position, velocity, "
                  "sensed_force, brake_force, rates, brake_torque, brake_power, min_mass); derive from it.");
  else if constexpr (!detail::balances_energy<P>)
    static_assert(!Explain, "passive_haptics: a plant needs `const energy_balance& energy() const`.");
  else return true;
  return Explain;
}

/// A device in a simulation: simulated_device, mujoco_device (interop/mujoco.hpp) or your own. moving_device
/// has all members but advance(), with their units.
template <class P>
concept Plant = is_plant<P>();

}  // namespace passive_haptics
