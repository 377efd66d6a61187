/// Depth of the handle in each wall when the brakes are activated.
#pragma once

#include <configuration/configuration.hpp>

#include <string>
#include <vector>

namespace example {

/// A wall by its number in the file, and the depth of a point in it.
struct wall_depth {
  int number = 0;    ///< From 1; 0 for none.
  double depth = 0;  ///< < 0 in front of the wall, NaN for an unknown point [m].

  /// True if brakes must not be activated; largest: max_start_depth [m].
  bool is_over(double largest) const noexcept { return number > 0 && !(depth <= largest); }
};

/// The wall with the maximum depth of a point [m]; the nearest one if it is in front of all.
wall_depth deepest_wall(const std::vector<named_wall>& walls, const spatial& x) noexcept;

/// One line for the home pose and for each wall, as "wall 1 (half_space): 0.5 mm in front of it".
std::string home_in_words(const configuration& c);

/// Error text of the home pose with its likely cause: too deep in a wall, undefined, or an angle beyond a
/// full turn. Empty if there is none.
std::string home_error(const configuration& c);

/// Text of the reason why brakes are not activated at this depth.
std::string not_activated_in_words(const wall_depth& deepest);

}  // namespace example
