/// @file
/// A shape grown or shrunk.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/bounds/bounding_box.hpp>
#include <passive_haptics/scene/shapes/shape_wrapper.hpp>

#include <utility>

namespace passive_haptics {

/// How much a wall grows.
struct offset_parameters {
  double growth = 0;  ///< The surface moves this far to the free side [m]; < 0 shrinks the wall.

  static constexpr const char* type_name = "an offset";  ///< In errors.
  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = offset_parameters;
    return member_table(member("growth", &p::growth, "m", range::finite));
  }
};

/// distance(x) = S(x) - growth: for a tool of radius `growth`, or with edges rounded by it.
///
/// A grown wall is exact outside if S is. A shrunk one is the set of points deeper than -growth; its distance
/// is exact inside, and outside a lower bound that is exact except beyond edges which S rounds.
template <class S>
class offset : public shape_wrapper<S> {
 public:
  using shape_wrapper<S>::dimension;  ///< d

  /// Throws std::invalid_argument if growth [m] is not finite.
  offset(S shape, double growth)
      : shape_wrapper<S>(std::move(shape)), growth_(require_valid(offset_parameters{growth}).growth) {}

  /// Signed distance [m]; that of the shape and a subtraction.
  double distance(const point<dimension>& x) const { return this->shape_.distance(x) - growth_; }

  /// Thickness of the shape, grown on both sides [m].
  double thickness() const { return thickness_of(this->shape_) + 2 * growth_; }

  /// The bounds of the shape, wider by the growth; those of a shrunk one are not narrower.
  bounding_box<dimension> bounds() const
    requires BoundedShape<S>
  {
    return this->shape_.bounds().grown(growth_ > 0 ? growth_ : 0);
  }

 private:
  double growth_;
};

}  // namespace passive_haptics
