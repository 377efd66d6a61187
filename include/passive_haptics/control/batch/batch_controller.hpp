/// Control cycles for a batch of states.
#pragma once

#include <passive_haptics/control/batch/batch_results.hpp>
#include <passive_haptics/control/controller.hpp>

#include <cstddef>
#include <utility>

namespace passive_haptics {

/// Runs the control cycle of N independent states, for maps, sweeps and studies. Each result is that of a new
/// controller and scene. To use threads, divide the states with part_of().
template <class M, class S, class L, class B = brakes_of<M>>
class batch_controller {
  static_assert(detail::is_controller<M, B, S, L, explain>());

 public:
  using mechanism_type = M;                               ///< The mechanism.
  using options_type = step_options<typename M::scalar>;  ///< Options of a step.

  /// Throws std::invalid_argument like a controller.
  batch_controller(M mechanism, const B& brakes, S scene, L law = {},
                   const options_type& options = options_type())
      : mechanism_(std::move(mechanism)),
        brakes_(detail::require_valid_brakes(brakes)),
        scene_(std::move(scene)),
        law_(detail::require_valid_law(std::move(law))),
        options_(options),
        brake_jacobian_(mechanism_),
        parameters_(passive_haptics::check_parameters(brakes_, law_, options_)) {}

  /// Stores the results of these states. Thread-safe with separate results. Throws std::invalid_argument if
  /// check_lengths() or check_hand_force() returns an error. Only allocates if copying the scene does.
  void operator()(const batch_states<M>& states, const batch_results<M>& results) const {
    require_no_error(check_lengths(states));
    require_no_error(check_lengths(results, states.size()));
    if constexpr (needs_hand_force<L>) require_no_error(check_hand_force(states));
    if (are_commands(results)) run<brake_command<M>>(states, results);
    else run<step_result_for<M, typename S::contacts_type>>(states, results);
  }

  const M& mechanism() const { return mechanism_; }  ///< The mechanism.
  const B& brakes() const { return brakes_; }        ///< The brakes.

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

/// Deduces the types from arguments in this order; a wrong order fails with a message.
template <class M, class B, class S, class L>
batch_controller(M, const B&, S, L) -> batch_controller<M, S, L, B>;
/// With options.
template <class M, class B, class S, class L>
batch_controller(M, const B&, S, L, const step_options<typename M::scalar>&) -> batch_controller<M, S, L, B>;
/// For a message about a missing argument.
template <class M, class B, class S>
batch_controller(M, const B&, S) -> batch_controller<M, S, detail::nothing_given, B>;

}  // namespace passive_haptics
