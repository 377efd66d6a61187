/// A tree of bounding boxes that can be searched a few nodes at a time and without allocation, which Eigen's
/// unsupported BVH and Boost.Geometry's R-tree cannot do.
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

/// An immutable tree with four branches per node over items 0 .. n-1, each given by its box. Any number of
/// threads may search it. The bound of a search is a function of four_outer_boxes: for each box the minimum
/// of the quantity searched for, >= 0 with relative error four_outer_boxes::rounding. Neighbouring items have
/// neighbouring places.
template <int D>
class bounding_volume_tree {
 public:
  using four = typename four_outer_boxes<D>::four;  ///< One value of each box.

  /// The state of an interrupted search. Copies do not allocate.
  class search {
   public:
    search() = default;
    search(const search& other) { *this = other; }  ///< A copy.
    /// A copy.
    search& operator=(const search& other) {
      size_ = other.size_;
      std::copy_n(other.stack_.begin(), size_, stack_.begin());
      return *this;
    }

    bool done() const { return size_ == 0; }  ///< True if nothing is left to visit.

   private:
    friend class bounding_volume_tree;
    struct entry {
      float bound;
      std::int32_t node;
    };
    // Each branch has at most 3/7 of its node's items: 27 levels for 2^31 items, three nodes left per level
    std::array<entry, 3 * 27 + 1> stack_;  // the first `size_` are set
    int size_ = 0;
  };

  bounding_volume_tree() = default;

  /// Builds the tree from finite boxes in O(n log n); may allocate.
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

  std::size_t size() const { return items_.size(); }  ///< Number of items.

  /// Returns the item at a place, 0 <= place < size().
  int item(int place) const { return nth(items_, place); }

  double scale() const { return scale_; }  ///< Maximum coordinate of the boxes [m].

  /// Starts a search at the root.
  search start() const {
    search s;
    if (!nodes_.empty()) nth(s.stack_, s.size_++) = {0, 0};
    return s;
  }

  /// Continues a search by at most `budget` nodes: calls visit(place, bound) for items with bound <= limit,
  /// nearer branches first. visit may lower the limit. Up to four items share a bound.
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
      // A single branch skips the stack, which would stall the processor
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

  /// Searches the whole tree: visits all items with bound <= limit, which visit may lower.
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
    std::array<std::int32_t, 4> first;  // first place of a leaf, node number of an inner node
    std::array<std::int32_t, 4> count;  // items of a leaf; 0 for an inner node, `empty` for no branch
  };

  struct centre {
    vector<float, D> at;  // [m]
    std::int32_t item;
  };
  struct range {
    centre *begin, *end;
    std::ptrdiff_t size() const { return end - begin; }
  };

  static const std::int32_t* only_inner(const node& n, unsigned within) {
    if (within == 0 || (within & (within - 1)) != 0) return nullptr;
    const auto k = static_cast<std::size_t>(std::countr_zero(within));
    return n.count[k] == 0 ? &n.first[k] : nullptr;
  }

  // Keeps the entries pushed since `from` sorted, the nearest on top.
  static void push(search& s, int from, typename search::entry e) {
    int at = s.size_++;
    for (; at > from && nth(s.stack_, at - 1).bound < e.bound; --at)
      nth(s.stack_, at) = nth(s.stack_, at - 1);
    nth(s.stack_, at) = e;
  }

  // Splits the longest side of the box about the centres in the middle, or at the median if that is uneven.
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
    for (centre* c = r.begin; c != r.end; ++c) {  // std::partition without unpredictable branches
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

  // Builds the node of these items and its subtree; returns their box.
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
  std::vector<std::int32_t> items_;  // by place
  double scale_ = 0;                 // maximum coordinate [m]
};

}  // namespace passive_haptics
