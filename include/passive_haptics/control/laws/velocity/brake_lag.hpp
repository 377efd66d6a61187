/// Model of the first-order brake lag, and its inversion over a short horizon.
#pragma once

#include <passive_haptics/brake/torque_interval.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/core/scalar/first_order_lag.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

namespace passive_haptics {

/// Torques of brakes with time constants T_b from their commands, T_b dtau/dt + tau = u. In double and for up
/// to max_brakes, so that the memory of a law does not depend on the mechanism.
class brake_lag_model {
 public:
  static constexpr std::size_t max_brakes = 12;  ///< Maximum number of brakes.

  /// Advances the torques [N m] to `time` [s]; a decreasing time changes nothing.
  template <class T, int Brakes>
  void advance(double time, const vector<T, Brakes>& time_constant) {
    static_assert(Brakes <= static_cast<int>(max_brakes),
                  "passive_haptics: brake_lag_model is for at most 12 brakes.");
    const double dt = time < time_ ? 0.0 : time - time_;
    time_ = time;
    unrolled<Brakes>([&](auto i) {
      const auto k = static_cast<std::size_t>(i);
      torque_[k] = lagged(torque_[k], command_[k], dt, static_cast<double>(time_constant[i]));
    });
  }

  /// Stores and returns the command [N m] for which the brake reaches `wanted` >= 0 after a horizon [s] with
  /// share = lag_share(horizon, T_b): u = tau + (wanted - tau) / share, in [0, limit].
  template <class T>
  T command(int brake, T wanted, T limit, T share = T(1)) {
    const auto k = static_cast<std::size_t>(brake);
    double u = static_cast<double>(wanted);
    if (share < T(1)) u = torque_[k] + (u - torque_[k]) / static_cast<double>(share);
    command_[k] = std::clamp(u, 0.0, static_cast<double>(limit));
    return static_cast<T>(command_[k]);
  }

  /// Torque of a brake [N m] at the last advance().
  double torque(int brake) const { return nth(torque_, brake); }

  void release() { command_.fill(0); }  ///< Releases all brakes from the last advance() on.

 private:
  std::array<double, max_brakes> torque_{}, command_{};
  double time_ = -std::numeric_limits<double>::infinity();
};

/// Share of the step to a command within a horizon [s], for each brake.
template <class B>
auto lag_shares(const B& brakes, double horizon) {
  using T = typename std::remove_cvref_t<decltype(brakes.time_constant)>::Scalar;
  auto share = brakes.time_constant;
  for (T& lag : share) lag = horizon > 0 ? lag_share(static_cast<T>(horizon), lag) : T(1);
  return share;
}

/// Torques [N m] to command so that brakes have magnitudes t after a horizon, each against its sign.
template <class Device, class T, int Brakes>
vector<T, Brakes> torques_to_command(const Device& device, vector<T, Brakes> t,
                                     const vector<T, Brakes>& lag_share, brake_lag_model& model) {
  unrolled<Brakes>([&](auto i) {
    const T limit = passive_haptics::torque_bound_of<T>(device.brakes, i, device.s[i] > T(0) ? T(-1) : T(1));
    const T u = model.command(i, t[i], limit, lag_share[i]);
    t[i] = device.s[i] > T(0) ? -u : u;
  });
  return t;
}

}  // namespace passive_haptics
