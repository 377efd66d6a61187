/// A scene of walls known at compile time.
#pragma once

#include <passive_haptics/core/for_each.hpp>
#include <passive_haptics/scene/wall.hpp>

#include <utility>

namespace passive_haptics {

/// A fixed set of walls with one dimension, made by scene().
///
/// Contacts use the nearest side of each wall, so a hand pressed beyond the middle of a thin wall comes out
/// on the other side, and it sinks in at the seam of two adjacent walls. A world handles both cases.
template <class First, class... Rest>
class static_scene {
 public:
  static constexpr int dimension = First::dimension;                        ///< d
  static constexpr int wall_count = 1 + static_cast<int>(sizeof...(Rest));  ///< Number of walls.
  static_assert(((Rest::dimension == dimension) && ...),
                "passive_haptics: all walls of a scene need the same dimension.");
  static_assert(
      Shape<First> && (Shape<Rest> && ...),
      "passive_haptics: a shape that is followed (TrackedShape) needs a world (scene/world/world.hpp).");

  using contacts_type = contacts<dimension, wall_count>;  ///< Type of the contacts.

  /// The walls in the order of their numbers.
  explicit static_scene(wall<First> first, wall<Rest>... rest)
      : walls_(std::move(first), std::move(rest)...) {}

  /// Returns the walls touched at x [m] (distance < 0, or < margin after set_margin) with the velocities of
  /// their surfaces. NaN in x gives a contact with a NaN depth, which the step reports.
  contacts_type touched_at(const point<dimension>& x) const {
    contacts_type touched;
    int number = 0;
    detail::for_each(walls_, [&](const auto& w) {
      const double distance = w.shape.distance(x);
      if (!(distance >= margin_)) {
        contact<dimension> c = contact_of(w, x, distance);
        c.wall_number = number;
        touched.append_unchecked(c);
      }
      ++number;
    });
    return touched;
  }

  /// Reports contacts from this distance to each wall [m], with a depth < 0 before the touch.
  void set_margin(double margin) { margin_ = margin; }

  /// Calls f(number, wall) for each wall.
  template <class F>
  void for_each(F&& f) const {
    int number = 0;
    detail::for_each(walls_, [&](const auto& w) { f(number++, w); });
  }

  /// Extrapolates each moving shape by this time [s] (moving.hpp).
  void extrapolate(double seconds) {
    detail::for_each(walls_, [&](auto& w) {
      if constexpr (requires { w.shape.extrapolate(seconds); }) w.shape.extrapolate(seconds);
    });
  }

  /// Returns wall Number, for example to move its shape: `scene.template get<0>().shape.set_motion(...)`.
  template <int Number>
  auto& get() {
    static_assert(0 <= Number && Number < wall_count,
                  "passive_haptics: the scene has no wall with this number.");
    return boost::hana::at_c<Number>(walls_);
  }

 private:
  boost::hana::basic_tuple<wall<First>, wall<Rest>...> walls_;
  double margin_ = 0;  // [m]
};

/// Makes a scene of walls, numbered in this order: `scene(wall(shape, stiffness), ...)`.
template <class First, class... Rest>
static_scene<First, Rest...> scene(wall<First> first, wall<Rest>... rest) {
  return static_scene<First, Rest...>(std::move(first), std::move(rest)...);
}

/// Rejects arguments that are not walls.
template <class... X>
  requires(!(detail::is_wall<X> && ...))
auto scene(const X&...) {
  static_assert((detail::is_wall<X> && ...),
                "passive_haptics: a scene consists of walls: put each shape into one, "
                "`scene(wall(shape, stiffness))`; for effects use `with_effects(scene, effect)`.");
}

}  // namespace passive_haptics
