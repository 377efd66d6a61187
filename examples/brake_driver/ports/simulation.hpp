/// A simulated device behind counts, readings and currents.
#pragma once

#include <configuration/configuration.hpp>
#include <ports/simulated_wire.hpp>

#include <catalogue/catalogue.hpp>
#include <passive_haptics/driver/clock.hpp>
#include <passive_haptics/plant/brakes/coulomb_brake.hpp>
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

/// Plant, hand, encoders and force sensor with the calibration of the configuration. Each read advances it to
/// the present. The wire to its brakes is shared with a supervisor's process.
class simulation {
 public:
  /// The mechanism must have inertia.
  explicit simulation(const configuration& c)
      : mechanism_(c.mechanism),
        calibration_(calibration_of(c)),
        p_(c.simulation),
        force_(c.force),
        curves_(c.curves),
        walls_(c.walls),
        device_(catalogue().make_plant(c.mechanism.of(), real_brakes(c), c.simulation.hand_mass,
                                       first(c.home, mechanism_.joints()))),
        sensor_({.corner = 200, .noise = c.simulation.sensor_noise, .seed = c.simulation.seed}),
        wire_(c.simulation.watchdog, c.simulation.wire) {
    const ph::following_hand<double, 3> hand(spatial::UnitX(), position());
    ph::require_no_error(ph::check_time_step(dt, hand.min_time_constant(device_->min_mass())));
  }

  /// Allows the hand to take the handle, as a user may after taring.
  void let_the_hand_in() noexcept { take_hold(1, std::max(time_, p_.hand_start)); }

  /// Counts of the encoders, with an arbitrary start, wrapping at 2^counter_bits.
  std::array<double, max_axes> counts() noexcept {
    advance();
    const auto exact = calibration_.encoders.counts(axis_positions());
    std::array<double, max_axes> all;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double count = std::floor(exact[static_cast<int>(i)]) + somewhere[i % 2];
      all[i] = count - std::floor(count / turn) * turn;
    }
    return all;
  }

  /// Raw values of the force sensor, with an offset: the minimum-norm raw with C raw = R^T (F + m g) +
  /// offset.
  std::array<double, sensor_channels> readings() noexcept {
    advance();
    const spatial force = sensor_.read() + force_.handle_mass * force_.gravity;
    const spatial felt = calibration_.sensor_frame(axis_positions()).transpose() * force + offset;
    const auto& C = force_.newtons_per_unit;
    const ph::matrix<double, 3, 3> CCt = C * C.transpose();
    const ph::vector<double, sensor_channels> raw = C.transpose() * CCt.inverse() * felt;
    std::array<double, sensor_channels> all;
    std::copy_n(raw.data(), all.size(), all.begin());
    return all;
  }

  /// Returns false if the board's watchdog tripped without a later release.
  bool set(const ph::brake_currents<max_axes>& currents) noexcept {
    advance();
    return wire_->set(currents);
  }
  /// May be called by any process.
  void release() noexcept { wire_->release(); }
  double watchdog() const noexcept { return p_.watchdog; }

  static constexpr int counter_bits = 24;

 private:
  static constexpr double dt = 1e-4, max_at_once = 0.1, turn = 1 << counter_bits;  // [s, s, counts]
  static constexpr std::array somewhere{100.0, turn - 200};
  inline static const spatial offset{0.3, -0.2, 0.1};  // [N]

  // Models of the file, or Coulomb friction with the limit and residual torque of each curve
  static std::vector<ph::runtime::run_time_brake> real_brakes(const configuration& c) {
    std::vector<ph::runtime::run_time_brake> all;
    for (const auto& model : c.device.brake_models)
      all.push_back(ph::runtime::entry_of(catalogue().brake_models(), model.name).make(model.parameters));
    for (int i = 0; i < c.mechanism.brakes() && c.device.brake_models.empty(); ++i) {
      const ph::brake_curve& curve = c.curves[static_cast<std::size_t>(i)];
      all.emplace_back(
          ph::coulomb_brake<double>{.torque_limit = torque_of_current(curve, curve.current_limit),
                                    .time_constant = c.simulation.brake_lag,
                                    .residual = {.strength = curve.residual_torque}});
    }
    return all;
  }

  template <class V>
  static std::span<const double> first(const V& v, int count) {
    return {v.data(), static_cast<std::size_t>(count)};
  }
  axis_numbers axis_positions() const {
    return mechanism_.axis_positions(filled_up<axis_numbers>(device_->q()));
  }
  spatial position() const { return filled_up<spatial>(device_->position()); }
  // Normal of the first wall, which the hand follows; 0 without walls and for an open surface
  spatial normal(const spatial& x) const {
    return walls_.empty() ? spatial(spatial::Zero()) : walls_.front().gradient(x);
  }

  void take_hold(double sense, double time) {
    hand_.emplace(sense * filled_up<spatial>(p_.direction), position(),
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
    const ph::brake_currents<max_axes> flowing = wire_->flowing(now);
    for (; time_ + dt <= now - start_; time_ += dt) {
      axis_numbers strength;
      for (std::size_t i = 0; i < flowing.size(); ++i)
        strength.data()[i] = torque_of_current(curves_[i], flowing[i]) - curves_[i].residual_torque;
      const spatial x = position();
      spatial muscle = spatial::Zero();
      if (hand_ && time_ >= hand_since_) {
        if ((x - hand_from_).norm() > p_.path) take_hold(-sense_, time_);
        muscle = hand_->force(time_ - hand_since_, x, filled_up<spatial>(device_->velocity()), normal(x), 0);
      }
      device_->advance(dt, first(strength, mechanism_.brakes()), first(muscle, mechanism_.dimension()));
      sensor_.advance(dt, filled_up<spatial>(device_->sensed_force()));
    }
  }

  driven_mechanism mechanism_;
  calibration calibration_;
  simulation_parameters p_;
  ph::force_calibration_parameters<3, sensor_channels> force_;
  ph::brake_curves<max_axes> curves_;
  std::vector<named_wall> walls_;
  std::unique_ptr<ph::runtime::any_plant> device_;
  ph::force_sensor<double, 3> sensor_;
  std::optional<ph::following_hand<double, 3>> hand_;  // none before it may take the handle
  spatial hand_from_ = spatial::Zero();
  double hand_since_ = 0, sense_ = 1;
  double start_ = -1, time_ = 0;  // [s]
  shared_simulated_wire<max_axes> wire_;
};

/// A BrakePort to a simulation. It only computes, without system calls, so the loop does not wait.
class simulated_port {
 public:
  static constexpr int encoder_count = max_axes, brake_count = max_axes;

  explicit simulated_port(std::shared_ptr<simulation> device) : device_(std::move(device)) {}

  std::string open() { return {}; }
  ph::port_status read(ph::port_sample<max_axes>& sample) noexcept {
    sample.value = device_->counts();
    sample.time = ph::monotonic_seconds();
    sample.sequence = ++sequence_;
    sample.valid.fill(true);
    return ph::port_status::ok;
  }
  ph::port_status write(const ph::brake_currents<max_axes>& currents) noexcept {
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
