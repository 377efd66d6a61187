/// @file
/// Runs a logged motion through a control law, line by line.
#pragma once

#include <log/decision.hpp>
#include <log/motion_columns.hpp>

#include <passive_haptics/passive_haptics.hpp>

#include <functional>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace example {

namespace ph = passive_haptics;

/// How a replay went [lines].
struct replay_summary {
  std::size_t lines = 0;
  std::size_t decided = 0;   ///< All but those in which a number is missing, as before homing.
  std::size_t compared = 0;  ///< Of them, those whose capacities the log has as well,
  std::size_t same = 0;      ///< and has the same to the last digit.
};

/// Runs each line of a log through a controller and writes it with the decision to `out`, a log itself. A
/// line in which a number is missing is written without a decision; where no force is needed, a missing one
/// is 0, as of a device without a force sensor. Throws log_error on the first malformed line. Memory does not
/// grow with the log. `progress` hears the number of lines done, every 65 536 of them.
template <class Control>
replay_summary replay(log_reader& log, std::ostream& out, Control& control, bool needs_force = true,
                      const std::function<void(std::size_t)>& progress = {}) {
  using M = std::remove_cvref_t<decltype(control.mechanism())>;
  const motion_columns<M> columns(log, needs_force);
  const joint_kinds joints = columns.joints();
  typename Control::result_type decision;
  log_row row;
  const auto fill = [&](const ph::device_state<M>& state, bool was_asked) {
    row.start();
    put_motion(row, joints, state);
    put_decision(row, joints, decision, was_asked);
  };
  fill({}, false);
  out << row.header();

  replay_summary all;
  while (log.next()) {
    const ph::device_state<M> logged = columns.state();
    ph::device_state<M> state = logged;
    if (!needs_force && !state.hand_force.allFinite()) state.hand_force.setZero();
    const bool is_whole = state.q.allFinite() && state.qd.allFinite() && state.hand_force.allFinite();
    if (is_whole) {
      decision = control(state);
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
