/// Scenes with effects, for a controller or step().
#pragma once

#include <passive_haptics/control/pipelines/beside_effects.hpp>

namespace passive_haptics {

/// A scene without walls, for with_effects.
template <int D>
using no_walls = contacts<D, 1>;

/// A scene with effects in addition to its walls:
///
///     ph::controller control(arm, brakes, ph::with_effects(scene, honey, knob, stops), law);
///
/// Scene: any scene of a controller, contacts for step(), or no_walls<d>(). Effects: one or more of Effect,
/// WallEffect and JointEffect (force/effect.hpp), with the scene's dimension and the mechanism's scalar.
///
/// Walls have priority: effects do not change their displayed forces, except the drag along them. Effects get
/// the remaining freedom of the brakes (torques_beside). Requires a ScalingLaw; it does not see effects.
///
/// Result: a step_result_with_effects, with wall_number -1 if no wall is touched. An effect that is not
/// finite releases the brakes with status::result_not_finite.
template <class Scene, class... Effects>
class with_effects {
 public:
  static constexpr int dimension = Scene::dimension;                        ///< Task dimensions d.
  using contacts_type = walls_and_effects<contacts_of<Scene>, Effects...>;  ///< Result of sensing.
  static constexpr int capacity = contacts_type::capacity;                  ///< Maximum number of walls.
  /// Result of a cycle.
  template <class M>
  using result_type = typename contacts_type::template result_type<M>;

  /// The scene or contacts, and the effects.
  explicit with_effects(Scene scene, Effects... effects)
      : scene_(std::move(scene)), effects_(std::move(effects)...) {}

  /// Forgets the handle.
  void reset()
    requires requires(Scene& s) { s.reset(); }
  {
    scene_.reset();
  }

  Scene& scene() { return scene_; }              ///< The scene, e.g. to move one of its walls between cycles.
  const Scene& scene() const { return scene_; }  ///< The scene.

  /// Effect Number, e.g. to change it between cycles.
  template <int Number>
  auto& effect() {
    static_assert(0 <= Number && Number < static_cast<int>(sizeof...(Effects)),
                  "passive_haptics: there is no effect with this number.");
    return boost::hana::at_c<Number>(effects_);
  }
  const detail::effects_of<Effects...>& effects() const { return effects_; }  ///< All effects.

 private:
  Scene scene_;
  detail::effects_of<Effects...> effects_;
};

namespace detail {
template <class S>
inline constexpr bool is_with_effects = false;
template <class Scene, class... Effects>
inline constexpr bool is_with_effects<with_effects<Scene, Effects...>> = true;

template <class T, class Scene, class... Effects>
auto sense_beside(Scene& scene, const effects_of<Effects...>& effects, const T& x, double time) {
  return walls_and_effects<decltype(passive_haptics::walls_at(scene, x, time)), Effects...>{
      passive_haptics::walls_at(scene, x, time), effects};
}
}  // namespace detail

/// The walls touched at x [m] and a time [s], and the effects. The scene must outlive the result.
template <class S>
  requires detail::is_with_effects<std::remove_const_t<S>>
auto sense(S& scene, const point<S::dimension>& x, double time) {
  return detail::sense_beside(scene.scene(), scene.effects(), x, time);
}

/// Reason why the contacts of the scene cannot be displayed, or status::ok.
template <class Scene, class... Effects>
status scene_status(const with_effects<Scene, Effects...>& scene) {
  return passive_haptics::status_of(scene.scene());
}

}  // namespace passive_haptics
