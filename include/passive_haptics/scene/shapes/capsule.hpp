/// @file
/// A rounded bar: all points within a radius of a segment.
#pragma once

#include <passive_haptics/core/validate.hpp>
#include <passive_haptics/scene/bounds/bounding_box.hpp>
#include <passive_haptics/scene/shapes/directions.hpp>

#include <algorithm>

namespace passive_haptics {

/// The ends of the segment and the radius about it.
template <int D>
struct capsule_parameters {
  point<D> from;      ///< One end of the segment [m].
  point<D> to;        ///< The other end [m]; may be the same, which gives a ball.
  double radius = 0;  ///< [m], >= 0; a bare segment has no inside until an offset grows it.
};

/// What is wrong with the parameters; empty if nothing.
template <int D>
std::string validate(const capsule_parameters<D>& p) {
  if (!all_finite(p.from)) return "from of a capsule is not finite, expected metres";
  if (!all_finite(p.to)) return "to of a capsule is not finite, expected metres";
  return detail::first_error(detail::check_finite("length of a capsule [m]", (p.to - p.from).stableNorm()),
                             detail::check_not_negative("radius of a capsule [m]", p.radius));
}

/// distance(x) = |x - c(x)| - r with c(x) the point of the segment nearest to x. Exact. On the segment
/// itself, where the gradient does not exist, it is a direction across the segment.
template <int D>
class capsule {
 public:
  static constexpr int dimension = D;  ///< d

  /// Throws std::invalid_argument with the text of validate(p).
  explicit capsule(const capsule_parameters<D>& p)
      : from_(require_valid(p).from),
        axis_(detail::direction_or<D>(p.to - p.from, point<D>::Zero())),
        length_((p.to - p.from).stableNorm()),
        radius_(p.radius) {}

  /// Bar with a radius [m] about the segment between two points [m].
  capsule(const point<D>& from, const point<D>& to, double radius)
      : capsule(capsule_parameters<D>{from, to, radius}) {}

  /// Signed distance [m]; one square root.
  double distance(const point<D>& x) const { return from_segment(x).norm() - radius_; }

  /// Unit vector away from the segment; one square root.
  point<D> gradient(const point<D>& x) const {
    return detail::direction_or<D>(from_segment(x), detail::any_perpendicular<D>(axis_));
  }

  /// The box about the ends, wider by the radius.
  bounding_box<D> bounds() const {
    bounding_box<D> box = box_about(from_, radius_);
    box.extend(box_about<D>(from_ + length_ * axis_, radius_));
    return box;
  }

 private:
  point<D> from_segment(const point<D>& x) const {
    const point<D> r = x - from_;
    return r - std::clamp(axis_.dot(r), 0.0, length_) * axis_;
  }

  point<D> from_;
  point<D> axis_;  // unit vector; zero for a ball
  double length_;
  double radius_;
};

}  // namespace passive_haptics
