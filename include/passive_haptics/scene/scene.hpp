/// @file
/// A scene of walls known at compile time.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/contacts.hpp>

#include <boost/hana/at.hpp>
#include <boost/hana/for_each.hpp>
#include <boost/hana/tuple.hpp>

#include <utility>

namespace passive_haptics {

/// A shape that resists with F = stiffness * depth along its gradient; frictionless. One with a tracker is
/// for a world (scene/world/tracked_shape.hpp).
template <class S>
struct wall {
  static_assert(
      Shape<S> || requires { typename S::tracker; },
      "passive_haptics: a wall needs a Shape: `static constexpr int dimension`, "
      "`double distance(x) const`, `point<dimension> gradient(x) const`.");
  /// Throws std::invalid_argument if the stiffness [N/m] is negative or not finite; section 5.1: 1e7 N/m.
  explicit wall(S geometry, double newton_per_metre = 1e7)
      : shape(std::move(geometry)), stiffness(newton_per_metre) {
    require_valid(*this);
  }
  S shape;           ///< Geometry.
  double stiffness;  ///< [N/m]

  static constexpr const char* owner = "a wall";  ///< In errors.
  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = wall;
    return member_table(member("stiffness", &p::stiffness, "N/m", range::not_negative, plausible(0, 1e9)));
  }
};

/// All that a contact of this wall at x [m] tells, but the wall's number.
template <class S>
void describe(const wall<S>& w, const point<S::dimension>& x, double distance, contact<S::dimension>& c) {
  c.normal = w.shape.gradient(x);
  c.depth = -distance;
  c.stiffness = w.stiffness;
  c.wall_velocity = surface_velocity(w.shape, x);
  c.position = x;
  c.curvature = surface_curvature(w.shape, x);
}

/// Fixed walls of any shapes and one dimension. Only the code for the shapes it names exists.
template <class First, class... Rest>
class scene {
 public:
  static constexpr int dimension = First::dimension;                        ///< d
  static constexpr int wall_count = 1 + static_cast<int>(sizeof...(Rest));  ///< Walls, so most contacts.
  static_assert(((Rest::dimension == dimension) && ...),
                "passive_haptics: all walls of a scene need the same dimension.");
  static_assert(
      Shape<First> && (Shape<Rest> && ...),
      "passive_haptics: a shape that is followed (TrackedShape) needs a world (scene/world/world.hpp).");

  /// What sensing this scene gives.
  using contacts_type = contacts<dimension, wall_count>;

  /// The walls, in the order of their numbers.
  explicit scene(wall<First> first, wall<Rest>... rest) : walls_(std::move(first), std::move(rest)...) {}

  /// The walls touched at x [m] (distance < 0), each with the velocity of its surface. A NaN in x gives a
  /// contact with a NaN depth, which the step reports. Cost: one distance for each wall, one gradient for
  /// each contact.
  contacts_type touched_at(const point<dimension>& x) const {
    contacts_type touched;
    int number = 0;
    boost::hana::for_each(walls_, [&](const auto& w) {
      const double distance = w.shape.distance(x);
      if (!(distance >= 0)) {
        auto& c = *touched.append();  // in place: a copy would wait for its parts to be stored
        describe(w, x, distance, c);
        c.wall = number;
      }
      ++number;
    });
    return touched;
  }

  /// Carries each shape that can be on for this time [s] (moving.hpp).
  void extrapolate(double seconds) {
    boost::hana::for_each(walls_, [&](auto& w) {
      if constexpr (requires { w.shape.extrapolate(seconds); }) w.shape.extrapolate(seconds);
    });
  }

  /// Wall Number, to move its shape between two cycles: `scene.template get<0>().shape.set_motion(...)`.
  template <int Number>
  auto& get() {
    static_assert(0 <= Number && Number < wall_count,
                  "passive_haptics: the scene has no wall of this number.");
    return boost::hana::at_c<Number>(walls_);
  }

 private:
  boost::hana::tuple<wall<First>, wall<Rest>...> walls_;
};

}  // namespace passive_haptics
