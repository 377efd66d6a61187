/// The control cycle. Section 4 is in control/pipelines/; control/pipelines/one_wall.hpp is the paper's.
#pragma once

#include <passive_haptics/brake/passive_constraint.hpp>
#include <passive_haptics/brake/torque_interval.hpp>
#include <passive_haptics/control/cycle_result.hpp>
#include <passive_haptics/control/pipelines/one_wall.hpp>
#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/control/pipelines/torque_law.hpp>
#include <passive_haptics/core/flatten.hpp>

#include <type_traits>

namespace passive_haptics {

/// The brakes at rates w [rad/s or m/s], with their current limits for rate_limited_brakes.
template <class B, class Rates>
decltype(auto) brakes_at(const B& brakes, const Rates& w) {
  if constexpr (requires { brakes.at(w); }) return brakes.at(w);
  else return (brakes);
}

/// Displays the touched walls. x: end effector [m]. Only members of Result are computed.
template <class Result, class Setup, class Pose, class State, int D, class Walls, class Memory>
PASSIVE_HAPTICS_PART Result display_walls(const Setup& setup, const Pose& pose, const State& state,
                                          const point<D>& x, const Walls& touched, Memory& memory) {
  namespace ph = passive_haptics;  // No function of a user's namespace is meant
  using M = typename Setup::mechanism_type;

  // Demand of the walls
  const pipeline_of<Result, Setup, Walls> pipeline{setup, touched};
  if (!pipeline.demands_force())
    return ph::released<Result>(setup, state.time, ph::status_without_force<M>(x, touched), memory);

  // Abilities of the brakes: v = E w, t = E^T F, and the signs
  const auto E = setup.brake_jacobian(pose);
  const brake_vector<M> w = pose.brake_rates(state.qd);
  const auto& brakes = ph::brakes_at(setup.brakes, w);
  const task_vector<M> v = ph::velocity_of(pose, E, w, state.qd), Fh = ph::hand_force<M>(state);
  const brake_vector<M> th = ph::hand_torque<M>(state, E, brakes);
  const brake_vector<M> turning = ph::brake_signs(w, th, brakes);
  const auto& s = ph::signs_within(turning, brakes);
  const brake_situation<M, decltype(E), std::remove_cvref_t<decltype(brakes)>> device{
      setup.mechanism, pose, brakes, state.time, state.q, state.qd, x, E, w, v, s, Fh, th, setup.options};

  // Section 4, and the resulting torques on the mechanism
  const auto steps = pipeline.command(device, memory);
  const brake_vector<M> t =
      ph::passive_torque(form_of<M>::resisting(steps.td.torque, turning, brakes), w, th, turning, brakes);
  return pipeline.result(device, steps, t, memory);
}

/// One control cycle: pose, contacts, commands. scene: that of a controller, or the touched walls.
template <class Result, class Setup, class S, class State, class Memory>
PASSIVE_HAPTICS_PART Result cycle(const Setup& setup, S& scene, const State& state, Memory& memory) {
  namespace ph = passive_haptics;
  using M = typename Setup::mechanism_type;
  const mechanism_pose<M> pose(setup.mechanism, state.q);
  const auto x = as<double>(pose.position());
  if (!ph::is_usable_position<M>(scene, x))
    return ph::released<Result>(setup, state.time, status::pose_undefined, memory);

  ph::see_ahead(scene, setup.law, setup.brakes);
  const auto& touched = ph::walls_at(scene, x, state.time);
  if (const status s = ph::status_of(scene); s != status::ok)
    return ph::released<Result>(setup, state.time, s, memory);
  if constexpr (ScalingLaw<typename Setup::law_type> && std::remove_cvref_t<decltype(touched)>::capacity > 1)
    if (touched.size() == 1)
      return ph::display_walls<Result>(setup, pose, state, x, as_single(touched), memory);
  return ph::display_walls<Result>(setup, pose, state, x, touched, memory);
}

/// Checks the state, then runs the cycle. parameters: from check_parameters.
template <class Result, class Setup, class S, class State, class Memory>
PASSIVE_HAPTICS_PART Result run_cycle(const Setup& setup, status parameters, S& scene, const State& state,
                                      Memory& memory) {
  namespace ph = passive_haptics;
  status given = ph::check_state<typename Setup::mechanism_type>(state);
  if (given == status::ok) given = ph::check_time(state.time, memory);
  if (given == status::ok) given = parameters;
  return given == status::ok ? ph::cycle<Result>(setup, scene, state, memory)
                             : ph::released<Result>(setup, state.time, given, memory);
}

}  // namespace passive_haptics
