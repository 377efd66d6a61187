/// @file
/// A scene that is sampled more slowly than the brakes are controlled.
#pragma once

#include <passive_haptics/scene/scene.hpp>

#include <limits>

namespace passive_haptics {

/// Period of a held scene.
struct hold_parameters {
  /// Between two samples [s]; 0 samples every time. Section 5.2: 1 ms and 50 ms (20 Hz).
  double period = 0;

  static constexpr const char* type_name = "a held_scene";  ///< In errors.
  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = hold_parameters;
    return member_table(member("period", &p::period, "s", range::not_negative));
  }
};

/// Zero-order hold of a scene: a virtual environment that updates at its own rate, as a faster loop sees it.
/// Between two samples only contact::sensed_at changes: it moves with the wall, by its velocity times the age
/// of the sample, so that a law that carries the contact on by the handle's motion (carried_to) uses the
/// relative motion.
///
/// A law without a margin, such as direct_control, meets a wall up to a period after the touch, so a hand at
/// speed v sinks v * period deeper: 5 mm for 0.1 m/s at 20 Hz. Between two samples nothing shows the next
/// face of a polygon or mesh; of a room with edges give each face as a wall (walls_of).
template <class Scene>
class held_scene {
 public:
  static constexpr int dimension = Scene::dimension;    ///< d
  using contacts_type = typename Scene::contacts_type;  ///< As of the scene.

  /// Throws std::invalid_argument if the period is negative or not finite.
  held_scene(Scene scene, double period) : scene_(std::move(scene)), period_(period) {
    require_valid(hold_parameters{period});
  }

  /// The contacts of the latest sample at or before time [s]. It samples anew if a period has passed, or if
  /// time runs backwards.
  const contacts_type& touched_at(const point<dimension>& x, double time) {
    const double slack = 1e-9 * period_;  // a loop whose period divides this one must not sample a cycle late
    if (!(time - sampled_at_ < period_ - slack) || time < sampled_at_) {
      contacts_ = sense(scene_, x);
      sampled_at_ = time;
    } else {
      for (auto& c : contacts_) c.sensed_at += (time - carried_to_) * c.wall_velocity;
    }
    carried_to_ = time;
    return contacts_;
  }

  /// As of the scene, from its next sample on.
  void set_margin(double margin)
    requires SeesAhead<Scene>
  {
    scene_.set_margin(margin);
  }

  /// Forgets the latest sample, and the handle.
  void reset() {
    sampled_at_ = -std::numeric_limits<double>::infinity();
    if constexpr (requires { scene_.reset(); }) scene_.reset();
  }

  /// Takes over what the scene of another one remembers of the handle (scene_exchange.hpp).
  void remember(const held_scene& other) noexcept
    requires requires(Scene& s, const Scene& o) { s.remember(o); }
  {
    scene_.remember(other.scene_);
  }

  /// As of the scene.
  friend status scene_status(const held_scene& held) { return passive_haptics::status_of(held.scene_); }

  /// The scene, for example to move a wall of it before it is sampled.
  Scene& scene() { return scene_; }
  /// The scene.
  const Scene& scene() const { return scene_; }

 private:
  Scene scene_;
  double period_;
  double sampled_at_ = -std::numeric_limits<double>::infinity();
  double carried_to_ = 0;  // the time at which sensed_at of the contacts is [s]
  contacts_type contacts_{};
};

}  // namespace passive_haptics
