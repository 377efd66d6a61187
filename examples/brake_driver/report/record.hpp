/// Log record of a cycle.
#pragma once

#include <configuration/configuration.hpp>
#include <configuration/home.hpp>

#include <passive_haptics/runtime/cycle_record.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace example {

/// Phases of the driver.
enum class phase : std::uint8_t { homing, taring, running };

/// A cycle as a value for exchange between processes.
struct record {
  double time = 0;          ///< [s], since the start of the loop.
  std::int64_t number = 0;  ///< Number of the period.
  phase doing = phase::homing;
  ph::port_state state = ph::port_state::ready;
  ph::fault_record reason;               ///< Reason for the release.
  wall_depth too_deep;                   ///< Reason why ready brakes are not activated; none if they may be.
  bool needs_homing = false;             ///< True if that lasts until the program restarts.
  ph::fault_record held_over;            ///< Fault of the last samples.
  ph::runtime::joint_numbers q, qd;      ///< [rad or m], and its rate; NaN before homing.
  ph::runtime::task_numbers x;           ///< Handle [m]; NaN before homing.
  ph::runtime::task_numbers hand_force;  ///< [N]; NaN before taring.
  ph::runtime::cycle_record decision;
  bool was_asked = false;              ///< True if there is a decision.
  ph::runtime::joint_numbers current;  ///< Current of each brake [A].
  bool current_is_known = true;        ///< False if the device is lost or rejects writes.
  double late = 0, compute = 0;        ///< [s]

  record() = default;
  /// Of a device with these sizes: unknown motion, released brakes.
  explicit record(const ph::runtime::device_sizes& sizes) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();  // an empty cell of the log
    const auto fill = [](auto& numbers, int count, double value) {
      numbers.count = count;
      std::fill_n(numbers.values.begin(), count, value);
    };
    fill(q, sizes.dof, unknown);
    fill(qd, sizes.dof, unknown);
    fill(x, sizes.task_dimension, unknown);
    fill(hand_force, sizes.task_dimension, unknown);
    fill(decision.desired_force, sizes.task_dimension, 0);
    fill(decision.control_force, sizes.task_dimension, 0);
    fill(decision.capacity, sizes.brake_count, 0);
    fill(decision.torque, sizes.brake_count, 0);
    fill(current, sizes.brake_count, 0);
  }
};

}  // namespace example
