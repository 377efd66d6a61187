/// @file
/// The time steps of a wall-following experiment as an array of Python.
#pragma once

#include "devices.hpp"
#include "progress.hpp"

#include <pybind11/numpy.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace passive_haptics_python {

/// Time steps as rows of 8-byte numbers: doubles, and whole numbers in the same width.
class recorder final : public following_observer {
 public:
  /// Of a device of these sizes. wanted: whether rows are kept.
  recorder(const device_sizes& sizes, bool wanted, const ph::wall_following_parameters& parameters)
      : sizes_(sizes), wanted_(wanted), progress_(milliseconds(parameters.max_duration), "ms at most") {}

  /// Keeps a row, and lets Ctrl-C end the experiment.
  void see(const following_sample& now) override {
    constexpr int steps_between_signals = 1 << 10;
    if (++steps_ % steps_between_signals == 0) {
      let_others_run();
      progress_.show(milliseconds(now.time));
    }
    if (!wanted_) return;
    const int d = sizes_.task_dimension, m = sizes_.brake_count;
    const result_values& c = *now.control;
    add(&now.time, 1);
    add(&now.depth, 1);
    for (const auto& [first, count] : {std::pair{now.position, d},
                                       {now.velocity, d},
                                       {now.rates, m},
                                       {now.torque, m},
                                       {now.power, m},
                                       {now.hand_force, d},
                                       {now.brake_force, d},
                                       {c.capacity.data(), m}})
      add(first, count);
    add(&c.alpha, 1);
    for (const int whole : {int(c.outcome), int(c.power), int(c.display), int(c.saturated), c.wall_number})
      numbers_.push_back(std::bit_cast<double>(std::int64_t(whole)));
  }

  /// The rows, an array with named fields.
  py::array rows() const {
    py::list fields;
    const auto add_field = [&](const char* name, const char* kind, int width) {
      if (width == 1) fields.append(py::make_tuple(name, kind));
      else fields.append(py::make_tuple(name, kind, py::make_tuple(width)));
    };
    const int d = sizes_.task_dimension, m = sizes_.brake_count;
    for (const char* name : {"time", "depth"}) add_field(name, "f8", 1);
    for (const auto& [name, width] : {std::pair{"position", d},
                                      {"velocity", d},
                                      {"rates", m},
                                      {"brake_torque", m},
                                      {"brake_power", m},
                                      {"hand_force", d},
                                      {"brake_force", d},
                                      {"capacity", m}})
      add_field(name, "f8", width);
    add_field("alpha", "f8", 1);
    for (const char* name : {"outcome", "power", "display", "saturated", "wall_number"})
      add_field(name, "i8", 1);
    const py::dtype type = py::dtype::from_args(fields);
    const auto count = py::ssize_t(numbers_.size() * sizeof(double)) / type.itemsize();
    return py::array(type, std::vector<py::ssize_t>{count}, numbers_.data());
  }

 private:
  static long milliseconds(double time) { return std::lround(1e3 * time); }
  void add(const double* first, int count) { numbers_.insert(numbers_.end(), first, first + count); }

  device_sizes sizes_;
  bool wanted_;
  progress progress_;
  long steps_ = 0;
  std::vector<double> numbers_;
};

}  // namespace passive_haptics_python
