/// @file
/// A scene of many walls, made at run time.
#pragma once

#include <passive_haptics/scene/neighbour_list.hpp>
#include <passive_haptics/scene/strongest_contacts.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace passive_haptics {

/// The walls of a world to be, numbered from 0 in the order in which they are added.
template <int D>
class world_walls {
 public:
  /// Adds a wall that stays where it is and returns its number.
  int add(any_wall<D> w) {
    walls_.push_back(std::move(w));
    return static_cast<int>(walls_.size()) - 1;
  }
  /// The same of a shape that is to be wrapped.
  template <class S>
  int add(const wall<S>& w) {
    return add(any_wall<D>(w));
  }

  /// Adds a wall that world::set_motion can move, and returns its number.
  template <class S>
  int add_moving(const wall<S>& w) {
    moving_.push_back(add(w));
    return moving_.back();
  }

  /// All walls, by their numbers.
  const std::vector<any_wall<D>>& all() const { return walls_; }
  /// The numbers of those that may move.
  const std::vector<int>& moving() const { return moving_; }

 private:
  std::vector<any_wall<D>> walls_;
  std::vector<int> moving_;
};

/// What is wrong with the walls; empty if nothing.
template <int D>
std::string validate(const world_walls<D>& walls) {
  for (std::size_t i = 0; i < walls.all().size(); ++i) {
    const bounding_box<D>& b = walls.all()[i].bounds();
    if (!(b.lower.array() <= b.upper.array()).all())
      return detail::indexed(
          "bounds of wall ", i,
          " of a world are not lower <= upper, expected a box of finite or infinite metres");
  }
  return {};
}

/// Many walls, of which a cycle looks at those that the handle can have reached since it last looked: the contacts are those
/// of a scan over all of them (neighbour_list.hpp). At most Capacity contacts, those of the largest forces.
///
/// The walls are shared by copies and never change; each copy has its own memory of the handle. Walls that stay where they are
/// and have finite bounds lie in a tree; the others (unbounded, moving or followed ones, TrackedShape) are compared one by one
/// in each cycle that is not skipped: keep them few. Cost: a comparison where nothing can have been reached; else
/// neighbour_list.hpp. Construction O(n log n); it alone allocates.
template <int D, int Capacity = D + 1>
class world {
 public:
  static constexpr int dimension = D;           ///< d
  using contacts_type = contacts<D, Capacity>;  ///< What sensing this world gives.

  /// Throws std::invalid_argument with the text of validate(walls).
  explicit world(world_walls<D> walls) : geometry_(std::make_shared<const geometry>(require_valid(walls))) {
    near_ = neighbour_list<D>(geometry_->others.size(), geometry_->tree.scale());
    motions_.resize(geometry_->walls.moving().size());
    trackers_.resize(geometry_->tracker_storage);
    start_trackers();
  }

  /// The contacts at x [m], in the order of their walls; valid until the next call. A NaN or infinity in x gives a contact
  /// with a NaN depth, which the step reports.
  const contacts_type& touched_at(const point<D>& x) {
    found_.clear();
    if (!near_.idle(x)) {
      if (!all_finite(x)) return undefined_contact();
      near_.visit(geometry_->tree, x,
                  [&](int item) { return item < 0 ? look_at_other(item, x) : look(item, x); });
    }
    previous_ = x;
    return found_.in_order();
  }

  /// How many contacts at the latest x found no room.
  int left_out() const { return found_.left_out(); }

  /// Moves a wall that was added by add_moving: displacement from where it was made [m], velocity of its surface
  /// [m/s]; base frame. Two values, as of `moving`. False, and nothing moved, if there is no such wall or they are not finite.
  bool set_motion(int number, const point<D>& displacement, const point<D>& velocity) {
    const auto& moving = geometry_->walls.moving();
    const auto found = std::lower_bound(moving.begin(), moving.end(), number);
    if (found == moving.end() || *found != number || !all_finite(displacement, velocity)) return false;
    const auto k = static_cast<std::size_t>(found - moving.begin());
    move(k, {displacement, velocity, displacement});
    return true;
  }

  /// Carries each moving wall on with its velocity for this time [s] from where set_motion put it.
  void extrapolate(double seconds) {
    for (std::size_t k = 0; k < motions_.size(); ++k) {
      const motion& m = motions_[k];
      const point<D> ahead = m.displacement + seconds * m.velocity;
      if (all_finite(ahead)) move(k, {m.displacement, m.velocity, ahead});
    }
  }

  /// Forgets the handle; for another handle, or after a fault.
  void reset() {
    near_.reset();
    start_trackers();
    previous_.setConstant(std::numeric_limits<double>::quiet_NaN());
  }

  /// Takes over what another world knows of the handle, if the walls that remember it are the same in both; so that it does
  /// not slip through them where a scene is exchanged.
  void remember(const world& other) {
    if (other.geometry_->tracked != geometry_->tracked || other.trackers_.size() != trackers_.size()) return;
    std::copy(other.trackers_.begin(), other.trackers_.end(), trackers_.begin());
    previous_ = other.previous_;
    for (std::size_t k = 0; k < std::min(motions_.size(), other.motions_.size()); ++k)
      motions_[k].seen = other.motions_[k].seen;
  }

  /// The walls.
  const world_walls<D>& walls() const { return geometry_->walls; }

 private:
  // What never changes
  struct geometry {
    explicit geometry(world_walls<D> w) : walls(std::move(w)), others(walls.moving()) {
      std::vector<bounding_box<D>> boxes;
      for (int i = 0; i < static_cast<int>(walls.all().size()); ++i) {
        if (std::binary_search(walls.moving().begin(), walls.moving().end(), i)) continue;
        const any_wall<D>& wall = at(i);
        if (wall.tracker_size() == 0 && all_finite(wall.bounds().lower, wall.bounds().upper)) {
          boxes.push_back(wall.bounds());
          in_tree.push_back(i);
        } else {
          others.push_back(i);
        }
      }
      tree = bounding_volume_tree<D>(boxes);
      for (const int i : others) {
        trackers.push_back(tracker_storage);
        tracker_storage += (at(i).tracker_size() + sizeof(std::max_align_t) - 1) / sizeof(std::max_align_t);
        if (at(i).tracker_size() > 0) tracked.push_back(i);
      }
    }

    const any_wall<D>& at(int number) const { return walls.all()[static_cast<std::size_t>(number)]; }

    world_walls<D> walls;
    std::vector<int> in_tree;  // numbers of the walls in the tree
    bounding_volume_tree<D> tree;
    std::vector<int> others;            // numbers of those outside, the moving ones first
    std::vector<std::size_t> trackers;  // where the tracker of each of these begins
    std::size_t tracker_storage = 0;    // in units of max_align_t
    std::vector<int> tracked;           // numbers of the walls that have one
  };

  struct motion {
    point<D> displacement = point<D>::Zero();  // as set [m]
    point<D> velocity = point<D>::Zero();      // [m/s]
    point<D> now = point<D>::Zero();           // displacement in this cycle [m]
    point<D> seen = point<D>::Zero();          // in the cycle that looked last [m]
  };

  void move(std::size_t k, motion m) {
    m.seen = motions_[k].seen;
    near_.moved(k, (m.now - motions_[k].now).norm());
    motions_[k] = m;
  }

  void start_trackers() {
    for (std::size_t k = 0; k < geometry_->others.size(); ++k)
      geometry_->at(geometry_->others[k]).start_tracker(tracker(k));
  }
  void* tracker(std::size_t other) { return trackers_.data() + geometry_->trackers[other]; }

  double look(int item, const point<D>& x) {
    const int number = geometry_->in_tree[static_cast<std::size_t>(item)];
    found_.from_wall(number, &x, nullptr);
    return geometry_->at(number).look(x, x, nullptr, found_);
  }

  double look_at_other(int item, const point<D>& x) {
    const auto k = static_cast<std::size_t>(-1 - item);
    const int number = geometry_->others[k];
    if (k >= motions_.size()) {
      found_.from_wall(number, &x, nullptr);
      return geometry_->at(number).look(previous_, x, tracker(k), found_);
    }
    motion& m = motions_[k];
    found_.from_wall(number, &x, &m.velocity);
    const double distance = geometry_->at(number).look(previous_ - m.seen, x - m.now, tracker(k), found_);
    m.seen = m.now;
    return distance;
  }

  const contacts_type& undefined_contact() {
    contact<D> c;
    c.depth = std::numeric_limits<double>::quiet_NaN();
    found_.from_wall(0, &c.position, nullptr);
    found_.add(c);
    return found_.in_order();
  }

  std::shared_ptr<const geometry> geometry_;
  neighbour_list<D> near_;
  point<D> previous_ = point<D>::Constant(std::numeric_limits<double>::quiet_NaN());  // x of the cycle before
  std::vector<motion> motions_;  // in the order of walls.moving()
  std::vector<std::max_align_t> trackers_;
  strongest_contacts<D, Capacity> found_;
};

/// The contacts of a world at x [m].
template <int D, int Capacity>
const contacts<D, Capacity>& sense(world<D, Capacity>& walls, const point<D>& x) {
  return walls.touched_at(x);
}

}  // namespace passive_haptics
