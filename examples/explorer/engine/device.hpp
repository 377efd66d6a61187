/// @file
/// A device, its law, scene and state: as the page shows it.
#pragma once

#include "parts.hpp"
#include "value_table.hpp"

#include <string>
#include <vector>

namespace explorer {

/// A device that the page shows.
class device {
 public:
  /// With these settings. Throws std::invalid_argument.
  explicit device(const configuration& c);
  /// Changes settings. Throws std::invalid_argument, with nothing changed.
  void set(const settings& changed);
  /// All lines that differ from the defaults, and the state.
  settings changed();
  /// n + n + 3 + 3 numbers that the page may write: q [rad or m], qd [rad/s or m/s], Fh and Fd [N].
  double* state() { return state_.data(); }
  /// The parts, with the state as it was written.
  const device_parts& parts();
  /// Puts the handle at x [m], on the present branch; true if it was reached, else q is at the nearest reach.
  bool reach(const place& x);
  /// Sets qd to the least joint rates that move the handle with v [m/s].
  void move(const place& v);
  /// Computes all values at the state: one control cycle of a fresh controller, and what is drawn.
  void evaluate();
  /// The values.
  value_table& values() { return values_; }
  /// The drawing at the state, as rows of numbers.
  std::vector<double> draw();
  /// The box of the reach [m]: low, high.
  std::vector<double> bounds();
  /// Outline of the forces [N] that the brakes can produce within their limits in one region of torque signs,
  /// 0 to 2^m - 1 as in passive_fme.hpp: (+,+), (+,-), (-,+), (-,-); -1: that of the present signs, also with
  /// brakes at rest. Points x, y, z: in the plane a closed polygon, in space triangles.
  std::vector<double> outline(int region);
  /// Handle positions over a length [m] to each side of the handle while this brake holds; none unless n = 2.
  std::vector<double> locus(int brake, double length);

 private:
  void write_state();
  void set_joints(const joint_numbers& q);

  device_parts parts_;
  std::vector<double> state_;
  value_table values_;
};

/// The device of a text of settings. Throws std::invalid_argument.
device make_device(const settings& given);

}  // namespace explorer
