/// @file
/// What a device looks like in a pose: points of links, pulleys and brakes.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <vector>

namespace explorer {

namespace ph = passive_haptics;

/// What an item of a drawing is; the numbers stand in exports.hpp.
enum class item_kind { ground, link, joint, slide, carriage, pulley, belt, brake, platform, handle };

/// Items of a drawing, rows of 10 numbers.
class drawing {
 public:
  using place = ph::vector<double, 3>;  ///< A point [m], base frame.
  static constexpr int width = 10;      ///< Numbers of a row.

  /// A point of the plane.
  static place in_plane(const ph::vector<double, 2>& x) { return {x[0], x[1], 0}; }

  /// Forgets all.
  void clear() { rows_.clear(); }
  /// Adds an item. number: of the brake or joint from 0, -1 for none. size [m], angle [rad].
  void add(item_kind kind, int number, const place& from, const place& to, double size = 0,
           double angle = 0) {
    for (const double x :
         {double(int(kind)), double(number), from[0], from[1], from[2], to[0], to[1], to[2], size, angle})
      rows_.push_back(x);
  }
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

/// The axis out of the plane.
inline drawing::place out_of_plane() { return {0, 0, 1}; }

}  // namespace explorer
