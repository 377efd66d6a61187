/// Ports of a configuration.
#pragma once

#include <configuration/configuration.hpp>
#include <devices/haptic_device.hpp>
#include <ports/any_port.hpp>

namespace example {

/// Purpose of a port: to control, or only to release the brakes next to a controlling port.
enum class port_use { control, release };

/// Makes the port of the configuration. A simulated one belongs to the device; any other controlling port is
/// called by its own thread. Throws std::invalid_argument if this program was built without its library.
any_brake_port make_port(const configuration& c, haptic_device& device, port_use use);
/// Makes its force sensor in the same way.
any_force_sensor make_sensor(const configuration& c, haptic_device& device);

}  // namespace example
