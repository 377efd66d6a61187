/// @file
/// The ports that a configuration names.
#pragma once

#include <configuration/configuration.hpp>
#include <devices/haptic_device.hpp>
#include <ports/any_port.hpp>

namespace example {

/// What a port is for: to control, or only to release the brakes beside another that controls.
enum class port_use { control, release };

/// The port of the configuration; a simulated one belongs to the device, any other is called by a thread of
/// its own where it controls. Throws std::invalid_argument where this program was built without what it
/// needs.
any_brake_port make_port(const configuration& c, haptic_device& device, port_use use);
/// Its force sensor, in the same way.
any_force_sensor make_sensor(const configuration& c, haptic_device& device);

}  // namespace example
