/// @file
/// A mechanism, its brakes, a scene and a law, ready to be called once a cycle.
#pragma once

#include <passive_haptics/control/step.hpp>
#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/scene/scene.hpp>

#include <type_traits>
#include <utility>

namespace passive_haptics {
namespace detail {
// A law whose parameters can be checked, passed on once they are.
template <class L>
L&& require_valid_law(L&& law) {
  if constexpr (requires { validate(law); }) require_no_error(validate(law));
  else if constexpr (requires { validate(law.parameters); }) require_no_error(validate(law.parameters));
  return std::forward<L>(law);
}
// Brakes that have been checked.
template <class B>
const B& require_valid_brakes(const B& brakes) {
  if constexpr (requires { validate(brakes); }) return require_valid(brakes);
  require_no_error(check_brakes(brakes));
  return brakes;
}
}  // namespace detail

/// Owns all that a control loop needs but the state, which comes in each cycle.
///
/// S: a static_scene<...>, held_scene<...>, world<...> or latest_scene<...>, or any type with a contacts_type
/// for which sense(s, x) or sense(s, x, time) gives such contacts. Where there is a scene_status(s), a cycle
/// ends with it unless it is ok. B: brakes_of<M>, or any type with some of its members
/// (brake/brake_concepts.hpp): what it lacks costs nothing.
template <class M, class S, class L, class B = brakes_of<M>>
class controller {
  static_assert(mechanism_requirements<M>::met);
  static_assert(detail::scene_requirements<S, M>::met);
  static_assert(detail::law_brake_requirements<M, L, B>::met);

 public:
  using mechanism_type = M;                                           ///< The mechanism.
  using options_type = step_options<typename M::scalar>;              ///< Options of a step.
  using result_type = step_result_for<M, typename S::contacts_type>;  ///< What a cycle decides.

  /// Throws std::invalid_argument with the text of validate(brakes) or check_brakes(brakes), or of
  /// validate(law) or validate(law.parameters) where there is one.
  controller(M mechanism, const B& brakes, S scene, L law = {}, const options_type& options = options_type())
      : mechanism_(std::move(mechanism)),
        brakes_(detail::require_valid_brakes(brakes)),
        scene_(std::move(scene)),
        law_(detail::require_valid_law(std::move(law))),
        options_(options),
        brake_jacobian_(mechanism_),
        parameters_(check_parameters<L>(brakes_, options_)) {}

  /// One control cycle; see step(). A state that is not finite is not shown to the scene, nor is a position
  /// that a scene could remember.
  template <class State>
  PASSIVE_HAPTICS_FLATTEN result_type operator()(const State& state) noexcept {
    return run<result_type>(state);
  }

  /// The same cycle for a loop that only drives its brakes: what its account would cost is not computed.
  template <class State>
  PASSIVE_HAPTICS_FLATTEN brake_command<M> command(const State& state) noexcept {
    return run<brake_command<M>>(state);
  }

  /// Forgets the motion so far.
  void reset() { memory_ = {}; }

  /// The scene, for example to move a wall of it before a cycle.
  S& scene() { return scene_; }
  /// The mechanism.
  const M& mechanism() const { return mechanism_; }
  /// The brakes.
  const B& brakes() const { return brakes_; }

 private:
  template <class Answer, class State>
  Answer run(const State& state) noexcept {
    static_assert(detail::step_requirements<M, typename S::contacts_type, L, State, B>::met);
    const cycle_parts<M, B, L> with{mechanism_, brakes_, law_, brake_jacobian_, options_};
    return run_cycle<Answer>(with, parameters_, scene_, state, memory_);
  }

  M mechanism_;
  [[no_unique_address]] B brakes_;
  S scene_;
  L law_;
  options_type options_;
  brake_jacobian_evaluator<M> brake_jacobian_;
  status parameters_;  // of brakes_ and options_, which do not change
  step_memory<L> memory_;
};

}  // namespace passive_haptics
