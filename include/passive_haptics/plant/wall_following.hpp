/// The wall-following experiment of section 5.
#pragma once

#include <passive_haptics/control/device_state.hpp>
#include <passive_haptics/control/step_result.hpp>
#include <passive_haptics/plant/contact_metrics.hpp>
#include <passive_haptics/plant/encoder.hpp>
#include <passive_haptics/plant/following_hand.hpp>
#include <passive_haptics/plant/force_sensor.hpp>
#include <passive_haptics/plant/plant.hpp>
#include <passive_haptics/plant/simulated_device.hpp>
#include <passive_haptics/scene/shape.hpp>

#include <cmath>
#include <cstdint>
#include <type_traits>

namespace passive_haptics {

/// Parameters of follow_wall.
struct wall_following_parameters {
  double time_step = 1e-4;  ///< Step of the simulation [s].
  /// Period of control and sensors [s], rounded to whole time steps; section 5.1: 1 kHz.
  double control_period = 1e-3;
  double sensor_corner = 200;    ///< Low-pass of the force sensor [Hz]; 0 for none.
  double sensor_scale = 1;       ///< Reading of the force sensor per newton [1].
  double sensor_noise = 0;       ///< Standard deviation of each component [N].
  std::uint64_t noise_seed = 1;  ///< Seed of that noise.
  /// One count on the encoder_axes [rad or m]; 0 for ideal encoders.
  double encoder_resolution = encoder_parameters().resolution;
  double rate_corner = 50;  ///< Low-pass of the differenced rates [Hz]; 0 for none.
  double path_end = 0.17;   ///< Progress at which the run ends [m].
  double max_duration = 8;  ///< Time at which the run ends [s].
  double max_depth = 1;     ///< Depth beyond which the run ends [m].
  int watched_brake = 1;    ///< Brake for stick_share, from 0.

  static constexpr auto members() {
    using p = wall_following_parameters;
    return member_table(member("time_step", &p::time_step, "s", range::positive),
                        member("control_period", &p::control_period, "s", range::positive),
                        member("sensor_corner", &p::sensor_corner, "Hz", range::not_negative),
                        member("sensor_scale", &p::sensor_scale, "1", range::positive),
                        member("sensor_noise", &p::sensor_noise, "N", range::not_negative),
                        member("noise_seed", &p::noise_seed),
                        member("encoder_resolution", &p::encoder_resolution, "rad or m", range::not_negative),
                        member("rate_corner", &p::rate_corner, "Hz", range::not_negative),
                        member("path_end", &p::path_end, "m", range::finite),
                        member("max_duration", &p::max_duration, "s", range::positive),
                        member("max_depth", &p::max_depth, "m", range::positive),
                        member("watched_brake", &p::watched_brake));
  }
  /// Requires control_period >= time_step.
  std::string rules() const {
    if (control_period >= time_step) return {};
    return detail::error_text("control_period [s]", control_period,
                              "at least time_step, " + detail::value_text(time_step));
  }
};

/// One time step of the experiment, for plots. Decision is the result type of the controller.
template <class M, class Decision = step_result<M>>
struct wall_following_sample {
  double time;                   ///< [s]
  double depth;                  ///< [m], < 0 outside the wall.
  task_vector<M> position;       ///< Handle [m].
  task_vector<M> velocity;       ///< Handle [m/s].
  brake_vector<M> rates;         ///< Brakes' axes [rad/s or m/s].
  brake_vector<M> brake_torque;  ///< [N m], without residual drag.
  brake_vector<M> brake_power;   ///< t_i w_i [W].
  task_vector<M> hand_force;     ///< After the sensor's low-pass, without noise [N].
  task_vector<M> brake_force;    ///< Brake force at the handle [N].
  const Decision* control;       ///< Result of the latest control cycle.
};

namespace detail {

// The stored part of a controller's result: step_result<M> for derived types.
template <class M, class Control,
          class Answer = std::remove_cvref_t<std::invoke_result_t<Control&, const device_state<M>&>>>
using decision_of = std::conditional_t<std::is_base_of_v<step_result<M>, Answer>, step_result<M>, Answer>;

struct no_observer {
  void operator()(const auto&) const {}
};

}  // namespace detail

/// Runs the experiment: the hand moves a Plant along `shape` (the measured wall) until the
/// end of the path, for at most `max_duration`, while the depth is finite and at most `max_depth`. So each
/// run ends, and contact_metrics::end says how.
///
/// control(device_state<M>) is called once a control period with what encoders and force sensor read, the
/// first time at once, and returns a step_result<M>, or any default-constructible value with a
/// brake_vector<M> `capacity`. Time begins at 0: call reset() of a controller that has run before.
/// observe(wall_following_sample) is called once a time step. Depth and figures are the true ones, not those
/// read. Throws std::invalid_argument with the text of validate(parameters) or check_time_step, or if there
/// is no watched_brake.
template <class P, class T, int D, class Shape, class Control, class Observer = detail::no_observer>
contact_metrics follow_wall(P& device, Control&& control, const Shape& shape,
                            const following_hand<T, D>& hand, const wall_following_parameters& parameters,
                            Observer&& observe = {}) {
  static_assert(is_plant<P, explain>());
  using M = mechanism_of<P>;
  const wall_following_parameters& p = require_valid(parameters);
  detail::refuse_unless(p.watched_brake >= 0 && p.watched_brake < M::brake_count, "watched_brake",
                        p.watched_brake, "a brake of the device, from 0");
  require_no_error(passive_haptics::check_time_step(
      p.time_step, static_cast<double>(hand.min_time_constant(device.min_mass()))));
  force_sensor<T, D> sensor({p.sensor_corner, p.sensor_noise, p.noise_seed, p.sensor_scale});
  contact_meter meter(p.path_end, p.time_step);
  const T dt = static_cast<T>(p.time_step);
  const long steps = std::lround(p.max_duration / p.time_step);
  const long steps_per_cycle = std::lround(p.control_period / p.time_step);
  joint_encoders<M> encoders(device.mechanism(), {p.encoder_resolution, p.rate_corner},
                             static_cast<double>(steps_per_cycle) * p.time_step);

  using decision_type = detail::decision_of<M, Control>;
  decision_type decision{};
  run_end end = run_end::time_over;
  double depth = -shape.distance(device.position().template cast<double>());
  for (long k = 0; k < steps; ++k) {
    const double time = static_cast<double>(k) * p.time_step;
    if (k % steps_per_cycle == 0) {
      encoders.read(device.q(), device.qd());
      decision = control(device_state<M>{time, encoders.q(), encoders.qd(), sensor.read()});
    }
    const task_vector<M> x = device.position();
    const point<D> n = shape.gradient(x.template cast<double>());
    const task_vector<M> normal = n.template cast<T>();
    const double dissipated = device.energy().friction();
    device.advance(dt, decision.capacity,
                   hand.force(static_cast<T>(time), x, device.velocity(), normal, static_cast<T>(depth)));
    sensor.advance(dt, device.sensed_force());

    const task_vector<M> moved = device.position();
    depth = -shape.distance(moved.template cast<double>());
    const wall_following_sample<M, decision_type> now{time + p.time_step,
                                                      depth,
                                                      moved,
                                                      device.velocity(),
                                                      device.rates(),
                                                      device.brake_torque(),
                                                      device.brake_power(),
                                                      sensor.filtered(),
                                                      device.brake_force(),
                                                      &decision};
    const double progress = static_cast<double>(hand.progress(moved));
    meter.add({.progress = progress,
               .depth = depth,
               .rate = static_cast<double>(now.rates[p.watched_brake]),
               .retarding_force = -static_cast<double>(now.brake_force.dot(hand.tangent(normal))),
               .brake_energy = device.energy().friction() - dissipated,
               .brake_power = static_cast<double>(now.brake_power.maxCoeff()),
               .hand_force = -static_cast<double>(device.sensed_force().dot(normal))});
    observe(now);
    if (progress >= p.path_end) end = run_end::arrived;
    else if (!std::isfinite(depth)) end = run_end::not_finite;
    else if (depth > p.max_depth) end = run_end::too_deep;
    if (end != run_end::time_over) break;
  }
  contact_metrics figures = meter.result();
  figures.end = end;
  return figures;
}

}  // namespace passive_haptics
