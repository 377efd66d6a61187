/// @file
/// A log that goes through the law of a device, line by line.
#pragma once

#include "simulation_of.hpp"

#include <log/log_reader.hpp>
#include <log/motion_columns.hpp>

#include <array>
#include <sstream>

namespace explorer {

/// The log of E's device.
template <class E>
class replay_of final : public replayed_log {
  using C = configuration<E>;
  using M = typename E::mechanism;
  static constexpr int d = C::d, m = C::m;

 public:
  /// Throws example::log_error at the first line that is wrong.
  replay_of(const C& c, const std::string& text) {
    std::istringstream in(text);
    example::log_reader log(in, "the log");
    const example::motion_columns where(log, {C::n, d, m}, true);
    const M model = E::make(c.mechanism);
    const auto control = c.control(model, c.law, c.walls());
    const std::optional<any_shape<d>> shape = shape_of<d>(c.top.scene);
    value_table& t = columns_.table;
    while (log.next()) {
      const example::logged_motion now = where.motion();
      const ph::device_state<M> state{now.time, ph::joint_vector<M>(now.q.data()),
                                      ph::joint_vector<M>(now.qd.data()),
                                      ph::task_vector<M>(now.hand_force.data())};
      std::fill_n(t.data(), t.size(), std::numeric_limits<double>::quiet_NaN());
      t.put(columns_.t, state.time);
      t.put_column(columns_.q, state.q, C::n);
      t.put_column(columns_.qd, state.qd, C::n);
      if (state.q.allFinite() && state.qd.allFinite() && state.hand_force.allFinite()) {
        const ph::step_result<M> r = control->decide(state);
        columns_.put_cycle(state, r);
        const ph::task_vector<M> x = model.position(state.q);
        const ph::brake_vector<M> w = ph::brake_rates(model, state.q, state.qd);
        t.put_column(columns_.x, x, 3);
        t.put_column(columns_.v,
                     ph::task_vector<M>(ph::jacobian_matrix<M>(ph::jacobian(model, state.q)) * state.qd), 3);
        t.put_column(columns_.w, w, m);
        t.put(columns_.depth, shape ? -shape->distance(x) : 0.0);
        t.put_column(columns_.brake_torque, r.torque, m);  // as predicted: nobody measured it
        for (int i = 0; i < m; ++i) t.put(columns_.brake_state + i, int(doing_of(c, i, w[i], r.capacity[i])));
        if (const auto logged = where.capacity()) {
          agreement_[1] += 1;
          agreement_[0] += *logged == ph::runtime::joint_numbers(r.capacity) ? 1 : 0;
        }
      }
      rows_.insert(rows_.end(), t.data(), t.data() + t.size());
    }
  }

  int count() const override { return static_cast<int>(rows_.size()) / width(); }
  value_table& row(int line) override {
    value_table& t = columns_.table;
    if (line >= 0 && line < count())
      std::copy_n(rows_.data() + std::size_t(line) * std::size_t(width()), width(), t.data());
    return t;
  }
  double* agreement() override { return agreement_.data(); }

 private:
  int width() const { return columns_.table.size(); }

  row_columns<E> columns_;
  std::vector<double> rows_;
  std::array<double, 2> agreement_{};
};

}  // namespace explorer
