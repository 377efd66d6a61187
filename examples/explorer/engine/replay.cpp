#include "replay.hpp"

#include "pose.hpp"

#include <log/log_reader.hpp>
#include <log/motion_columns.hpp>

#include <algorithm>
#include <limits>
#include <sstream>

namespace explorer {
namespace {

template <class Numbers>
bool is_finite(const Numbers& x) {
  return std::all_of(x.data(), x.data() + x.count, [](double y) { return std::isfinite(y); });
}

}  // namespace

replayed_log::replayed_log(const device_parts& of, const std::string& text) : row_(row_table(of.settings)) {
  std::istringstream in(text);
  example::log_reader log(in, "the log");
  const configuration& c = of.settings;
  const example::motion_columns where(log, c.sizes, true);
  const page_controller control = c.controller(*of.kind, c.scene_of(of.wall));
  while (log.next()) {
    const example::logged_motion now = where.motion();
    row_.fill(std::numeric_limits<double>::quiet_NaN());
    row_.put("t", now.time);
    row_.put("q", now.q);
    row_.put("qd", now.qd);
    if (is_finite(now.q) && is_finite(now.qd) && is_finite(now.hand_force)) {
      const runtime::state_view state{now.time, now.q, now.qd, now.hand_force};
      const runtime::cycle_record r = control.decide(state);
      const place x = of.position(now.q);
      const joint_numbers rates = of.mechanism->brake_rates(now.q, now.qd);
      put_cycle(row_, state, r);
      row_.put("x", x);
      row_.put("v", of.velocity(now.q, now.qd));
      row_.put("w", rates);
      row_.put("depth", of.wall ? -of.wall.distance(x) : 0.0);
      row_.put("brake_torque", r.torque);  // as predicted: nobody measured it
      put_brake_states(row_, c, rates, r.capacity);
      if (const auto logged = where.capacity()) {
        agreement_[1] += 1;
        agreement_[0] += *logged == r.capacity ? 1 : 0;
      }
    }
    rows_.insert(rows_.end(), row_.data(), row_.data() + row_.size());
  }
}

}  // namespace explorer
