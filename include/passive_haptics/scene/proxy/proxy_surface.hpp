/// The ProxySurface concept: surfaces that stop a proxy, the point on the free side of all surfaces that
/// represents a handle which may be behind them.
///
/// References: C. B. Zilles, J. K. Salisbury, A constraint-based god-object method for haptic display, IROS
/// 1995, pp. 146-151; D. C. Ruspini, K. Kolarov, O. Khatib, The haptic display of complex graphical
/// environments, SIGGRAPH 1997, pp. 345-352.
#pragma once

#include <passive_haptics/scene/shape.hpp>

#include <concepts>
#include <span>

namespace passive_haptics {

/// The point at which a straight motion p + t step, t in [0, 1], meets a surface.
struct proxy_stop {
  double time = 1;  ///< t
  int facet = -1;   ///< Facet at that point; -1 for none.
};

/// The plane of a facet.
template <int D>
struct proxy_plane {
  point<D> normal;    ///< Unit, to the free side.
  point<D> position;  ///< Point of the plane [m].

  /// Height of x over the plane [m].
  double height(const point<D>& x) const { return normal.dot(x - position); }
};

/// A surface of facets that stops motion from front to back. A smooth shape is one facet.
///
/// Minimal complete definition, positions in the frame of the surface [m]:
///   - `static constexpr int dimension`;
///   - `double skin() const`: distance at which a proxy stays in front of the surface [m] > 0;
///   - `double crease_cosine() const`: facets with normals n, m are one smooth surface if n . m exceeds it;
///   - `proxy_stop first_stop(const point<d>& p, const point<d>& step, std::span<const int> resting) const`:
///     first point on the motion from p, in front of the surface, that is nearer than a skin. Resting facets
///     stop the proxy only if the motion would pass through them;
///   - `proxy_plane<d> plane(int facet, const point<d>& p) const`: the facet's plane under p;
///   - `bool holds(int facet, const point<d>& p) const`: true if a proxy at p, a skin high, rests on the
///     facet;
///   - `double clearance(const point<d>& x, int& hint) const`: distance from x within which nothing stops a
///     proxy [m]; <= 0 inside a solid. hint: start facet of a search, updated;
///   - `bool is_solid() const`: false for a thin surface;
///   - `point<d> entry(const point<d>& x) const`: assumed origin of a handle that is first seen at x: x, or
///     the nearest point outside a solid.
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

/// ProxySurface by virtual functions, see there.
template <int D>
class any_proxy_surface {
 public:
  static constexpr int dimension = D;                                    ///< d
  virtual ~any_proxy_surface() = default;                                ///< Virtual.
  virtual double skin() const = 0;                                       ///< [m]
  virtual double crease_cosine() const = 0;                              ///< [1]
  virtual proxy_plane<D> plane(int facet, const point<D>& p) const = 0;  ///< Plane under p.
  virtual bool holds(int facet, const point<D>& p) const = 0;            ///< True if p rests on it.
  virtual double clearance(const point<D>& x, int& hint) const = 0;      ///< [m]
  virtual bool is_solid() const = 0;                                     ///< False if thin.
  virtual point<D> entry(const point<D>& x) const = 0;                   ///< [m]
  /// First stop of a motion.
  virtual proxy_stop first_stop(const point<D>& p, const point<D>& step,
                                std::span<const int> resting) const = 0;
};

/// Makes any ProxySurface an any_proxy_surface. It refers to the surface, which must live longer.
template <ProxySurface S>
class proxy_surface_model final : public any_proxy_surface<S::dimension> {
  using at = point<S::dimension>;
  using plane_type = proxy_plane<S::dimension>;

 public:
  explicit proxy_surface_model(const S& surface) : s_(surface) {}  ///< Refers to the surface.

  double skin() const override { return s_.skin(); }                              ///< [m]
  double crease_cosine() const override { return s_.crease_cosine(); }            ///< [1]
  plane_type plane(int f, const at& p) const override { return s_.plane(f, p); }  ///< Plane under p.
  bool holds(int f, const at& p) const override { return s_.holds(f, p); }        ///< True if p rests on f.
  double clearance(const at& x, int& f) const override { return s_.clearance(x, f); }  ///< [m]
  bool is_solid() const override { return s_.is_solid(); }                             ///< False if thin.
  at entry(const at& x) const override { return s_.entry(x); }                         ///< [m]
  /// First stop of a motion.
  proxy_stop first_stop(const at& p, const at& step, std::span<const int> resting) const override {
    return s_.first_stop(p, step, resting);
  }

 private:
  const S& s_;
};

}  // namespace passive_haptics
