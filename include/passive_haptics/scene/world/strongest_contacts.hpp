/// Selection of contacts if there are too many.
#pragma once

#include <passive_haptics/scene/contacts.hpp>

#include <algorithm>
#include <tuple>

namespace passive_haptics {

/// Keeps the contacts with the maximum forces k * depth, among equal ones those with lower wall numbers. The
/// result does not depend on their order.
template <int D, int Capacity>
class strongest_contacts {
 public:
  /// Removes all.
  void clear() {
    kept_.clear();
    left_out_ = 0;
  }

  /// Adds a contact.
  void add(const contact<D>& c) {
    if (kept_.push_back(c)) return;
    ++left_out_;
    contact<D>* weakest = std::max_element(kept_.begin(), kept_.end(), stronger);
    if (stronger(c, *weakest)) *weakest = c;
  }

  /// The kept contacts in the order of their walls.
  const contacts<D, Capacity>& in_order() {
    if (kept_.size() > 1) sort_by_wall();
    return kept_;
  }

  int left_out() const { return left_out_; }  ///< Number of contacts left out.

 private:
  static double force(const contact<D>& c) { return c.stiffness * c.depth; }
  static bool stronger(const contact<D>& a, const contact<D>& b) {
    return std::tuple(-force(a), a.wall_number) < std::tuple(-force(b), b.wall_number);
  }
  // The deepest contact of a wall comes first
  static auto rank(const contact<D>& c) { return std::tuple(c.wall_number, -c.depth); }
  void sort_by_wall() {
    const auto comes_first = [](const auto& a, const auto& b) { return rank(a) < rank(b); };
    for (contact<D>* c = kept_.begin(); c != kept_.end(); ++c)
      std::rotate(std::upper_bound(kept_.begin(), c, *c, comes_first), c, c + 1);
  }

  contacts<D, Capacity> kept_;
  int left_out_ = 0;
};

}  // namespace passive_haptics
