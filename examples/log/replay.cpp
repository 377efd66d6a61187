#include <log/decision.hpp>
#include <log/motion_columns.hpp>
#include <log/replay.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace example {
namespace {

template <class Numbers>
bool all_finite(const Numbers& v) {
  return std::all_of(v.data(), v.data() + v.size(), [](double x) { return std::isfinite(x); });
}

// Columns that brake_driver logs in addition to motion and decision; other logs may lack them.
class run_columns {
 public:
  explicit run_columns(const log_reader& log)
      : log_(log),
        status_at_(log.find("status")),
        state_at_(log.find("state")),
        reason_at_(log.find("reason")) {}

  // Reads the next line. Returns true if the driver reset its controller before the cycle of this line by a
  // rearm: the brakes are no longer released, or were released again in the same cycle for another reason.
  bool next_is_rearmed() {
    const bool was_released = state_ == released;
    const std::string reason = std::exchange(reason_, text(reason_at_));
    state_ = text(state_at_);
    return was_released && (state_ != released || reason_ != reason);
  }

  // The driver does not call the law during homing and taring.
  bool law_was_called() const { return !status_at_ || !text(status_at_).empty(); }

  // With these columns the output replays to the same decisions.
  void put(log_row& row) const {
    if (state_at_) row.put("state", state_);
    if (reason_at_) row.put("reason", reason_);
  }

 private:
  static constexpr std::string_view released = "released";
  std::string text(std::optional<std::size_t> column) const { return column ? log_.text(*column) : ""; }

  const log_reader& log_;
  std::optional<std::size_t> status_at_, state_at_, reason_at_;
  std::string state_, reason_;
};

}  // namespace

replay_summary replay(log_reader& log, std::ostream& out, ph::runtime::any_controller& control,
                      const std::function<void(std::size_t)>& progress) {
  const bool needs_force = control.needs_hand_force();
  const motion_columns columns(log, control.sizes(), needs_force);
  run_columns run(log);
  const joint_kinds joints = columns.joints();
  ph::runtime::cycle_record decision = control({});  // with the sizes of the device
  log_row row;
  const auto fill = [&](const logged_motion& state, bool was_asked) {
    row.start();
    put_motion(row, joints, state);
    put_decision(row, joints, decision, was_asked);
    run.put(row);
  };
  fill(columns.nothing(), false);
  out << row.header();

  replay_summary all;
  while (log.next()) {
    if (run.next_is_rearmed()) control.reset();
    const logged_motion logged = columns.motion();
    logged_motion state = logged;
    if (!needs_force && !all_finite(state.hand_force)) state.hand_force = columns.nothing().hand_force;
    const bool is_decided =
        run.law_was_called() && all_finite(state.q) && all_finite(state.qd) && all_finite(state.hand_force);
    if (is_decided) {
      decision = control({state.time, state.q, state.qd, state.hand_force});
      ++all.decided;
      if (const auto capacity = columns.capacity()) {
        ++all.compared;
        all.same += *capacity == decision.capacity;
      }
    }
    fill(logged, is_decided);
    out << row.csv();
    if (++all.lines % 65536 == 0 && progress) progress(all.lines);
  }
  return all;
}

}  // namespace example
