/// A virtual wall: a shape that resists.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/contacts.hpp>

#include <limits>
#include <utility>

namespace passive_haptics {

/// A shape that resists with F = stiffness * depth along its gradient, without friction. Shapes with a
/// tracker require a world (scene/world/tracked_shape.hpp).
template <class S>
class wall {
  static_assert(
      Shape<S> || requires { typename S::tracker; },
      "passive_haptics: a wall needs a Shape: `static constexpr int dimension`, "
      "`double distance(x) const`, `point<dimension> gradient(x) const`.");

 public:
  /// Throws std::invalid_argument if the stiffness [N/m] is negative or not finite. Section 5.1 uses 1e7 N/m.
  explicit wall(S geometry, double newton_per_metre = 1e7)
      : shape(std::move(geometry)), stiffness_(newton_per_metre) {
    require_valid(*this);
  }
  /// Rejects the wrong order of arguments.
  wall(double, const S& geometry) : shape(geometry), stiffness_(0) {
    static_assert(sizeof(S) == 0,
                  "passive_haptics: the arguments of a wall are (shape, stiffness), in this order.");
  }
  S shape;  ///< Geometry.

  double stiffness() const { return stiffness_; }  ///< [N/m], >= 0 and finite.
  /// Sets the stiffness [N/m] between cycles; false without effect if it is negative or not finite.
  [[nodiscard]] bool set_stiffness(double newton_per_metre) {
    if (!range::not_negative.contains(newton_per_metre)) return false;
    stiffness_ = newton_per_metre;
    return true;
  }

  static constexpr const char* type_name = "a wall";  ///< In errors.
  static constexpr auto members() {
    return member_table(member("stiffness", &wall::stiffness_, "N/m", range::not_negative)
                            .remark_at_zero("the wall exerts no force"));
  }

 private:
  double stiffness_;
};

/// For the error about the wrong order.
template <class S>
wall(double, S) -> wall<S>;

namespace detail {
template <class>
inline constexpr bool is_wall = false;
template <class S>
inline constexpr bool is_wall<wall<S>> = true;
}  // namespace detail

/// Contact of a wall at x [m], at this `distance`. The depth is NaN if the gradient is not a unit vector.
template <class S>
contact<S::dimension> contact_of(const wall<S>& w, const point<S::dimension>& x, double distance) {
  const point<S::dimension> n = w.shape.gradient(x);
  const bool valid = gradient_is_unit<S> || is_unit(n);
  contact<S::dimension> c;
  c.normal = n;
  c.depth = valid ? -distance : std::numeric_limits<double>::quiet_NaN();
  c.stiffness = w.stiffness();
  c.wall_velocity = surface_velocity(w.shape, x);
  c.sensed_at = x;
  c.curvature = surface_curvature(w.shape, x);
  return c;
}

}  // namespace passive_haptics
