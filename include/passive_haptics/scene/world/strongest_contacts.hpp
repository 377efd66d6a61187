/// @file
/// Which contacts are kept where there are more than a step takes.
#pragma once

#include <passive_haptics/scene/contacts.hpp>

#include <algorithm>
#include <tuple>

namespace passive_haptics {

/// Keeps the contacts of the largest forces k * depth, of equal ones those of lower wall numbers. What is
/// kept does not depend on the order in which they come.
template <int D, int Capacity>
class strongest_contacts {
 public:
  /// Forgets all.
  void clear() {
    kept_.clear();
    left_out_ = 0;
  }

  /// Takes a contact.
  void add(const contact<D>& c) {
    if (kept_.push_back(c)) return;
    ++left_out_;
    contact<D>* weakest = std::max_element(kept_.begin(), kept_.end(), stronger);
    if (stronger(c, *weakest)) *weakest = c;
  }

  /// Those kept, in the order of their walls.
  const contacts<D, Capacity>& in_order() {
    if (kept_.size() > 1) sort_by_wall();
    return kept_;
  }

  /// How many are not among them.
  int left_out() const { return left_out_; }

 private:
  static double force(const contact<D>& c) { return c.stiffness * c.depth; }
  static bool stronger(const contact<D>& a, const contact<D>& b) {
    return std::tuple(-force(a), a.wall_number) < std::tuple(-force(b), b.wall_number);
  }
  // Of one wall with several contacts the deepest comes first
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
