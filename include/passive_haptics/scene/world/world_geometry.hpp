/// The immutable part of a world: its walls and their tree.
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

template <int D>
struct wall_motion {
  point<D> displacement = point<D>::Zero();  ///< As set [m].
  point<D> velocity = point<D>::Zero();      ///< [m/s]
  point<D> now = point<D>::Zero();           ///< Displacement in this cycle [m].
  point<D> before = point<D>::Zero();        ///< Displacement before it moved in this cycle [m].
  /// Position of the handle before the last move [m], which identifies the cycle.
  point<D> handle = point<D>::Constant(std::numeric_limits<double>::quiet_NaN());

  /// Moves to a displacement. previous: position of the handle in the previous cycle, nullptr if not needed.
  void go_to(const point<D>& place, const point<D>* previous) {
    if (previous != nullptr) {
      before = before_cycle(*previous);
      handle = *previous;
    }
    now = place;
  }
  /// Takes over from the same wall in another world, with the handle at `previous` in the previous cycle.
  void take_over(const wall_motion& other, const point<D>& previous) {
    before = other.now;
    handle = previous;
  }
  /// Displacement in the previous cycle, with the handle at `previous` [m].
  point<D> before_cycle(const point<D>& previous) const { return handle == previous ? before : now; }
};

template <int D>
struct world_geometry {
  struct alignas(std::max_align_t) tracker_bytes {
    std::array<std::byte, sizeof(std::max_align_t)> bytes;
  };

  struct numbered_wall {
    any_wall<D> wall;
    int number;
    bool is_followed;  ///< Has a tracker.
  };

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

  /// True if the previous position of a wall is needed.
  bool remembers() const { return needs_proxy || trackers.back() > 0; }

  const numbered_wall& wall_of(world_item item) const {
    return (item.is_in_tree() ? in_tree : others)[item.place()];
  }
  world_item item_of(int number) const { return nth(items, number); }

  /// True if both have the same wall at this place outside the tree.
  bool shares(const world_geometry& with, std::size_t place) const {
    if (place >= others.size() || place >= with.others.size()) return false;
    const numbered_wall &mine = others[place], &its = with.others[place];
    return mine.number == its.number && mine.wall.shares(its.wall);
  }

  /// True if both worlds have the same wall for this number of the other one.
  bool shares_wall(const world_geometry& other, int number) const {
    return static_cast<std::size_t>(number) < items.size() &&
           wall_of(item_of(number)).wall.shares(other.wall_of(other.item_of(number)).wall);
  }

  std::ptrdiff_t tracker_at(std::size_t other) const { return static_cast<std::ptrdiff_t>(trackers[other]); }

  bounding_volume_tree<D> tree;          ///< Boxes of the bounded walls at rest.
  std::vector<numbered_wall> in_tree;    ///< By place in the tree.
  std::vector<numbered_wall> others;     ///< Outside the tree, moving ones first.
  std::vector<int> moving;               ///< Numbers of the moving walls.
  std::vector<world_item> items;         ///< By wall number.
  std::vector<std::size_t> trackers{0};  ///< Start of each other item's tracker, and the end of the last.
  bool needs_proxy = false;              ///< For a mesh, a thin wall, or two that meet.
  double extent = 0;                     ///< Maximum coordinate of the bounded walls [m].

 private:
  // True if a box meets or overlaps b. At the seam of adjacent solids, the nearest sides do not push out
  bool has_beside(const bounding_box<D>& b, const std::vector<bounding_box<D>>& boxes) const {
    constexpr double wide = 0.01;              // [m], of a seam; a hand slips off smaller ones
    const double touch = 1e-9 * tree.scale();  // [m]
    const double radius = (b.upper - b.lower).norm() / 2 + touch;
    int count = 0;
    const auto look = [&](int place, double) {
      const bounding_box<D>& other = nth(boxes, tree.item(place));
      const point<D> common = b.upper.cwiseMin(other.upper) - b.lower.cwiseMax(other.lower);
      if ((common.array() >= -touch).all() && (common.array() > wide).count() >= D - 1) ++count;
    };
    tree.visit_within(squared_distance_from<D>((b.lower + b.upper) / 2), radius * radius, look);
    return count > 1;  // b is one of them
  }
};

}  // namespace passive_haptics::detail
