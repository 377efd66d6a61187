/// @file
/// A device as it is drawn in a pose: points of links, pulleys and brakes.
#pragma once

#include "places.hpp"

#include <vector>

namespace explorer {

/// Items of a drawing; exports.hpp lists their numbers.
enum class item_kind { ground, link, joint, slide, carriage, pulley, belt, brake, platform, handle };

/// Items of a drawing, rows of 10 numbers.
class drawing {
 public:
  static constexpr int width = 10;  ///< Numbers of a row.

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
  /// Items.
  int size() const { return static_cast<int>(rows_.size()) / width; }
  /// The rows.
  double* data() { return rows_.data(); }

 private:
  std::vector<double> rows_;
};

}  // namespace explorer
