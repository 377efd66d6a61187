/// @file
/// A tree of bounding boxes: which of many are near, without looking at the others.
///
/// Eigen's unsupported BVH and Boost.Geometry's R-tree allocate in a query; a control loop must not, and wants to search
/// a little in each cycle. Hence this one.
#pragma once

#include <passive_haptics/scene/bounding_box.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace passive_haptics {

/// A box in float, rounded outwards: half the memory, and a bound all the same.
template <int D>
struct outer_box {
  std::array<float, static_cast<std::size_t>(D)> lower;  ///< [m]
  std::array<float, static_cast<std::size_t>(D)> upper;  ///< [m]

  /// Square of the distance from x to the box [m^2]; 0 inside; to rounding.
  double squared_distance(const point<D>& x) const {
    double sum = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(D); ++i) {
      const double u = x[static_cast<int>(i)];
      const double beyond = std::max({double(lower[i]) - u, u - double(upper[i]), 0.0});
      sum += beyond * beyond;
    }
    return sum;
  }
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
    std::array<entry, 40> stack_;
    int size_ = 0;
  };

  bounding_volume_tree() = default;

  /// O(n log n); may allocate. Boxes finite or infinite, not NaN.
  explicit bounding_volume_tree(const std::vector<bounding_box<D>>& boxes) {
    if (boxes.empty()) return;
    std::vector<std::int32_t> items(boxes.size());
    std::iota(items.begin(), items.end(), 0);
    nodes_.reserve(2 * boxes.size());
    nodes_.resize(2);  // the root and a gap, so that two children share a cache line
    build(0, boxes, items.data(), items.data() + items.size());
  }

  /// Number of items.
  std::size_t size() const { return nodes_.size() / 2; }

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
      const std::int32_t link = nodes_[static_cast<std::size_t>(top.node)].link;
      if (link < 0) {
        visit(static_cast<int>(~link), top.bound);
        continue;
      }
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
  struct alignas(D == 3 ? 32 : 4) node {
    outer_box<D> box;
    std::int32_t link;  // of an inner node its first child, of a leaf ~item
  };

  static outer_box<D> outer(const bounding_box<D>& b) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    outer_box<D> o;
    for (std::size_t i = 0; i < static_cast<std::size_t>(D); ++i) {
      const double lower = b.lower[static_cast<int>(i)], upper = b.upper[static_cast<int>(i)];
      o.lower[i] = std::nextafter(static_cast<float>(lower), -infinity);
      o.upper[i] = std::nextafter(static_cast<float>(upper), infinity);
    }
    return o;
  }

  void build(std::size_t at, const std::vector<bounding_box<D>>& boxes, std::int32_t* first,
             std::int32_t* last) {
    const auto box = [&](std::int32_t i) -> const bounding_box<D>& {
      return boxes[static_cast<std::size_t>(i)];
    };
    bounding_box<D> all;
    std::for_each(first, last, [&](std::int32_t i) { all.extend(box(i)); });
    nodes_[at].box = outer(all);
    if (last - first == 1) {
      nodes_[at].link = ~*first;
      return;
    }
    int axis = 0;
    (all.upper - all.lower).maxCoeff(&axis);
    std::int32_t* middle = first + (last - first) / 2;
    std::nth_element(first, middle, last, [&](std::int32_t i, std::int32_t j) {
      return box(i).lower[axis] + box(i).upper[axis] < box(j).lower[axis] + box(j).upper[axis];
    });
    const std::size_t children = nodes_.size();
    nodes_.resize(children + 2);
    nodes_[at].link = static_cast<std::int32_t>(children);
    build(children, boxes, first, middle);
    build(children + 1, boxes, middle, last);
  }

  std::vector<node> nodes_;
};

}  // namespace passive_haptics
