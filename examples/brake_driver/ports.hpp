/// @file
/// The ports that a configuration names.
#pragma once

#include <any_port.hpp>
#include <configuration.hpp>
#include <simulation.hpp>

#include <memory>

namespace example {

/// What a port is for: to control, or only to release the brakes beside another that controls.
enum class port_use { control, release };

/// Port and sensor of real devices. Throws std::invalid_argument where this program was built without what they need.
any_brake_port<axes, axes> make_real_port(const configuration& c, port_use use);
any_force_sensor make_real_sensor(const configuration& c);

/// The port of the configuration; the simulated one is a way to `plant`.
template <class M>
any_brake_port<axes, axes> make_port(const configuration& c, const std::shared_ptr<simulation<M>>& plant,
                                     port_use use) {
  if (c.port != "simulated") return make_real_port(c, use);
  return any_brake_port<axes, axes>::of<simulated_port<M>>(plant);
}

/// Its force sensor.
template <class M>
any_force_sensor make_sensor(const configuration& c, const std::shared_ptr<simulation<M>>& plant) {
  if (c.sensor != "simulated") return make_real_sensor(c);
  return any_force_sensor::of<simulated_force_sensor<M>>(plant);
}

}  // namespace example
