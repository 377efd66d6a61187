/// @file
/// A haptic_device of mechanism M under law Law.
#pragma once

#include <devices/haptic_device.hpp>
#include <ports/simulation.hpp>

#include <algorithm>
#include <memory>

namespace example {

template <class M, class Law>
class mechanism_device final : public haptic_device {
  // One wall at a time for a law that handles no more
  using walls = ph::world<2, ph::saturates_before_scaling<Law> ? 1 : 3>;

 public:
  mechanism_device(const M& mechanism, const Law& law, const configuration& c)
      : configuration_(c),
        calibration_(mechanism, {c.encoders, c.rates, c.curves, c.force}, c.sensor_frame),
        control_(mechanism, c.brakes, walls(c.walls), law),
        homing_(calibration_.encoders, calibration_.axis_positions(c.home), c.homing),
        tare_({.duration = c.homing.duration, .tolerance = c.tare_tolerance, .max_gap = c.homing.max_gap}) {
    if (c.port == "simulated") plant_ = std::make_shared<simulation<M>>(mechanism, c);
  }

  any_brake_port<axes, axes> simulated_port() override {
    return any_brake_port<axes, axes>::of<example::simulated_port<M>>(plant_);
  }
  any_force_sensor simulated_sensor() override {
    return any_force_sensor::of<simulated_force_sensor<M>>(plant_);
  }

  phase prepare(const samples& now) noexcept override {
    if (doing_ == phase::homing) {
      const ph::vector<double, axes> counts(now.counts.data());
      if (is_done(homing_.add(now.time, counts))) {
        calibration_.encoders.set_zero_count(homing_.zero_count());
        doing_ = configuration_.tare ? phase::taring : phase::running;
      }
    } else if (doing_ == phase::taring) {
      const ph::vector<double, sensor_channels> raw(now.readings.data());
      if (is_done(tare_.add(now.time, raw))) {
        const auto R = calibration_.sensor_frame(configuration_.home);
        calibration_.force.set_tare(calibration_.force.tare_of(tare_.mean(), R));
        doing_ = phase::running;
      }
    }
    if (doing_ == phase::running && plant_) plant_->let_the_hand_in();
    return doing_;
  }

  std::string hindrance() const override {
    switch (hindered_) {
      case ph::steady_status::moved:
        return doing_ == phase::homing ? "the handle moved by more than [homing] tolerance"
                                       : "the force changed by more than [sensor] tare_tolerance";
      case ph::steady_status::interrupted:
        return "samples came more than [homing] max_gap apart, or not at all";
      default: return "the program ended before it was over";
    }
  }

  wall_depth deepest_wall(const samples& now) const noexcept override {
    const auto q = calibration_.joint_positions(now.counts);
    return example::deepest_wall(configuration_.named_walls, control_.mechanism().position(q));
  }

  ph::brake_currents<axes> cycle(const samples& now, phase doing, record& r) noexcept override {
    auto state = calibration_.state(now.time, now.counts, now.readings);
    state.time = now.now;
    typename decltype(control_)::result_type decided;
    r.was_asked = doing == phase::running;
    if (r.was_asked) decided = control_(state);

    const auto copy = [](const auto& from, pair& to) { std::copy_n(from.data(), to.size(), to.data()); };
    if (doing_ != phase::homing) {
      copy(state.q, r.q);
      copy(state.qd, r.qd);
      copy(control_.mechanism().position(state.q), r.x);
    }
    if (doing_ == phase::running && configuration_.sensor != "none") copy(state.hand_force, r.hand_force);
    r.decision = {.outcome = decided.outcome,
                  .power = decided.power,
                  .display = decided.display,
                  .gamma = decided.approximation_angle(),
                  .alpha = decided.alpha};
    copy(decided.desired_force, r.decision.desired_force);
    copy(decided.control_force, r.decision.control_force);
    copy(decided.capacity, r.decision.capacity);
    copy(decided.torque, r.decision.torque);
    return calibration_.currents(decided.capacity);
  }

  void reset() noexcept override { control_.reset(); }

 private:
  // Remembers what began it anew
  bool is_done(ph::steady_status now) noexcept {
    if (now != ph::steady_status::collecting) hindered_ = now;
    return now == ph::steady_status::done;
  }

  configuration configuration_;
  ph::device_calibration<M, sensor_channels, ph::planar_sensor_frame<2>> calibration_;
  ph::controller<M, walls, Law, ph::switchable_brakes<M>> control_;
  ph::homing<axes> homing_;
  ph::steady_mean<sensor_channels> tare_;
  ph::steady_status hindered_ = ph::steady_status::collecting;  // the last that was not this
  phase doing_ = phase::homing;
  std::shared_ptr<simulation<M>> plant_;
};

/// on_off_control, which leads by the lag of the slowest brake.
inline ph::on_off_control on_off_law(const configuration& c) {
  ph::on_off_control law;
  law.parameters.lead = c.brakes.time_constant.maxCoeff();
  return law;
}

/// Mechanism M under the law that the configuration names.
template <class M>
std::unique_ptr<haptic_device> device_of(const M& mechanism, const configuration& c) {
  const auto under = [&](const auto& law) -> std::unique_ptr<haptic_device> {
    return std::make_unique<mechanism_device<M, std::decay_t<decltype(law)>>>(mechanism, law, c);
  };
  if (c.law == "velocity_direct_control") return under(ph::velocity_direct_control());
  if (c.law == "on_off_control") return under(on_off_law(c));
  if (c.law == "saturated_direct_control") return under(ph::saturated_direct_control());
  if (c.law == "no_direct_control") return under(ph::no_direct_control());
  return under(ph::direct_control());
}

}  // namespace example
