/// @file
/// The motion of a mechanism in the columns of a log.
#pragma once

#include <log/decision.hpp>
#include <log/log_reader.hpp>

#include <passive_haptics/control/device_state.hpp>

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace example {

namespace ph = passive_haptics;

/// Where the numbers of a mechanism M stand in a log.
template <class M>
class motion_columns {
 public:
  /// Throws log_error if there is no t, q1 ..., qd1 ..., in the right units; nor Fh_x ..., unless that is
  /// optional.
  motion_columns(const log_reader& log, bool needs_force) : log_(log), time_(log.column("t", {"s"})) {
    for (int i = 1; i <= M::dof; ++i) {
      q_.push_back(log.column("q" + std::to_string(i), {"rad", "m"}));
      qd_.push_back(log.column("qd" + std::to_string(i), {"rad/s", "m/s"}));
    }
    for (int i = 0; i < M::task_dimension; ++i) {
      const std::string name = std::string("Fh_") + "xyz"[i];
      if (needs_force || log.find(name)) force_.push_back(log.column(name, {"N"}));
    }
    for (int i = 1; i <= M::brake_count; ++i)
      if (const auto found = log.find("capacity" + std::to_string(i))) capacity_.push_back(*found);
  }

  joint_kinds joints() const {
    joint_kinds all;
    for (const std::size_t q : q_) all.slides.push_back(log_.unit(q) == "m");
    return all;
  }

  /// NaN stands for an empty cell.
  ph::device_state<M> state() const {
    ph::device_state<M> s;
    s.time = log_.number(time_);
    for (int i = 0; i < M::dof; ++i) {
      s.q[i] = log_.number(q_[static_cast<std::size_t>(i)]);
      s.qd[i] = log_.number(qd_[static_cast<std::size_t>(i)]);
    }
    s.hand_force.setConstant(std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < force_.size(); ++i)
      s.hand_force[static_cast<int>(i)] = log_.number(force_[i]);
    return s;
  }

  /// The commands in the log, if it has them.
  std::optional<ph::brake_vector<M>> capacity() const {
    ph::brake_vector<M> all;
    if (capacity_.size() != M::brake_count) return std::nullopt;
    for (int i = 0; i < M::brake_count; ++i) all[i] = log_.number(capacity_[static_cast<std::size_t>(i)]);
    if (!all.allFinite()) return std::nullopt;
    return all;
  }

 private:
  const log_reader& log_;
  std::size_t time_;
  std::vector<std::size_t> q_, qd_, force_, capacity_;
};

}  // namespace example
