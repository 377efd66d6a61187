/// @file
/// All settings of the driver, with the paper's device as the default.
#pragma once

#include <comedi/comedi_parameters.hpp>
#include <devices/planar_device.hpp>
#include <ports/net_ft.hpp>
#include <ports/simulation_parameters.hpp>
#include <serial/serial_port_parameters.hpp>

#include <passive_haptics/driver/calibration/device_calibration.hpp>
#include <passive_haptics/driver/control_loop.hpp>
#include <passive_haptics/driver/process/supervisor.hpp>
#include <passive_haptics/driver/real_time.hpp>
#include <passive_haptics/driver/safe_port_parameters.hpp>
#include <passive_haptics/runtime/device_file/device_description.hpp>

#include <memory>
#include <string>
#include <vector>

namespace example {

namespace ph = passive_haptics;

/// Channels of the force sensor of a device, at most.
inline constexpr int sensor_channels = 6;

/// A wall, as a person finds it in the file.
struct named_wall {
  std::string type;                 ///< Of the shape.
  std::string free_side;            ///< A question after the side on which it is free.
  ph::runtime::any_shape<2> shape;  ///< With its distance and normal.
};

/// Where the handle may be when the brakes come on.
struct start_parameters {
  double max_start_depth = 0.005;  ///< Deepest that it may be in a wall [m].

  /// The table of passive_haptics/core/parameters.hpp.
  static constexpr auto members() {
    using p = start_parameters;
    return ph::member_table(ph::member("max_start_depth", &p::max_start_depth, "m", ph::range::not_negative)
                                .suspicious_above(0.1));
  }
};

/// A configuration file, checked.
struct configuration {
  ph::runtime::device_description device;                       ///< As replay reads it.
  std::shared_ptr<const ph::runtime::any_mechanism> mechanism;  ///< Of the device.
  std::vector<named_wall> walls;                                ///< In the order of the file.

  // What was measured on the device
  ph::encoder_calibration_parameters<axes> encoders;
  ph::rate_estimator_parameters rates;
  ph::brake_curves<axes> curves{};
  ph::force_calibration_parameters<2, sensor_channels> force;
  ph::planar_sensor_frame<2> sensor_frame;
  ph::vector<double, axes> home = {0.55, -1.6};  ///< Joint positions at the start [rad or m].
  ph::steady_parameters homing;
  start_parameters start;
  bool tare = true;             ///< Whether the sensor's offset is taken at the start, with the hand off.
  double tare_tolerance = 0.5;  ///< Most that a channel may move meanwhile, in its unit.

  // How the loop runs and when it lets go
  ph::control_loop_parameters loop;
  ph::real_time_parameters real_time;
  ph::safe_port_parameters<axes, sensor_channels> safety;
  ph::supervisor_parameters supervisor;

  std::string port = "simulated";  ///< Or comedi, serial.
  comedi_port_parameters<axes, axes> comedi;
  serial_port_parameters serial;
  std::string sensor = "simulated";  ///< Or comedi, net_ft, none.
  comedi_force_sensor_parameters<2> comedi_sensor;
  net_ft_parameters net_ft;
  simulation_parameters simulation;

  std::string log = "brake_driver.csv";  ///< Empty for none.
};

/// Of a file; of the default without one. Throws std::invalid_argument that names file, line, key, value and
/// expectation.
configuration read_configuration(const std::string& path);

/// A line for each value that is allowed but unusual; empty if there is none.
std::string remarks(const configuration& c);

/// The device and the sensor replaced by simulated ones. Throws std::invalid_argument if the mechanism has no
/// inertia.
configuration simulated(configuration c);

/// Device, port, sensor and law, for a title.
std::string summary(const configuration& c);

}  // namespace example
