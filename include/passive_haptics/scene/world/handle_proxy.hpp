/// The proxy of a handle among all surfaces near it.
#pragma once

#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/proxy/proxy_contacts.hpp>

#include <algorithm>
#include <span>
#include <vector>

namespace passive_haptics::detail {

/// A proxy belongs to the handle, not to a surface: the surfaces near it are listed in each cycle, and all of
/// them stop it. It therefore stays in place when the handle slides from one surface to the next.
template <int D>
class handle_proxy {
 public:
  using surface = placed_surface<any_proxy_surface<D>>;  ///< A surface near the proxy.

  handle_proxy() = default;
  /// capacity: maximum number of surfaces. extent: maximum coordinate of the surfaces [m].
  handle_proxy(std::size_t capacity, double extent)
      : room_(capacity), before_(capacity), far_(1e3 * (1 + extent)) {}

  bool held() const { return tracker_.held; }  ///< True if a surface keeps the proxy from the handle.
  point<D> position() const { return point<D>(tracker_.position.data()); }  ///< Position, if held [m].
  /// True if it rests on a surface with a number accepted by `numbers`.
  template <class Numbers>
  bool rests_where(const Numbers& numbers) const {
    const auto& resting = tracker_.resting();
    return std::any_of(resting.begin(), resting.end(), [&](const auto& f) { return numbers(f.surface); });
  }
  bool rests_on(int number) const {
    return rests_where([number](int n) { return n == number; });
  }

  void forget_surfaces() { count_ = 0; }
  /// Adds a surface near it, with its displacement in the previous cycle [m].
  void add(const surface& s, const point<D>& before) {
    if (count_ == room_.size()) return;
    room_[count_] = s;
    before_[count_++] = before;
  }
  std::span<const surface> surfaces() const { return {room_.data(), count_}; }

  void start_at(const point<D>& p) {
    tracker_.held = is_here_ = true;
    tracker_.facet_count = 0;
    keep(p);
  }

  /// Moves towards a handle at x, as near as the surfaces allow; a free proxy starts at `from`.
  void go(const point<D>& from, const point<D>& x) {
    keep(within_reach(tracker_.held ? position() : from));
    if (is_here_ || !any_moved()) go_on(x);
    else go_with_surfaces(x);
    if (tracker_.held) return;
    for (const surface& s : surfaces()) {  // inside without a path: at the start or after a jump
      const point<D> at = x - s.displacement;
      int hint = 0;
      if (!s.surface->is_solid() || s.surface->clearance(at, hint) > 0) continue;
      const point<D> entry = s.surface->entry(at);
      if (entry == at) continue;
      start_at(entry + s.displacement);
      return go_on(x);
    }
  }

  /// Calls add(normal, depth, surface number) for each contact of a handle at x, at most D.
  template <class Add>
  void contacts_at(const point<D>& x, Add&& add) const {
    if (tracker_.held) proxy_contacts<any_proxy_surface<D>>(surfaces(), tracker_, x).add_to(add);
  }

  const proxy_tracker<D>& tracker() const { return tracker_; }  ///< State of the handle without the surfaces.
  void set_tracker(const proxy_tracker<D>& t) {
    tracker_ = t;
    is_here_ = false;
  }
  /// Takes over the proxy from other surfaces; is_here(number) is true for a surface that exists here, too.
  template <class IsHere>
  void take_over(const handle_proxy& other, const IsHere& is_here) {
    set_tracker(other.tracker_);
    tracker_.facet_count = 0;
    for (const facet_of_surface& f : other.tracker_.resting())
      if (is_here(f.surface)) nth(tracker_.facets, tracker_.facet_count++) = f;
  }

 private:
  void keep(const point<D>& p) { point<D>::Map(tracker_.position.data()) = p; }
  void go_on(const point<D>& x) {
    is_here_ = false;
    proxy_path<any_proxy_surface<D>>(surfaces(), tracker_).go_to(within_reach(x));
  }

  // Limits coordinates with rounding thicker than a skin.
  point<D> within_reach(const point<D>& x) const { return x.cwiseMax(-far_).cwiseMin(far_); }

  bool any_moved() const {
    for (std::size_t k = 0; k < count_; ++k)
      if (room_[k].displacement != before_[k]) return true;
    return false;
  }
  point<D> moved_by(std::size_t k) const { return room_[k].displacement - before_[k]; }

  // Linear motion of surfaces and handle. A free proxy follows the handle until a surface meets it, then
  // moves with its resting facets.
  void go_with_surfaces(const point<D>& x) {
    point<D> p = position();
    double time = 0;
    if (!tracker_.held) {
      const auto [met, place] = first_met(p, x);
      if (met.facet < 0) return keep(x);
      time = met.time;
      p += time * (x - p);
      tracker_.facets[0] = {room_[place].number, met.facet};
      tracker_.facet_count = 1;
    }
    point<D> at = carried(p, time);
    for (std::size_t k = 0; k < count_; ++k) {
      const point<D> now = room_[k].displacement, then = now - (1 - time) * moved_by(k);
      if (p - then == at - now) continue;
      const surface alone{room_[k].surface, point<D>::Zero(), room_[k].number};
      proxy_tracker<D> seen_from_it;
      point<D>::Map(seen_from_it.position.data()) = p - then;
      proxy_path<any_proxy_surface<D>>({&alone, 1}, seen_from_it).go_to(at - now);
      if (seen_from_it.held) at = point<D>(seen_from_it.position.data()) + now;
    }
    keep(at);
    go_on(x);
  }

  struct meeting {
    proxy_stop met;
    std::size_t place = 0;
  };
  meeting first_met(const point<D>& p, const point<D>& x) const {
    meeting first;
    for (std::size_t k = 0; k < count_; ++k) {
      const point<D> start = p - before_[k], end = within_reach(x) - room_[k].displacement;
      const proxy_stop met = room_[k].surface->first_stop(start, end - start, {});
      if (met.facet >= 0 && (first.met.facet < 0 || met.time < first.met.time)) first = {met, k};
    }
    return first;
  }

  // Displacement of p by its resting facets in the rest of the cycle, by the shortest path
  point<D> carried(const point<D>& p, double time) const {
    constexpr int sweeps = 8;
    point<D> way = point<D>::Zero();
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      for (const facet_of_surface& f : tracker_.resting()) {
        const surface* s = surface_of(surfaces(), f.surface);
        if (s == nullptr) continue;
        const point<D> moved = (1 - time) * moved_by(static_cast<std::size_t>(s - room_.data()));
        const point<D> n = s->surface->plane(f.facet, p - s->displacement + moved).normal;
        way += n.dot(moved - way) * n;
      }
    }
    return p + way;
  }

  proxy_tracker<D> tracker_;
  std::vector<surface> room_;     // fixed size: the control loop does not allocate
  std::vector<point<D>> before_;  // their displacements in the previous cycle [m]
  std::size_t count_ = 0;
  double far_ = 0;        // [m]
  bool is_here_ = false;  // placed in this cycle: no surface has moved since
};

}  // namespace passive_haptics::detail
