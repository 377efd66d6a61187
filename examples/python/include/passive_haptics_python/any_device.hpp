/// @file
/// What Python calls of a device: its functions, over vectors of any length.
#pragma once

#include <passive_haptics_python/any_controller.hpp>
#include <passive_haptics_python/any_simulation.hpp>
#include <passive_haptics_python/laws.hpp>
#include <passive_haptics_python/scenes.hpp>
#include <passive_haptics_python/states.hpp>

#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/control/cycle_inputs.hpp>
#include <passive_haptics/design/map/design_figures.hpp>
#include <passive_haptics/design/wall_limits.hpp>

#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace passive_haptics_python {

/// switchable_brake_parameters of any number of brakes.
struct brake_numbers {
  numbers torque_limit;      ///< [N m]
  numbers rate_dead_band;    ///< [rad/s]
  numbers torque_dead_band;  ///< [N m]
  numbers time_constant;     ///< [s]
  numbers torque_lower;      ///< <= 0, -inf where there is no bound [N m]
  numbers torque_upper;      ///< >= 0, inf where there is no bound [N m]

  /// Whether all are on and work both ways.
  bool has_no_bounds() const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return (torque_lower.array() == -infinity).all() && (torque_upper.array() == infinity).all();
  }
};

/// The brakes of a mechanism, without bounds; of as many numbers as it has brakes.
template <class M>
ph::brakes_of<M> brakes_from(const brake_numbers& b) {
  ph::brakes_of<M> brakes;
  brakes.torque_limit = b.torque_limit;
  brakes.rate_dead_band = b.rate_dead_band;
  brakes.torque_dead_band = b.torque_dead_band;
  brakes.time_constant = b.time_constant;
  return brakes;
}
/// The brakes of a mechanism with their bounds.
template <class M>
ph::switchable_brakes<M> switchable_from(const brake_numbers& b) {
  ph::switchable_brakes<M> brakes(brakes_from<M>(b));
  brakes.torque_lower = b.torque_lower;
  brakes.torque_upper = b.torque_upper;
  return brakes;
}

/// Brakes for questions of design: limits that may be infinite, and motors beside them.
struct design_brakes {
  numbers torque_limit;   ///< [N m]
  numbers time_constant;  ///< [s]
  numbers torque_lower;   ///< [N m]
  numbers torque_upper;   ///< [N m]
  numbers motor_limit;    ///< [N m]
};

/// reference_force_set of any device.
struct reference_force_values {
  Eigen::MatrixXd G;   ///< d x m [N per N m]
  ph::status outcome;  ///< ok, or why there are none.
};

/// A passive FME of two brakes in the plane.
struct outlined_fme {
  std::array<int, 2> signs;           ///< Of the torques.
  std::vector<ph::point<2>> outline;  ///< Closed [N].
};

/// displayable_force of any device.
struct displayable_values {
  ph::status outcome;             ///< ok, or why nothing is known.
  ph::display_class display;      ///< How the normal force is displayed.
  double angle;                   ///< gamma [rad]
  double max_force;               ///< [N]
  double max_approximated_force;  ///< [N]
  numbers signs;                  ///< s
};

/// A place on a path along a wall, of any device.
struct path_values {
  numbers q;          ///< [rad or m]
  numbers direction;  ///< In which the end effector moves.
  numbers normal;     ///< Of the wall, out of it.
};

/// The functions of a device. Each throws Python's ValueError where a vector has not the device's length, and
/// TypeError where the device is of a kind for which the function has no meaning.
struct any_device {
  /// As of a base class.
  virtual ~any_device() = default;
  /// n, d and m.
  virtual device_sizes sizes() const = 0;
  /// The controller; at_wall: batches that are compiled for this wall, or nullptr.
  virtual std::unique_ptr<any_controller> make_controller(const brake_numbers& brakes, const scene& walls,
                                                          const law& of,
                                                          const ph::step_options<double>& options,
                                                          std::unique_ptr<any_batch> at_wall) const = 0;

  /// x [m]
  virtual numbers position(const numbers& q) const = 0;
  /// J
  virtual Eigen::MatrixXd jacobian(const numbers& q) const = 0;
  /// v [m/s]
  virtual numbers velocity(const numbers& q, const numbers& qd) const = 0;
  /// w [rad/s or m/s]
  virtual numbers brake_rates(const numbers& q, const numbers& qd) const = 0;
  /// s
  virtual numbers brake_signs(const numbers& q, const numbers& qd, const std::optional<numbers>& hand_force,
                              const brake_numbers& brakes) const = 0;

  /// R+ of each brake, a column.
  virtual reference_force_values reference_forces(const numbers& q) const = 0;
  /// The nearest force [N] of brakes of these signs.
  virtual numbers nearest_force(const numbers& q, const numbers& signs, const numbers& desired) const = 0;
  /// The passive FMEs, outlines of this number of chords.
  virtual std::vector<outlined_fme> passive_fmes(const numbers& q, int segments) const = 0;

  /// What brakes can display along a normal.
  virtual displayable_values displayable(const path_values& at, const design_brakes& brakes) const = 0;
  /// The sink slope against a push [N].
  virtual ph::sink_slope_result<double> sink_slope(const path_values& at, const design_brakes& brakes,
                                                   double push) const = 0;
  /// The depth [m] to which a hand sinks on a path of these places.
  virtual double sink_depth(const std::vector<path_values>& path, const design_brakes& brakes,
                            double push) const = 0;
  /// The figures at a place.
  virtual ph::design_figures<double> design_figures(const path_values& at, const design_brakes& brakes,
                                                    double push) const = 0;
  /// The wall that brakes can make; direction: the velocity [m/s].
  virtual ph::braked_wall braked_wall_at(const path_values& at, const design_brakes& brakes,
                                         const numbers& residual_torque, const numbers& resolution,
                                         double hand_mass) const = 0;

  /// The device with a hand's mass [kg] on its handle, at rest at q: brakes that are what a controller
  /// believes.
  virtual std::unique_ptr<any_simulation> simulation(const brake_numbers& brakes, double hand_mass,
                                                     const numbers& q) const = 0;
  /// The device with real brakes.
  virtual std::unique_ptr<any_simulation> simulation(const std::vector<run_time_brake>& brakes,
                                                     double hand_mass, const numbers& q) const = 0;
};

}  // namespace passive_haptics_python
