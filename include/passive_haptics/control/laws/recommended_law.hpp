/// Default law of a device.
#pragma once

#include <passive_haptics/control/device_state.hpp>
#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>

#include <string_view>

namespace passive_haptics {

namespace detail {
template <class B>
concept names_limit_and_lag = names_torque_limit<B> && names_time_constant<B>;
template <class M, class B, class State>
concept meets_needs_of_velocity_control = Dynamics<M> && HandForceState<State, M> && names_limit_and_lag<B>;
}  // namespace detail

/// Returns velocity_direct_control if the mechanism has Dynamics, the state a hand force, and the brakes
/// limits and lags. Otherwise on_off_control, with the lag of the slowest brake as lead.
///
/// These two laws lose contact least often (docs/results.md, table of laws and brakes): on eight types of
/// brakes velocity_direct_control 0 times, on_off_control 0 to 8 times, direct_control 5 to 25 times. In a
/// corner, both hold as much as locked brakes; without a force sensor only on_off_control does. State: the
/// state type of the controller, `recommended_law<State>(mechanism, brakes)`.
template <class State, class M, class B>
auto recommended_law(const M&, [[maybe_unused]] const B& brakes) {
  if constexpr (detail::meets_needs_of_velocity_control<M, B, State>) {
    return velocity_direct_control();
  } else {
    on_off_control relay;
    if constexpr (detail::names_time_constant<B>)
      relay.parameters.lead = static_cast<double>(brakes.time_constant.maxCoeff());
    return relay;
  }
}

/// recommended_law for a device with a force sensor, device_state<M>.
template <class M, class B>
auto recommended_law(const M& mechanism, const B& brakes) {
  return passive_haptics::recommended_law<device_state<M>>(mechanism, brakes);
}

/// Reason for the choice of recommended_law<State>: lists the missing requirements of a better law.
template <class State, class M, class B>
constexpr std::string_view reason_for_law(const M&, const B&) {
  if constexpr (!Dynamics<M>)
    return "on_off_control: velocity_direct_control needs the mechanism's inertia (mass_matrix, bias_torque, "
           "bias_acceleration)";
  else if constexpr (!HandForceState<State, M>)
    return "on_off_control: velocity_direct_control needs a force sensor (state.hand_force)";
  else if constexpr (!detail::names_limit_and_lag<B>)
    return "on_off_control: velocity_direct_control needs the brakes' torque_limit and time_constant";
  else return "velocity_direct_control: inertia, hand force, limits and lags of the brakes are available";
}

/// reason_for_law for a device with a force sensor, device_state<M>.
template <class M, class B>
constexpr std::string_view reason_for_law(const M& mechanism, const B& brakes) {
  return passive_haptics::reason_for_law<device_state<M>>(mechanism, brakes);
}

}  // namespace passive_haptics
