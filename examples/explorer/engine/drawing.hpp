/// @file
/// A device as it is drawn in a pose: points of links, pulleys and brakes.
#pragma once

#include "places.hpp"

#include <vector>

namespace explorer {

/// Items of a drawing, with the meaning of their rows: kind, number, x0, y0, z0, x1, y1, z1, size, angle.
enum class item_kind {
  ground,    ///< At 0; size: half its width.
  link,      ///< From 0 to 1.
  joint,     ///< At 0, turns about 1 - 0.
  slide,     ///< A rail from 0 to 1.
  carriage,  ///< At 0, moves along 1 - 0.
  pulley,    ///< At 0; size: radius; angle: how far it turned [rad]; number: of the brake from 0.
  belt,      ///< A straight run of a tendon from 0 to 1.
  brake,     ///< At 0, axis 1 - 0; as a pulley.
  platform,  ///< An edge from 0 to 1.
  handle,    ///< At 0.
};

/// Items of a drawing, rows of 10 numbers.
class drawing {
 public:
  /// Adds an item. number: of the brake or joint from 0, -1 for none. size [m], angle [rad].
  void add(item_kind kind, int number, const place& from, const place& to, double size = 0,
           double angle = 0) {
    rows_.insert(rows_.end(), {double(int(kind)), double(number), from[0], from[1], from[2], to[0], to[1],
                               to[2], size, angle});
  }
  /// Adds an item at a point.
  void add(item_kind kind, const place& at, double size = 0) { add(kind, -1, at, at, size); }
  /// Adds a joint or brake that turns about `axis`.
  void add_turning(item_kind kind, int number, const place& at, const place& axis, double size = 0,
                   double angle = 0) {
    add(kind, number, at, at + axis, size, angle);
  }
  /// The rows, one after the other.
  const std::vector<double>& numbers() const { return rows_; }

 private:
  std::vector<double> rows_;
};

}  // namespace explorer
