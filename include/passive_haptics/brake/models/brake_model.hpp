/// The BrakeModel concept: the response of one physical brake to a command.
#pragma once

#include <passive_haptics/core/explain.hpp>
#include <passive_haptics/core/parameters.hpp>

#include <concepts>
#include <limits>

namespace passive_haptics {

/// Resistance of a brake: the torque -strength sgn(w) - drag w at rate w, any within +-strength at rest.
template <class T>
struct brake_resistance {
  T strength = T(0);  ///< Coulomb friction [N m].
  T drag = T(0);      ///< Viscous drag [N m s].

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

/// Requirements of BrakeModel, with one message each: `static_assert(is_brake_model<B, explain>())`.
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

/// One brake on its own axis; for a sliding brake, read N and m/s. Minimal complete definition:
///   - `using scalar`: float or double;
///   - `struct state`, copyable: the memory of the brake. A default-constructed state is that of a brake
///     released long ago;
///   - `brake_resistance<scalar> advance(scalar dt, scalar command, scalar rate, state&) const noexcept`:
///     advances the state by dt [s] and returns the commanded resistance at its end. command: capacity [N m]
///     from a controller; rate [rad/s]: at the beginning of dt;
///   - `scalar torque_limit_at(scalar rate) const noexcept`: maximum commanded torque [N m] at this rate. A
///     controller may use nothing else of the model.
///
/// Laws, for any command, rate and history (testing/support/brake_model_laws.hpp):
///   - passive: strength and drag are finite and >= 0;
///   - bounded: strength + drag |rate| <= torque_limit_at(rate);
///   - a negative or NaN command counts as 0, an infinite one as the maximum (valid_command);
///   - a negative, NaN or infinite time step counts as 0 (valid_time_step);
///   - a NaN rate counts as 0, an infinite one as the maximum of its sign (valid_rate).
///
/// Optional:
///   - `brake_resistance<scalar> residual`, a member or a function: added to the commanded resistance;
///   - `scalar compliance` [rad/(N m)], a member or a function, constant and >= 0: elastic rotation of the
///     axis per N m of friction before the brake slips;
///   - members(), a table as in core/parameters.hpp, for checks of the parameters.
///
/// Refinement: InvertibleBrakeModel.
template <class B>
concept BrakeModel = is_brake_model<B>();

/// A brake model with an inverse. Minimal complete definition: BrakeModel, and
///   - `scalar command_for(scalar torque, scalar rate, const state&) const noexcept`: command [N m] for which
///     the brake, at this rate and with this history, settles at `torque` [N m] or as near as possible.
template <class B>
concept InvertibleBrakeModel =
    BrakeModel<B> && requires(const B brake, typename B::scalar x, const typename B::state state) {
      { brake.command_for(x, x, state) } noexcept -> std::same_as<typename B::scalar>;
    };

/// Resistance without a command; zero if the model has no residual.
template <class B>
brake_resistance<typename B::scalar> residual_of(const B& brake) {
  if constexpr (requires { brake.residual(); }) return brake.residual();
  else if constexpr (requires { brake.residual; }) return brake.residual;
  else return {};
}

/// Elastic rotation of a brake's axis per N m of friction [rad/(N m)]; 0 if the model has no compliance.
template <class B>
typename B::scalar compliance_of(const B& brake) {
  if constexpr (requires { brake.compliance(); }) return brake.compliance();
  else if constexpr (requires { brake.compliance; }) return brake.compliance;
  else return {};
}

/// A command [N m] limited to [0, limit]; 0 for NaN.
template <class T>
constexpr T valid_command(T command, T limit) {
  if (!(command > T(0))) return T(0);
  return command < limit ? command : limit;
}

/// A time step [s]; 0 if it is negative, NaN or infinite.
template <class T>
constexpr T valid_time_step(T dt) {
  return dt > T(0) && dt < std::numeric_limits<T>::infinity() ? dt : T(0);
}

/// A rate [rad/s] limited to finite values; 0 for NaN.
template <class T>
constexpr T valid_rate(T rate) {
  constexpr T greatest = std::numeric_limits<T>::max();
  if (!(rate == rate)) return T(0);
  return rate < -greatest ? -greatest : rate > greatest ? greatest : rate;
}

}  // namespace passive_haptics
