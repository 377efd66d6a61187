/// The motion of a device in the columns of a log.
#pragma once

#include <log/decision.hpp>
#include <log/log_reader.hpp>

#include <passive_haptics/runtime/cycle_record.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace example {

namespace ph = passive_haptics;

/// device_state of any device; NaN for an empty cell.
struct logged_motion {
  double time = 0;                       ///< [s]
  ph::runtime::joint_numbers q, qd;      ///< n [rad or m] and rates.
  ph::runtime::task_numbers hand_force;  ///< d [N]
};

/// Columns of a device in a log.
class motion_columns {
 public:
  /// Throws log_error if t, q1 ..., qd1 ... are missing or in other units, or Fh_x ..., unless they are
  /// optional.
  motion_columns(const log_reader& log, const ph::runtime::device_sizes& device, bool needs_force)
      : log_(log), device_(device), time_(log.column("t", {"s"})) {
    for (int i = 1; i <= device.dof; ++i) {
      q_.push_back(log.column("q" + std::to_string(i), {"rad", "m"}));
      qd_.push_back(log.column("qd" + std::to_string(i), {"rad/s", "m/s"}));
    }
    for (int i = 0; i < device.task_dimension; ++i) {
      const std::string name = std::string("Fh_") + "xyz"[i];
      if (needs_force || log.find(name)) force_.push_back(log.column(name, {"N"}));
    }
    for (int i = 1; i <= device.brake_count; ++i)
      if (const auto found = log.find("capacity" + std::to_string(i))) capacity_.push_back(*found);
  }

  joint_kinds joints() const {
    joint_kinds all;
    for (const std::size_t q : q_) all.slides.push_back(log_.unit(q) == "m");
    return all;
  }

  /// Zeros for each number of the device.
  logged_motion nothing() const {
    logged_motion m;
    m.q.count = m.qd.count = device_.dof;
    m.hand_force.count = device_.task_dimension;
    return m;
  }
  /// Motion in this line.
  logged_motion motion() const {
    logged_motion m = nothing();
    m.time = log_.number(time_);
    m.q = numbers<ph::runtime::joint_numbers>(q_);
    m.qd = numbers<ph::runtime::joint_numbers>(qd_);
    if (force_.size() == m.hand_force.size()) m.hand_force = numbers<ph::runtime::task_numbers>(force_);
    else m.hand_force.values.fill(std::numeric_limits<double>::quiet_NaN());
    return m;
  }

  /// Commands in the log, if it has them.
  std::optional<ph::runtime::joint_numbers> capacity() const {
    if (std::ssize(capacity_) != device_.brake_count) return std::nullopt;
    const auto all = numbers<ph::runtime::joint_numbers>(capacity_);
    if (!std::all_of(all.data(), all.data() + all.size(), [](double x) { return std::isfinite(x); }))
      return std::nullopt;
    return all;
  }

 private:
  template <class Numbers>
  Numbers numbers(const std::vector<std::size_t>& columns) const {
    Numbers all;
    all.count = static_cast<int>(columns.size());
    for (std::size_t i = 0; i < columns.size(); ++i) all.values[i] = log_.number(columns[i]);
    return all;
  }

  const log_reader& log_;
  ph::runtime::device_sizes device_;
  std::size_t time_;
  std::vector<std::size_t> q_, qd_, force_, capacity_;
};

}  // namespace example
