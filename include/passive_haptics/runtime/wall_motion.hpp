/// Walls with a motion given by the time of a cycle, which logs contain.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/scene.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace passive_haptics::runtime {

/// Motion of a wall: a sinusoid, a conveyor belt, or both; by default none.
template <int D>
struct wall_motion {
  point<D> amplitude = point<D>::Zero();      ///< Of the displacement [m].
  double frequency = 0;                       ///< Of the displacement [Hz].
  point<D> belt_velocity = point<D>::Zero();  ///< Velocity of the surface of a wall at rest [m/s].

  static constexpr const char* type_name = "a wall's motion";  ///< In errors.
  static constexpr auto members() {
    using p = wall_motion;
    return member_table(member("amplitude", &p::amplitude, "m", range::finite),
                        member("frequency", &p::frequency, "Hz", range::not_negative),
                        member("belt_velocity", &p::belt_velocity, "m/s", range::finite));
  }
  /// Requires a frequency for an amplitude.
  std::string rules() const {
    if (frequency > 0 || amplitude.isZero(0)) return {};
    return detail::error_text("frequency of a wall's motion [Hz]", frequency, "> 0 with an amplitude");
  }

  /// Displacement at a time [s]: amplitude sin(2 pi frequency time) [m].
  point<D> displacement(double time) const { return std::sin(rate() * time) * amplitude; }
  /// Velocity of the surface [m/s] at a time [s].
  point<D> velocity(double time) const {
    return belt_velocity + rate() * std::cos(rate() * time) * amplitude;
  }

 private:
  double rate() const { return 2 * std::numbers::pi * frequency; }  // [rad/s]
};

/// A world, or a held_scene of one, with walls that are placed before each sample. No allocation, no locks.
template <class Scene>
class scene_in_motion {
 public:
  static constexpr int dimension = Scene::dimension;    ///< d
  using contacts_type = typename Scene::contacts_type;  ///< Contacts of the scene.

  /// Number of a wall, and its motion.
  using numbered_motion = std::pair<int, wall_motion<dimension>>;

  /// Moves these walls, added by world_walls::add_moving.
  scene_in_motion(Scene scene, std::vector<numbered_motion> motions)
      : scene_(std::move(scene)), motions_(std::move(motions)) {}

  /// The contacts at x [m] and a time [s], valid until the next call.
  const contacts_type& touched_at(const point<dimension>& x, double time) {
    for (const auto& [number, motion] : motions_)
      moved().set_motion(number, motion.displacement(time), motion.velocity(time));
    if constexpr (requires { scene_.touched_at(x, time); }) return scene_.touched_at(x, time);
    else return scene_.touched_at(x);
  }
  /// As the scene.
  void set_margin(double margin) { scene_.set_margin(margin); }
  /// As the scene.
  void reset() { scene_.reset(); }

 private:
  auto& moved() {
    if constexpr (requires { scene_.scene(); }) return scene_.scene();
    else return scene_;
  }

  Scene scene_;
  std::vector<numbered_motion> motions_;
};

}  // namespace passive_haptics::runtime
