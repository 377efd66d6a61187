/// @file
/// A device, its law, scene and state: the functions of exports.hpp.
#pragma once

#include "drawing.hpp"
#include "parts.hpp"
#include "value_table.hpp"

#include <array>
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
  /// The form, JSON.
  std::string form();
  /// q, qd, Fh, Fd, which the page may write.
  double* state() { return state_.data(); }
  /// The parts, with the state as it was written.
  const device_parts& parts();
  /// Puts the handle at x [m]; true if it was reached.
  bool reach(const place& x);
  /// Sets qd so that the handle moves with v [m/s].
  void move(const place& v);
  /// Takes the other elbow; false if there is none.
  bool flip();
  /// Computes all values.
  void evaluate();
  /// The values.
  value_table& values() { return values_; }
  /// The drawing.
  drawing draw();
  /// The box of the reach [m]: low, high.
  double* bounds();
  /// Points of the forces that can be produced in a region of torque signs [N]; -1: the present one.
  std::vector<double> outline(int region);
  /// Handle positions over a length [m] to each side of the handle while this brake holds; none unless n = 2.
  std::vector<double> locus(int brake, double length);

 private:
  void write_state();
  void set_joints(const joint_numbers& q);

  device_parts parts_;
  std::vector<double> state_;
  value_table values_;
  std::array<double, 6> bounds_{};
};

/// The device of a text of settings. Throws std::invalid_argument.
device make_device(const settings& given);

}  // namespace explorer
