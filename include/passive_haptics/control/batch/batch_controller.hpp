/// @file
/// A mechanism, its brakes, a scene and a law, ready to be called for many states at once.
#pragma once

#include <passive_haptics/control/batch/batch_results.hpp>
#include <passive_haptics/control/controller.hpp>

#include <cstddef>
#include <utility>

namespace passive_haptics {

/// The control cycle of N states, one after the other, for maps, sweeps and studies: what a controller
/// returns for each of them, called with a fresh memory and a scene that has not seen the handle before.
/// Threads may share the states by part_of().
template <class M, class S, class L, class B = brakes_of<M>>
class batch_controller {
  static_assert(detail::is_controller<M, B, S, L, explain>());

 public:
  using mechanism_type = M;                               ///< The mechanism.
  using options_type = step_options<typename M::scalar>;  ///< Options of a step.

  /// Throws std::invalid_argument as a controller does.
  batch_controller(M mechanism, const B& brakes, S scene, L law = {},
                   const options_type& options = options_type())
      : mechanism_(std::move(mechanism)),
        brakes_(detail::require_valid_brakes(brakes)),
        scene_(std::move(scene)),
        law_(detail::require_valid_law(std::move(law))),
        options_(options),
        brake_jacobian_(mechanism_),
        parameters_(passive_haptics::check_parameters(brakes_, law_, options_)) {}

  /// Stores the results of these states. May be called by several threads at once, with other results. Throws
  /// std::invalid_argument with the text of check_lengths(), or if the law needs a hand force and there is
  /// none. Allocates nothing unless a copy of the scene does.
  void operator()(const batch_states<M>& states, const batch_results<M>& results) const {
    require_no_error(check_lengths(states));
    require_no_error(check_lengths(results, states.size()));
    if constexpr (needs_hand_force<L>) require_no_error(check_hand_force(states));
    if (are_commands(results)) run<brake_command<M>>(states, results);
    else run<step_result_for<M, typename S::contacts_type>>(states, results);
  }

  /// The mechanism.
  const M& mechanism() const { return mechanism_; }
  /// The brakes.
  const B& brakes() const { return brakes_; }

 private:
  template <class Result>
  PASSIVE_HAPTICS_FLATTEN void run(const batch_states<M>& states, const batch_results<M>& results) const {
    S scene = scene_;
    for (std::size_t k = 0; k < states.size(); ++k) {
      step_memory<L> memory;
      if constexpr (requires { scene.reset(); }) scene.reset();
      detail::store(results, k,
                    passive_haptics::run_cycle<Result>(setup(), parameters_, scene, states[k], memory));
    }
  }

  cycle_setup<M, B, L> setup() const { return {mechanism_, brakes_, law_, brake_jacobian_, options_}; }

  M mechanism_;
  [[no_unique_address]] B brakes_;
  S scene_;
  L law_;
  options_type options_;
  brake_jacobian_evaluator<M> brake_jacobian_;
  status parameters_;  // of brakes_, law_ and options_
};

/// Of these types, in this order: others meet the message about the order.
template <class M, class B, class S, class L>
batch_controller(M, const B&, S, L) -> batch_controller<M, S, L, B>;
/// With options.
template <class M, class B, class S, class L>
batch_controller(M, const B&, S, L, const step_options<typename M::scalar>&) -> batch_controller<M, S, L, B>;
/// One argument is missing: meets the message about it.
template <class M, class B, class S>
batch_controller(M, const B&, S) -> batch_controller<M, S, detail::nothing_given, B>;

}  // namespace passive_haptics
