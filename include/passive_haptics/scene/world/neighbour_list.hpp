/// Exact skipping: selects the items that the handle may have reached since the last cycle.
///
/// Distances are 1-Lipschitz; the neighbour list is that of L. Verlet, Phys. Rev. 159 (1967), 98-103.
#pragma once

#include <passive_haptics/core/flatten.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/bounds/bounding_volume_tree.hpp>
#include <passive_haptics/scene/world/world_item.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace passive_haptics {

/// The items that one moving point may touch: items of a tree, and others outside it (unbounded or moving).
///
/// It uses three bounds, each only when the previous one is exhausted:
///   - clearance: distance until any item is due. Most cycles end here;
///   - due: for each of the nearest items, the travelled distance at which it can first be touched;
///   - reach: distance of the nearest item not in the list. When most of it is used up, the next list is
///     collected, a few tree nodes per cycle.
///
/// A cycle costs one comparison, or at most Listed + others looks and `nodes_per_cycle` nodes. If the handle
/// leaves the reach early, the rest of the list is collected in one cycle. After a jump, or if more than
/// Listed boxes contain the handle, it looks at all items with such boxes. No allocation after construction.
template <int D, int Listed = 16>
class neighbour_list {
 public:
  static constexpr int nodes_per_cycle = 8;  ///< Tree nodes per cycle while the next list is collected.

  neighbour_list() = default;

  /// other_count: items outside the tree. scale [m]: maximum coordinate of bounded items, for the rounding of
  /// distances. A plane through a point 1 km away may be touched 1e-13 m late, by its own rounding.
  neighbour_list(std::size_t other_count, double scale) : others_(other_count, 0.0), scale_(scale) {}

  /// Calls look(item) for each item that a finite, not idle x may touch. look returns the distance that the
  /// handle may move from x without touching the item [m]; 0 for a touch.
  template <class Look>
  void visit(const bounding_volume_tree<D>& tree, const point<D>& x, const Look& look) {
    const double step = (x - last_).norm();
    last_ = x;
    if (!(step < usual_reach_)) return jump(tree, x, look);  // also in the first cycle
    travelled_ = (travelled_ + step) * (1 + 4 * epsilon);    // rounded up
    if (collecting_) collect(tree, nodes_per_cycle);
    double from_centre = (x - now().centre).norm();
    if (!(from_centre < now().reach)) {
      start_collecting(tree, x);
      collect(tree, std::numeric_limits<int>::max());
      from_centre = 0;
    } else if (!collecting_ && from_centre > start_early * now().reach) {
      start_collecting(tree, x);
    }

    const double slack = rounding(x);
    const auto next_due = [&](world_item item) {
      return travelled_ + (look(item) * (1 - relative_rounding) - slack);
    };
    look_at_near(next_due);
    look_at_others(next_due);
    if (now().reach == 0) look_about(tree, x, look);  // the list is too short for the items about x
    double clearance = std::min(now().size > 0 ? now().items[0].due : unbounded, first_other_) - travelled_;
    // Start the next list in time; while it is collected, never idle
    clearance = collecting_ ? 0 : std::min(clearance, start_early * now().reach - from_centre);
    clearance = std::max(clearance - slack, 0.0);
    squared_clearance_ = clearance * clearance;
  }

  /// True if no item can be reached at x. False if x is not finite.
  bool idle(const point<D>& x) const { return (x - last_).squaredNorm() < squared_clearance_; }

  /// Reports that an item outside the tree (0, 1, ...) has moved by this distance [m].
  void moved(std::size_t other, double distance) {
    others_[other] -= distance;
    first_other_ = std::min(first_other_, others_[other]);
    const double left = std::sqrt(squared_clearance_) - distance;
    squared_clearance_ = left > 0 ? left * left : 0;
  }

  /// Sets the distance at which items count as touched by look() [m] >= 0.
  void set_margin(double margin) {
    if (margin == margin_) return;
    margin_ = margin;
    reset();
  }

  /// Forgets the handle.
  void reset() {
    squared_clearance_ = 0;
    now().size = 0;
    now().reach = 0;
    collecting_ = false;
    std::fill(others_.begin(), others_.end(), 0.0);
    first_other_ = 0;
  }

 private:
  using search = typename bounding_volume_tree<D>::search;
  static constexpr double unbounded = std::numeric_limits<double>::infinity();

  struct neighbour {
    double due = 0;  // distance at which it can be touched [m]; the distance of its box while collecting
    world_item item;
    bool operator<(const neighbour& other) const { return due < other.due; }
  };

  // The nearest items seen from a centre; all others are beyond reach.
  struct list {
    point<D> centre = point<D>::Zero();
    double reach = 0;  // [m]
    // Compared as `x > size`: `size <` could begin the arguments of a user's template of that name
    int size = 0;
    std::array<neighbour, static_cast<std::size_t>(Listed)> items{};

    auto begin() { return items.begin(); }
    auto end() { return items.begin() + size; }
  };

  static constexpr double start_early = 0.9;  // fraction of the reach after which the next list begins
  static constexpr double epsilon = std::numeric_limits<double>::epsilon();
  static constexpr double relative_rounding = 64 * epsilon;

  list& now() { return nth(lists_, current_); }
  list& next() { return nth(lists_, 1 - current_); }

  // Discards all state that the jump made useless.
  template <class Look>
  void jump(const bounding_volume_tree<D>& tree, const point<D>& x, const Look& look) {
    reset();
    usual_reach_ *= 1.002;  // tries a list again eventually
    for (std::size_t i = 0; i < others_.size(); ++i) look(world_item::outside(i));
    look_about(tree, x, look);
  }

  template <class Look>
  void look_about(const bounding_volume_tree<D>& tree, const point<D>& x, const Look& look) const {
    const double within = margin_ * (1 + relative_rounding);
    tree.visit_within(squared_distance_from<D>(x), within * within,
                      [&](int place, double) { look(world_item::in_tree(place)); });
  }

  // Rounding of a distance at x and of the travelled distance, without the relative part [m]
  double rounding(const point<D>& x) const {
    return relative_rounding * (scale_ + x.cwiseAbs().maxCoeff() + travelled_);
  }

  // The list is sorted by due distance.
  template <class NextDue>
  void look_at_near(const NextDue& next_due) {
    auto& items = now().items;
    const auto at = [&](int k) -> neighbour& { return nth(items, k); };
    int due = 0;
    for (; due < now().size && at(due).due <= travelled_; ++due) at(due).due = next_due(at(due).item);
    for (int k = due - 1; k >= 0; --k) {
      const neighbour moved = at(k);
      int to = k;
      for (; to + 1 < now().size && at(to + 1).due < moved.due; ++to) at(to) = at(to + 1);
      at(to) = moved;
    }
  }

  template <class NextDue>
  void look_at_others(const NextDue& next_due) {
    if (first_other_ > travelled_) return;
    first_other_ = unbounded;
    for (std::size_t i = 0; i < others_.size(); ++i) {
      if (others_[i] <= travelled_) others_[i] = next_due(world_item::outside(i));
      first_other_ = std::min(first_other_, others_[i]);
    }
  }

  void start_collecting(const bounding_volume_tree<D>& tree, const point<D>& x) {
    collecting_ = true;
    next().centre = x;
    next().size = 0;
    // A half-full list is fastest to collect
    const double reach = (Listed / 2 > now().size ? 1.25 : 0.8) * now().reach;
    squared_limit_ = reach > 0 ? (reach + margin_) * (reach + margin_) : unbounded;
    started_at_ = travelled_;
    search_ = tree.start();
  }

  // Collects all boxes within reach, or the nearest of them if there are too many
  PASSIVE_HAPTICS_FLATTEN void collect(const bounding_volume_tree<D>& tree, int budget) {
    list& next = this->next();
    tree.go_on(
        search_, squared_distance_from<D>(next.centre), squared_limit_,
        [&](int place, double squared_distance) {
          const neighbour found{std::sqrt(squared_distance), world_item::in_tree(place)};
          if (Listed > next.size) {
            nth(next.items, next.size++) = found;
            if (Listed > next.size) return;
            std::make_heap(next.begin(), next.end());
          } else {
            std::pop_heap(next.begin(), next.end());
            next.items.back() = found;
            std::push_heap(next.begin(), next.end());
          }
          squared_limit_ = next.items[0].due * next.items[0].due;
        },
        budget);
    if (search_.done()) change_lists();
  }

  void change_lists() {
    collecting_ = false;
    // Restart the travelled distance with each list, to keep it short and exact
    for (double& due : others_) due -= started_at_;
    first_other_ -= started_at_;
    travelled_ -= started_at_;
    next().reach = std::max(std::sqrt(squared_limit_) - margin_, 0.0);
    if (next().reach == 0) next().size = 0;
    else usual_reach_ = next().reach;
    current_ = 1 - current_;
    const double early = margin_ + rounding(now().centre);
    for (neighbour& n : now()) n.due -= early;
    std::sort(now().begin(), now().end());
  }

  point<D> last_ = point<D>::Constant(std::numeric_limits<double>::quiet_NaN());
  double squared_clearance_ = 0;  // of last_ [m^2]
  double travelled_ = 0;          // since the list was begun [m]
  std::array<list, 2> lists_;
  int current_ = 0;                 // index in lists_
  double usual_reach_ = unbounded;  // of the latest list with a reach [m]
  std::vector<double> others_;      // due distances [m]
  double first_other_ = 0;          // their minimum
  double scale_ = 0;
  double margin_ = 0;         // [m]
  double squared_limit_ = 0;  // of the search for the next list [m^2]
  search search_;
  double started_at_ = 0;  // travelled_ when the next list was begun
  bool collecting_ = false;
};

}  // namespace passive_haptics
