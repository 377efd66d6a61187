/// @file
/// The arrays of a batch in Python: states that come in, results that go out.
#pragma once

#include <passive_haptics_python/any_controller.hpp>
#include <passive_haptics_python/from_python.hpp>

#include <cstring>
#include <string>
#include <vector>

namespace passive_haptics_python {

/// Columns of numbers that come in: an array of N rows, or of N numbers. Where a column is one piece of
/// memory it is read where it stands; else parts of it are copied.
class input_columns {
 public:
  /// Nothing.
  input_columns() = default;
  /// Of an array of N rows of `width` numbers, or with width = 0 of N numbers; a TypeError or ValueError if
  /// it is something else. what: the rows in words.
  input_columns(py::handle x, const char* name, int width, const char* what);

  /// N
  py::ssize_t rows() const { return array_.shape(0); }
  /// Whether there is an array.
  bool is_given() const { return columns_ > 0; }
  /// Whether all columns are read where they stand.
  bool is_in_place() const { return in_place_; }
  /// The array.
  const py::array& array() const { return array_; }
  /// The columns from a row on, `count` rows of each; copies, if any, stand in `buffer`.
  std::vector<const double*> from(std::size_t first, std::size_t count, std::vector<double>& buffer) const;

 private:
  py::array array_;
  int columns_ = 0;
  bool in_place_ = true;
};

/// What a batch stores, an array for each member of step_result that was wanted; None for the others.
struct batch_values {
  py::object capacity, outcome, torque, power, display, saturated, wall_number, alpha, approximation_cosine,
      desired_force, control_force, cone_coefficients, signs;

  /// Calls f(name, array, numbers in a row: 'm' brakes, 'd' task dimensions or '1').
  template <class Self, class F>
  static void for_each(Self& self, F&& f) {
    f("capacity", self.capacity, 'm');
    f("outcome", self.outcome, '1');
    f("torque", self.torque, 'm');
    f("power", self.power, '1');
    f("display", self.display, '1');
    f("saturated", self.saturated, '1');
    f("wall_number", self.wall_number, '1');
    f("alpha", self.alpha, '1');
    f("approximation_cosine", self.approximation_cosine, '1');
    f("desired_force", self.desired_force, 'd');
    f("control_force", self.control_force, 'd');
    f("cone_coefficients", self.cone_coefficients, 'm');
    f("signs", self.signs, 'm');
  }
};

/// New arrays for N states of a device. fields: the names that are wanted, or None for all.
batch_values new_results(const device_sizes& sizes, py::ssize_t states, const py::object& fields);

/// Where the results of states go; a ValueError if these arrays are not those of `states` results of such a
/// device.
batch_columns columns_of(const batch_values& results, const device_sizes& sizes, py::ssize_t states);

/// Runs a batch, without Python's lock. Ctrl-C ends it between two parts.
batch_values run_batch(const any_batch& batch, const device_sizes& sizes, py::handle q, py::handle qd,
                       py::handle hand_force, py::handle time, const py::object& fields,
                       const py::object& out);

}  // namespace passive_haptics_python
