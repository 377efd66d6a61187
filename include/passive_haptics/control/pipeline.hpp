/// Selection of the pipeline of section 4 for a cycle, by its law and walls.
#pragma once

#include <passive_haptics/control/control_law.hpp>

#include <type_traits>

namespace passive_haptics {

/// One wall, as in the paper: control/pipelines/one_wall.hpp.
template <class Result, class Setup, class Walls>
struct one_wall;
/// Several walls: control/pipelines/several_walls.hpp.
template <class Result, class Setup, class Walls>
struct several_walls;
/// A TorqueLaw: control/pipelines/torque_law.hpp.
template <class Result, class Setup, class Walls>
struct torques_of_law;
/// Effects in addition to walls: control/pipelines/beside_effects.hpp.
template <class Result, class Setup, class Walls>
struct beside_effects;

/// Walls with effects (with_effects).
template <class Walls>
concept HasEffects = requires { requires Walls::has_effects; };

namespace detail {
template <class Result, class Setup, class Walls>
auto chosen_pipeline() {
  if constexpr (HasEffects<Walls>) return std::type_identity<beside_effects<Result, Setup, Walls>>();
  else if constexpr (TorqueLaw<typename Setup::law_type>)
    return std::type_identity<torques_of_law<Result, Setup, Walls>>();
  else if constexpr (Walls::capacity > 1) return std::type_identity<several_walls<Result, Setup, Walls>>();
  else return std::type_identity<one_wall<Result, Setup, Walls>>();
}
}  // namespace detail

/// The pipeline of a cycle. Result: its return type; Setup: a cycle_setup; Walls: the contacts. The list is
/// closed: custom laws, scenes, effects, mechanisms and brakes use one of these.
///
/// Each is a struct with all steps of section 4:
///   - `pipeline{setup, touched}`: the walls, each with a demand Fd;
///   - `bool demands_force() const`: if false, the brakes are released;
///   - `steps command(now, memory) const`: from Fd to td; `steps.td.torque` is the brake command;
///   - `Result result(now, steps, t, memory) const`: the result, with the predicted torques t on the
///     mechanism.
template <class Result, class Setup, class Walls>
using pipeline_of = typename decltype(detail::chosen_pipeline<Result, Setup, Walls>())::type;

}  // namespace passive_haptics
