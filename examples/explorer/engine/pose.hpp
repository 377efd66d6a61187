/// @file
/// The values of a pose: motion, forces, brakes and decision.
#pragma once

#include "parts.hpp"
#include "value_table.hpp"

#include <passive_haptics/runtime/cycle_record.hpp>

#include <string>
#include <vector>

namespace explorer {

/// The table of a device's values.
value_table pose_table(const configuration& c);
/// Fills it at the pose of the settings.
void evaluate(value_table& table, const device_parts& of);

// Shared with the rows of a simulation

/// The names of power_class, of display, of brake states and of status, in the order of the enumerations.
std::vector<std::string> power_words(), display_words(), brake_words(), status_words();
/// The number of the word for how a cycle displays its force.
int display_number(const runtime::cycle_record& r);
/// Puts the state of each brake at its rate [rad/s] with a capacity [N m]: an index of brake_words().
void put_brake_states(value_table& table, const configuration& c, numbers rates, numbers capacity);

}  // namespace explorer
