/// @file
/// What never changes of a world: its walls, and the tree in which most of them lie.
#pragma once

#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/bounds/bounding_volume_tree.hpp>
#include <passive_haptics/scene/world/world_item.hpp>
#include <passive_haptics/scene/world/world_walls.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace passive_haptics::detail {

/// Motion of a wall that was added by add_moving.
template <int D>
struct wall_motion {
  point<D> displacement = point<D>::Zero();  ///< As set [m].
  point<D> velocity = point<D>::Zero();      ///< [m/s]
  point<D> now = point<D>::Zero();           ///< Displacement in this cycle [m].
  point<D> before = point<D>::Zero();        ///< Before it moved in this cycle [m].
  /// Where the handle was in the cycle before it moved last [m]: whether this is that cycle.
  point<D> handle = point<D>::Constant(std::numeric_limits<double>::quiet_NaN());

  /// Goes to where it is now; the handle was at `previous` in the cycle before, nullptr if nobody must know.
  void go_to(const point<D>& place, const point<D>* previous) {
    if (previous != nullptr) {
      before = before_cycle(*previous);
      handle = *previous;
    }
    now = place;
  }
  /// Takes over from the same wall in another world, which saw the handle at `previous` in the cycle before.
  void take_over(const wall_motion& other, const point<D>& previous) {
    before = other.now;
    handle = previous;
  }
  /// Displacement in the cycle before, in which the handle was at `previous` [m].
  point<D> before_cycle(const point<D>& previous) const { return handle == previous ? before : now; }
};

/// The walls of a world.
template <int D>
struct world_geometry {
  /// Storage in which any tracker can be made.
  struct alignas(std::max_align_t) tracker_bytes {
    std::array<std::byte, sizeof(std::max_align_t)> bytes;  ///< Of it.
  };

  /// A wall and its number.
  struct numbered_wall {
    any_wall<D> wall;  ///< The wall.
    int number;        ///< Of its contacts.
    bool is_followed;  ///< By a tracker of its own.
  };

  /// Throws std::invalid_argument with the text of validate(walls).
  explicit world_geometry(const world_walls<D>& walls) : moving(walls.moving()) {
    const auto numbered = [&](int i) -> numbered_wall {
      const any_wall<D>& wall = nth(walls.all(), i);
      return {wall, i, wall.tracker_size() > 0};
    };
    for (const int i : moving) others.push_back(numbered(i));
    std::vector<int> bounded;
    std::vector<bounding_box<D>> boxes;
    for (int i = 0; i < static_cast<int>(walls.all().size()); ++i) {
      if (std::binary_search(moving.begin(), moving.end(), i)) continue;
      const any_wall<D>& wall = nth(walls.all(), i);
      if (wall.is_solid() && all_finite(wall.bounds().lower, wall.bounds().upper)) {
        bounded.push_back(i);
        boxes.push_back(wall.bounds());
      } else {
        others.push_back(numbered(i));
      }
    }
    tree = bounding_volume_tree<D>(boxes);
    in_tree.reserve(bounded.size());
    for (int place = 0; place < static_cast<int>(bounded.size()); ++place)
      in_tree.push_back(numbered(nth(bounded, tree.item(place))));
    items.resize(walls.all().size());
    for (std::size_t k = 0; k < in_tree.size(); ++k)
      nth(items, in_tree[k].number) = world_item::in_tree(static_cast<int>(k));
    for (std::size_t k = 0; k < others.size(); ++k) nth(items, others[k].number) = world_item::outside(k);
    for (const numbered_wall& w : others) {
      const std::size_t units = (w.wall.tracker_size() + sizeof(tracker_bytes) - 1) / sizeof(tracker_bytes);
      trackers.push_back(trackers.back() + units);
    }
    const auto is_one = [](const any_wall<D>& wall) { return wall.needs_proxy(); };
    needs_proxy =
        std::any_of(walls.all().begin(), walls.all().end(), is_one) ||
        std::any_of(boxes.begin(), boxes.end(), [&](const auto& b) { return has_beside(b, boxes); });
    for (const any_wall<D>& wall : walls.all()) {
      const double largest = detail::max_coordinate(wall.bounds());
      if (std::isfinite(largest)) extent = std::max(extent, largest);
    }
  }

  /// Whether a wall or the proxy must know where a wall has come from.
  bool remembers() const { return needs_proxy || trackers.back() > 0; }

  /// The wall of an item.
  const numbered_wall& wall_of(world_item item) const {
    return (item.is_in_tree() ? in_tree : others)[item.place()];
  }
  /// The item of the wall with this number.
  world_item item_of(int number) const { return nth(items, number); }

  /// Whether the walls outside of both trees at this place are one.
  bool shares(const world_geometry& with, std::size_t place) const {
    if (place >= others.size() || place >= with.others.size()) return false;
    const numbered_wall &mine = others[place], &its = with.others[place];
    return mine.number == its.number && mine.wall.shares(its.wall);
  }

  /// True if both worlds have the same wall under this number of the other one.
  bool shares_wall(const world_geometry& other, int number) const {
    return static_cast<std::size_t>(number) < items.size() &&
           wall_of(item_of(number)).wall.shares(other.wall_of(other.item_of(number)).wall);
  }

  /// Where the tracker of another begins [tracker_bytes].
  std::ptrdiff_t tracker_at(std::size_t other) const { return static_cast<std::ptrdiff_t>(trackers[other]); }

  bounding_volume_tree<D> tree;        ///< Of the boxes about most walls.
  std::vector<numbered_wall> in_tree;  ///< By their places there.
  std::vector<numbered_wall> others;   ///< Outside of it, the moving ones first.
  std::vector<int> moving;             ///< Their numbers.
  std::vector<world_item> items;       ///< By the numbers of the walls.
  /// Where the tracker of each of the others begins, and the last ends.
  std::vector<std::size_t> trackers{0};
  bool needs_proxy = false;  ///< For a mesh, a thin wall, or two that meet.
  double extent = 0;         ///< Largest coordinate of the bounded walls [m].

 private:
  // True if one of the boxes meets or overlaps b: inside two solids side by side, the sides at the seam are
  // nearest, which do not push out
  bool has_beside(const bounding_box<D>& b, const std::vector<bounding_box<D>>& boxes) const {
    constexpr double wide = 0.01;              // [m], of a seam; a hand slips off what is smaller
    const double touch = 1e-9 * tree.scale();  // [m]
    const double radius = (b.upper - b.lower).norm() / 2 + touch;
    int count = 0;
    const auto look = [&](int place, double) {
      const bounding_box<D>& other = nth(boxes, tree.item(place));
      const point<D> common = b.upper.cwiseMin(other.upper) - b.lower.cwiseMax(other.lower);
      if ((common.array() >= -touch).all() && (common.array() > wide).count() >= D - 1) ++count;
    };
    tree.visit_within(squared_distance_from<D>((b.lower + b.upper) / 2), radius * radius, look);
    return count > 1;  // b is one
  }
};

}  // namespace passive_haptics::detail
