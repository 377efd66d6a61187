/// @file
/// A tree of bounding boxes: which of many are near, without looking at the others.
///
/// Eigen's unsupported BVH and Boost.Geometry's R-tree allocate in a query; a control loop must not, and
/// needs to search a little in each cycle. Hence this tree.
#pragma once

#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/scene/bounds/four_outer_boxes.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace passive_haptics {

/// A tree of four branches a node over items 0 .. n-1, each known by its box. Immutable: any number of
/// threads may search it. A search is limited by a function of four_outer_boxes: for each, the least that it
/// seeks in the box can be, as four floats >= 0, each to four_outer_boxes::rounding. A search visits places
/// in the order of the leaves, in which items that are near each other stand side by side.
template <int D>
class bounding_volume_tree {
 public:
  using four = typename four_outer_boxes<D>::four;  ///< One value of each box.

  /// Where a search has got to, so that it can go on later. No allocation.
  class search {
   public:
    search() = default;
    /// As far as it has got.
    search(const search& other) { *this = other; }
    /// As far as it has got.
    search& operator=(const search& other) {
      size_ = other.size_;
      std::copy_n(other.stack_.begin(), size_, stack_.begin());
      return *this;
    }

    /// True if nothing is left to visit.
    bool done() const { return size_ == 0; }

   private:
    friend class bounding_volume_tree;
    struct entry {
      float bound;
      std::int32_t node;
    };
    // No branch has more than 3/7 of its node's items, so a tree of 2^31 is less than 27 levels deep; each
    // level leaves three nodes behind.
    std::array<entry, 3 * 27 + 1> stack_;  // of which the first `size_` are set
    int size_ = 0;
  };

  bounding_volume_tree() = default;

  /// O(n log n); may allocate. Boxes finite.
  explicit bounding_volume_tree(const std::vector<bounding_box<D>>& boxes) {
    if (boxes.empty()) return;
    bounding_box<D> all;
    for (const auto& box : boxes) all.extend(box);
    scale_ = detail::max_coordinate(all);
    std::vector<centre> centres;
    centres.reserve(boxes.size());
    for (const auto& box : boxes)
      centres.push_back({(box.lower / 2 + box.upper / 2).template cast<float>(),
                         static_cast<std::int32_t>(centres.size())});
    build(boxes, {centres.data(), centres.data() + centres.size()}, centres.data());
    nodes_.shrink_to_fit();
    items_.reserve(centres.size());
    for (const centre& c : centres) items_.push_back(c.item);
  }

  /// Number of items.
  std::size_t size() const { return items_.size(); }

  /// Which item stands at a place, 0 <= place < size().
  int item(int place) const { return nth(items_, place); }

  /// Largest coordinate of the boxes [m].
  double scale() const { return scale_; }

  /// A search from the root.
  search start() const {
    search s;
    if (!nodes_.empty()) nth(s.stack_, s.size_++) = {0, 0};
    return s;
  }

  /// Calls visit(place, bound) for items whose bound is <= limit, those in nearer branches first; visit may
  /// lower the limit. Up to four items share the bound of a box about them. Opens no more than `budget`
  /// nodes.
  template <class Bound, class Visit>
  void go_on(search& s, const Bound& bound, double& limit, const Visit& visit,
             int budget = std::numeric_limits<int>::max()) const {
    const node* here;
    four bounds;
    unsigned within;  // a bit for each branch
    const auto open = [&](std::int32_t number) {
      --budget;
      here = &nth(nodes_, number);
      const four nearly = bound(here->boxes);
      within = bits(nearly <= static_cast<float>(limit) * (1 + rounding));
      bounds = min(nearly * (1 - rounding), std::numeric_limits<float>::max());
    };
    while (s.size_ > 0 && budget > 0) {
      const auto top = nth(s.stack_, --s.size_);
      if (!(top.bound <= limit)) continue;
      open(top.node);
      // One branch alone leads on without the stack, for which the processor would wait
      while (const std::int32_t* on = only_inner(*here, within)) {
        if (budget <= 0) break;
        open(*on);
      }
      const int inner = s.size_;
      for (; within != 0; within &= within - 1) {
        const auto k = static_cast<std::size_t>(std::countr_zero(within));
        const float b = bounds[static_cast<int>(k)];
        if (here->count[k] == 0) push(s, inner, {b, here->first[k]});
        for (std::int32_t i = 0; i < here->count[k] && b <= limit; ++i)
          visit(static_cast<int>(here->first[k] + i), double(b));
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
  static constexpr float rounding = four_outer_boxes<D>::rounding;
  static constexpr std::ptrdiff_t leaf_size = 4;
  static constexpr std::int32_t empty = -1;

  struct node {
    four_outer_boxes<D> boxes;
    std::array<std::int32_t, 4> first;  // of a leaf its first place; of an inner node its number
    std::array<std::int32_t, 4> count;  // of items; 0 of an inner node, `empty` of a branch without any
  };

  // An item while the tree is built
  struct centre {
    vector<float, D> at;  // [m]
    std::int32_t item;
  };
  struct range {
    centre *begin, *end;
    std::ptrdiff_t size() const { return end - begin; }
  };

  // The number of the only branch within, if that is an inner node
  static const std::int32_t* only_inner(const node& n, unsigned within) {
    if (within == 0 || (within & (within - 1)) != 0) return nullptr;
    const auto k = static_cast<std::size_t>(std::countr_zero(within));
    return n.count[k] == 0 ? &n.first[k] : nullptr;
  }

  // Keeps those pushed since `from` in order, the nearest on top.
  static void push(search& s, int from, typename search::entry e) {
    int at = s.size_++;
    for (; at > from && nth(s.stack_, at - 1).bound < e.bound; --at)
      nth(s.stack_, at) = nth(s.stack_, at - 1);
    nth(s.stack_, at) = e;
  }

  // In two at the middle of the longest side of the box about the centres; where that leaves less than a
  // quarter on one side, in halves of their number.
  static centre* cut(range r) {
    if (r.size() < 2) return r.end;
    vector<float, D> lower = r.begin->at, upper = lower;
    for (const centre* c = r.begin; c != r.end; ++c) {
      lower = lower.cwiseMin(c->at);
      upper = upper.cwiseMax(c->at);
    }
    int axis = 0;
    (upper - lower).maxCoeff(&axis);
    const float middle = lower[axis] / 2 + upper[axis] / 2;
    centre* at = r.begin;
    for (centre* c = r.begin; c != r.end; ++c) {  // std::partition, without branches that cannot be foretold
      const bool low = c->at[axis] < middle;
      std::swap(*c, *at);
      at += low;
    }
    const auto least = (r.size() + 3) / 4;
    if (at - r.begin >= least && r.end - at >= least) return at;
    at = r.begin + r.size() / 2;
    std::nth_element(r.begin, at, r.end,
                     [&](const centre& a, const centre& b) { return a.at[axis] < b.at[axis]; });
    return at;
  }

  // Makes the node of these items and all below it, and returns the box about them.
  bounding_box<D> build(const std::vector<bounding_box<D>>& boxes, range all, const centre* first) {
    const auto at = nodes_.size();
    nodes_.emplace_back();
    std::array<range, 4> branches{all};
    for (std::size_t k = 1; k < 4; ++k) {
      range& largest = *std::max_element(branches.begin(), branches.begin() + k,
                                         [](const range& a, const range& b) { return a.size() < b.size(); });
      branches[k] = {cut(largest), largest.end};
      largest.end = branches[k].begin;
    }
    std::array<bounding_box<D>, 4> about;
    for (std::size_t k = 0; k < 4; ++k) {
      const range r = branches[k];
      const bool leaf = r.size() <= leaf_size;
      nodes_[at].first[k] =
          static_cast<std::int32_t>(leaf ? r.begin - first : static_cast<std::ptrdiff_t>(nodes_.size()));
      nodes_[at].count[k] = !leaf ? 0 : r.size() > 0 ? static_cast<std::int32_t>(r.size()) : empty;
      if (leaf)
        for (const centre* c = r.begin; c != r.end; ++c) about[k].extend(nth(boxes, c->item));
      else about[k] = build(boxes, r, first);
    }
    nodes_[at].boxes = {about, scale_};
    for (std::size_t k = 1; k < 4; ++k) about[0].extend(about[k]);
    return about[0];
  }

  std::vector<node> nodes_;
  std::vector<std::int32_t> items_;  // by their places
  double scale_ = 0;                 // largest coordinate [m]
};

}  // namespace passive_haptics
