#include <devices/haptic_device.hpp>

#include <catalogue/catalogue.hpp>

#include <span>

namespace example {

haptic_device::haptic_device(const configuration& c)
    : configuration_(c),
      calibration_(calibration_of(c)),
      control_(c.device.make_controller(catalogue(), c.mechanism.of())),
      homing_(calibration_.encoders, c.mechanism.axis_positions(c.home), c.homing),
      tare_({.duration = c.homing.duration, .tolerance = c.tare_tolerance, .max_gap = c.homing.max_gap}) {
  if (c.port == "simulated") plant_ = std::make_shared<simulation>(c);
}

any_brake_port haptic_device::simulated_port() { return any_brake_port::of<example::simulated_port>(plant_); }

any_force_sensor haptic_device::simulated_sensor() {
  return any_force_sensor::of<simulated_force_sensor>(plant_);
}

phase haptic_device::prepare(const samples& now) noexcept {
  if (doing_ == phase::homing) {
    const axis_numbers counts(now.counts.data());
    if (is_done(homing_.add(now.time, counts))) {
      calibration_.encoders.set_zero_count(homing_.zero_count());
      doing_ = configuration_.tare ? phase::taring : phase::running;
    }
  } else if (doing_ == phase::taring) {
    const ph::vector<double, sensor_channels> raw(now.readings.data());
    if (is_done(tare_.add(now.time, raw))) {
      const auto R = calibration_.sensor_frame(configuration_.mechanism.axis_positions(configuration_.home));
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
  const axis_numbers axes = calibration_.joint_positions(now.counts);
  return example::deepest_wall(configuration_.walls, configuration_.mechanism.position(axes));
}

ph::brake_currents<max_axes> haptic_device::cycle(const samples& now, phase doing, record& r) noexcept {
  const auto state = calibration_.state(now.time, now.counts, now.readings);  // of the axes
  const driven_mechanism& mechanism = configuration_.mechanism;
  const axis_numbers q = mechanism.joint_positions(state.q), qd = mechanism.joint_positions(state.qd);
  const auto first = [](const auto& v, int count) {
    return std::span(v.data(), static_cast<std::size_t>(count));
  };
  const auto joints = [&](const axis_numbers& v) { return first(v, mechanism.joints()); };
  const auto components = [&](const spatial& v) { return first(v, mechanism.dimension()); };
  const bool has_force = configuration_.sensor != "none";
  r.was_asked = doing == phase::running;
  if (r.was_asked)
    r.decision = (*control_)({now.now, joints(q), joints(qd),
                              has_force ? components(state.hand_force) : std::span<const double>()});
  if (doing_ != phase::homing) {
    r.q = ph::runtime::joint_numbers(joints(q));
    r.qd = ph::runtime::joint_numbers(joints(qd));
    r.x = ph::runtime::task_numbers(components(mechanism.handle(q)));
  }
  if (doing_ == phase::running && has_force)
    r.hand_force = ph::runtime::task_numbers(components(state.hand_force));
  return calibration_.currents(filled_up<axis_numbers>(r.decision.capacity));
}

}  // namespace example
