/// Exact torques on brakes at rest, for mechanisms with known inertia.
#pragma once

#include <passive_haptics/brake/at_rest/hand_torque_at_rest.hpp>
#include <passive_haptics/control/device_state.hpp>
#include <passive_haptics/control/laws/velocity/brake_lag.hpp>
#include <passive_haptics/core/finite.hpp>

#include <utility>

namespace passive_haptics {

/// A device_state with known torques on brakes at rest.
template <class M>
struct device_state_at_rest : device_state<M> {
  /// Torque of the hand, gravity and other brakes on each brake at rest [N m or N]; else unused.
  brake_vector<M> hand_torque = brake_vector<M>::Zero();
};

/// Adds the exact torques on brakes at rest (exact_hand_torque) to the states of a control loop. A cycle uses
/// them instead of the static rule of the paper, th = E^T Fh:
///
///     ph::torques_at_rest rest(arm, brakes);
///     ...
///     const auto result = control(rest.update(state, capacity));
///     capacity = result.capacity;
///
/// Does not throw or allocate. Returns 0 if the state, the capacities or the pose is not finite. Cost: about
/// 20 instructions per brake if none is at rest, else that of exact_hand_torque.
///
/// B: any brakes with a rate_dead_band; without a time_constant they have no lag.
template <class M, class B = brakes_of<M>>
class torques_at_rest {
  static_assert(are_brakes<B, M, explain>());
  static_assert(!Mechanism<M> || Dynamics<M>,
                "passive_haptics: torques_at_rest needs a mechanism that models Dynamics "
                "(mechanism/dynamics.hpp).");

 public:
  /// Throws std::invalid_argument if check_brakes(brakes) returns an error.
  torques_at_rest(M mechanism, const B& brakes) : mechanism_(std::move(mechanism)), brakes_(brakes) {
    require_no_error(passive_haptics::check_brakes(brakes));
  }

  /// Adds th to the current state. capacity: commanded since the previous state [N m]; 0 at first.
  device_state_at_rest<M> update(const device_state<M>& state, const brake_vector<M>& capacity) noexcept {
    device_state_at_rest<M> now{state};
    if (!all_finite(state.q, state.qd, state.hand_force, state.time, capacity)) return now;
    for (int i = 0; i < M::brake_count; ++i)
      (void)lag_.command(i, capacity[i], torque_limit_of<typename M::scalar>(brakes_, i));
    lag_.advance(state.time, time_constants());
    const mechanism_pose<M> pose(mechanism_, state.q);
    const brake_vector<M> w = pose.brake_rates(state.qd);
    if (!any_sticks(w, brakes_)) return now;
    brake_vector<M> strength;
    for (int i = 0; i < M::brake_count; ++i) strength[i] = static_cast<typename M::scalar>(lag_.torque(i));
    const brake_vector<M> th = passive_haptics::exact_hand_torque<M>(pose, brakes_, state, w, strength);
    if (all_finite(th)) now.hand_torque = th;
    return now;
  }

  void reset() { lag_ = {}; }  ///< Forgets the brake torques.

 private:
  brake_vector<M> time_constants() const {
    if constexpr (LaggingBrakes<B, typename M::scalar, M::brake_count>) return brakes_.time_constant;
    else return brake_vector<M>::Zero();
  }

  M mechanism_;
  B brakes_;
  brake_lag_model lag_;
};

}  // namespace passive_haptics
