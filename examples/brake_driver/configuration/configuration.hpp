/// @file
/// All settings of the driver, with the paper's device as the default.
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

/// Channels of the force sensor of a device, at most.
inline constexpr int sensor_channels = 6;

/// A wall, as a person finds it in the file.
struct named_wall {
  std::string type;       ///< Of the shape.
  std::string free_side;  ///< A question after the side on which it is free.
  /// None of an open surface, which has no inside.
  std::variant<std::monostate, ph::runtime::any_shape<2>, ph::runtime::any_shape<3>> shape;

  /// Signed distance of the handle [m]; infinite from what has no inside.
  double distance(const spatial& x) const {
    if (const auto* plane = std::get_if<1>(&shape)) return plane->distance(x.head<2>());
    if (const auto* space = std::get_if<2>(&shape)) return space->distance(x);
    return std::numeric_limits<double>::infinity();
  }
  /// Its gradient there; 0 of what has no inside.
  spatial gradient(const spatial& x) const {
    if (const auto* space = std::get_if<2>(&shape)) return space->gradient(x);
    spatial all = spatial::Zero();
    if (const auto* plane = std::get_if<1>(&shape)) all.head<2>() = plane->gradient(x.head<2>());
    return all;
  }
};

/// How the force sensor turns: in the plane with a sum of joint angles, in space not at all.
struct sensor_orientation {
  driven_mechanism mechanism;
  ph::planar_sensor_frame<max_axes> link;  ///< Of joint angles.

  /// R where the axes of the encoders are so.
  ph::matrix<double, 3, 3> operator()(const axis_numbers& axes) const noexcept {
    ph::matrix<double, 3, 3> R = ph::matrix<double, 3, 3>::Identity();
    R.topLeftCorner<2, 2>() = link(mechanism.joint_positions(axes));
    return R;
  }
};
/// From counts and readings to the state of the axes, and from capacities to currents.
using calibration = ph::device_calibration<driven_mechanism, sensor_channels, sensor_orientation>;

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
  ph::runtime::device_description device;  ///< As replay reads it.
  driven_mechanism mechanism;              ///< Of the device.
  std::vector<named_wall> walls;           ///< In the order of the file.

  // What was measured on the device, with defaults for what it lacks
  ph::encoder_calibration_parameters<max_axes> encoders;
  ph::rate_estimator_parameters rates;
  ph::brake_curves<max_axes> curves{};
  ph::force_calibration_parameters<3, sensor_channels> force;  ///< In the plane nobody reads z.
  ph::planar_sensor_frame<max_axes> sensor_link{.link = axis_numbers::Zero()};
  axis_numbers home = axis_numbers::Zero();  ///< Joint positions at the start [rad or m].
  ph::steady_parameters homing;
  start_parameters start;
  bool tare = true;             ///< Whether the sensor's offset is taken at the start, with the hand off.
  double tare_tolerance = 0.5;  ///< Most that a channel may move meanwhile, in its unit.

  // How the loop runs and when it lets go
  ph::control_loop_parameters loop;
  ph::real_time_parameters real_time;
  ph::safe_port_parameters<max_axes, sensor_channels> safety;
  ph::supervisor_parameters supervisor;

  std::string port = "simulated";  ///< Or comedi, serial.
  std::variant<comedi_port_parameters<2, 2>, comedi_port_parameters<3, 3>> comedi;
  serial_port_parameters serial;
  std::string sensor = "simulated";  ///< Or comedi, net_ft, none.
  std::variant<comedi_force_sensor_parameters<2>, comedi_force_sensor_parameters<3>> comedi_sensor;
  net_ft_parameters net_ft;
  simulation_parameters simulation;

  std::string log = "brake_driver.csv";  ///< Empty for none.
};

/// Of a file; of the default without one. Throws std::invalid_argument that names file, line, key, value and
/// expectation.
configuration read_configuration(const std::string& path);

/// Its calibrations.
calibration calibration_of(const configuration& c);

/// A line for each value that is allowed but unusual; empty if there is none.
std::string remarks(const configuration& c);

/// The device and the sensor replaced by simulated ones. Throws std::invalid_argument if the mechanism has no
/// inertia.
configuration simulated(configuration c);

/// Device, port, sensor and law, for a title.
std::string summary(const configuration& c);

}  // namespace example
