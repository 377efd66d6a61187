/// @file
/// Where the handle is when the brakes come on: its depth in each wall.
#pragma once

#include <configuration/configuration.hpp>

#include <string>
#include <vector>

namespace example {

/// A wall, as the file numbers it, and how deep a point is in it.
struct wall_depth {
  int number = 0;    ///< From 1; 0 for none.
  double depth = 0;  ///< < 0 in front of it, NaN where the point is not known [m].

  /// Whether brakes must not come on here; largest: the max_start_depth [m].
  bool is_over(double largest) const noexcept { return number > 0 && !(depth <= largest); }
};

/// The wall in which a point [m] is deepest; the nearest one in front of all of them.
wall_depth deepest_wall(const std::vector<named_wall>& walls, const spatial& x) noexcept;

/// A line for the home pose and one for each wall, as "wall 1 (half_space): 0.5 mm in front of it".
std::string home_in_words(const configuration& c);

/// What is wrong with the home pose, and the likely cause: deeper in a wall than brakes may come on, nowhere,
/// or an angle beyond a turn. Empty if nothing.
std::string home_error(const configuration& c);

/// Why brakes do not come on at this depth.
std::string not_activated_in_words(const wall_depth& deepest);

}  // namespace example
