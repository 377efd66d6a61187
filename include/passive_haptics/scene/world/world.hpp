/// Scenes of many walls, made at run time.
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/scene/world/handle_proxy.hpp>
#include <passive_haptics/scene/world/neighbour_list.hpp>
#include <passive_haptics/scene/world/strongest_contacts.hpp>
#include <passive_haptics/scene/world/world_geometry.hpp>

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

namespace passive_haptics {

/// Many walls, of which each cycle checks only those that the handle may have reached (neighbour_list.hpp).
/// At most Capacity contacts, those with the maximum forces.
///
/// Copies share the immutable walls, and each has its own state of the handle. Walls without finite bounds,
/// moving walls and mesh_surface are compared in each cycle that is not skipped: keep them few. Only
/// construction, O(n log n), allocates.
///
/// A world keeps a proxy of the handle (handle_proxy.hpp) for a mesh, a plate or bar thinner than 1 cm, or
/// two solids at rest, over 1 cm wide, with bounds that meet or overlap. Thin walls then hold at any depth,
/// and adjacent walls feel like one, for up to 2000 more instructions in contact. If adjacent solids move,
/// make one of them a mesh_solid.
template <int D, int Capacity = D + 1>
class world {
 public:
  static constexpr int dimension = D;           ///< d
  using contacts_type = contacts<D, Capacity>;  ///< Type of the contacts.

  /// Throws std::invalid_argument with the text of validate(walls).
  explicit world(const world_walls<D>& walls)
      : geometry_(std::make_shared<const geometry>(require_valid(walls))) {
    near_ = neighbour_list<D>(geometry_->others.size(), geometry_->extent);
    motions_.resize(geometry_->moving.size());
    trackers_.resize(geometry_->trackers.back());
    if (geometry_->needs_proxy) proxy_ = detail::handle_proxy<D>(walls.all().size(), geometry_->extent);
    nearest_.resize(geometry_->others.size());
    start_trackers();
  }

  /// Returns the contacts at x [m] in the order of their walls, valid until the next call. NaN or infinity in
  /// x gives a contact with a NaN depth, which the step reports.
  const contacts_type& touched_at(const point<D>& x) {
    found_.clear();
    if (!near_.idle(x)) {
      if (!all_finite(x)) {
        found_.add({.depth = std::numeric_limits<double>::quiet_NaN()});
        return found_.in_order();
      }
      if (geometry_->needs_proxy) follow(x);
      else near_.visit(geometry_->tree, x, [&](world_item item) { return look(item, x); });
    }
    previous_ = x;
    return found_.in_order();
  }

  /// Reports contacts from this distance to each wall [m] >= 0, with a depth < 0 before the touch; a
  /// TrackedShape ignores it. A changed margin costs the search of a jump.
  void set_margin(double margin) {
    margin_ = margin;
    near_.set_margin(std::max(margin, reach_));
  }

  /// Number of contacts at the latest x that exceeded Capacity.
  int left_out() const { return found_.left_out(); }

  /// Moves a wall of add_moving: displacement from its original place [m], velocity of its surface [m/s]; see
  /// `moving`. Returns false without effect if there is no such wall or the values are not finite.
  bool set_motion(int number, const point<D>& displacement, const point<D>& velocity) {
    const auto& moving = geometry_->moving;
    const auto found = std::lower_bound(moving.begin(), moving.end(), number);
    if (found == moving.end() || *found != number || !all_finite(displacement, velocity)) return false;
    const auto k = static_cast<std::size_t>(found - moving.begin());
    motions_[k].displacement = displacement;
    motions_[k].velocity = velocity;
    move(k, displacement);
    return true;
  }

  /// Extrapolates moving walls by this time [s] from the values of set_motion.
  void extrapolate(double seconds) {
    for (std::size_t k = 0; k < motions_.size(); ++k) {
      const point<D> ahead = motions_[k].displacement + seconds * motions_[k].velocity;
      if (all_finite(ahead)) move(k, ahead);
    }
  }

  /// Forgets the handle, for another handle or after a fault.
  void reset() {
    near_.reset();
    start_trackers();
    previous_.setConstant(std::numeric_limits<double>::quiet_NaN());
  }

  /// Takes over the state of the handle at the walls that both worlds share (copies of one any_wall with one
  /// number), so that it does not slip through them at an exchange of scenes.
  void remember(const world& other) noexcept {
    const geometry &mine = *geometry_, &others = *other.geometry_;
    const auto is_here = [&](int number) { return mine.shares_wall(others, number); };
    previous_ = other.previous_;
    for (std::size_t k = 0; k < std::min(mine.others.size(), others.others.size()); ++k) {
      if (!mine.shares(others, k)) continue;
      nearest_[k] = other.nearest_[k];
      std::copy_n(other.trackers_.begin() + others.tracker_at(k), mine.tracker_at(k + 1) - mine.tracker_at(k),
                  trackers_.begin() + mine.tracker_at(k));
      if (k < std::min(motions_.size(), other.motions_.size()))
        motions_[k].take_over(other.motions_[k], previous_);
    }
    if (other.proxy_.rests_where([&](int n) { return others.item_of(n).is_in_tree() || is_here(n); }))
      proxy_.take_over(other.proxy_, is_here);
  }

 private:
  using geometry = detail::world_geometry<D>;
  using numbered_wall = typename geometry::numbered_wall;
  using motion = detail::wall_motion<D>;

  void move(std::size_t k, const point<D>& to) {
    near_.moved(k, (to - motions_[k].now).norm());
    motions_[k].go_to(to, geometry_->remembers() ? &previous_ : nullptr);
  }

  void start_trackers() {
    for (std::size_t k = 0; k < geometry_->others.size(); ++k)
      geometry_->others[k].wall.start_tracker(tracker(k));
    std::fill(nearest_.begin(), nearest_.end(), not_seen);
    proxy_.set_tracker({});
    keep_within(0);
  }
  void* tracker(std::size_t other) { return trackers_.data() + geometry_->trackers[other]; }

  motion* motion_of(world_item item) {
    return !item.is_in_tree() && item.place() < motions_.size() ? &motions_[item.place()] : nullptr;
  }

  // Repeats a first stop with all surfaces near, since the proxy may slide off the path
  [[gnu::noinline]] void follow(const point<D>& x) {
    const auto before = proxy_.tracker();
    const point<D> from = all_finite(previous_) ? previous_ : x;
    go(from, x, before.held ? (x - proxy_.position()).norm() : 0);
    if (proxy_.held() && !before.held) {
      const double way = std::max((x - from).norm(), (x - proxy_.position()).norm());
      proxy_.set_tracker(before);
      go(from, x, way);
    }
    if (!proxy_.held()) keep_within(0);
    std::replace(nearest_.begin(), nearest_.end(), not_seen, 0);
    for (const auto& s : proxy_.surfaces())
      if (motion* m = motion_of(geometry_->item_of(s.number))) m->before = m->now;
    proxy_.contacts_at(x, [&](const point<D>& normal, double depth, int number) {
      touched_.clear();
      const world_item item = geometry_->item_of(number);
      const motion m = motion_of(item) ? *motion_of(item) : motion();
      contact<D> c = geometry_->wall_of(item).wall.contact_by_proxy(proxy_.position() - m.now);
      c.normal = normal;
      if (!std::isnan(c.depth)) c.depth = depth;
      c.wall_velocity += m.velocity;
      touched_.append_unchecked(c);
      add_touched(number, x);
    });
  }

  // reach: distance from x within which a surface may stop the proxy [m]
  void go(const point<D>& from, const point<D>& x, double reach) {
    if (reach > reach_) keep_within(2 * reach);
    found_.clear();
    proxy_.forget_surfaces();
    near_.visit(geometry_->tree, x, [&](world_item item) { return look_at_surface(item, x); });
    proxy_.go(from, x);
  }

  void keep_within(double reach) {
    if (reach == reach_) return;
    reach_ = reach;
    near_.set_margin(std::max(margin_, reach));
  }

  // At an item that may stop the proxy. A shape reports contacts before the touch itself
  double look_at_surface(world_item item, const point<D>& x) {
    const numbered_wall& w = geometry_->wall_of(item);
    const auto* surface = w.wall.surface();
    if (surface == nullptr) return look(item, x);
    const motion m = motion_of(item) ? *motion_of(item) : motion();
    proxy_.add({surface, m.now, w.number}, m.before_cycle(previous_));
    if (proxy_.rests_on(w.number)) return 0;
    if (surface->is_solid()) {
      const double distance = sense_wall(w, item, x) + margin_;
      if (touched_.empty() || !(touched_[0].depth > 0)) add_touched(w.number, x);
      return std::max(0.0, distance - std::max(margin_, reach_));
    }
    int& nearest = nearest_[item.place()];
    int hint = std::max(nearest, 0);
    const point<D> at = x - m.now;
    const double clearance = surface->clearance(at, hint);
    if (nearest != not_seen) nearest = hint;
    else if (const point<D> entry = surface->entry(at); entry != at) proxy_.start_at(entry + m.now);
    return std::max(0.0, clearance - std::max(margin_, reach_));
  }

  double look(world_item item, const point<D>& x) {
    const numbered_wall& w = geometry_->wall_of(item);
    const double distance = sense_wall(w, item, x);
    add_touched(w.number, x);
    return distance;
  }
  PASSIVE_HAPTICS_INLINE double sense_wall(const numbered_wall& w, world_item item, const point<D>& x) {
    touched_.clear();
    if (item.is_in_tree()) return w.wall.look(x, x, margin_, nullptr, touched_);
    const std::size_t k = item.place();
    if (k >= motions_.size()) return w.wall.look(previous_, x, margin_, tracker(k), touched_);
    motion& m = motions_[k];
    const point<D> from = w.is_followed ? point<D>(previous_ - m.before_cycle(previous_)) : x;
    const double distance = w.wall.look(from, x - m.now, margin_, tracker(k), touched_);
    if (w.is_followed) m.before = m.now;
    for (contact<D>& c : touched_) c.wall_velocity += m.velocity;
    return distance;
  }
  PASSIVE_HAPTICS_INLINE void add_touched(int number, const point<D>& x) {
    for (contact<D>& c : touched_) {
      c.wall_number = number;
      c.sensed_at = x;
      found_.add(c);
    }
  }

  std::shared_ptr<const geometry> geometry_;
  neighbour_list<D> near_;
  point<D> previous_ = point<D>::Constant(std::numeric_limits<double>::quiet_NaN());  // in the last cycle
  std::vector<motion> motions_;  // in the order of walls.moving()
  std::vector<typename geometry::tracker_bytes> trackers_;
  static constexpr int not_seen = -1;
  std::vector<int> nearest_;  // by other item: start facet of the next search
  detail::handle_proxy<D> proxy_;
  double margin_ = 0;       // [m]
  double reach_ = 0;        // distance within which surfaces may stop the proxy [m]
  contacts<D, D> touched_;  // of one wall, by sense_wall
  strongest_contacts<D, Capacity> found_;
};

}  // namespace passive_haptics
