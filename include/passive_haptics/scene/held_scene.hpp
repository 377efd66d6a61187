/// A scene sampled more slowly than the control loop.
#pragma once

#include <passive_haptics/scene/scene.hpp>

#include <limits>

namespace passive_haptics {

/// Parameters of held_scene.
struct hold_parameters {
  /// Time between two samples [s]; 0 samples in each cycle. Section 5.2 uses 1 ms and 50 ms (20 Hz).
  double period = 0;

  static constexpr const char* type_name = "a held_scene";  ///< In errors.
  static constexpr auto members() {
    using p = hold_parameters;
    return member_table(member("period", &p::period, "s", range::not_negative));
  }
};

/// Zero-order hold of a scene that updates at its own rate. Between two samples only contact::sensed_at
/// changes, by the wall's velocity, so that carried_to gives the contact for the relative motion.
///
/// A law without a margin detects a wall up to one period after the touch, so a hand at speed v sinks deeper
/// by v * period. Only the sampled face of a polygon or mesh is known; for a room, make each face a wall
/// (walls_of).
template <class Scene>
class held_scene {
 public:
  static constexpr int dimension = Scene::dimension;    ///< d
  using contacts_type = typename Scene::contacts_type;  ///< Contacts of the scene.

  /// Throws std::invalid_argument if the period is negative or not finite.
  held_scene(Scene scene, double period) : scene_(std::move(scene)), period_(period) {
    require_valid(hold_parameters{period});
  }

  /// Contacts of the latest sample at time [s]; samples again after a period or if time runs backwards.
  const contacts_type& touched_at(const point<dimension>& x, double time) {
    const double slack = 1e-9 * period_;  // for rounding of the times
    if (!(time - sampled_at_ < period_ - slack) || time < sampled_at_) {
      contacts_ = sense(scene_, x);
      sampled_at_ = time;
    } else {
      for (auto& c : contacts_) c.sensed_at += (time - carried_to_) * c.wall_velocity;
    }
    carried_to_ = time;
    return contacts_;
  }

  /// Sets the margin of the scene from its next sample on.
  void set_margin(double margin)
    requires SeesAhead<Scene>
  {
    scene_.set_margin(margin);
  }

  /// Forgets the latest sample and the handle.
  void reset() {
    sampled_at_ = -std::numeric_limits<double>::infinity();
    if constexpr (requires { scene_.reset(); }) scene_.reset();
  }

  /// Takes over the handle's state from another scene (scene_exchange.hpp).
  void remember(const held_scene& other) noexcept
    requires requires(Scene& s, const Scene& o) { s.remember(o); }
  {
    scene_.remember(other.scene_);
  }

  /// Status of the scene.
  friend status scene_status(const held_scene& held) { return passive_haptics::status_of(held.scene_); }

  /// The scene, for example to move one of its walls before it is sampled.
  Scene& scene() { return scene_; }
  const Scene& scene() const { return scene_; }  ///< The scene.

 private:
  Scene scene_;
  double period_;
  double sampled_at_ = -std::numeric_limits<double>::infinity();
  double carried_to_ = 0;  // time of sensed_at [s]
  contacts_type contacts_{};
};

}  // namespace passive_haptics
