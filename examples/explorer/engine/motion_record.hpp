/// @file
/// A record of a simulated motion: a log of the library, and the command that replays it.
#pragma once

#include "configuration.hpp"

#include <log/decision.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace explorer {

/// A cycle: what the controller saw and decided, and where the device was.
template <class M>
struct recorded_cycle {
  ph::device_state<M> state;         ///< What the controller saw.
  ph::step_result<M> decision;       ///< What it decided.
  ph::task_vector<M> position;       ///< Of the handle [m].
  double depth;                      ///< In the wall [m].
  ph::brake_vector<M> rates;         ///< Of the brakes [rad/s].
  ph::brake_vector<M> brake_torque;  ///< Of the brakes [N m].
};

/// Cycles one after the other, up to two minutes.
template <class E>
class motion_record {
  using M = typename E::mechanism;
  static constexpr std::size_t max_cycles = 120'000;  // [cycles]

 public:
  /// Forgets all.
  void clear() { cycles_.clear(); }
  /// Adds a cycle, if there is room.
  void add(const recorded_cycle<M>& now) {
    if (cycles_.size() < max_cycles) cycles_.push_back(now);
  }
  /// The log (docs/guide/log.md); empty without a cycle.
  std::string log() const {
    example::joint_kinds kinds;
    if (E::slides) kinds.slides.assign(std::size_t(std::max(M::dof, M::brake_count)), true);
    example::log_row row;
    std::string text;
    for (const recorded_cycle<M>& r : cycles_) {
      row.start();
      put_motion(row, kinds, r.state);
      put_decision(row, kinds, r.decision);
      row.put_axes("x", "m", r.position);
      row.put("depth", "m", r.depth);
      row.put("w", kinds.rate(), r.rates);
      row.put("brake_torque", kinds.torque(), r.brake_torque);
      if (text.empty()) text = row.header();
      text += row.csv();
    }
    return text;
  }

 private:
  std::vector<recorded_cycle<M>> cycles_;
};

/// Whether the program replay (examples/05_replay.cpp) has all that a device is made of.
template <class E>
bool is_replayable(const configuration<E>& c) {
  configuration<E> now = c, usual;
  usual.law = now.law;
  const field_list fields = now.fields(), defaults = usual.fields();
  const std::string& scene = c.top.scene;
  if (!E::has_replay || c.wall.rate != 0 || c.law == law_kind::on_off_control) return false;
  if (!scene.starts_with("plane:") && !scene.starts_with("solid:") && !scene.starts_with("hollow:"))
    return false;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const std::string_view name = fields[k].name, group = fields[k].group;
    if (name == "brakes.torque_limit" || name == "brakes.rate_dead_band") {
      for (int i = 1; i < fields[k].count; ++i)
        if (fields[k].numbers[i] != fields[k].numbers[0]) return false;
    } else if ((group == "brakes" || group == "law" || group == "options") &&
               text_of(fields[k]) != text_of(defaults[k])) {
      return false;
    }
  }
  return true;
}

/// The command that replays a log of this device; empty where the program lacks part of it.
template <class E>
std::string replay_command(const configuration<E>& c) {
  if (!is_replayable(c)) return "";
  std::string command = std::string("./examples/run replay --input FILE --mechanism ") + E::id + " --wall " +
                        c.top.scene + " --stiffness " + number_text(c.wall.stiffness) + " --law " +
                        id_of(c.law) + " --limit " + number_text(c.brakes.torque_limit[0]) + " --dead-band " +
                        number_text(c.brakes.rate_dead_band[0]);
  configuration<E> now = c, usual;
  usual.law = now.law;
  const field_list fields = now.fields(), defaults = usual.fields();
  for (std::size_t k = 0; k < fields.size(); ++k)
    if (fields[k].name.starts_with("mechanism.") && text_of(fields[k]) != text_of(defaults[k]))
      command.append(" --parameter ").append(fields[k].about.name).append("=").append(text_of(fields[k]));
  return command;
}

}  // namespace explorer
