/// @file
/// What the loop says of each cycle.
#pragma once

#include <configuration/configuration.hpp>
#include <configuration/home.hpp>

#include <array>
#include <cstdint>
#include <limits>

namespace example {

/// What the driver is doing.
enum class phase : std::uint8_t { homing, taring, running };

/// Not known: an empty cell of the log.
inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

using pair = std::array<double, axes>;
inline constexpr pair unknown_pair{unknown, unknown};

/// Of a step_result, what is written down.
struct decision_record {
  ph::status outcome = ph::status::ok;
  ph::power_class power = ph::power_class::none;
  ph::display_class display = ph::display_class::exact;
  double gamma = 0, alpha = 1;            ///< [rad], [1]
  pair desired_force{}, control_force{};  ///< Fd, Fc [N]
  pair capacity{};                        ///< What each brake may hold [N m or N].
  pair torque{};                          ///< What each brake is predicted to do [N m or N].

  double approximation_angle() const { return gamma; }
};

/// A cycle, as a value that processes can hand over.
struct record {
  double time = 0;          ///< [s], since the loop began.
  std::int64_t number = 0;  ///< Of the period.
  phase doing = phase::homing;
  ph::port_state state = ph::port_state::ready;
  ph::fault_record reason;                   ///< Why the brakes are released.
  wall_depth too_deep;                       ///< Why ready brakes do not come on; none where they may.
  bool needs_homing = false;                 ///< Whether they stay so until the program starts again.
  ph::fault_record held_over;                ///< What is wrong with the last samples.
  pair q = unknown_pair, qd = unknown_pair;  ///< [rad or m], and of it a second; known once it is homed.
  pair x = unknown_pair;                     ///< Handle [m]; known once the device is homed.
  pair hand_force = unknown_pair;            ///< [N]; known once the sensor is tared.
  decision_record decision;
  bool was_asked = false;        ///< Whether there is a decision.
  pair current{};                ///< What each brake gets [A].
  bool current_is_known = true;  ///< False where the device is lost or refuses.
  double late = 0, compute = 0;  ///< [s]
};

}  // namespace example
