/// @file
/// The ProxySurface concept: what stops a proxy.
///
/// A proxy is the point on the free side of all surfaces that stands for a handle which may be behind them.
/// References: C. B. Zilles, J. K. Salisbury, A constraint-based god-object method for haptic display, IROS
/// 1995, pp. 146-151; D. C. Ruspini, K. Kolarov, O. Khatib, The haptic display of complex graphical
/// environments, SIGGRAPH 1997, pp. 345-352.
#pragma once

#include <passive_haptics/scene/shape.hpp>

#include <concepts>
#include <span>

namespace passive_haptics {

/// Where a straight way p + t step, t in [0, 1], meets a surface.
struct proxy_stop {
  double time = 1;  ///< t
  int facet = -1;   ///< On which facet; -1 if it meets none.
};

/// The plane of a facet.
template <int D>
struct proxy_plane {
  point<D> normal;    ///< Unit, to the free side.
  point<D> position;  ///< A point of it [m].

  /// Of x over the plane [m].
  double height(const point<D>& x) const { return normal.dot(x - position); }
};

/// A surface that lets nothing from its front to its back, by facets: those of a mesh, or the whole of a
/// smooth shape as one.
///
/// Minimal complete definition, positions in the frame of the surface [m]:
///   - `static constexpr int dimension`;
///   - `double skin() const`: how far in front of it a proxy stays [m] > 0;
///   - `double crease_cosine() const`: facets whose normals n, m have n . m over it are one smooth surface;
///   - `proxy_stop first_stop(const point<d>& p, const point<d>& step, std::span<const int> resting) const`:
///     where the way from p, in front of the surface, first comes nearer than a skin. The facets on which the
///     proxy rests already stop it only where the way would pass through them;
///   - `proxy_plane<d> plane(int facet, const point<d>& p) const`;
///   - `bool holds(int facet, const point<d>& p) const`: whether a proxy at p, a skin high, rests on the
///     facet;
///   - `double clearance(const point<d>& x) const`: how far [m] from x nothing stops a proxy; <= 0 inside of
///     a solid;
///   - `point<d> entry(const point<d>& x) const`: where a handle that is seen for the first time at x has
///     come from: x, or the nearest point outside of a solid.
template <class S>
concept ProxySurface = detail::names_dimension<S> && requires(const S surface, const point<S::dimension> p,
                                                              std::span<const int> resting, int hint) {
  { surface.skin() } -> std::same_as<double>;
  { surface.crease_cosine() } -> std::same_as<double>;
  { surface.first_stop(p, p, resting) } -> std::same_as<proxy_stop>;
  { surface.plane(0, p) } -> std::same_as<proxy_plane<S::dimension>>;
  { surface.holds(0, p) } -> std::same_as<bool>;
  { surface.clearance(p, hint) } -> std::same_as<double>;
  { surface.is_solid() } -> std::same_as<bool>;
  { surface.entry(p) } -> std::same_as<point<S::dimension>>;
};

/// Any ProxySurface, by virtual functions: each as of the concept.
template <int D>
class any_proxy_surface {
 public:
  static constexpr int dimension = D;                                    ///< d
  virtual ~any_proxy_surface() = default;                                ///< Of any.
  virtual double skin() const = 0;                                       ///< [m]
  virtual double crease_cosine() const = 0;                              ///< [1]
  virtual proxy_plane<D> plane(int facet, const point<D>& p) const = 0;  ///< Under p.
  virtual bool holds(int facet, const point<D>& p) const = 0;            ///< Whether p rests on it.
  virtual double clearance(const point<D>& x, int& hint) const = 0;      ///< [m]
  virtual bool is_solid() const = 0;                                     ///< Or thin.
  virtual point<D> entry(const point<D>& x) const = 0;                   ///< [m]
  /// Where a way meets it.
  virtual proxy_stop first_stop(const point<D>& p, const point<D>& step,
                                std::span<const int> resting) const = 0;
};

/// A ProxySurface behind virtual functions. It refers to the surface, which must live longer.
template <ProxySurface S>
class proxy_surface_model final : public any_proxy_surface<S::dimension> {
  using at = point<S::dimension>;
  using plane_type = proxy_plane<S::dimension>;

 public:
  /// Of this surface.
  explicit proxy_surface_model(const S& surface) : s_(surface) {}

  double skin() const override { return s_.skin(); }                                   ///< [m]
  double crease_cosine() const override { return s_.crease_cosine(); }                 ///< [1]
  plane_type plane(int f, const at& p) const override { return s_.plane(f, p); }       ///< Under p.
  bool holds(int f, const at& p) const override { return s_.holds(f, p); }             ///< p on f.
  double clearance(const at& x, int& f) const override { return s_.clearance(x, f); }  ///< [m]
  bool is_solid() const override { return s_.is_solid(); }                             ///< Or thin.
  at entry(const at& x) const override { return s_.entry(x); }                         ///< [m]
  /// Where a way meets it.
  proxy_stop first_stop(const at& p, const at& step, std::span<const int> resting) const override {
    return s_.first_stop(p, step, resting);
  }

 private:
  const S& s_;
};

}  // namespace passive_haptics
