/// The motion of a proxy towards its handle.
#pragma once

#include <passive_haptics/core/linear/cone.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/proxy/proxy_surface.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <span>

namespace passive_haptics {

/// A facet of one of several surfaces.
struct facet_of_surface {
  int surface;  ///< Number of the surface.
  int facet;    ///< Index of the facet.

  bool operator==(const facet_of_surface&) const = default;  ///< True for the same facet.
};

/// State of the proxy of one handle.
template <int D>
struct proxy_tracker {
  static constexpr int max_facets = 4 * (D - 1);  ///< Maximum number of resting facets.

  bool known = false;  ///< True once the handle was seen.
  bool held = false;   ///< True if a surface keeps the proxy from the handle.
  std::array<double, static_cast<std::size_t>(D)> position{};      ///< Position of the proxy, if held [m].
  std::array<facet_of_surface, std::size_t(max_facets)> facets{};  ///< Resting facets, if held.
  int facet_count = 0;                                             ///< Number of resting facets.
  int nearest = 0;                                                 ///< Start facet of the next search.

  /// The resting facets.
  std::span<const facet_of_surface> resting() const {
    return {facets.data(), static_cast<std::size_t>(facet_count)};
  }
};

/// A surface at its position in this cycle.
template <class S>
struct placed_surface {
  const S* surface;                  ///< The surface.
  point<S::dimension> displacement;  ///< Displacement from its original position [m].
  int number;                        ///< Number that facets refer to.

  /// The plane of a facet under p [m].
  auto plane(int facet, const point<S::dimension>& p) const {
    auto under_p = surface->plane(facet, p - displacement);
    under_p.position += displacement;
    return under_p;
  }
};

namespace detail {

template <class S>
const placed_surface<S>* surface_of(std::span<const placed_surface<S>> surfaces, int number) {
  const auto found = std::find_if(surfaces.begin(), surfaces.end(),
                                  [number](const placed_surface<S>& s) { return s.number == number; });
  return found == surfaces.end() ? nullptr : &*found;
}

/// The motion of a proxy towards the handle in one cycle, a skin in front of the surfaces it meets. Each
/// straight part ends where a surface stops it, so it cannot pass from front to back.
template <class S>
class proxy_path {
  static constexpr int D = S::dimension;

 public:
  proxy_path(std::span<const placed_surface<S>> surfaces, proxy_tracker<D>& tracker)
      : surfaces_(surfaces), tracker_(tracker), p_(tracker.position.data()) {
    for (const auto& s : surfaces_) lip_ = std::min(lip_, lip_by_skin * s.surface->skin());
  }

  void go_to(const point<D>& x) {
    if (goes_over(x)) return;
    for (int move = 0; move < max_moves; ++move) {
      leave_facets();
      const point<D> step = along_facets(x);
      const bool free = active_ == 0;
      if (!free && !(step.norm() > lip_)) break;
      const auto [time, facet] = first_stop(p_, step, false);
      if (facet.facet < 0 && free) {
        tracker_.held = false;
        tracker_.facet_count = 0;
        keep(x);
        return;
      }
      p_ += time * step;
      if (facet.facet >= 0) rest_on(facet);
    }
    tracker_.held = true;
    keep(p_);
  }

 private:
  // Straight parts in one cycle; if they do not suffice, the proxy lags on the free side.
  static constexpr int max_moves = 64;
  static constexpr int max_facets = proxy_tracker<D>::max_facets;
  static constexpr double lip_by_skin = 1e-3;

  struct stop {
    double time;             // -1 for none
    facet_of_surface facet;  // -1 if none
  };

  facet_of_surface& resting(int k) { return nth(tracker_.facets, k); }
  void keep(const point<D>& at) { point<D>::Map(tracker_.position.data()) = at; }

  // Fast path for one resting facet: moves to the place over x on it, straight or round one edge of a shape.
  bool goes_over(const point<D>& x) {
    constexpr double low = 10;  // skins; a step along a solid ball enters it by length^2 / (8 radius)
    constexpr double other_side = -0.5;  // cosine of the turn; a larger turn could pass a thin shape
    if (tracker_.facet_count != 1) return false;
    const auto* s = surface_of(surfaces_, resting(0).surface);
    if (s == nullptr) return false;
    const auto over = s->plane(resting(0).facet, x);
    const double skin = s->surface->skin(), height = over.height(x), rise = skin - over.height(p_);
    const point<D> goal = x + (skin - height) * over.normal;
    if (!(height < skin) || !s->surface->holds(resting(0).facet, goal - s->displacement)) return false;
    point<D> edge = p_;
    if (rise > low * skin) {
      const point<D> here = s->plane(resting(0).facet, p_).normal;
      const double cosine = here.dot(over.normal);
      if (!(cosine > other_side) || !(cosine < 1)) return false;
      edge += rise / (1 - cosine * cosine) * (over.normal - cosine * here);
      if (!is_free(p_, edge)) return false;
    }
    if (!is_free(edge, goal)) return false;
    tracker_.held = true;
    keep(goal);
    return true;
  }

  void leave_facets() {
    const auto begin = tracker_.facets.begin();
    const auto left = [&](const facet_of_surface& f) {
      const auto* s = surface_of(surfaces_, f.surface);
      return s == nullptr || !s->surface->holds(f.facet, p_ - s->displacement);
    };
    tracker_.facet_count =
        static_cast<int>(std::remove_if(begin, begin + tracker_.facet_count, left) - begin);
  }

  // The displacement to x, projected on the directions s with n . s >= 0 for all resting facets.
  point<D> along_facets(const point<D>& x) {
    active_ = 0;
    matrix<double, D, max_facets> B = matrix<double, D, max_facets>::Zero();
    for (int k = 0; k < tracker_.facet_count; ++k) B.col(k) = -rise_over(resting(k));
    const point<D> wanted = x - p_;
    if (tracker_.facet_count <= 1) {
      const double into = B.col(0).dot(wanted);
      active_ = into > 0 ? 1 : 0;
      return into > 0 ? point<D>(wanted - into * B.col(0)) : wanted;
    }
    const double length = wanted.norm();
    if (!(length > 0)) return wanted;
    const auto projection = project_onto_half_spaces<double, D, max_facets>(B, wanted / length);
    active_ = projection.active;
    return active_ == 0 ? wanted : point<D>(length * projection.point);
  }

  // A full list first loses a facet that did not limit the last step; at most D did.
  void rest_on(const facet_of_surface& facet) {
    const auto begin = tracker_.facets.begin(), end = begin + tracker_.facet_count;
    if (std::find(begin, end, facet) != end) return;
    if (tracker_.facet_count == max_facets)
      resting(std::countr_one(active_)) = resting(--tracker_.facet_count);
    resting(tracker_.facet_count++) = facet;
  }

  bool is_free(const point<D>& from, const point<D>& to) const {
    return first_stop(from, to - from, false).facet.facet < 0;
  }

  // Returns the first surface on the step. raised: also consider resting facets.
  stop first_stop(const point<D>& from, const point<D>& step, bool raised) const {
    stop first{1, {-1, -1}};
    for (const auto& s : surfaces_) {
      std::array<int, std::size_t(max_facets)> facets;
      std::size_t count = 0;
      for (const auto& f : tracker_.resting())
        if (!raised && f.surface == s.number) facets[count++] = f.facet;
      const auto met = s.surface->first_stop(from - s.displacement, step, {facets.data(), count});
      if (met.facet < 0 || !(met.time < first.time || first.facet.facet < 0)) continue;
      first = {met.time, {s.number, met.facet}};
    }
    return first;
  }

  // Raises the proxy to a skin over a resting facet; returns the normal. It sinks at sharp convex edges and
  // along hollow shapes.
  point<D> rise_over(const facet_of_surface& f) {
    constexpr double low = 0.9;  // fraction of the skin
    const auto* s = surface_of(surfaces_, f.surface);
    const auto plane = s->plane(f.facet, p_);
    const double skin = s->surface->skin(), height = plane.height(p_);
    if (height < low * skin) {
      const point<D> step = (skin - height) * plane.normal;
      p_ += first_stop(p_, step, true).time * step;
    }
    return plane.normal;
  }

  std::span<const placed_surface<S>> surfaces_;
  proxy_tracker<D>& tracker_;
  point<D> p_;
  double lip_ = std::numeric_limits<double>::infinity();  // minimum length of a step [m]
  half_space_set active_ = 0;
};

}  // namespace detail
}  // namespace passive_haptics
