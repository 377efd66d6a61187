#include <devices/haptic_device.hpp>

#include <catalogue/catalogue.hpp>

#include <algorithm>
#include <span>

namespace example {

haptic_device::haptic_device(const configuration& c)
    : configuration_(c),
      mechanism_(c.mechanism),
      calibration_(mechanism_, {c.encoders, c.rates, c.curves, c.force}, c.sensor_frame),
      control_(c.device.make_controller(catalogue(), *c.mechanism)),
      homing_(calibration_.encoders, calibration_.axis_positions(c.home), c.homing),
      tare_({.duration = c.homing.duration, .tolerance = c.tare_tolerance, .max_gap = c.homing.max_gap}) {
  if (c.port == "simulated") plant_ = std::make_shared<simulation>(c);
}

any_brake_port<axes, axes> haptic_device::simulated_port() {
  return any_brake_port<axes, axes>::of<example::simulated_port>(plant_);
}

any_force_sensor haptic_device::simulated_sensor() {
  return any_force_sensor::of<simulated_force_sensor>(plant_);
}

phase haptic_device::prepare(const samples& now) noexcept {
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

std::string haptic_device::hindrance() const {
  switch (hindered_) {
    case ph::steady_status::moved:
      return doing_ == phase::homing ? "the handle moved by more than [homing] tolerance"
                                     : "the force changed by more than [sensor] tare_tolerance";
    case ph::steady_status::interrupted:
      return "samples came more than [homing] max_gap apart, or not at all";
    default: return "the program ended before it was over";
  }
}

wall_depth haptic_device::deepest_wall(const samples& now) const noexcept {
  const auto q = calibration_.joint_positions(now.counts);
  return example::deepest_wall(configuration_.walls, mechanism_.position(q));
}

ph::brake_currents<axes> haptic_device::cycle(const samples& now, phase doing, record& r) noexcept {
  const auto state = calibration_.state(now.time, now.counts, now.readings);
  const bool has_force = configuration_.sensor != "none";
  const auto numbers = [](const ph::vector<double, 2>& v) { return std::span<const double>(v.data(), 2); };
  ph::runtime::cycle_record decided;
  r.was_asked = doing == phase::running;
  if (r.was_asked)
    decided = (*control_)({now.now, numbers(state.q), numbers(state.qd),
                           has_force ? numbers(state.hand_force) : std::span<const double>()});

  const auto copy = [](const auto& from, pair& to) { std::copy_n(from.data(), to.size(), to.data()); };
  if (doing_ != phase::homing) {
    copy(state.q, r.q);
    copy(state.qd, r.qd);
    copy(mechanism_.position(state.q), r.x);
  }
  if (doing_ == phase::running && has_force) copy(state.hand_force, r.hand_force);
  r.decision = {.outcome = decided.outcome,
                .power = decided.power,
                .display = decided.display,
                .gamma = decided.approximation_angle(),
                .alpha = decided.alpha};
  copy(decided.desired_force, r.decision.desired_force);
  copy(decided.control_force, r.decision.control_force);
  copy(decided.capacity, r.decision.capacity);
  copy(decided.torque, r.decision.torque);
  return calibration_.currents(ph::vector<double, axes>(decided.capacity.data()));
}

}  // namespace example
