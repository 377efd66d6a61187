/// Shapes with an offset surface.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/bounds/bounding_box.hpp>
#include <passive_haptics/scene/shapes/shape_wrapper.hpp>

#include <utility>

namespace passive_haptics {

/// Parameters of offset.
struct offset_parameters {
  double growth = 0;  ///< Displacement of the surface to the free side [m]; < 0 shrinks the wall.

  static constexpr const char* type_name = "an offset";  ///< In errors.
  static constexpr auto members() {
    using p = offset_parameters;
    return member_table(member("growth", &p::growth, "m", range::finite));
  }
};

/// distance(x) = S(x) - growth, for a tool of radius `growth` or for rounded edges.
///
/// A grown wall is exact outside if S is. A shrunk wall is the set of points deeper than -growth; its
/// distance is exact inside, and a lower bound outside, exact except beyond edges that S rounds.
template <class S>
class offset : public shape_wrapper<S> {
 public:
  using shape_wrapper<S>::dimension;  ///< d

  /// Throws std::invalid_argument if growth [m] is not finite.
  offset(S shape, double growth)
      : shape_wrapper<S>(std::move(shape)), growth_(require_valid(offset_parameters{growth}).growth) {}

  /// Signed distance [m].
  double distance(const point<dimension>& x) const { return this->shape_.distance(x) - growth_; }

  /// Thickness, grown on both sides [m].
  double thickness() const { return thickness_of(this->shape_) + 2 * growth_; }

  /// Bounds of the shape, extended by the growth if that is > 0.
  bounding_box<dimension> bounds() const
    requires BoundedShape<S>
  {
    return this->shape_.bounds().grown(growth_ > 0 ? growth_ : 0);
  }

 private:
  double growth_;
};

}  // namespace passive_haptics
