/// All settings of the driver, by default for the paper's device.
#pragma once

#include <comedi/comedi_parameters.hpp>
#include <devices/driven_mechanism.hpp>
#include <ports/net_ft.hpp>
#include <ports/simulation_parameters.hpp>
#include <serial/serial_port_parameters.hpp>

#include <passive_haptics/driver/calibration/device_calibration.hpp>
#include <passive_haptics/driver/control_loop.hpp>
#include <passive_haptics/driver/process/supervisor.hpp>
#include <passive_haptics/driver/real_time.hpp>
#include <passive_haptics/driver/safe_port_parameters.hpp>
#include <passive_haptics/runtime/device_file/device_description.hpp>

#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace example {

namespace ph = passive_haptics;

/// Maximum number of force channels.
inline constexpr int sensor_channels = 6;

/// A wall with the names of the file.
struct named_wall {
  std::string type;       ///< Type of the shape.
  std::string free_side;  ///< A question about its free side.
  /// Empty for an open surface, which has no inside.
  std::variant<std::monostate, ph::runtime::any_shape<2>, ph::runtime::any_shape<3>> shape;

  /// Signed distance of the handle [m]; infinite without an inside.
  double distance(const spatial& x) const {
    if (const auto* plane = std::get_if<1>(&shape)) return plane->distance(x.head<2>());
    if (const auto* space = std::get_if<2>(&shape)) return space->distance(x);
    return std::numeric_limits<double>::infinity();
  }
  /// Its gradient; 0 without an inside.
  spatial gradient(const spatial& x) const {
    if (const auto* space = std::get_if<2>(&shape)) return space->gradient(x);
    spatial all = spatial::Zero();
    if (const auto* plane = std::get_if<1>(&shape)) all.head<2>() = plane->gradient(x.head<2>());
    return all;
  }
};

/// Orientation of the force sensor: a sum of joint angles for planar devices, constant for spatial ones.
struct sensor_orientation {
  driven_mechanism mechanism;
  ph::planar_sensor_frame<max_axes> link;  ///< Of joint angles.

  /// R for these encoder axes.
  ph::matrix<double, 3, 3> operator()(const axis_numbers& axes) const noexcept {
    ph::matrix<double, 3, 3> R = ph::matrix<double, 3, 3>::Identity();
    R.topLeftCorner<2, 2>() = link(mechanism.joint_positions(axes));
    return R;
  }
};
/// Counts and readings to the state of the axes, and capacities to currents.
using calibration = ph::device_calibration<driven_mechanism, sensor_channels, sensor_orientation>;

/// Conditions for driving the brakes.
struct start_parameters {
  double max_start_depth = 0.005;  ///< Maximum depth of the handle in a wall [m].

  static constexpr auto members() {
    using p = start_parameters;
    return ph::member_table(ph::member("max_start_depth", &p::max_start_depth, "m", ph::range::not_negative)
                                .suspicious_above(0.1));
  }
};

/// A checked configuration file.
struct configuration {
  ph::runtime::device_description device;  ///< As read by replay.
  driven_mechanism mechanism;              ///< Mechanism of the device.
  std::vector<named_wall> walls;           ///< In the order of the file.

  // Measured on the device, with defaults
  ph::encoder_calibration_parameters<max_axes> encoders;
  ph::rate_estimator_parameters rates;
  ph::brake_curves<max_axes> curves{};
  ph::force_calibration_parameters<3, sensor_channels> force;  ///< z is unused for planar devices.
  ph::planar_sensor_frame<max_axes> sensor_link{.link = axis_numbers::Zero()};
  axis_numbers home = axis_numbers::Zero();  ///< Joint positions at the start [rad or m].
  ph::steady_parameters homing;
  start_parameters start;
  bool tare = true;             ///< Determines the sensor's offset at the start, without the hand.
  double tare_tolerance = 0.5;  ///< Maximum change of a channel during taring, in its unit.

  // Loop and release
  ph::control_loop_parameters loop;
  ph::real_time_parameters real_time;
  ph::safe_port_parameters<max_axes, sensor_channels> safety;
  ph::supervisor_parameters supervisor;

  std::string port = "simulated";  ///< simulated, comedi or serial.
  std::variant<comedi_port_parameters<2, 2>, comedi_port_parameters<3, 3>> comedi;
  serial_port_parameters serial;
  std::string sensor = "simulated";  ///< simulated, comedi, net_ft or none.
  std::variant<comedi_force_sensor_parameters<2>, comedi_force_sensor_parameters<3>> comedi_sensor;
  net_ft_parameters net_ft;
  simulation_parameters simulation;

  std::string log = "brake_driver.csv";  ///< Empty for none.
};

/// Reads a file; an empty path gives the default. Throws std::invalid_argument with file, line, key, value
/// and expectation.
configuration read_configuration(const std::string& path);

calibration calibration_of(const configuration& c);

/// One line per allowed but unusual value; empty if there is none.
std::string remarks(const configuration& c);

/// The configuration with simulated device and sensor. Throws std::invalid_argument if the mechanism has no
/// inertia.
configuration simulated(configuration c);

/// Device, port, sensor and law, for a title.
std::string summary(const configuration& c);

}  // namespace example
