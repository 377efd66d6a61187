/// Concepts of brakes: optional limits, intervals, dead bands and lags.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/mechanism/mechanism.hpp>

#include <concepts>
#include <limits>
#include <string>
#include <type_traits>

namespace passive_haptics {
namespace detail {

template <class B>
concept names_torque_limit = requires(const B brakes) { brakes.torque_limit; };
// Explicit, so that a misspelled torque_limit is an error
template <class B>
concept is_unlimited = !names_torque_limit<B> && requires { requires B::unlimited; };
template <class B>
concept names_torque_lower = requires(const B brakes) { brakes.torque_lower; };
template <class B>
concept names_torque_upper = requires(const B brakes) { brakes.torque_upper; };
template <class B>
concept names_torque_interval = names_torque_lower<B> || names_torque_upper<B>;
template <class B>
concept names_rate_dead_band = requires(const B brakes) { brakes.rate_dead_band; };
template <class B>
concept names_torque_dead_band = requires(const B brakes) { brakes.torque_dead_band; };
template <class B>
concept names_time_constant = requires(const B brakes) { brakes.time_constant; };

}  // namespace detail

/// Brakes with `vector<T, m> torque_limit` [N m], >= 0. Others need `static constexpr bool unlimited = true`.
template <class B, class T, int Brakes>
concept LimitedBrakes = requires(const B brakes) {
  { brakes.torque_limit } -> ExactVector<T, Brakes>;
};

/// Brakes that may be off or one-way (a released clutch, a one-way clutch, a slack tendon): `vector<T, m>
/// torque_lower, torque_upper` [N m], torque_lower <= 0 <= torque_upper, infinite if unbounded. Brake i can
/// produce torques between them, signed on its own axis, and within +-torque_limit; it is off if both are 0.
template <class B, class T, int Brakes>
concept SwitchableBrakes = requires(const B brakes) {
  { brakes.torque_lower } -> ExactVector<T, Brakes>;
  { brakes.torque_upper } -> ExactVector<T, Brakes>;
};

/// Brakes that can be at rest: `vector<T, m> rate_dead_band` [rad/s], >= 0. Others always slip: s = sgn(w).
template <class B, class T, int Brakes>
concept StickingBrakes = requires(const B brakes) {
  { brakes.rate_dead_band } -> ExactVector<T, Brakes>;
};

/// Brakes at rest that ignore small torques: `vector<T, m> torque_dead_band` [N m], >= 0. Default: none.
template <class B, class T, int Brakes>
concept TorqueDeadBandBrakes = StickingBrakes<B, T, Brakes> && requires(const B brakes) {
  { brakes.torque_dead_band } -> ExactVector<T, Brakes>;
};

/// Brakes with a known lag: `vector<T, m> time_constant` [s], >= 0. For laws that need it.
template <class B, class T, int Brakes>
concept LaggingBrakes = requires(const B brakes) {
  { brakes.time_constant } -> ExactVector<T, Brakes>;
};

/// Requirements of BrakesFor, with one message each: `static_assert(are_brakes<B, M, explain>())`.
template <class B, class M, bool Explain = false>
consteval bool are_brakes() {
  if constexpr (!Mechanism<M>) return is_mechanism<M, Explain>();
  else if constexpr (!std::is_class_v<B>)
    static_assert(
        !Explain,
        "passive_haptics: the brakes must be a brake_parameters, unlimited_brakes, or a class with some of "
        "the members torque_limit, torque_lower, torque_upper, rate_dead_band, torque_dead_band and "
        "time_constant.");
  else if constexpr (!detail::names_torque_limit<B> && !detail::is_unlimited<B>)
    static_assert(
        !Explain,
        "passive_haptics: the brakes need a torque_limit, or static constexpr bool unlimited = true.");
  else if constexpr (detail::names_torque_limit<B> && !LimitedBrakes<B, typename M::scalar, M::brake_count>)
    static_assert(
        !Explain,
        "passive_haptics: torque_limit of the brakes must be a vector<scalar, brake_count> exactly.");
  else if constexpr (detail::names_torque_interval<B> &&
                     !SwitchableBrakes<B, typename M::scalar, M::brake_count>)
    static_assert(
        !Explain,
        "passive_haptics: torque_lower and torque_upper of the brakes must both be a vector<scalar, "
        "brake_count> exactly.");
  else if constexpr (detail::names_rate_dead_band<B> &&
                     !StickingBrakes<B, typename M::scalar, M::brake_count>)
    static_assert(
        !Explain,
        "passive_haptics: rate_dead_band of the brakes must be a vector<scalar, brake_count> exactly.");
  else if constexpr (detail::names_torque_dead_band<B> &&
                     !TorqueDeadBandBrakes<B, typename M::scalar, M::brake_count>)
    static_assert(!Explain,
                  "passive_haptics: torque_dead_band of the brakes must be a vector<scalar, brake_count> "
                  "exactly, in addition to a rate_dead_band: it is for brakes at rest.");
  else if constexpr (detail::names_time_constant<B> && !LaggingBrakes<B, typename M::scalar, M::brake_count>)
    static_assert(
        !Explain,
        "passive_haptics: time_constant of the brakes must be a vector<scalar, brake_count> exactly.");
  else return true;
  return Explain;
}

/// Brakes for a control cycle of mechanism M with m brakes: a class with any of the members torque_limit,
/// torque_lower and torque_upper, rate_dead_band, torque_dead_band and time_constant, of exactly these types.
/// Missing members cost nothing. switchable_brakes has all, brake_parameters all except the interval,
/// unlimited_brake_parameters the dead bands, unlimited_brakes none.
template <class B, class M>
concept BrakesFor = are_brakes<B, M>();

/// Brakes without limits or dead bands, with the fewest instructions. For a device with walls that never
/// demand more than its brakes can produce (soft walls, or a driver that limits the current), and with rates
/// that are exactly 0 at rest (encoders). A brake at rest has sign 0, so it may hold either way.
struct unlimited_brakes {
  static constexpr bool unlimited = true;  ///< Explicitly without a torque_limit.
};

/// Always empty.
inline error_message validate(const unlimited_brakes&) { return {}; }

/// Maximum torque of brake i [N m]; infinite without a limit.
template <class T, class B>
T torque_limit_of(const B& brakes, int i) {
  if constexpr (detail::names_torque_limit<B>) return brakes.torque_limit[i];
  else return std::numeric_limits<T>::infinity();
}

/// Maximum torques of all brakes (m) [N m]; infinite without a limit.
template <class T, int Brakes, class B>
vector<T, Brakes> torque_limits_of(const B& brakes) {
  if constexpr (detail::names_torque_limit<B>) return brakes.torque_limit;
  else return vector<T, Brakes>::Constant(std::numeric_limits<T>::infinity());
}

/// Rate below which brake i is at rest [rad/s]; 0 without a dead band.
template <class T, class B>
T rate_dead_band_of(const B& brakes, int i) {
  if constexpr (detail::names_rate_dead_band<B>) return brakes.rate_dead_band[i];
  else return T(0);
}

/// Hand torques that are ignored (m) [N m]; 0 without a dead band.
template <class T, int Brakes, class B>
vector<T, Brakes> torque_dead_bands_of(const B& brakes) {
  if constexpr (detail::names_torque_dead_band<B>) return brakes.torque_dead_band;
  else return vector<T, Brakes>::Zero();
}

/// Valid torque_lower.
inline constexpr range lower_torques =
    range::between(-range::infinity, 0).as("a number <= 0, or -inf for no bound");
/// Valid torque_upper.
inline constexpr range upper_torques =
    range::between(0, range::infinity).as("a number >= 0, or inf for no bound");

/// Returns the first error of the members that the brakes have, or an empty one.
template <class B>
error_message check_brakes(const B& brakes) {
  [[maybe_unused]] constexpr range size = range::not_negative;
  error_message limit, lower, upper, rate, torque, lag;
  if constexpr (detail::names_torque_limit<B>)
    limit = check_value("torque_limit", brakes.torque_limit, "N m", size);
  if constexpr (detail::names_torque_interval<B>) {
    lower = check_value("torque_lower", brakes.torque_lower, "N m", lower_torques);
    upper = check_value("torque_upper", brakes.torque_upper, "N m", upper_torques);
  }
  if constexpr (detail::names_rate_dead_band<B>)
    rate = check_value("rate_dead_band", brakes.rate_dead_band, "rad/s", size);
  if constexpr (detail::names_torque_dead_band<B>)
    torque = check_value("torque_dead_band", brakes.torque_dead_band, "N m", size);
  if constexpr (detail::names_time_constant<B>)
    lag = check_value("time_constant", brakes.time_constant, "s", size);
  return detail::first_error(limit, lower, upper, rate, torque, lag);
}

}  // namespace passive_haptics
