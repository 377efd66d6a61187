/// @file
/// A proxy: the point on the free side of a mesh that stands for a handle behind it.
///
/// References: C. B. Zilles, J. K. Salisbury, A constraint-based god-object method for haptic display, IROS
/// 1995, pp. 146-151; D. C. Ruspini, K. Kolarov, O. Khatib, The haptic display of complex graphical
/// environments, SIGGRAPH 1997, pp. 345-352.
#pragma once

#include <passive_haptics/core/linear/space_cone.hpp>
#include <passive_haptics/scene/mesh/facet_slab.hpp>
#include <passive_haptics/scene/mesh/mesh.hpp>

#include <algorithm>
#include <array>
#include <bit>

namespace passive_haptics {

/// What is remembered of one handle at one mesh.
template <int D>
struct proxy_tracker {
  /// Facets on which a proxy rests at once; of more, some wait.
  static constexpr int max_facets = 4 * (D - 1);

  bool known = false;  ///< Whether the handle was seen.
  bool held = false;   ///< Whether the surface keeps the proxy from the handle; else they are in one place.
  std::array<double, static_cast<std::size_t>(D)> position{};  ///< Of the proxy, if held [m].
  std::array<int, std::size_t(max_facets)> facets{};           ///< On which it rests, if held.
  int facet_count = 0;                                         ///< How many.
  int nearest = 0;  ///< A facet that was nearest: where to search first.
};

namespace detail {

/// The way of a proxy towards the handle in one cycle. It stays a skin in front of the facets that it meets;
/// none lets it from the front to the back, since each straight part of its way ends where a facet's slab
/// begins.
template <int D>
class proxy_way {
 public:
  /// Goes on from where the tracker says.
  proxy_way(const mesh<D>& surface, double skin, proxy_tracker<D>& tracker)
      : surface_(surface), skin_(skin), tracker_(tracker), p_(tracker.position.data()) {}

  /// As near to x as the surface lets it.
  void go_to(const point<D>& x) {
    for (int move = 0; move < max_moves; ++move) {
      leave_facets();
      const point<D> wanted = x - p_;
      const point<D> step = along_facets(wanted);
      const bool free = active_ == 0;
      if (!free && !(step.norm() > lip())) break;
      const auto [time, facet] = first_stop(step, false);
      if (facet < 0 && free) {
        tracker_.held = false;
        tracker_.facet_count = 0;
        keep(x);
        return;
      }
      p_ += time * step;
      if (facet >= 0) rest_on(facet);
    }
    rise();
    tracker_.held = true;
    keep(p_);
  }

 private:
  // Straight parts in one cycle; where they do not suffice the proxy lags, on the free side.
  static constexpr int max_moves = 64;
  static constexpr int max_facets = proxy_tracker<D>::max_facets;

  struct hit {
    double time;  // in [0, 1]
    int facet;    // -1 if none
  };

  double lip() const { return lip_by_skin * skin_; }
  facet_slab<D> slab(int facet) const { return {surface_[facet], skin_, lip()}; }
  int& resting(int k) { return tracker_.facets[static_cast<std::size_t>(k)]; }
  void keep(const point<D>& at) { point<D>::Map(tracker_.position.data()) = at; }

  // Facets that the proxy has slid off hold it no longer.
  void leave_facets() {
    const auto begin = tracker_.facets.begin();
    const auto left = [&](int facet) { return !slab(facet).holds(p_); };
    tracker_.facet_count =
        static_cast<int>(std::remove_if(begin, begin + tracker_.facet_count, left) - begin);
  }

  // The part of the wanted step that enters no facet on which the proxy rests: its projection on { s : n . s
  // >= 0 }.
  point<D> along_facets(const point<D>& wanted) {
    active_ = 0;
    const double length = wanted.norm();
    if (tracker_.facet_count == 0 || !(length > 0)) return wanted;
    matrix<double, D, max_facets> B = matrix<double, D, max_facets>::Zero();
    for (int k = 0; k < tracker_.facet_count; ++k) B.col(k) = -surface_[resting(k)].normal;
    const auto projection = project_onto_half_spaces<double, D, max_facets>(B, wanted / length);
    active_ = projection.active;
    return active_ == 0 ? wanted : point<D>(length * projection.point);
  }

  // A full list first loses a facet that did not hold the last step back; at most D did.
  void rest_on(int facet) {
    if (tracker_.facet_count == max_facets)
      resting(std::countr_one(active_)) = resting(--tracker_.facet_count);
    resting(tracker_.facet_count++) = facet;
  }

  bool rests_on(int facet) {
    const auto begin = tracker_.facets.begin(), end = begin + tracker_.facet_count;
    return std::find(begin, end, facet) != end;
  }

  // The slab that the step enters first; those of the facets on which the proxy rests only if resting_too.
  hit first_stop(const point<D>& step, bool resting_too) {
    const auto entry = [&](const four_outer_boxes<D>& boxes) {
      return typename four_outer_boxes<D>::four([&](int k) {
        part_of_way way;
        for (int i = 0; i < D; ++i) {
          const auto axis = static_cast<std::size_t>(i);
          way.keep_between(p_[i], step[i], double(boxes.lower[axis][k]) - 2 * skin_,
                           double(boxes.upper[axis][k]) + 2 * skin_);
        }
        return way.empty() ? 2.f : static_cast<float>(way.first);
      });
    };
    hit first{1, -1};
    auto search = surface_.tree().start();
    surface_.tree().go_on(search, entry, first.time, [&](int place, double) {
      const int i = surface_.tree().item(place);
      const double time = slab(i).stop(p_, step);
      const bool sooner = time < first.time || (time <= first.time && first.facet < 0);
      if (sooner && (resting_too || !rests_on(i))) first = {time, i};
    });
    return first;
  }

  // Round a convex edge the height over the next facet is the lower the sharper the edge is: back to the
  // skin.
  void rise() {
    constexpr double low = 0.9;  // of the skin
    for (int k = 0; k < tracker_.facet_count; ++k) {
      const auto& f = surface_[resting(k)];
      const double height = f.height(p_);
      if (!(height < low * skin_)) continue;
      const point<D> step = (skin_ - height) * f.normal;
      p_ += first_stop(step, true).time * step;
    }
  }

  static constexpr double lip_by_skin = 1e-3;

  const mesh<D>& surface_;
  double skin_;
  proxy_tracker<D>& tracker_;
  point<D> p_;
  half_space_set active_ = 0;
};

}  // namespace detail
}  // namespace passive_haptics
