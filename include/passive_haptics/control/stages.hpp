/// @file
/// The stages of a control cycle that depend on the device and the law; cycle.hpp chains them.
#pragma once

#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/control/device_state.hpp>
#include <passive_haptics/control/step_options.hpp>
#include <passive_haptics/force/approximation.hpp>
#include <passive_haptics/force/desired_force.hpp>

#include <type_traits>

namespace passive_haptics {

/// What a cycle works with, all but the scene, the state and the memory. A controller owns it, step() is
/// given it.
template <class M, class B, class L>
struct cycle_parts {
  const M& mechanism;                                 ///< The mechanism.
  const B& brakes;                                    ///< Its brakes.
  const L& law;                                       ///< The control law.
  const brake_jacobian_evaluator<M>& brake_jacobian;  ///< Of the mechanism.
  const step_options<typename M::scalar>& options;    ///< Options.
};

/// The walls touched at x [m]: of a scene, or given as they are.
template <class S, int D>
decltype(auto) walls_at(S& scene, const point<D>& x, double time) {
  if constexpr (requires { sense(scene, x, time); }) return sense(scene, x, time);
  else if constexpr (requires { sense(scene, x); }) return sense(scene, x);
  else return (scene);
}

namespace detail {
template <class S>
struct contacts_given : std::type_identity<S> {};
template <class S>
  requires requires { typename S::contacts_type; }
struct contacts_given<S> : std::type_identity<typename S::contacts_type> {};
}  // namespace detail

/// The contacts that a scene gives; contacts give themselves.
template <class S>
using contacts_of = typename detail::contacts_given<S>::type;

/// Fh [N]; zero where the state has none.
template <class M, class State>
task_vector<M> hand_force(const State& state) {
  if constexpr (HandForceState<State, M>) return state.hand_force;
  else return task_vector<M>::Zero();
}

/// The hand's torque on the brakes' axes, E^T Fh [N m]; zero where nobody measures the hand, or no brake is
/// ever at rest.
template <class M, class B, class State, class EMatrix>
brake_vector<M> hand_torque(const State& state, const EMatrix& E) {
  if constexpr (HandForceState<State, M> && StickingBrakes<B, typename M::scalar, M::brake_count>)
    return brake_torque(E, state.hand_force);
  else return brake_vector<M>::Zero();
}

/// Fd: what the wall asks for; no force in free space.
template <class M, class B, class L, class Walls>
  requires(Walls::capacity <= 1)
auto desired(const cycle_parts<M, B, L>&, const Walls& touched) {
  using T = typename M::scalar;
  constexpr int d = M::task_dimension;
  if (touched.empty()) return desired_force<T, d>{vector<T, d>::Zero(), T(0), vector<T, d>::Zero()};
  return force_of<T>(touched[0]);
}

/// Fc (step 1 of section 4): Fd itself, or the nearest force that the brakes can make with Fc . n = |Fd|.
template <class M, class B, ScalingLaw L, class Now, class T, int D>
  requires(!displays_by_generators<M>)
auto displayed(const cycle_parts<M, B, L>& with, const Now& now, const desired_force<T, D>& Fd,
               const auto& /*touched*/, step_memory<L>& memory) {
  return Fd.magnitude * approximate(now.E, now.s, Fd.direction, with.options.min_cosine, memory.start);
}

/// alpha (step 2); 1 where there is nothing to scale, unless the law is asked_always.
template <class M, class B, ScalingLaw L, class Now, class T, int D, int Brakes>
T scale(const cycle_parts<M, B, L>& with, const Now& now, const desired_force<T, D>& Fd,
        const approximated_force<T, D, Brakes>& Fc) {
  if (!asked_always<L> && !is_displayed(Fc.display)) return T(1);
  const T leaving = outward(Fd, now.v);
  return with.law.scale(contact_situation<T, D>{Fd.direction, Fd.magnitude, leaving, now.hand_force});
}

/// Torques within the brakes' limits, by the policy of the options.
template <class M, class B, ScalingLaw L, class T, int Brakes>
saturated_torque<T, Brakes> limited(const cycle_parts<M, B, L>& with, const vector<T, Brakes>& t) {
  if constexpr (LimitedBrakes<B, T, Brakes>)
    return saturate(t, with.brakes.torque_limit, with.options.limits);
  else return {t, false};
}

/// td: what the brakes are told (step 4), the torques of Fc_scaled = alpha Fc within their limits; or alpha
/// times the torques of Fc within their limits, where the law says so.
template <class M, class B, class L, class Scale, class Force, class ScaledForce>
auto commanded(const cycle_parts<M, B, L>& with, const Scale& alpha, const Force& Fc,
               const ScaledForce& Fc_scaled) {
  if constexpr (saturates_before_scaling<L>) {
    static_assert(std::is_same_v<Scale, typename M::scalar>,
                  "passive_haptics: a law that saturates before scaling knows one wall at a time; give this "
                  "scene a law without saturates_before_scaling (control/control_law.hpp).");
    return alpha * limited(with, Fc.torque);
  } else {
    return limited(with, Fc_scaled.torque);
  }
}

/// The torques as the walls want them: no effects stand beside these walls. control/effects/ has those that
/// do.
template <class Parts, class Now, class Walls, class Torques>
Torques add_effects(const Parts&, const Now&, const Walls&, const Torques& td) {
  return td;
}

}  // namespace passive_haptics
