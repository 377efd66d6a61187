/// @file
/// All settings of the driver, with the paper's device as the default.
#pragma once

#include <comedi/comedi_parameters.hpp>
#include <ports/net_ft.hpp>
#include <ports/simulation_parameters.hpp>
#include <serial/serial_port_parameters.hpp>

#include <passive_haptics/driver/calibration/device_calibration.hpp>
#include <passive_haptics/driver/control_loop.hpp>
#include <passive_haptics/driver/process/supervisor.hpp>
#include <passive_haptics/driver/real_time.hpp>
#include <passive_haptics/driver/safe_port_parameters.hpp>
#include <passive_haptics/passive_haptics.hpp>

#include <functional>
#include <string>
#include <vector>

namespace example {

namespace ph = passive_haptics;

/// Of all devices of this program: planar, two encoders, two brakes, a force sensor with up to six channels.
inline constexpr int axes = 2, sensor_channels = 6;

/// The unit normal of a wall near a point, out of the wall.
using wall_normal = std::function<ph::point<2>(const ph::point<2>&)>;

/// A wall, as a person finds it in the file.
struct named_wall {
  std::string type;                                     ///< "plane" or "ball".
  std::function<double(const ph::point<2>&)> distance;  ///< Signed, positive in free space [m].
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
  std::string mechanism = "tendon_two_link";  ///< Or xy_table, five_bar.
  ph::tendon_two_link_parameters<double> tendon_two_link;
  ph::xy_table_parameters<double> xy_table;
  ph::five_bar_parameters<double> five_bar;

  std::string law = "velocity_direct_control";  ///< By its name in the library; see read_configuration().
  std::string wall_remarks;                     // for remarks()
  ph::world_walls<2> walls;
  std::vector<named_wall> named_walls;                   ///< The walls in the order of the file.
  wall_normal first_normal;                              ///< Of the first of them.
  ph::switchable_brake_parameters<double, axes> brakes;  ///< What the controller believes.

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

/// Of a file; of the default without one. Where the file names no law, it is the recommended one: without a
/// force sensor on_off_control, else velocity_direct_control. Throws std::invalid_argument that names file,
/// line, key, value and expectation.
configuration read_configuration(const std::string& path);

/// A line for each value that is allowed but unusual; empty if there is none.
std::string remarks(const configuration& c);

/// The device and the sensor replaced by simulated ones.
configuration simulated(configuration c);

}  // namespace example
