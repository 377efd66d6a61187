/// @file
/// A virtual wall: a shape that resists.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/contacts.hpp>

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

  static constexpr const char* type_name = "a wall";  ///< In errors.
  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = wall;
    return member_table(member("stiffness", &p::stiffness, "N/m", range::not_negative));
  }
};

namespace detail {
template <class>
inline constexpr bool is_wall = false;
template <class S>
inline constexpr bool is_wall<wall<S>> = true;
}  // namespace detail

/// All that a contact of this wall at x [m] tells, but the wall's number.
template <class S>
void describe(const wall<S>& w, const point<S::dimension>& x, double distance, contact<S::dimension>& c) {
  c.normal = w.shape.gradient(x);
  c.depth = -distance;
  c.stiffness = w.stiffness;
  c.wall_velocity = surface_velocity(w.shape, x);
  c.sensed_at = x;
  c.curvature = surface_curvature(w.shape, x);
}

}  // namespace passive_haptics
