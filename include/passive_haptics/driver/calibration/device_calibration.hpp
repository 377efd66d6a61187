/// All calibrations of a device: counts and readings to its state, capacities to currents.
#pragma once

#include <passive_haptics/brake/models/encoder_axes.hpp>
#include <passive_haptics/control/device_state.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/driver/calibration/brake_calibration.hpp>
#include <passive_haptics/driver/calibration/encoder_calibration.hpp>
#include <passive_haptics/driver/calibration/force_calibration.hpp>
#include <passive_haptics/driver/rate_estimator.hpp>

namespace passive_haptics {

/// Calibration of a device with mechanism M and a force sensor with this many channels.
template <class M, int Channels = M::task_dimension>
struct device_calibration_parameters {
  encoder_calibration_parameters<encoder_axes<M>::count> encoders;       ///< On encoder_axes<M>.
  rate_estimator_parameters rates;                                       ///< In counts.
  brake_curves<M::brake_count> brakes{};                                 ///< Currents to torques.
  force_calibration_parameters<M::task_dimension, Channels> force = {};  ///< Unused without a sensor.

  static constexpr auto members() {
    using p = device_calibration_parameters;
    return member_table(member("encoders", &p::encoders), member("rates", &p::rates),
                        member("brakes", &p::brakes), member("force", &p::force));
  }
};

/// Rate estimator, encoder, force and brake calibration of mechanism M. Frame: orientation of the sensor.
template <class M, int Channels = M::task_dimension, class Frame = fixed_sensor_frame<M::task_dimension>>
class device_calibration {
  static_assert(is_mechanism<M, explain>());
  static_assert(SensorFrame<Frame, M::dof, M::task_dimension>,
                "passive_haptics: a sensor frame takes q and returns a matrix<double, d, d> exactly.");
  using T = typename M::scalar;

 public:
  using axes = encoder_axes<M>;                          ///< Axes of the encoders.
  using counts_array = std::array<double, axes::count>;  ///< As safe_port::position(), beyond wraps [counts].
  using readings_array = std::array<double, static_cast<std::size_t>(Channels)>;  ///< One per channel.
  using parameters = device_calibration_parameters<M, Channels>;                  ///< Parameters.

  /// Throws std::invalid_argument with the text of validate(p) or, for a frame with a table, of
  /// validate(frame); or if the transmission is singular.
  device_calibration(const M& mechanism, const device_calibration_parameters<M, Channels>& p,
                     const Frame& frame = {})
      : encoders(require_valid(p).encoders),
        rates(p.rates),
        force(p.force),
        brakes(p.brakes),
        axes_(mechanism),
        frame_(frame) {
    if constexpr (Parameters<Frame>) require_valid(frame);
    const bool solvable = all_finite(axes_.to_joints(vector<T, axes::count>::Ones()));
    require_no_error(
        solvable ? "" : "transmission is singular: expected an invertible matrix; check the mechanism");
  }

  /// State at the time [s] of a sample; not finite if a count or reading is not.
  device_state<M> state(double time, const counts_array& counts, const readings_array& readings) noexcept {
    device_state<M> y;
    read(y, time, counts);
    const vector<double, Channels> raw(readings.data());
    y.hand_force = as<T>(force.force(raw, frame_(as<double>(y.q))));
    return y;
  }

  /// State of a device without a force sensor.
  sensorless_device_state<M> state(double time, const counts_array& counts) noexcept {
    sensorless_device_state<M> y;
    read(y, time, counts);
    return y;
  }

  /// Currents [A] for capacities [N m], with temperatures [K] if measured.
  brake_currents<M::brake_count> currents(
      const brake_vector<M>& capacity,
      const vector<double, M::brake_count>& temperature =
          brake_calibration<M::brake_count>::unknown_temperatures()) noexcept {
    return brakes.currents(as<double>(capacity), temperature);
  }

  /// Joint positions [rad or m] for counts; does not change the state.
  joint_vector<M> joint_positions(const counts_array& counts) const noexcept {
    return axes_.to_joints(as<T>(encoders.position(vector<double, axes::count>(counts.data()))));
  }
  /// Axis positions [rad or m] of a pose, the reference of homing.
  vector<double, axes::count> axis_positions(const joint_vector<M>& q) const noexcept {
    return as<double>(axes_.from_joints(q));
  }
  /// Orientation of the sensor in a pose, for taring.
  matrix<double, M::task_dimension, M::task_dimension> sensor_frame(const joint_vector<M>& q) const noexcept {
    return frame_(as<double>(q));
  }

  encoder_calibration<axes::count> encoders;             ///< Counts to axis positions.
  rate_estimator<axes::count> rates;                     ///< Rates of counts.
  force_calibration<M::task_dimension, Channels> force;  ///< Readings to force.
  brake_calibration<M::brake_count> brakes;              ///< Capacities to currents.

 private:
  template <class State>
  void read(State& y, double time, const counts_array& counts) noexcept {
    const vector<double, axes::count> at(counts.data());
    y.time = time;
    y.q = joint_positions(counts);
    y.qd = axes_.to_joints(as<T>(encoders.rate(rates.add(time, at))));
  }

  axes axes_;
  Frame frame_;
};

}  // namespace passive_haptics
