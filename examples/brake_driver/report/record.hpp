/// @file
/// What the loop says of each cycle.
#pragma once

#include <configuration/configuration.hpp>

#include <array>
#include <cstdint>

namespace example {

/// What the driver is doing.
enum class phase : std::uint8_t { homing, taring, running };

/// A cycle, as a value that processes can hand over.
struct record {
  double time = 0;          ///< [s], since the loop began.
  std::int64_t number = 0;  ///< Of the period.
  phase doing = phase::homing;
  ph::port_state state = ph::port_state::ready;
  ph::fault_record reason;     ///< Why the brakes are released.
  bool needs_homing = false;   ///< Whether they stay so until the program starts again.
  ph::fault_record held_over;  ///< What is wrong with the last samples.
  ph::status outcome = ph::status::ok;
  ph::power_class power = ph::power_class::none;
  ph::display_class display = ph::display_class::exact;
  double gamma = 0, alpha = 1;          ///< [rad], [1]
  std::array<double, axes> q{}, qd{};   ///< [rad or m], and of it a second
  std::array<double, 2> x{};            ///< Handle [m].
  std::array<double, 2> hand{};         ///< Force of the hand [N].
  std::array<double, 2> desired{};      ///< Force that the walls ask for [N].
  std::array<double, axes> capacity{};  ///< What each brake may hold [N m].
  std::array<double, axes> current{};   ///< What each brake gets [A].
  bool current_is_known = true;         ///< False where the device is lost or refuses.
  double late = 0, compute = 0;         ///< [s]
};

}  // namespace example
