/// Construction of a world.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/world/any_wall.hpp>

#include <string>
#include <utility>
#include <vector>

namespace passive_haptics {

/// Walls of a new world, numbered from 0 in the order of addition.
template <int D>
class world_walls {
 public:
  /// Adds a wall at rest; returns its number.
  int add(any_wall<D> w) {
    walls_.push_back(std::move(w));
    return static_cast<int>(walls_.size()) - 1;
  }

  /// Adds a wall for world::set_motion; returns its number.
  int add_moving(any_wall<D> w) {
    moving_.push_back(add(std::move(w)));
    return moving_.back();
  }

  const std::vector<any_wall<D>>& all() const { return walls_; }  ///< All walls by number.
  const std::vector<int>& moving() const { return moving_; }      ///< Numbers of the walls that may move.

 private:
  std::vector<any_wall<D>> walls_;
  std::vector<int> moving_;
};

/// Returns an error text, empty if there is none.
template <int D>
std::string validate(const world_walls<D>& walls) {
  for (std::size_t i = 0; i < walls.all().size(); ++i) {
    const bounding_box<D>& b = walls.all()[i].bounds();
    for (int k = 0; k < D; ++k)
      if (!(b.lower[k] <= b.upper[k]))
        return detail::error_text(
            detail::indexed(detail::indexed("bounds of wall ", i, " of a world: upper["), k, "] [m]"),
            b.upper[k], "at least lower, " + detail::number_text(b.lower[k]));
  }
  return {};
}

}  // namespace passive_haptics
