/// @file
/// A tree of bounding boxes: which of many are near, without looking at the others.
///
/// Eigen's unsupported BVH and Boost.Geometry's R-tree allocate in a query; a control loop must not, and
/// wants to search a little in each cycle. Hence this one.
#pragma once

#include <passive_haptics/scene/bounds/bounding_box.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace passive_haptics {

/// Four boxes in float side by side, looked at together. Each is grown by what its arithmetic may lose: a
/// bound all the same.
template <int D>
struct four_outer_boxes {
  using four = Eigen::Array<float, 4, 1>;  ///< One value of each box.

  Eigen::Array<float, 4, D> lower;  ///< A column for each axis [m].
  Eigen::Array<float, 4, D> upper;  ///< A column for each axis [m].

  /// Makes box k, 0 <= k < 4, hold b, whose coordinates are up to `scale` [m].
  void set(int k, const bounding_box<D>& b, double scale) {
    const double margin = 4 * epsilon * scale;
    unrolled<D>([&](auto i) {
      lower(k, i) = static_cast<float>(b.lower[i] - margin);
      upper(k, i) = static_cast<float>(b.upper[i] + margin);
    });
  }

  /// Not more than the squares of the distances from x to the boxes [m^2], and less by rounding only; 0
  /// inside.
  four squared_distances(const vector<float, D>& x) const {
    constexpr float largest = std::numeric_limits<float>::max();
    four sum = four::Zero();
    unrolled<D>([&](auto i) { sum += (lower.col(i) - x[i]).max(x[i] - upper.col(i)).max(0.f).square(); });
    return (1 - 8 * epsilon) * sum.min(largest);
  }

 private:
  static constexpr float epsilon = std::numeric_limits<float>::epsilon();
};

/// How far each of four boxes is from x [m^2]: what limits a search for what is near.
template <int D>
auto squared_distance_from(const point<D>& x) {
  const vector<float, D> from = x.template cast<float>();
  return [from](const four_outer_boxes<D>& boxes) { return boxes.squared_distances(from); };
}

/// A balanced tree of four branches a node over items 0 .. n-1, each known by its box. Immutable: any number
/// of threads may search it. A search is limited by a function of four_outer_boxes: for each, the least that
/// it seeks in the box can be, as four floats or doubles.
template <int D>
class bounding_volume_tree {
 public:
  /// Where a search has got to, so that it can go on later. No allocation.
  class search {
   public:
    /// True if nothing is left to visit.
    bool done() const { return size_ == 0; }

   private:
    friend class bounding_volume_tree;
    struct entry {
      double bound = 0;
      std::int32_t node = 0;
    };
    // A balanced tree of 2^31 items is 16 levels deep; each level leaves three nodes behind.
    std::array<entry, 64> stack_{};
    int size_ = 0;
  };

  bounding_volume_tree() = default;

  /// O(n log n); may allocate. Boxes finite.
  explicit bounding_volume_tree(const std::vector<bounding_box<D>>& boxes) : items_(boxes.size()) {
    if (boxes.empty()) return;
    std::iota(items_.begin(), items_.end(), 0);
    const range all{0, static_cast<std::int32_t>(boxes.size())};
    scale_ = detail::largest_coordinate(box_of(boxes, all));
    build(boxes, all);
    nodes_.shrink_to_fit();
  }

  /// Number of items.
  std::size_t size() const { return items_.size(); }

  /// Largest coordinate of the boxes [m].
  double scale() const { return scale_; }

  /// A search from the root.
  search start() const {
    search s;
    if (!nodes_.empty()) s.size_ = 1;
    return s;
  }

  /// Calls visit(item, bound) for items whose bound is <= limit, those in nearer branches first; visit may
  /// lower the limit. Up to four items share the bound of a box about them. Opens no more than `budget`
  /// nodes.
  template <class Bound, class Visit>
  void go_on(search& s, const Bound& bound, double& limit, const Visit& visit,
             int budget = std::numeric_limits<int>::max()) const {
    for (; s.size_ > 0 && budget > 0;) {
      const auto top = s.stack_[static_cast<std::size_t>(--s.size_)];
      if (!(top.bound <= limit)) continue;
      --budget;
      const node& here = nodes_[static_cast<std::size_t>(top.node)];
      const auto bounds = bound(here.boxes);
      unsigned within = 0;  // a bit for each branch: cheaper to find out first than to guess four times
      for (int k = 0; k < 4; ++k) within |= static_cast<unsigned>(bounds[k] <= limit) << k;
      const int inner = s.size_;
      for (; within != 0; within &= within - 1) {
        const int k = std::countr_zero(within);
        const auto branch = static_cast<std::size_t>(k);
        const double b = bounds[k];
        if (here.count[branch] == 0) push(s, inner, {b, here.first[branch]});
        for (std::int32_t i = 0; i < here.count[branch] && b <= limit; ++i)
          visit(static_cast<int>(items_[static_cast<std::size_t>(here.first[branch] + i)]), b);
      }
    }
  }

  /// The whole search at once: visits all items with bound <= limit, which visit may lower.
  template <class Bound, class Visit>
  void visit_within(const Bound& bound, double limit, const Visit& visit) const {
    search s = start();
    go_on(s, bound, limit, visit);
  }

 private:
  static constexpr std::int32_t leaf_size = 4;
  static constexpr std::int32_t empty = -1;

  struct node {
    four_outer_boxes<D> boxes;
    std::array<std::int32_t, 4> first;  // of a leaf its first in items_; of an inner node its number
    std::array<std::int32_t, 4> count;  // of items; 0 of an inner node, `empty` of a branch without any
  };

  struct range {
    std::int32_t first, count;  // of items_
  };

  // Keeps those pushed since `from` in order, the nearest on top.
  static void push(search& s, int from, typename search::entry e) {
    int at = s.size_++;
    for (; at > from && s.stack_[static_cast<std::size_t>(at - 1)].bound < e.bound; --at)
      s.stack_[static_cast<std::size_t>(at)] = s.stack_[static_cast<std::size_t>(at - 1)];
    s.stack_[static_cast<std::size_t>(at)] = e;
  }

  bounding_box<D> box_of(const std::vector<bounding_box<D>>& boxes, range r) const {
    bounding_box<D> all;
    for (auto item = items_.begin() + r.first; item != items_.begin() + r.first + r.count; ++item)
      all.extend(boxes[static_cast<std::size_t>(*item)]);
    return all;
  }

  // Two halves along the longest side of the box about all
  std::array<range, 2> halves(const std::vector<bounding_box<D>>& boxes, range r) {
    const bounding_box<D> all = box_of(boxes, r);
    int axis = 0;
    if (r.count > 0) (all.upper - all.lower).maxCoeff(&axis);
    const auto begin = items_.begin() + r.first;
    std::nth_element(begin, begin + r.count / 2, begin + r.count, [&](std::int32_t i, std::int32_t j) {
      const auto &a = boxes[static_cast<std::size_t>(i)], &b = boxes[static_cast<std::size_t>(j)];
      return a.lower[axis] + a.upper[axis] < b.lower[axis] + b.upper[axis];
    });
    return {range{r.first, r.count / 2}, range{r.first + r.count / 2, r.count - r.count / 2}};
  }

  // Makes the node of these items and all below it, and returns its number.
  std::int32_t build(const std::vector<bounding_box<D>>& boxes, range r) {
    const auto at = nodes_.size();
    nodes_.emplace_back();
    const auto two = halves(boxes, r);
    const auto low = halves(boxes, two[0]), high = halves(boxes, two[1]);
    const std::array<range, 4> four{low[0], low[1], high[0], high[1]};
    for (std::size_t k = 0; k < 4; ++k) {
      nodes_[at].boxes.set(static_cast<int>(k), box_of(boxes, four[k]), scale_);
      const bool leaf = four[k].count <= leaf_size;
      const std::int32_t first = leaf ? four[k].first : build(boxes, four[k]);
      nodes_[at].first[k] = first;
      nodes_[at].count[k] = !leaf ? 0 : four[k].count > 0 ? four[k].count : empty;
    }
    return static_cast<std::int32_t>(at);
  }

  std::vector<node> nodes_;
  std::vector<std::int32_t> items_;  // in the order of the leaves
  double scale_ = 0;                 // largest coordinate [m]
};

}  // namespace passive_haptics
