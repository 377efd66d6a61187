/// A rounded bar: all points within a radius of a segment.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/bounds/bounding_box.hpp>
#include <passive_haptics/scene/shapes/directions.hpp>

#include <algorithm>

namespace passive_haptics {

/// Parameters of capsule.
template <int D>
struct capsule_parameters {
  point<D> from = point<D>::Zero();  ///< One end of the segment [m].
  point<D> to = point<D>::Zero();    ///< The other end [m]; equal ends give a ball.
  double radius = 0;                 ///< [m], >= 0. A capsule of radius 0 has no inside.

  static constexpr const char* type_name = "a capsule";  ///< In errors.
  static constexpr auto members() {
    using p = capsule_parameters;
    return member_table(member("from", &p::from, "m", range::finite),
                        member("to", &p::to, "m", range::finite),
                        member("radius", &p::radius, "m", range::not_negative));
  }
  /// Requires a length that does not overflow.
  error_message rules() const {
    return check_value("length", length_of(to - from), "m", range::finite, type_name);
  }
};

/// distance(x) = |x - c(x)| - r, c(x) the nearest point of the segment. On it, the gradient is perpendicular.
template <int D>
class capsule {
 public:
  static constexpr int dimension = D;              ///< d
  static constexpr bool has_unit_gradient = true;  ///< By construction.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit capsule(const capsule_parameters<D>& p)
      : from_(require_valid(p).from),
        axis_(detail::direction_or<D>(p.to - p.from, point<D>::Zero())),
        length_(length_of(p.to - p.from)),
        radius_(p.radius) {}

  /// Segment between two points [m] with a radius [m].
  capsule(const point<D>& from, const point<D>& to, double radius)
      : capsule(capsule_parameters<D>{from, to, radius}) {}

  /// Signed distance [m].
  double distance(const point<D>& x) const { return from_segment(x).norm() - radius_; }

  /// Unit vector away from the segment.
  point<D> gradient(const point<D>& x) const {
    return detail::direction_or<D>(from_segment(x), detail::any_perpendicular<D>(axis_));
  }

  /// (P - n n^T) / |x - c| [1/m]; P = I near an end, I - a a^T along the segment with unit vector a.
  matrix<double, D, D> hessian(const point<D>& x) const {
    const double along = axis_.dot(x - from_);
    matrix<double, D, D> P = matrix<double, D, D>::Identity();
    if (along > 0 && along < length_) {
      if constexpr (D == 2) return matrix<double, D, D>::Zero();
      P -= axis_ * axis_.transpose();
    }
    return detail::hessian_of_length<D>(from_segment(x), P);
  }

  double thickness() const { return 2 * radius_; }  ///< The diameter [m].

  /// Bounding box.
  bounding_box<D> bounds() const {
    bounding_box<D> box{from_, from_};
    box.extend(from_ + length_ * axis_);
    return box.grown(radius_);
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
