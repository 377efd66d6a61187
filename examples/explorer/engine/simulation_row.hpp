/// @file
/// The columns of a simulation: what each cycle saw, decided and did.
#pragma once

#include "pose_values.hpp"
#include "value_table.hpp"

#include <passive_haptics/control/device_state.hpp>
#include <passive_haptics/control/step_result.hpp>

#include <string>
#include <vector>

namespace explorer {

/// The columns of a row: what a cycle saw, decided and did.
template <class E>
struct row_columns {
  static constexpr int n = configuration<E>::n, m = configuration<E>::m;
  value_table table;  ///< The names, and the numbers of one row.
  int t, q, qd, x, v, pointer, hand_force, muscle_force, depth, w, capacity, brake_torque, brake_force, Fd,
      Fc, gamma, alpha, display, power, status, brake_state, progress;  ///< Offsets.

  row_columns() {
    const std::string torque = E::slides ? "N" : "N m", rate = E::slides ? "m/s" : "rad/s";
    const auto add = [&](const char* id, const char* label, const char* symbol, const std::string& unit,
                         int size, std::vector<std::string> words = {}) {
      return table.add({id, label, symbol, "", unit, "simulation", size, size, std::move(words)});
    };
    t = add("t", "time", "t", "s", 1);
    q = add("q", "joint positions", "q", E::slides ? "m" : "rad", n);
    qd = add("qd", "joint rates", "q̇", rate, n);
    x = add("x", "handle", "x", "m", 3);
    v = add("v", "velocity of the handle", "v", "m/s", 3);
    pointer = add("pointer", "pointer", "", "m", 3);
    hand_force = add("hand_force", "sensed hand force", "Fₕ", "N", 3);
    muscle_force = add("muscle_force", "force of the hand's muscles", "", "N", 3);
    depth = add("depth", "depth in the wall", "", "m", 1);
    w = add("w", "rates of the brakes", "θ̇", rate, m);
    capacity = add("capacity", "commanded capacity", "|τ_c|", torque, m);
    brake_torque = add("brake_torque", "torque of the brakes", "τ", torque, m);
    brake_force = add("brake_force", "force of the brakes at the handle", "", "N", 3);
    Fd = add("Fd", "desired force", "F_d", "N", 3);
    Fc = add("Fc", "control force, before α and the torque limits", "F_c", "N", 3);
    gamma = add("gamma", "approximation angle", "γ", "rad", 1);
    alpha = add("alpha", "scale factor", "α", "1", 1);
    display = add("display", "how it is displayed, before the torque limits", "", "", 1, display_words());
    power = add("power", "region of the desired force", "", "", 1, power_words());
    status = add("status", "status", "", "", 1, status_words());
    brake_state = add("brake_state", "state of the brakes", "", "", m, brake_words());
    progress = add("progress", "share of the way", "", "1", 1);
  }

  /// State and decision of a cycle.
  template <class M>
  void put_cycle(const ph::device_state<M>& state, const ph::step_result<M>& r) {
    table.put(t, state.time);
    table.put_column(q, state.q, n);
    table.put_column(qd, state.qd, n);
    table.put_column(hand_force, state.hand_force, 3);
    table.put_column(capacity, r.capacity, m);
    table.put_column(Fd, r.desired_force, 3);
    table.put_column(Fc, r.control_force, 3);
    table.put(gamma, r.approximation_angle());
    table.put(alpha, r.alpha);
    table.put(display, display_number(r));
    table.put(power, int(r.power));
    table.put(status, int(r.outcome));
  }
};

}  // namespace explorer
