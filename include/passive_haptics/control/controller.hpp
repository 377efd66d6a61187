/// @file
/// A mechanism, its brakes, a scene and a law, ready to be called once a cycle.
#pragma once

#include <passive_haptics/control/step.hpp>
#include <passive_haptics/scene/scene.hpp>

#include <type_traits>
#include <utility>

namespace passive_haptics {
namespace detail {
template <class S, int D>
concept has_another_dimension = requires { requires S::dimension != D; };
}  // namespace detail

/// Owns all that a control loop needs but the state, which comes in each cycle.
///
/// S: a scene<...> or a held_scene<...>, or any type with a contacts_type for which sense(s, x) or
/// sense(s, x, time) gives such contacts.
template <class M, class S, class L>
class controller {
  static_assert(mechanism_requirements<M>::met);
  static_assert(!detail::has_another_dimension<S, M::task_dimension>,
                "passive_haptics: the scene's dimension must be the mechanism's task_dimension.");

 public:
  using mechanism_type = M;                               ///< The mechanism.
  using options_type = step_options<typename M::scalar>;  ///< Options of a step.

  /// Throws std::invalid_argument with the text of validate(brakes).
  controller(M mechanism, const brakes_of<M>& brakes, S scene, L law = {},
             const options_type& options = options_type())
      : mechanism_(std::move(mechanism)),
        brakes_(require_valid(brakes)),
        scene_(std::move(scene)),
        law_(std::move(law)),
        options_(options) {}

  /// One control cycle; see step(). A state or position that is not finite is not shown to the scene.
  template <class State>
  step_result_for<M, typename S::contacts_type> operator()(const State& state) noexcept {
    using result = step_result_for<M, typename S::contacts_type>;
    if (const status s = check_state<M>(state); s != status::ok) return released_by<result>(s);
    const auto x = mechanism_.position(state.q).template cast<double>().eval();
    if (!all_finite(x)) return released_by<result>(status::pose_undefined);
    if constexpr (requires { sense(scene_, x, state.time); }) {
      return step(mechanism_, brakes_, sense(scene_, x, state.time), law_, state, memory_, options_);
    } else {
      return step(mechanism_, brakes_, sense(scene_, x), law_, state, memory_, options_);
    }
  }

  /// Forgets the motion so far.
  void reset() { memory_ = {}; }

  /// The scene, for example to move a wall of it before a cycle.
  S& scene() { return scene_; }
  /// The mechanism.
  const M& mechanism() const { return mechanism_; }
  /// The brakes.
  const brakes_of<M>& brakes() const { return brakes_; }

 private:
  M mechanism_;
  brakes_of<M> brakes_;
  S scene_;
  L law_;
  options_type options_;
  step_memory<L> memory_;
};

}  // namespace passive_haptics
