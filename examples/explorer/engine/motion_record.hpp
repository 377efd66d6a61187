/// @file
/// A record of a simulated motion: a log of the library, and the device file that replays it.
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

/// The device file with which `replay --config` replays a log of this device; empty for a mechanism or a wall
/// that device files do not have.
template <class E>
std::string device_file(const configuration<E>& c) {
  const std::string kind = c.top.scene.substr(0, c.top.scene.find(':'));
  const bool is_round = kind == "solid" || kind == "hollow";
  if (!E::has_replay || (!is_round && kind != "plane")) return "";
  configuration<E> now = c;
  const field_list fields = now.fields();
  const auto add_group = [&](std::string& text, std::string_view prefix) {
    for (const field& f : fields) {
      if (!f.name.starts_with(prefix) || f.name == "brakes.present") continue;
      const std::string value = text_of(f);
      text.append(f.about.name).append(" = ");
      if (f.numbers == nullptr) text.append("\"").append(value).append("\"\n");
      else if (f.count == 1) text.append(value).append("\n");
      else text.append("[").append(value).append("]\n");
    }
  };
  const auto with_brackets = [](const auto& v) {
    std::string text = "[";
    for (int i = 0; i < v.size(); ++i) text.append(i == 0 ? "" : ", ").append(number_text(v[i]));
    return text.append("]");
  };
  std::string text = "[mechanism]\ntype = \"";
  if constexpr (requires { E::device_type; }) text.append(E::device_type);
  else text.append(E::id);
  add_group(text.append("\"\n"), "mechanism.");
  add_group(text.append("\n[brakes]\n"), "brakes.");
  if (!c.on.present.isOnes(0)) {
    const auto bounds = now.switchable();
    text.append("torque_lower = ").append(with_brackets(bounds.torque_lower)).append("\n");
    text.append("torque_upper = ").append(with_brackets(bounds.torque_upper)).append("\n");
  }
  add_group(text.append("\n[law]\ntype = \"").append(id_of(c.law)).append("\"\n"), "law.");
  add_group(text, "options.");
  using vector = ph::vector<double, configuration<E>::d>;
  const std::vector<double> numbers =
      numbers_of("scene", std::string_view(c.top.scene).substr(kind.size() + 1));
  text.append("\n[[walls]]\nstiffness = ").append(number_text(c.wall.stiffness)).append("\n");
  const std::string point = with_brackets(vector(numbers.data()));
  if (is_round)
    text.append("type = \"ball\"\ncentre = " + point + "\nradius = " + number_text(numbers.back()) +
                "\ninside = \"" + kind + "\"\n");
  else
    text.append("type = \"half_space\"\nsurface_point = " + point +
                "\nnormal = " + with_brackets(vector(numbers.data() + vector::SizeAtCompileTime)) + "\n");
  if (c.wall.rate > 0) text.append("\n[scene]\nperiod = ").append(number_text(1 / c.wall.rate)).append("\n");
  return text;
}

}  // namespace explorer
