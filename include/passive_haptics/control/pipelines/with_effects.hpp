/// @file
/// Effects beside walls: what a controller takes for a scene, or step() for contacts.
#pragma once

#include <passive_haptics/control/pipelines/beside_effects.hpp>

namespace passive_haptics {

/// No wall at all, as a scene for with_effects.
template <int D>
using no_walls = contacts<D, 1>;

/// A scene with effects that stand beside its walls:
///
///     ph::controller control(arm, brakes, ph::with_effects(scene, honey, knob, stops), law);
///
/// Scene: any that a controller takes, contacts for step(), or no_walls<d>(). Effects: at least one Effect,
/// WallEffect or JointEffect (force/effect.hpp), of the scene's dimension and the mechanism's scalar.
///
/// Walls come first: what a cycle displays of them does not depend on the effects, but for the drag along
/// them. Effects get what the brakes can do besides (torques_beside). A law does not see effects:
/// effects resist, and nothing has to be scaled. They need a ScalingLaw: a TorqueLaw chooses torques itself,
/// so an effect cannot be added without overriding it.
///
/// Result: a step_result_with_effects. `wall` is -1 where no wall is touched. A NaN or infinity from an
/// effect releases the brakes, status::result_not_finite.
template <class Scene, class... Effects>
class with_effects {
 public:
  static constexpr int dimension = Scene::dimension;  ///< d
  /// What sensing gives.
  using contacts_type = walls_and_effects<contacts_of<Scene>, Effects...>;
  static constexpr int capacity = contacts_type::capacity;  ///< Most walls at once.
  /// What a cycle returns.
  template <class M>
  using result_type = typename contacts_type::template result_type<M>;

  /// The scene or contacts, and the effects.
  explicit with_effects(Scene scene, Effects... effects)
      : scene_(std::move(scene)), effects_(std::move(effects)...) {}

  /// Forgets the handle, as the scene does.
  void reset()
    requires requires(Scene& s) { s.reset(); }
  {
    scene_.reset();
  }

  /// The scene, for example to move a wall of it before a cycle.
  Scene& scene() { return scene_; }
  /// The scene.
  const Scene& scene() const { return scene_; }

  /// Effect Number, to change it between two cycles.
  template <int Number>
  auto& effect() {
    static_assert(0 <= Number && Number < static_cast<int>(sizeof...(Effects)),
                  "passive_haptics: there is no effect with this number.");
    return boost::hana::at_c<Number>(effects_);
  }
  /// All effects.
  const detail::effects_of<Effects...>& effects() const { return effects_; }

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

/// The walls touched at x [m] and a time [s], and the effects. Lives no longer than the scene.
template <class S>
  requires detail::is_with_effects<std::remove_const_t<S>>
auto sense(S& scene, const point<S::dimension>& x, double time) {
  return detail::sense_beside(scene.scene(), scene.effects(), x, time);
}

/// Why the contacts of the scene cannot be displayed; status::ok if they can.
template <class Scene, class... Effects>
status scene_status(const with_effects<Scene, Effects...>& scene) {
  return passive_haptics::status_of(scene.scene());
}

}  // namespace passive_haptics
