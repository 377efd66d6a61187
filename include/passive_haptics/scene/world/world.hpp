/// @file
/// A scene of many walls, made at run time.
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/scene/world/neighbour_list.hpp>
#include <passive_haptics/scene/world/strongest_contacts.hpp>
#include <passive_haptics/scene/world/world_walls.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace passive_haptics {

/// Many walls, of which a cycle looks at those that the handle can have reached since it last looked: the
/// contacts are those of a scan over all of them (neighbour_list.hpp). At most Capacity contacts, those of
/// the largest forces.
///
/// The walls are shared by copies and never change; each copy has its own memory of the handle. Walls that
/// stay where they are and have finite bounds lie in a tree; the others (unbounded, moving or followed ones,
/// TrackedShape) are compared one by one in each cycle that is not skipped: keep them few. Cost: a comparison
/// where nothing can have been reached; else neighbour_list.hpp. Construction O(n log n); it alone allocates.
template <int D, int Capacity = D + 1>
class world {
 public:
  static constexpr int dimension = D;           ///< d
  using contacts_type = contacts<D, Capacity>;  ///< What sensing this world gives.

  /// Throws std::invalid_argument with the text of validate(walls).
  explicit world(const world_walls<D>& walls)
      : geometry_(std::make_shared<const geometry>(require_valid(walls))) {
    near_ = neighbour_list<D>(geometry_->others.size(), geometry_->tree.scale());
    motions_.resize(geometry_->moving.size());
    trackers_.resize(geometry_->trackers.back());
    start_trackers();
  }

  /// The contacts at x [m], in the order of their walls; valid until the next call. A NaN or infinity in x
  /// gives a contact with a NaN depth, which the step reports.
  const contacts_type& touched_at(const point<D>& x) {
    found_.clear();
    if (!near_.idle(x)) {
      if (!all_finite(x)) {
        found_.add({.depth = std::numeric_limits<double>::quiet_NaN()});
        return found_.in_order();
      }
      near_.visit(geometry_->tree, x, [&](int item) { return look(item, x); });
    }
    previous_ = x;
    return found_.in_order();
  }

  /// Gives contacts from this distance [m] >= 0 off each wall on, with a depth < 0 before the touch; of a
  /// TrackedShape only from the touch on. Another margin than before costs the search of a jump.
  void set_margin(double margin) {
    margin_ = margin;
    near_.set_margin(margin);
  }

  /// How many contacts at the latest x found no room.
  int left_out() const { return found_.left_out(); }

  /// Moves a wall that was added by add_moving: displacement from where it was made [m], velocity of its
  /// surface [m/s]; base frame. Two values, as of `moving`. False, and nothing moved, if there is no such
  /// wall or they are not finite.
  bool set_motion(int number, const point<D>& displacement, const point<D>& velocity) {
    const auto& moving = geometry_->moving;
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

  /// Takes over what another world remembers of the handle at the walls that both share (copies of one
  /// any_wall under one number), so that the handle does not slip through them where a scene is exchanged. At
  /// other walls the handle is seen for the first time.
  void remember(const world& other) noexcept {
    const geometry &mine = *geometry_, &others = *other.geometry_;
    previous_ = other.previous_;
    for (std::size_t k = 0; k < std::min(mine.others.size(), others.others.size()); ++k) {
      const numbered_wall &now = mine.others[k], &before = others.others[k];
      if (now.number != before.number || !now.wall.shares(before.wall)) continue;
      std::copy_n(other.trackers_.begin() + others.tracker_at(k), mine.tracker_at(k + 1) - mine.tracker_at(k),
                  trackers_.begin() + mine.tracker_at(k));
      if (k < std::min(motions_.size(), other.motions_.size())) motions_[k].seen = other.motions_[k].seen;
    }
  }

 private:
  // Storage in which any tracker can be made
  struct alignas(std::max_align_t) tracker_bytes {
    std::array<std::byte, sizeof(std::max_align_t)> bytes;
  };

  struct numbered_wall {
    any_wall<D> wall;
    int number;
  };

  // What never changes
  struct geometry {
    explicit geometry(const world_walls<D>& walls) : moving(walls.moving()) {
      const auto numbered = [&](int i) -> numbered_wall {
        return {walls.all()[static_cast<std::size_t>(i)], i};
      };
      for (const int i : moving) others.push_back(numbered(i));
      std::vector<int> bounded;
      std::vector<bounding_box<D>> boxes;
      for (int i = 0; i < static_cast<int>(walls.all().size()); ++i) {
        if (std::binary_search(moving.begin(), moving.end(), i)) continue;
        const any_wall<D>& wall = walls.all()[static_cast<std::size_t>(i)];
        if (wall.tracker_size() == 0 && all_finite(wall.bounds().lower, wall.bounds().upper)) {
          bounded.push_back(i);
          boxes.push_back(wall.bounds());
        } else {
          others.push_back(numbered(i));
        }
      }
      tree = bounding_volume_tree<D>(boxes);
      in_tree.reserve(bounded.size());
      for (int place = 0; place < static_cast<int>(bounded.size()); ++place)
        in_tree.push_back(numbered(bounded[static_cast<std::size_t>(tree.item(place))]));
      for (const numbered_wall& w : others) {
        const std::size_t units = (w.wall.tracker_size() + sizeof(tracker_bytes) - 1) / sizeof(tracker_bytes);
        trackers.push_back(trackers.back() + units);
      }
    }

    std::ptrdiff_t tracker_at(std::size_t other) const {
      return static_cast<std::ptrdiff_t>(trackers[other]);
    }

    bounding_volume_tree<D> tree;
    std::vector<numbered_wall> in_tree;  // by their places there
    std::vector<numbered_wall> others;   // outside, the moving ones first
    std::vector<int> moving;             // their numbers
    // Where the tracker of each of the others begins, and the last ends [tracker_bytes]
    std::vector<std::size_t> trackers{0};
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
      geometry_->others[k].wall.start_tracker(tracker(k));
  }
  void* tracker(std::size_t other) { return trackers_.data() + geometry_->trackers[other]; }

  // At an item of near_: those outside the tree have negative numbers
  double look(int item, const point<D>& x) {
    touched_.clear();
    const auto k = static_cast<std::size_t>(item >= 0 ? item : -1 - item);
    const auto& [wall, number] = item >= 0 ? geometry_->in_tree[k] : geometry_->others[k];
    double distance;
    if (item >= 0) {
      distance = wall.look(x, x, margin_, nullptr, touched_);
    } else if (k < motions_.size()) {
      motion& m = motions_[k];
      distance = wall.look(previous_ - m.seen, x - m.now, margin_, tracker(k), touched_);
      for (contact<D>& c : touched_) c.wall_velocity += m.velocity;
      m.seen = m.now;
    } else {
      distance = wall.look(previous_, x, margin_, tracker(k), touched_);
    }
    for (contact<D>& c : touched_) {
      c.wall_number = number;
      c.sensed_at = x;
      found_.add(c);
    }
    return distance;
  }

  std::shared_ptr<const geometry> geometry_;
  neighbour_list<D> near_;
  point<D> previous_ = point<D>::Constant(std::numeric_limits<double>::quiet_NaN());  // x of the cycle before
  std::vector<motion> motions_;  // in the order of walls.moving()
  std::vector<tracker_bytes> trackers_;
  double margin_ = 0;       // [m]
  contacts<D, D> touched_;  // of one wall
  strongest_contacts<D, Capacity> found_;
};

}  // namespace passive_haptics
