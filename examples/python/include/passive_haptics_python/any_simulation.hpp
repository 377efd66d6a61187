/// @file
/// A simulated device whose mechanism is known at run time only.
#pragma once

#include <passive_haptics_python/any_controller.hpp>
#include <passive_haptics_python/run_time_brake.hpp>
#include <passive_haptics_python/shapes.hpp>
#include <passive_haptics_python/states.hpp>

#include <passive_haptics/plant/contact_metrics.hpp>
#include <passive_haptics/plant/energy_balance.hpp>
#include <passive_haptics/plant/following_hand.hpp>
#include <passive_haptics/plant/wall_following.hpp>

#include <vector>

namespace passive_haptics_python {

/// following_hand of any dimension.
struct hand_values {
  numbers direction;                                 ///< Along the wall, any length > 0.
  numbers start;                                     ///< x0 [m]
  ph::following_hand_parameters<double> parameters;  ///< The impedance.
};

/// One time step of an experiment: wall_following_sample of any device.
struct following_sample {
  double time;                   ///< [s]
  double depth;                  ///< [m]
  const double* position;        ///< d numbers [m],
  const double* velocity;        ///< [m/s].
  const double* rates;           ///< m numbers [rad/s or m/s],
  const double* torque;          ///< brake_torque [N m],
  const double* power;           ///< brake_power [W].
  const double* hand_force;      ///< d numbers [N],
  const double* brake_force;     ///< [N].
  const result_values* control;  ///< The latest control cycle.
};

/// Sees each time step of an experiment.
struct following_observer {
  /// As of a base class.
  virtual ~following_observer() = default;
  /// Of one time step. What it throws ends the experiment.
  virtual void see(const following_sample& now) = 0;
};

/// A simulated_device.
struct any_simulation {
  /// As of a base class.
  virtual ~any_simulation() = default;
  /// One time step dt [s] under capacities [N m] and the force of the hand's muscles [N].
  virtual void advance(double dt, const numbers& capacity, const numbers& muscle_force) = 0;
  /// Sets joint positions and rates, and begins the energy balance anew.
  virtual void set_motion(const numbers& q, const numbers& qd) = 0;
  virtual numbers q() const = 0;                         ///< [rad or m]
  virtual numbers qd() const = 0;                        ///< [rad/s or m/s]
  virtual numbers position() const = 0;                  ///< [m]
  virtual numbers velocity() const = 0;                  ///< [m/s]
  virtual numbers rates() const = 0;                     ///< w [rad/s or m/s]
  virtual numbers sensed_force() const = 0;              ///< [N]
  virtual numbers brake_torque() const = 0;              ///< [N m]
  virtual numbers brake_force() const = 0;               ///< [N]
  virtual const ph::energy_balance& energy() const = 0;  ///< [J]
  /// The wall-following experiment.
  virtual ph::contact_metrics follow_wall(any_controller& control, const shape_geometry& shape,
                                          const hand_values& hand,
                                          const ph::wall_following_parameters& parameters,
                                          following_observer& observer) = 0;
};

}  // namespace passive_haptics_python
