/// @file
/// A controller whose mechanism, scene and law are known at run time only.
#pragma once

#include <passive_haptics_python/batch_columns.hpp>
#include <passive_haptics_python/states.hpp>

#include <memory>

namespace passive_haptics_python {

/// The batches of a controller.
struct any_batch {
  /// As of a base class.
  virtual ~any_batch() = default;
  /// Stores the results of these states; throws std::invalid_argument as a batch_controller does. May be
  /// called by several threads at once, and needs no lock of Python.
  virtual void run(const batch_columns& columns) const = 0;
};

struct brake_numbers;

/// A controller and its batches.
struct any_controller : any_batch {
  /// One control cycle.
  virtual result_values step(const state_values& state) = 0;
  /// Forgets the motion so far.
  virtual void reset() = 0;
  /// Other brakes of the device from the next cycle on.
  virtual void set_brakes(const brake_numbers& brakes) = 0;
};

/// n, d and m of a device.
struct device_sizes {
  int dof = 0;             ///< n
  int task_dimension = 0;  ///< d
  int brake_count = 0;     ///< m
};

}  // namespace passive_haptics_python
