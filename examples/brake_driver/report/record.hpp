/// @file
/// What the loop says of each cycle.
#pragma once

#include <configuration/configuration.hpp>
#include <configuration/home.hpp>

#include <passive_haptics/runtime/cycle_record.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>

namespace example {

/// What the driver is doing.
enum class phase : std::uint8_t { homing, taring, running };

/// A cycle, as a value that processes can hand over.
struct record {
  double time = 0;          ///< [s], since the loop began.
  std::int64_t number = 0;  ///< Of the period.
  phase doing = phase::homing;
  ph::port_state state = ph::port_state::ready;
  ph::fault_record reason;               ///< Why the brakes are released.
  wall_depth too_deep;                   ///< Why ready brakes do not come on; none where they may.
  bool needs_homing = false;             ///< Whether they stay so until the program starts again.
  ph::fault_record held_over;            ///< What is wrong with the last samples.
  ph::runtime::joint_numbers q, qd;      ///< [rad or m], and of it a second; NaN until it is homed.
  ph::runtime::task_numbers x;           ///< Handle [m]; NaN until the device is homed.
  ph::runtime::task_numbers hand_force;  ///< [N]; NaN until the sensor is tared.
  ph::runtime::cycle_record decision;
  bool was_asked = false;              ///< Whether there is a decision.
  ph::runtime::joint_numbers current;  ///< What each brake gets [A].
  bool current_is_known = true;        ///< False where the device is lost or refuses.
  double late = 0, compute = 0;        ///< [s]

  record() = default;
  /// Of a device with these sizes: nothing is known of its motion, and its brakes are released.
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
