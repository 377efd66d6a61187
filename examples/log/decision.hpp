/// Columns of all logs: motion of the device and result of the law.
#pragma once

#include <log/log_row.hpp>

#include <passive_haptics/control/step_result.hpp>

#include <vector>

namespace example {

/// Joints and their brakes that slide; others rotate.
struct joint_kinds {
  std::vector<bool> slides;

  auto of(const char* turning, const char* sliding) const {
    return [=, this](std::size_t i) { return i < slides.size() && slides[i] ? sliding : turning; };
  }
  auto position() const { return of("rad", "m"); }
  auto rate() const { return of("rad/s", "m/s"); }
  auto torque() const { return of("N m", "N"); }
};

/// t, q1 ..., qd1 ..., Fh_x ... of a device_state or similar; NaN gives an empty cell.
template <class State>
void put_motion(log_row& row, const joint_kinds& joints, const State& s) {
  row.put("t", "s", s.time);
  row.put("q", joints.position(), s.q);
  row.put("qd", joints.rate(), s.qd);
  row.put_axes("Fh", "N", s.hand_force);
}

/// status, power, display, gamma, alpha, Fd_x ..., Fc_x ..., capacity1 ..., torque1 ... of a step_result or
/// similar; empty cells if the law did not run.
template <class Decision>
void put_decision(log_row& row, const joint_kinds& joints, const Decision& r, bool was_asked = true) {
  row.blank(!was_asked);
  row.put("status", to_string(r.outcome));
  row.put("power", to_string(r.power));
  row.put("display", passive_haptics::display_text(r));
  row.put("gamma", "rad", r.approximation_angle());
  row.put("alpha", "1", r.alpha);
  row.put_axes("Fd", "N", r.desired_force);
  row.put_axes("Fc", "N", r.control_force);
  row.put("capacity", joints.torque(), r.capacity);
  row.put("torque", joints.torque(), r.torque);
  row.blank(false);
}

}  // namespace example
