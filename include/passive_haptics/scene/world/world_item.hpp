/// Items of a world: in its tree or outside it.
#pragma once

#include <cstddef>

namespace passive_haptics {

/// An item of a neighbour_list, by its place in the tree or among the others.
class world_item {
 public:
  constexpr world_item() = default;  ///< The first item of the tree.

  /// Item at a place in the tree.
  static constexpr world_item in_tree(int place) { return world_item(place); }
  /// Item at a place among the others.
  static constexpr world_item outside(std::size_t place) { return world_item(-1 - static_cast<int>(place)); }

  constexpr bool is_in_tree() const { return code_ >= 0; }  ///< True for an item of the tree.
  /// Place in its list.
  constexpr std::size_t place() const { return static_cast<std::size_t>(is_in_tree() ? code_ : -1 - code_); }

 private:
  explicit constexpr world_item(int code) : code_(code) {}

  int code_ = 0;  // places in the tree are 0, 1, ..., of the others -1, -2, ...
};

}  // namespace passive_haptics
