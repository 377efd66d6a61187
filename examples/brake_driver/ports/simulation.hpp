/// @file
/// A device without hardware, seen through the same counts, readings and currents as a real one.
#pragma once

#include <configuration/configuration.hpp>
#include <ports/simulated_wire.hpp>

#include <catalogue/catalogue.hpp>
#include <passive_haptics/driver/clock.hpp>
#include <passive_haptics/plant/brakes/compensated_brake.hpp>
#include <passive_haptics/plant/brakes/eddy_current_brake.hpp>
#include <passive_haptics/plant/brakes/magnetorheological_brake.hpp>
#include <passive_haptics/plant/brakes/stribeck_brake.hpp>
#include <passive_haptics/plant/following_hand.hpp>
#include <passive_haptics/plant/force_sensor.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace example {

/// Plant, hand, encoders and force sensor, calibrated as the configuration says. It goes on to the present
/// whenever somebody reads it. The wire to its brakes is one that a supervisor's process shares.
class simulation {
  using pair = ph::vector<double, 2>;

 public:
  /// The mechanism has inertia.
  explicit simulation(const configuration& c)
      : calibration_(planar_device(c.mechanism), {c.encoders, c.rates, c.curves, c.force}, c.sensor_frame),
        p_(c.simulation),
        frame_(c.sensor_frame),
        force_(c.force),
        curves_(c.curves),
        walls_(c.walls),
        device_(catalogue().make_plant(*c.mechanism, real_brakes(c), c.simulation.hand_mass,
                                       {c.home.data(), axes})),
        sensor_({.corner = 200, .noise = c.simulation.sensor_noise, .seed = c.simulation.seed}),
        wire_(c.simulation.watchdog, c.simulation.wire) {
    const ph::following_hand<double, 2> hand({1, 0}, position());
    ph::require_no_error(ph::check_time_step(dt, hand.min_time_constant(device_->min_mass())));
  }

  /// From now on the hand may take the handle, as a user may once taring is done.
  void let_the_hand_in() noexcept { take_hold(1, std::max(time_, p_.hand_start)); }

  /// Counts of the encoders, which start anywhere and wrap at 2^counter_bits.
  std::array<double, axes> counts() noexcept {
    advance();
    const auto exact = calibration_.encoders.counts(calibration_.axis_positions(q()));
    std::array<double, axes> all;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double count = std::floor(exact[static_cast<int>(i)]) + somewhere[i];
      all[i] = count - std::floor(count / turn) * turn;
    }
    return all;
  }

  /// Raw values of the force sensor, with an offset: C raw = R^T (F + m g) + offset, the least such raw.
  std::array<double, sensor_channels> readings() noexcept {
    advance();
    const ph::vector<double, 2> force = sensor_.read() + force_.handle_mass * force_.gravity;
    const ph::vector<double, 2> felt = frame_(q()).transpose() * force + offset;
    const auto& C = force_.newtons_per_unit;
    const ph::matrix<double, 2, 2> CCt = C * C.transpose();
    const ph::vector<double, sensor_channels> raw = C.transpose() * CCt.inverse() * felt;
    std::array<double, sensor_channels> all;
    std::copy_n(raw.data(), all.size(), all.begin());
    return all;
  }

  /// False where the board's watchdog let go, and no release came since.
  bool set(const ph::brake_currents<axes>& currents) noexcept {
    advance();
    return wire_->set(currents);
  }
  /// From any process.
  void release() noexcept { wire_->release(); }
  double watchdog() const noexcept { return p_.watchdog; }

  static constexpr int counter_bits = 24;

 private:
  static constexpr double dt = 1e-4, max_at_once = 0.1, turn = 1 << counter_bits;  // [s, s, counts]
  static constexpr std::array<double, axes> somewhere{100.0, turn - 200};
  inline static const ph::vector<double, 2> offset{0.3, -0.2};  // [N]

  // Those of the file, or one of the kind that [simulation] names for each curve
  static std::vector<ph::runtime::run_time_brake> real_brakes(const configuration& c) {
    std::vector<ph::runtime::run_time_brake> all;
    for (const auto& model : c.device.brake_models)
      all.push_back(ph::runtime::entry_of(catalogue().brake_models(), model.name).make(model.parameters));
    if (all.empty())
      for (const ph::brake_curve& curve : c.curves) all.push_back(brake_of(curve, c.simulation));
    return all;
  }

  static ph::runtime::run_time_brake brake_of(const ph::brake_curve& curve, const simulation_parameters& p) {
    const auto with = [&](auto model) {
      if constexpr (requires { model.torque_limit; })
        model.torque_limit = torque_of_current(curve, curve.current_limit);
      model.time_constant = p.brake_lag;
      model.residual.strength = curve.residual_torque;
      return model;
    };
    using ph::runtime::run_time_brake;
    switch (p.brake) {
      case brake_kind::coulomb: break;
      case brake_kind::stribeck:
        return run_time_brake(ph::stribeck_brake<double>{.coulomb = with(ph::coulomb_brake<double>())});
      case brake_kind::magnetorheological:
        return run_time_brake(with(ph::magnetorheological_brake<double>()));
      case brake_kind::eddy_current:  // its board turns a torque into a current by the rate
        return run_time_brake(
            ph::compensated_brake<ph::eddy_current_brake<double>>{with(ph::eddy_current_brake<double>())});
    }
    return run_time_brake(with(ph::coulomb_brake<double>()));
  }

  pair q() const { return pair(device_->q().data()); }
  pair position() const { return pair(device_->position().data()); }
  // Of the first wall, along which the hand goes; 0 without walls
  pair normal(const pair& x) const {
    return walls_.empty() ? pair(pair::Zero()) : pair(walls_.front().shape.gradient(x));
  }

  void take_hold(double sense, double time) {
    const ph::vector<double, 2> direction(sense * p_.direction[0], sense * p_.direction[1]);
    hand_.emplace(direction, position(),
                  ph::following_hand_parameters<double>{
                      .speed = p_.speed, .push = sense > 0 ? p_.push : -p_.push / 4, .mass = p_.hand_mass});
    hand_from_ = position();
    hand_since_ = time;
    sense_ = sense;
  }

  void advance() noexcept {
    const double now = ph::monotonic_seconds();
    if (start_ < 0) start_ = now;
    // A program that was stopped does not catch up on hours
    if (now - start_ - time_ > max_at_once) start_ = now - time_ - max_at_once;
    const ph::brake_currents<axes> flowing = wire_->flowing(now);
    for (; time_ + dt <= now - start_; time_ += dt) {
      ph::vector<double, axes> strength;
      for (int i = 0; i < axes; ++i) {
        const auto k = static_cast<std::size_t>(i);
        strength[i] = torque_of_current(curves_[k], flowing[k]) - curves_[k].residual_torque;
      }
      const pair x = position();
      pair muscle = pair::Zero();
      if (hand_ && time_ >= hand_since_) {
        if ((x - hand_from_).norm() > p_.path) take_hold(-sense_, time_);
        muscle = hand_->force(time_ - hand_since_, x, pair(device_->velocity().data()), normal(x), 0);
      }
      device_->advance(dt, {strength.data(), axes}, {muscle.data(), 2});
      sensor_.advance(dt, pair(device_->sensed_force().data()));
    }
  }

  ph::device_calibration<planar_device, sensor_channels, ph::planar_sensor_frame<2>> calibration_;
  simulation_parameters p_;
  ph::planar_sensor_frame<2> frame_;
  ph::force_calibration_parameters<2, sensor_channels> force_;
  ph::brake_curves<axes> curves_;
  std::vector<named_wall> walls_;
  std::unique_ptr<ph::runtime::any_plant> device_;
  ph::force_sensor<double, 2> sensor_;
  std::optional<ph::following_hand<double, 2>> hand_;  // none before it may take the handle
  ph::vector<double, 2> hand_from_;
  double hand_since_ = 0, sense_ = 1;
  double start_ = -1, time_ = 0;  // [s]
  shared_simulated_wire<axes> wire_;
};

/// A BrakePort to a simulation. The loop cannot wait for it: it computes, and makes no system call.
class simulated_port {
 public:
  static constexpr int encoder_count = axes, brake_count = axes;

  explicit simulated_port(std::shared_ptr<simulation> device) : device_(std::move(device)) {}

  std::string open() { return {}; }
  ph::port_status read(ph::port_sample<axes>& sample) noexcept {
    const auto counts = device_->counts();
    sample = {ph::monotonic_seconds(), ++sequence_, counts, {true, true}};
    return ph::port_status::ok;
  }
  ph::port_status write(const ph::brake_currents<axes>& currents) noexcept {
    return device_->set(currents) ? ph::port_status::ok : ph::port_status::failed;
  }
  void release() noexcept { device_->release(); }
  int counter_bits() const noexcept { return simulation::counter_bits; }
  double watchdog() const noexcept { return device_->watchdog(); }

 private:
  std::shared_ptr<simulation> device_;
  std::uint32_t sequence_ = 0;
};

/// The ForceSensor of a simulation.
class simulated_force_sensor {
 public:
  static constexpr int channel_count = sensor_channels;

  explicit simulated_force_sensor(std::shared_ptr<simulation> device) : device_(std::move(device)) {}

  std::string open() { return {}; }
  ph::port_status read(ph::port_sample<sensor_channels>& sample) noexcept {
    sample.time = ph::monotonic_seconds();
    sample.sequence = ++sequence_;
    sample.value = device_->readings();
    sample.valid.fill(true);
    return ph::port_status::ok;
  }

 private:
  std::shared_ptr<simulation> device_;
  std::uint32_t sequence_ = 0;
};

}  // namespace example
