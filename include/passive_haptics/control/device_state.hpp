/// Measured state of a device, the input of a control cycle.
#pragma once

#include <passive_haptics/mechanism/mechanism.hpp>

#include <concepts>
#include <limits>
#include <type_traits>

namespace passive_haptics {

/// State of a device with a force sensor at the handle.
template <class M>
struct device_state {
  static_assert(is_mechanism<M, explain>());
  /// [s], any origin, of a monotonic clock. NaN until it is set, which a cycle rejects.
  double time = std::numeric_limits<double>::quiet_NaN();
  joint_vector<M> q = joint_vector<M>::Zero();         ///< Joint positions [rad or m].
  joint_vector<M> qd = joint_vector<M>::Zero();        ///< Joint rates [rad/s or m/s].
  task_vector<M> hand_force = task_vector<M>::Zero();  ///< Force of the hand on the handle [N], base frame.
};

/// State of a device without a force sensor. The direction of a push on a brake at rest is then unknown.
template <class M>
struct sensorless_device_state {
  static_assert(is_mechanism<M, explain>());
  /// [s], any origin, of a monotonic clock. NaN until it is set, which a cycle rejects.
  double time = std::numeric_limits<double>::quiet_NaN();
  joint_vector<M> q = joint_vector<M>::Zero();   ///< Joint positions [rad or m].
  joint_vector<M> qd = joint_vector<M>::Zero();  ///< Joint rates [rad/s or m/s].
};

namespace detail {
// Floating-point seconds, not integer milliseconds or nanoseconds.
template <class S>
concept has_time_in_seconds =
    requires(const S state) { requires std::floating_point<std::remove_cvref_t<decltype(state.time)>>; };
template <class S, class M>
concept has_motion = requires(const S state) {
  { state.q } -> ExactVector<typename M::scalar, M::dof>;
  { state.qd } -> ExactVector<typename M::scalar, M::dof>;
};
}  // namespace detail

/// Requirements of DeviceState, with one message each: `static_assert(is_device_state<S, M, explain>())`.
template <class S, class M, bool Explain = false>
consteval bool is_device_state() {
  if constexpr (!Mechanism<M>) return is_mechanism<M, Explain>();
  else if constexpr (!detail::has_time_in_seconds<S>)
    static_assert(!Explain,
                  "passive_haptics: the state needs a member time, in seconds and of a floating-point type "
                  "(device_state<M> has it).");
  else if constexpr (!detail::has_motion<S, M>)
    static_assert(!Explain,
                  "passive_haptics: the state needs members q and qd, each a vector<scalar, dof> exactly "
                  "(device_state<M> has them).");
  else return true;
  return Explain;
}

/// A state of mechanism M: any type with a floating-point time [s], and q and qd of exactly these types.
template <class S, class M>
concept DeviceState = is_device_state<S, M>();

/// A state with a hand force.
template <class S, class M>
concept HandForceState = DeviceState<S, M> && requires(const S state) {
  { state.hand_force } -> ExactVector<typename M::scalar, M::task_dimension>;
};

/// A state with torques th on brakes at rest [N m], from torques_at_rest or sensors. Otherwise th = E^T Fh.
template <class S, class M>
concept HandTorqueState = DeviceState<S, M> && requires(const S state) {
  { state.hand_torque } -> ExactVector<typename M::scalar, M::brake_count>;
};

}  // namespace passive_haptics
