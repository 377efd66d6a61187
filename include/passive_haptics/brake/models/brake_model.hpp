/// @file
/// The BrakeModel concept: what one brake makes of a command, whatever its controller believes.
#pragma once

#include <passive_haptics/core/explain.hpp>
#include <passive_haptics/core/parameters.hpp>

#include <concepts>
#include <limits>

namespace passive_haptics {

/// What a brake resists its motion with at one instant: at rate w the torque -strength sgn(w) - drag w, and
/// at rest any torque within +-strength. With strength and drag >= 0 it only ever takes energy.
template <class T>
struct brake_resistance {
  T strength = T(0);  ///< Coulomb friction [N m].
  T drag = T(0);      ///< Viscous drag [N m s].

  /// The table of core/parameters.hpp, of a resistance that is a parameter.
  static constexpr auto members() {
    using p = brake_resistance;
    return member_table(member("strength", &p::strength, "N m", range::not_negative),
                        member("drag", &p::drag, "N m s", range::not_negative));
  }
};

namespace detail {

template <class B>
concept names_brake_scalar = std::floating_point<typename B::scalar>;
template <class B>
concept names_brake_state = std::copyable<typename B::state> && std::default_initializable<typename B::state>;
template <class B>
concept advances_brake = requires(const B brake, typename B::scalar x, typename B::state state) {
  { brake.advance(x, x, x, state) } noexcept -> std::same_as<brake_resistance<typename B::scalar>>;
};
template <class B>
concept limits_brake = requires(const B brake, typename B::scalar rate) {
  { brake.torque_limit_at(rate) } noexcept -> std::same_as<typename B::scalar>;
};

}  // namespace detail

/// The requirements of BrakeModel, one message for each. What takes a model begins with
/// `static_assert(is_brake_model<B, explain>())`.
template <class B, bool Explain = false>
consteval bool is_brake_model() {
  if constexpr (!detail::names_brake_scalar<B>)
    static_assert(!Explain, "passive_haptics: a brake model needs `using scalar = double` or float.");
  else if constexpr (!detail::names_brake_state<B>)
    static_assert(
        !Explain,
        "passive_haptics: a brake model needs a default-constructible `struct state`, empty where it "
        "remembers nothing.");
  else if constexpr (!detail::advances_brake<B>)
    static_assert(!Explain,
                  "passive_haptics: a brake model needs `brake_resistance<scalar> advance(scalar dt, scalar "
                  "command, scalar rate, state&) const noexcept`.");
  else if constexpr (!detail::limits_brake<B>)
    static_assert(
        !Explain,
        "passive_haptics: a brake model needs `scalar torque_limit_at(scalar rate) const noexcept`.");
  else return true;
  return Explain;
}

/// One brake on its own axis; a mechanism has m. For a sliding brake read N for N m and m/s for rad/s.
/// Minimal complete definition:
///   - `using scalar`: float or double;
///   - `struct state`, default-constructible and copyable: what the brake remembers. A new one is of a brake
///     that has long been released;
///   - `brake_resistance<scalar> advance(scalar dt, scalar command, scalar rate, state&) const noexcept`:
///     brings the state dt [s] forward and returns what the brake then resists with by command. command: the
///     capacity [N m] that a controller gives; rate [rad/s] at the beginning of dt;
///   - `scalar torque_limit_at(scalar rate) const noexcept`: the most torque [N m] at this rate by command,
///     all of the model that a controller may use.
///
/// Laws, of any command, rate and history (testing/support/brake_model_laws.hpp):
///   - passive: strength and drag are finite and >= 0;
///   - bounded: strength + drag |rate| <= torque_limit_at(rate);
///   - a command that is negative or NaN is 0, an infinite one is the greatest that there is (valid_command);
///   - a time step that is negative, NaN or infinite is 0, in which no time passes (valid_time_step);
///   - a rate that is NaN is 0, an infinite one is the greatest of its sign (valid_rate).
///
/// Optional:
///   - `brake_resistance<scalar> residual`, a member or a function: what is there without a command and adds
///     to it;
///   - `scalar compliance` [rad/(N m)], a member or a function, constant and >= 0: how far the axis turns
///     elastically for each N m of friction before the brake slips;
///   - members(), the table of core/parameters.hpp: who takes the model then checks its parameters.
///
/// Refinement: InvertibleBrakeModel.
template <class B>
concept BrakeModel = is_brake_model<B>();

/// A brake whose command can be found. Minimal complete definition: BrakeModel, and
///   - `scalar command_for(scalar torque, scalar rate, const state&) const noexcept`: the command [N m] under
///     which the brake, at this rate and with this past, ends in `torque` [N m], or as near as it can.
template <class B>
concept InvertibleBrakeModel =
    BrakeModel<B> && requires(const B brake, typename B::scalar x, const typename B::state state) {
      { brake.command_for(x, x, state) } noexcept -> std::same_as<typename B::scalar>;
    };

/// What a brake resists with without a command; nothing where its model names no residual.
template <class B>
brake_resistance<typename B::scalar> residual_of(const B& brake) {
  if constexpr (requires { brake.residual(); }) return brake.residual();
  else if constexpr (requires { brake.residual; }) return brake.residual;
  else return {};
}

/// Elastic turn of a brake's axis for each N m of friction [rad/(N m)]; 0 where its model names no
/// compliance.
template <class B>
typename B::scalar compliance_of(const B& brake) {
  if constexpr (requires { brake.compliance(); }) return brake.compliance();
  else if constexpr (requires { brake.compliance; }) return brake.compliance;
  else return {};
}

/// A command [N m] as a brake takes it: 0 where it is negative or NaN, never more than `limit`.
template <class T>
constexpr T valid_command(T command, T limit) {
  if (!(command > T(0))) return T(0);
  return command < limit ? command : limit;
}

/// A time step [s] as a brake takes it: 0 where it is negative, NaN or infinite.
template <class T>
constexpr T valid_time_step(T dt) {
  return dt > T(0) && dt < std::numeric_limits<T>::infinity() ? dt : T(0);
}

/// A rate [rad/s] as a brake takes it: 0 where it is NaN, an infinite one the greatest of its sign.
template <class T>
constexpr T valid_rate(T rate) {
  constexpr T greatest = std::numeric_limits<T>::max();
  if (!(rate == rate)) return T(0);
  return rate < -greatest ? -greatest : rate > greatest ? greatest : rate;
}

}  // namespace passive_haptics
