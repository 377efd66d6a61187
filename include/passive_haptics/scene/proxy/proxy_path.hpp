/// @file
/// The way of a proxy towards its handle.
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
  int surface;  ///< The number of the surface.
  int facet;    ///< Of its facets.

  /// Whether both are one facet.
  bool operator==(const facet_of_surface&) const = default;
};

/// What is remembered of one handle.
template <int D>
struct proxy_tracker {
  /// Facets on which a proxy rests at once; of more, some wait.
  static constexpr int max_facets = 4 * (D - 1);

  bool known = false;  ///< Whether the handle was seen.
  bool held = false;   ///< Whether a surface keeps the proxy from the handle; else they are in one place.
  std::array<double, static_cast<std::size_t>(D)> position{};      ///< Of the proxy, if held [m].
  std::array<facet_of_surface, std::size_t(max_facets)> facets{};  ///< On which it rests, if held.
  int facet_count = 0;                                             ///< How many.
  int nearest = 0;  ///< A facet that was nearest: where to search first.

  /// The facets on which it rests.
  std::span<const facet_of_surface> resting() const {
    return {facets.data(), static_cast<std::size_t>(facet_count)};
  }
};

/// A surface where it is in this cycle.
template <class S>
struct placed_surface {
  const S* surface;                  ///< What stops a proxy.
  point<S::dimension> displacement;  ///< From where it was made [m].
  int number;                        ///< By which facets refer to it.

  /// The plane of a facet of it, under p [m].
  auto plane(int facet, const point<S::dimension>& p) const {
    auto under_p = surface->plane(facet, p - displacement);
    under_p.position += displacement;
    return under_p;
  }
};

namespace detail {

/// The surface of this number among some; nullptr if it is not among them.
template <class S>
const placed_surface<S>* surface_of(std::span<const placed_surface<S>> surfaces, int number) {
  const auto found = std::find_if(surfaces.begin(), surfaces.end(),
                                  [number](const placed_surface<S>& s) { return s.number == number; });
  return found == surfaces.end() ? nullptr : &*found;
}

/// The way of a proxy towards the handle in one cycle. It stays a skin in front of the surfaces that it
/// meets; none lets it from the front to the back, since each straight part of its way ends where a surface
/// stops it.
template <class S>
class proxy_path {
  static constexpr int D = S::dimension;

 public:
  /// Goes on from where the tracker says, among these surfaces.
  proxy_path(std::span<const placed_surface<S>> surfaces, proxy_tracker<D>& tracker)
      : surfaces_(surfaces), tracker_(tracker), p_(tracker.position.data()) {
    for (const auto& s : surfaces_) lip_ = std::min(lip_, lip_by_skin * s.surface->skin());
  }

  /// As near to x as the surfaces let it.
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
  // Straight parts in one cycle; where they do not suffice the proxy lags, on the free side.
  static constexpr int max_moves = 64;
  static constexpr int max_facets = proxy_tracker<D>::max_facets;
  static constexpr double lip_by_skin = 1e-3;

  struct stop {
    double time;             // in [0, 1]
    facet_of_surface facet;  // -1 if none
  };

  facet_of_surface& resting(int k) { return nth(tracker_.facets, k); }
  void keep(const point<D>& at) { point<D>::Map(tracker_.position.data()) = at; }

  // Goes to the place over x on the one facet on which the proxy rests, straight or round one edge of a
  // shape, if nothing is in between. Mostly this is all
  bool goes_over(const point<D>& x) {
    constexpr double low = 10;           // skins: a step along a solid ball comes in by length^2 / (8 radius)
    constexpr double other_side = -0.5;  // cosine of the turn: so a thin shape would be passed
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

  // Facets that the proxy has slid off hold it no longer.
  void leave_facets() {
    const auto begin = tracker_.facets.begin();
    const auto left = [&](const facet_of_surface& f) {
      const auto* s = surface_of(surfaces_, f.surface);
      return s == nullptr || !s->surface->holds(f.facet, p_ - s->displacement);
    };
    tracker_.facet_count =
        static_cast<int>(std::remove_if(begin, begin + tracker_.facet_count, left) - begin);
  }

  // The part of the way to x that enters no facet on which the proxy rests: its projection on the directions
  // s with n . s >= 0.
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

  // A full list first loses a facet that did not hold the last step back; at most D did.
  void rest_on(const facet_of_surface& facet) {
    const auto begin = tracker_.facets.begin(), end = begin + tracker_.facet_count;
    if (std::find(begin, end, facet) != end) return;
    if (tracker_.facet_count == max_facets)
      resting(std::countr_one(active_)) = resting(--tracker_.facet_count);
    resting(tracker_.facet_count++) = facet;
  }

  // True if nothing is in between, except the facets on which the proxy rests.
  bool is_free(const point<D>& from, const point<D>& to) const {
    return first_stop(from, to - from, false).facet.facet < 0;
  }

  // What the step meets first. raised: a facet on which the proxy rests stops it as others do.
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

  // Goes back to a skin over a facet on which the proxy rests, if it is lower; returns the normal. The
  // sharper a convex edge is, the lower it comes in over the next facet; and each step along a hollow shape
  // enters it
  point<D> rise_over(const facet_of_surface& f) {
    constexpr double low = 0.9;  // of the skin
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
  double lip_ = std::numeric_limits<double>::infinity();  // what is no step [m]
  half_space_set active_ = 0;
};

}  // namespace detail
}  // namespace passive_haptics
