/// @file
/// A tree of bounding boxes: which of many are near, without looking at the others.
///
/// Eigen's unsupported BVH and Boost.Geometry's R-tree allocate in a query; a control loop must not, and wants to search
/// a little in each cycle. Hence this one.
#pragma once

#include <passive_haptics/scene/bounding_box.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace passive_haptics {

/// A box in float, grown by what its arithmetic may lose: a fraction of the work, and a bound all the same.
template <int D>
struct outer_box {
  /// A point [m]; as many lanes as a vector register has, those beyond D zero.
  using float_point = Eigen::Array<float, (D + 3) / 4 * 4, 1>;

  float_point lower;  ///< [m]
  float_point upper;  ///< [m]

  /// Holds a box with coordinates up to `scale` [m].
  static outer_box about(const bounding_box<D>& b, double scale) {
    const auto margin = point<D>::Constant(4 * epsilon * scale);
    return {in_float(b.lower - margin), in_float(b.upper + margin)};
  }

  /// x in float.
  static float_point in_float(const point<D>& x) {
    float_point y = float_point::Zero();
    unrolled<D>([&](auto i) { y[i] = static_cast<float>(x[i]); });
    return y;
  }

  /// Not more than the square of the distance from x to the box [m^2], and less by rounding only; 0 inside.
  double squared_distance(const float_point& x) const {
    constexpr float largest = std::numeric_limits<float>::max();
    const float square = (lower - x).max(x - upper).max(0.f).square().sum();
    return (1 - 8 * epsilon) * double(std::min(square, largest));
  }
  /// The same.
  double squared_distance(const point<D>& x) const { return squared_distance(in_float(x)); }

 private:
  static constexpr double epsilon = std::numeric_limits<float>::epsilon();
};

/// A balanced binary tree over items 0 .. n-1, each known by its box. Immutable: any number of threads may search it.
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
      double bound;
      std::int32_t node;
    };
    // A balanced tree of 2^31 items is 31 levels deep; each level leaves one node behind.
    std::array<entry, 40> stack_{};
    int size_ = 0;
  };

  bounding_volume_tree() = default;

  /// O(n log n); may allocate. Boxes finite or infinite, not NaN.
  explicit bounding_volume_tree(const std::vector<bounding_box<D>>& boxes) {
    if (boxes.empty()) return;
    items_.resize(boxes.size());
    std::iota(items_.begin(), items_.end(), 0);
    nodes_.resize(1);
    bounding_box<D> all;
    for (const auto& b : boxes) all.extend(b);
    scale_ = detail::largest_coordinate(all);
    build(0, boxes, 0, static_cast<std::int32_t>(boxes.size()));
    nodes_.shrink_to_fit();
  }

  /// Number of items.
  std::size_t size() const { return items_.size(); }

  /// Largest coordinate of the boxes [m].
  double scale() const { return scale_; }

  /// A search from the root. bound(outer_box) is what limits it: the least that it seeks in the box can be.
  template <class Bound>
  search start(const Bound& bound) const {
    search s;
    if (!nodes_.empty()) s.stack_[static_cast<std::size_t>(s.size_++)] = {bound(nodes_[0].box), 0};
    return s;
  }

  /// Calls visit(item, bound) for items whose bound is <= limit, those in the nearer half first; visit may lower the
  /// limit. Looks at no more than `budget` nodes and returns what is left of it.
  template <class Bound, class Visit>
  int go_on(search& s, const Bound& bound, double& limit, const Visit& visit,
            int budget = std::numeric_limits<int>::max()) const {
    while (s.size_ > 0 && budget > 0) {
      const auto top = s.stack_[static_cast<std::size_t>(--s.size_)];
      if (!(top.bound <= limit)) continue;
      --budget;
      const node& here = nodes_[static_cast<std::size_t>(top.node)];
      if (here.count > 0) {
        for (std::int32_t i = here.first; i < here.first + here.count; ++i)
          visit(static_cast<int>(items_[static_cast<std::size_t>(i)]), top.bound);
        continue;
      }
      const std::int32_t link = here.first;
      typename search::entry near{bound(nodes_[static_cast<std::size_t>(link)].box), link};
      typename search::entry far{bound(nodes_[static_cast<std::size_t>(link) + 1].box), link + 1};
      if (far.bound < near.bound) std::swap(near, far);
      if (far.bound <= limit) s.stack_[static_cast<std::size_t>(s.size_++)] = far;
      if (near.bound <= limit) s.stack_[static_cast<std::size_t>(s.size_++)] = near;
    }
    return budget;
  }

  /// The whole search at once: visits all items with bound <= limit, which visit may lower.
  template <class Bound, class Visit>
  void visit_within(const Bound& bound, double limit, const Visit& visit) const {
    search s = start(bound);
    go_on(s, bound, limit, visit);
  }

 private:
  struct node {
    outer_box<D> box;
    std::int32_t first;  // of its items; of an inner node, of its two children
    std::int32_t count;  // of items; 0 of an inner node
  };

  // The node `at` of items_[first] .. items_[first + count - 1]
  void build(std::size_t at, const std::vector<bounding_box<D>>& boxes, std::int32_t first,
             std::int32_t count) {
    const auto box = [&](std::int32_t i) -> const bounding_box<D>& {
      return boxes[static_cast<std::size_t>(i)];
    };
    const auto begin = items_.begin() + first, middle = begin + count / 2, end = begin + count;
    bounding_box<D> all;
    std::for_each(begin, end, [&](std::int32_t i) { all.extend(box(i)); });
    nodes_[at] = {outer_box<D>::about(all, scale_), first, count};
    if (count <= leaf_size) return;
    int axis = 0;
    (all.upper - all.lower).maxCoeff(&axis);
    std::nth_element(begin, middle, end, [&](std::int32_t i, std::int32_t j) {
      return box(i).lower[axis] + box(i).upper[axis] < box(j).lower[axis] + box(j).upper[axis];
    });
    const std::size_t children = nodes_.size();
    nodes_.resize(children + 2);
    nodes_[at].first = static_cast<std::int32_t>(children);
    nodes_[at].count = 0;
    build(children, boxes, first, count / 2);
    build(children + 1, boxes, first + count / 2, count - count / 2);
  }

  static constexpr std::int32_t leaf_size = 4;  // less memory to fetch than one item a leaf

  std::vector<node> nodes_;
  std::vector<std::int32_t> items_;  // in the order of the leaves
  double scale_ = 0;                 // largest coordinate [m]
};

}  // namespace passive_haptics
