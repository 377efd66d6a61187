/// @file
/// The wall-following experiment (section 5): a hand moves a simulated device along a wall under a controller.
#pragma once

#include <passive_haptics/control/device_state.hpp>
#include <passive_haptics/control/step_result.hpp>
#include <passive_haptics/plant/contact_metrics.hpp>
#include <passive_haptics/plant/following_hand.hpp>
#include <passive_haptics/plant/simulated_device.hpp>
#include <passive_haptics/scene/shape.hpp>

#include <cmath>

namespace passive_haptics {

/// Timing and sensing of a wall-following experiment.
struct wall_following_parameters {
  double time_step = 1e-4;       ///< Of the simulation [s].
  double control_period = 1e-3;  ///< Of the brakes [s]; section 5.1: 1 kHz.
  double sensor_corner = 200;    ///< Low-pass of the force sensor [Hz]; 0 for none.
  double path_end = 0.17;        ///< Stops where the handle's progress reaches this [m].
  double longest = 8;            ///< Stops after this time in any case [s].
  int watched_brake = 1;         ///< Whose sticking is counted, from 0.
};

/// What is wrong with the parameters; empty if nothing.
inline std::string validate(const wall_following_parameters& p) {
  return detail::first_complaint(
      detail::check_positive("time_step [s]", p.time_step),
      detail::check_positive("control_period [s]", p.control_period),
      detail::check_not_negative("sensor_corner [Hz]", p.sensor_corner),
      detail::check_finite("path_end [m]", p.path_end), detail::check_positive("longest [s]", p.longest),
      p.control_period >= p.time_step
          ? ""
          : "control_period [s] is shorter than time_step, expected a multiple of it");
}

/// One time step of the experiment, for plots.
template <class M>
struct wall_following_sample {
  double time;                    ///< [s]
  double depth;                   ///< Into the wall [m], < 0 outside.
  task_vector<M> position;        ///< Of the handle [m].
  task_vector<M> velocity;        ///< Of the handle [m/s].
  brake_vector<M> rates;          ///< Of the brakes' axes [rad/s or m/s].
  brake_vector<M> brake_torque;   ///< Of the brakes [N m].
  task_vector<M> hand_force;      ///< As sensed [N].
  task_vector<M> brake_force;     ///< Of the brakes at the handle [N].
  const step_result<M>* control;  ///< The latest control cycle.
};

/// Runs the experiment: the hand moves the device beside `shape` (the wall whose depth is measured) until the end of
/// the path. control(device_state<M>) is called once a control period; observe(wall_following_sample<M>) once a
/// time step. Ideal encoders. For n = d.
template <class M, class Shape, class Control, class Observer>
  requires(M::dof == M::task_dimension)
contact_metrics follow_wall(simulated_device<M>& device, Control&& control, const Shape& shape,
                            const following_hand<typename M::scalar, M::task_dimension>& hand,
                            const wall_following_parameters& parameters, Observer&& observe) {
  using T = typename M::scalar;
  const wall_following_parameters& p = require_valid(parameters);
  if (p.watched_brake < 0 || p.watched_brake >= M::brake_count) {
    require_no_complaint(
        detail::complaint("watched_brake", p.watched_brake, "a brake of the device, from 0"));
  }
  constexpr int d = M::task_dimension;
  const T sensor_lag = p.sensor_corner > 0 ? low_pass_time_constant(static_cast<T>(p.sensor_corner)) : T(0);
  first_order_lag<T, d> sensor(vector<T, d>::Constant(sensor_lag));
  contact_meter meter(p.path_end, p.time_step);
  const T dt = static_cast<T>(p.time_step);
  const long steps = std::lround(p.longest / p.time_step);
  const long steps_per_cycle = std::lround(p.control_period / p.time_step);

  step_result<M> decision;
  for (long k = 0; k < steps; ++k) {
    const double time = static_cast<double>(k) * p.time_step;
    if (k % steps_per_cycle == 0) {
      decision = control(device_state<M>{time, device.q(), device.qd(), sensor.output()});
    }
    const task_vector<M> x = device.position();
    const point<d> n = shape.gradient(x.template cast<double>());
    const task_vector<M> normal = n.template cast<T>();
    device.advance(dt, decision.capacity, hand.force(static_cast<T>(time), x, device.velocity(), normal));
    sensor.advance(dt, device.sensed_force());

    const task_vector<M> moved = device.position();
    const matrix<T, d, M::brake_count> E =
        matrix<T, d, M::brake_count>(brake_jacobian(device.mechanism(), device.q()));
    const wall_following_sample<M> now{time + p.time_step,
                                       -shape.distance(moved.template cast<double>()),
                                       moved,
                                       device.velocity(),
                                       device.rates(),
                                       device.brake_torque(),
                                       sensor.output(),
                                       E.transpose().partialPivLu().solve(device.brake_torque()),
                                       &decision};
    const double progress = static_cast<double>(hand.progress(moved));
    meter.add(progress, now.depth, static_cast<double>(now.rates[p.watched_brake]),
              -static_cast<double>(now.brake_force.dot(hand.tangent(normal))));
    observe(now);
    if (progress >= p.path_end) break;
  }
  return meter.result();
}

/// The same without an observer.
template <class M, class Shape, class Control>
  requires(M::dof == M::task_dimension)
contact_metrics follow_wall(simulated_device<M>& device, Control&& control, const Shape& shape,
                            const following_hand<typename M::scalar, M::task_dimension>& hand,
                            const wall_following_parameters& parameters) {
  return follow_wall(device, control, shape, hand, parameters, [](const wall_following_sample<M>&) {});
}

}  // namespace passive_haptics
