/// Any shape as an obstacle of a proxy.
#pragma once

#include <passive_haptics/scene/proxy/proxy_surface.hpp>

#include <cstddef>
#include <numbers>
#include <utility>

namespace passive_haptics {

/// Any Shape as a ProxySurface with one facet, the tangent plane at the nearest point. A handle that crosses
/// a thin shape within one cycle has passed it, as in a scene. Refers to the shape, which must live longer.
template <Shape S>
class shape_surface {
 public:
  static constexpr int dimension = S::dimension;  ///< d
  using at = point<dimension>;                    ///< A point [m].

  explicit shape_surface(const S& shape) : shape_(shape) {}  ///< Refers to the shape.

  double skin() const { return skin_; }                   ///< [m]
  double crease_cosine() const { return smooth_cosine; }  ///< Default of mesh_surface.

  /// As ProxySurface: the point at which the distance falls to a skin, if it does so by the end of the step.
  /// One distance, or a few to find the point (false position, Illinois rule).
  proxy_stop first_stop(const at& p, const at& step, std::span<const int> resting) const {
    constexpr int max_looks = 60;
    const double lip = lip_by_skin * skin_;
    // A step along a curved surface changes the distance a little
    const double least = resting.empty() ? skin_ : 0.5 * skin_;
    const auto gap_at = [&](double time) { return shape_.distance(p + time * step) - least; };
    double outside = 0, inside = 1, right = gap_at(inside);  // distances at the ends of the bracket
    if (!(right < -lip)) return {};
    double gap = gap_at(outside), left = gap;
    int replaced = 0;  // the end that was replaced last
    for (int look = 0; look < max_looks && gap > lip; ++look) {
      const double time = outside + (inside - outside) * left / (left - right), gap_there = gap_at(time);
      if (gap_there >= 0) {
        outside = time;
        gap = left = gap_there;
        if (std::exchange(replaced, 1) == 1) right *= 0.5;
      } else {
        inside = time;
        right = gap_there;
        if (std::exchange(replaced, -1) == -1) left *= 0.5;
      }
    }
    return {outside, 0};
  }

  /// As ProxySurface.
  proxy_plane<dimension> plane(int, const at& p) const {
    const at n = shape_.gradient(p);
    return {n, p - shape_.distance(p) * n};
  }
  /// As ProxySurface.
  bool holds(int, const at& p) const { return !(shape_.distance(p) > (1 + 2 * lip_by_skin) * skin_); }
  double clearance(const at& x, int&) const { return shape_.distance(x) - 2 * skin_; }  ///< As ProxySurface.
  bool is_solid() const { return true; }                                                ///< As ProxySurface.
  /// As ProxySurface.
  at entry(const at& x) const {
    const double distance = shape_.distance(x);
    return distance < 0 ? at(x + (skin_ - distance) * shape_.gradient(x)) : x;
  }

 private:
  static constexpr double lip_by_skin = 1e-3;
  static constexpr double smooth_cosine = 0.5 * std::numbers::sqrt3;  // 30 deg
  static constexpr double skin_ = 1e-7;                               // [m]

  const S& shape_;
};

namespace detail {

/// The obstacle of a wall: a ProxySurface itself, a Shape as shape_surface, else nothing.
template <class S>
class stops_of {
 public:
  explicit stops_of(const S&) {}                                 ///< No obstacle.
  static constexpr std::nullptr_t surface() { return nullptr; }  ///< nullptr
};
template <ProxySurface S>
class stops_of<S> {
 public:
  explicit stops_of(const S& s) : model_(s) {}
  const any_proxy_surface<S::dimension>* surface() const { return &model_; }

 private:
  proxy_surface_model<S> model_;
};
template <class S>
  requires(Shape<S> && !ProxySurface<S>)
class stops_of<S> {
 public:
  explicit stops_of(const S& s) : surface_(s), model_(surface_) {}
  const any_proxy_surface<S::dimension>* surface() const { return &model_; }

 private:
  shape_surface<S> surface_;
  proxy_surface_model<shape_surface<S>> model_;
};

}  // namespace detail
}  // namespace passive_haptics
