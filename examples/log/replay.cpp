#include <log/decision.hpp>
#include <log/motion_columns.hpp>
#include <log/replay.hpp>

#include <algorithm>
#include <cmath>

namespace example {
namespace {

template <class Numbers>
bool all_finite(const Numbers& v) {
  return std::all_of(v.data(), v.data() + v.size(), [](double x) { return std::isfinite(x); });
}

}  // namespace

replay_summary replay(log_reader& log, std::ostream& out, ph::runtime::any_controller& control,
                      const std::function<void(std::size_t)>& progress) {
  const bool needs_force = control.needs_hand_force();
  const motion_columns columns(log, control.sizes(), needs_force);
  const joint_kinds joints = columns.joints();
  ph::runtime::cycle_record decision = control({});  // as many numbers as the device has
  log_row row;
  const auto fill = [&](const logged_motion& state, bool was_asked) {
    row.start();
    put_motion(row, joints, state);
    put_decision(row, joints, decision, was_asked);
  };
  fill(columns.nothing(), false);
  out << row.header();

  replay_summary all;
  while (log.next()) {
    const logged_motion logged = columns.motion();
    logged_motion state = logged;
    if (!needs_force && !all_finite(state.hand_force)) state.hand_force = columns.nothing().hand_force;
    const bool is_whole = all_finite(state.q) && all_finite(state.qd) && all_finite(state.hand_force);
    if (is_whole) {
      decision = control({state.time, state.q, state.qd, state.hand_force});
      ++all.decided;
      if (const auto capacity = columns.capacity()) {
        ++all.compared;
        all.same += *capacity == decision.capacity;
      }
    }
    fill(logged, is_whole);
    out << row.csv();
    if (++all.lines % 65536 == 0 && progress) progress(all.lines);
  }
  return all;
}

}  // namespace example
