/// @file
/// The pipelines of section 4: the one of a cycle, chosen by its law and walls, and the header that defines
/// it.
#pragma once

#include <passive_haptics/control/control_law.hpp>

#include <type_traits>

namespace passive_haptics {

/// Section 4 as the paper has it, for one wall: control/pipelines/one_wall.hpp.
template <class Result, class Setup, class Walls>
struct one_wall;
/// For several walls at once: control/pipelines/several_walls.hpp.
template <class Result, class Setup, class Walls>
struct several_walls;
/// A TorqueLaw commands the brakes: control/pipelines/torque_law.hpp.
template <class Result, class Setup, class Walls>
struct torques_of_law;
/// Effects beside walls: control/pipelines/beside_effects.hpp.
template <class Result, class Setup, class Walls>
struct beside_effects;

/// Walls with effects beside them (with_effects).
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

/// The pipeline of a cycle. Result: what it returns; Setup: a cycle_setup; Walls: what is touched. The list
/// is closed: a law, a scene, an effect, a mechanism or brakes of a user's own go through one of these.
///
/// Each is a struct that has all steps of section 4:
///   - `pipeline{setup, touched}`: the walls, of which each demands an Fd;
///   - `bool demands_force() const`: false where the brakes are released;
///   - `steps command(now, memory) const`: from Fd to td, where `steps.td.torque` is what the brakes get;
///   - `Result result(now, steps, t, memory) const`: the result, with t the torques that the mechanism will
///     feel.
template <class Result, class Setup, class Walls>
using pipeline_of = typename decltype(detail::chosen_pipeline<Result, Setup, Walls>())::type;

}  // namespace passive_haptics
