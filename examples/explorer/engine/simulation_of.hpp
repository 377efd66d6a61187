/// @file
/// The simulation of a device: a control cycle of 1 ms, ten time steps of the plant in it, and a hand.
#pragma once

#include "device.hpp"
#include "pose_values.hpp"

#include <log/decision.hpp>

#include <passive_haptics/plant/contact_metrics.hpp>
#include <passive_haptics/plant/following_hand.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

#include <array>
#include <optional>

namespace explorer {

/// The columns of a row: what a cycle saw, decided and did.
template <class E>
struct row_columns {
  static constexpr int n = configuration<E>::n, m = configuration<E>::m;
  value_table table;  ///< The names, and the numbers of one row.
  int t, q, qd, x, v, pointer, hand_force, muscle_force, depth, w, capacity, brake_torque, brake_force, Fd, Fc, gamma,
      alpha, display, power, status, brake_state, sound, progress;  ///< Offsets.

  row_columns() {
    const std::string torque = E::slides ? "N" : "N m", rate = E::slides ? "m/s" : "rad/s";
    const auto add = [&](const char* id, const char* label, const char* symbol, const std::string& unit, int size,
                         std::vector<std::string> words = {}) {
      return table.add({id, label, symbol, "", unit, "simulation", size, size, {}, std::move(words)});
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
    Fc = add("Fc", "control force", "F_c", "N", 3);
    gamma = add("gamma", "approximation angle", "γ", "rad", 1);
    alpha = add("alpha", "scale factor", "α", "1", 1);
    display = add("display", "how it is displayed", "", "", 1, display_words());
    power = add("power", "region of the desired force", "", "", 1, power_words());
    status = add("status", "status", "", "", 1, status_words());
    brake_state = add("brake_state", "state of the brakes", "", "", m, brake_words());
    sound = add("sound", "mean torque of slipping brakes", "", "1", 1);
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
    table.put(display, int(r.display));
    table.put(power, int(r.power));
    table.put(status, int(r.outcome));
  }
};

/// The simulation of E's device.
template <class E>
class simulation_of final : public simulation {
  using C = configuration<E>;
  using M = typename E::mechanism;
  using shape = any_shape<M::task_dimension>;
  static constexpr int n = C::n, d = C::d, m = C::m;
  static constexpr double cycle = 1e-3, time_step = 1e-4;  // [s]
  static constexpr int steps_per_cycle = 10;
  static constexpr std::size_t longest_record = 120'000;  // [cycles]

 public:
  /// Begins at the state of the settings.
  explicit simulation_of(const C& c)
      : c_(c), model_(E::make(c.mechanism)), plant_(model_, c.brakes, mass(), c.top.q), meter_(far_away, time_step) {
    ring_.resize(std::size_t(ring_size) * std::size_t(columns_.table.size()));
    prepare();
    restart();
  }

  void set(const settings& changed) override {
    C next = c_;
    next.take(changed);
    if (next.top.hand == hand_kind::along && !shape_of<d>(next.top.scene)) E::refuse_hand();
    const auto has = [&](std::string_view prefix) {
      for (const auto& [name, value] : changed.lines())
        if (name.starts_with(prefix)) return true;
      return false;
    };
    const bool is_new = has("mechanism.") || has("brakes.") || has("hand.");
    const ph::joint_vector<M> q = plant_.q(), qd = plant_.qd();
    M model = E::make(next.mechanism);
    c_ = std::move(next);
    if (is_new) {
      model_ = std::move(model);
      plant_ = ph::simulated_device<M>(model_, c_.brakes, mass(), q);
      plant_.set_motion(q, qd);
    }
    // A hand that takes over leaves the controller its memory, so that a log of both is that of one controller
    if (!has_only_hand(changed)) control_ = c_.control(model_, c_.law, c_.walls());
    prepare_hand();
  }

  void restart() override {
    plant_ = ph::simulated_device<M>(model_, c_.brakes, mass(), c_.top.q);
    plant_.set_motion(c_.top.q, c_.top.qd);
    control_ = c_.control(model_, c_.law, c_.walls());
    meter_ = ph::contact_meter(far_away, time_step);
    start_ = plant_.position();
    motion_time_ = 0;
    is_pointed_ = false;
    if (shape_ && c_.top.hand == hand_kind::along) hand_.emplace(c_.path.direction, start_, c_.along);
  }

  void step(int cycles, const drawing::place& pointer, bool is_held) override {
    const ph::task_vector<M> to = pointer.template head<d>();
    if (!is_pointed_) pointer_ = to;
    is_pointed_ = true;
    const ph::task_vector<M> from = pointer_;
    for (int k = 1; k <= cycles; ++k) {
      pointer_ = from + double(k) / cycles * (to - from);
      one_cycle(is_held);
    }
  }

  value_table& row() override { return columns_.table; }
  double* ring() override { return ring_.data(); }
  double cycles() const override { return double(cycles_); }

  double* figures() override {
    const ph::contact_metrics f = meter_.result();
    figures_ = {double(f.separations), f.depth_max,       f.depth_mean,          f.depth_std,
                f.stick_share,         f.retarding_force, f.largest_brake_power, f.duration};
    return figures_.data();
  }

  void record(bool is_on) override {
    if (is_on) record_.clear();
    is_recording_ = is_on;
  }

  std::string log() const override {
    example::joint_kinds kinds;
    if (E::slides) kinds.slides.assign(std::size_t(std::max(n, m)), true);
    example::log_row row;
    std::string text;
    for (const recorded& r : record_) {
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

  std::string replay_command() const override {
    if (!is_replayable()) return "";
    std::string command = std::string("./examples/run replay --input FILE --mechanism ") + E::id + " --wall " +
                          c_.top.scene + " --stiffness " + number_text(c_.wall.stiffness) + " --law " +
                          id_of(c_.law) + " --limit " + number_text(c_.brakes.torque_limit[0]) +
                          " --dead-band " + number_text(c_.brakes.rate_dead_band[0]);
    C now = c_, usual;
    usual.law = now.law;
    const field_list fields = now.fields(), defaults = usual.fields();
    for (std::size_t k = 0; k < fields.size(); ++k) {
      const field& f = fields[k];
      if (f.name.starts_with("mechanism.") && text_of(f) != text_of(defaults[k]))
        command.append(" --parameter ").append(f.about.name).append("=").append(text_of(f));
    }
    return command;
  }

 private:
  static constexpr double far_away = 1e300;  // [m]; a path without an end

  struct recorded {
    ph::device_state<M> state;
    ph::step_result<M> decision;
    ph::task_vector<M> position;
    double depth;
    ph::brake_vector<M> rates, brake_torque;
  };

  // Whether the program replay has what this device is made of.
  bool is_replayable() const {
    C now = c_, usual;
    usual.law = now.law;
    const field_list fields = now.fields(), defaults = usual.fields();
    const std::string& scene = c_.top.scene;
    if (!E::has_replay || c_.wall.rate != 0 || c_.law == law_kind::on_off || c_.law == law_kind::coercive) return false;
    if (!scene.starts_with("plane:") && !scene.starts_with("solid:") && !scene.starts_with("hollow:")) return false;
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

  double mass() const { return c_.top.hand == hand_kind::along ? c_.along.mass : c_.hand.mass; }

  static bool has_only_hand(const settings& changed) {
    for (const auto& [name, value] : changed.lines())
      if (name != "hand") return false;
    return true;
  }

  // What follows from the settings, but for the plant.
  void prepare() {
    control_ = c_.control(model_, c_.law, c_.walls());
    prepare_hand();
  }

  void prepare_hand() {
    shape_ = shape_of<d>(c_.top.scene);
    hand_.reset();
    if (c_.top.hand == hand_kind::along) {
      if (!shape_) E::refuse_hand();
      hand_.emplace(c_.path.direction, plant_.position(), c_.along);
      start_ = plant_.position();
      motion_time_ = 0;
    }
  }

  double depth() const { return shape_ ? -shape_->distance(plant_.position()) : 0.0; }
  ph::task_vector<M> normal() const {
    return shape_ ? shape_->gradient(plant_.position()) : ph::task_vector<M>(ph::task_vector<M>::Zero());
  }

  // The force of the hand's muscles [N].
  ph::task_vector<M> muscle_force(bool is_held, double time) const {
    const ph::task_vector<M> x = plant_.position(), v = plant_.velocity();
    if (hand_) return hand_->force(time, x, v, normal(), depth());
    if (!is_held) return -c_.hand.damping * v;
    const ph::task_vector<M> pull = c_.hand.stiffness * (pointer_ - x);
    const double size = pull.norm();
    const double share = size > c_.hand.strength ? c_.hand.strength / size : 1.0;
    return share * pull - c_.hand.damping * v;
  }

  double progress() const {
    const ph::task_vector<M> u = ph::direction_of(c_.path.direction);
    return u.dot(plant_.position() - start_) / c_.path.length;
  }

  void one_cycle(bool is_held) {
    const double time = double(cycles_) * cycle;
    const ph::device_state<M> state{time, plant_.q(), plant_.qd(), plant_.sensed_force()};
    const ph::step_result<M> r = control_->decide(state);
    ph::task_vector<M> muscle = ph::task_vector<M>::Zero();
    const double depth_then = depth();
    const recorded now{state, r, plant_.position(), depth_then, plant_.rates(), plant_.brake_torque()};
    for (int k = 0; k < steps_per_cycle; ++k) {
      muscle = muscle_force(is_held, motion_time_ + k * time_step);
      const double friction = plant_.energy().friction();
      plant_.advance(time_step, r.capacity, muscle);
      if (shape_) {
        const ph::task_vector<M> n_out = normal(), v = plant_.velocity();
        const ph::task_vector<M> along = v - n_out * n_out.dot(v);
        const double speed = along.norm();
        meter_.add({.progress = motion_time_,
                    .depth = depth(),
                    .rate = plant_.rates()[m - 1],
                    .retarding_force = speed > 0 ? -plant_.brake_force().dot(along) / speed : 0.0,
                    .brake_energy = plant_.energy().friction() - friction,
                    .brake_power = plant_.brake_power().maxCoeff(),
                    .hand_force = -plant_.sensed_force().dot(n_out)});
      }
    }
    motion_time_ += cycle;
    put_row(state, r, muscle);
    if (is_recording_ && record_.size() < longest_record) record_.push_back(now);
    ++cycles_;
    if (!plant_.q().allFinite() || !plant_.position().allFinite()) stop_at(state.q);
  }

  // Where the loop of a closed chain can no longer be closed: at rest at the last pose that is one.
  void stop_at(const ph::joint_vector<M>& q) {
    plant_ = ph::simulated_device<M>(model_, c_.brakes, mass(), q);
    plant_.set_motion(q, ph::joint_vector<M>::Zero());
  }

  void put_row(const ph::device_state<M>& state, const ph::step_result<M>& r, const ph::task_vector<M>& muscle) {
    value_table& t = columns_.table;
    columns_.put_cycle(state, r);
    t.put_column(columns_.x, plant_.position(), 3);
    t.put_column(columns_.v, plant_.velocity(), 3);
    t.put_column(columns_.pointer, pointer_, 3);
    t.put_column(columns_.muscle_force, muscle, 3);
    t.put(columns_.depth, depth());
    const ph::brake_vector<M> w = plant_.rates();
    t.put_column(columns_.w, w, m);
    t.put_column(columns_.brake_torque, plant_.brake_torque(), m);
    t.put_column(columns_.brake_force, plant_.brake_force(), 3);
    double sound = 0;
    for (int i = 0; i < m; ++i) {
      const brake_doing doing = doing_of(c_, i, w[i], r.capacity[i]);
      t.put(columns_.brake_state + i, int(doing));
      if (doing == brake_doing::slips && c_.brakes.torque_limit[i] > 0)
        sound += std::abs(plant_.brake_torque()[i]) / c_.brakes.torque_limit[i] / m;
    }
    t.put(columns_.sound, sound);
    t.put(columns_.progress, progress());
    const std::size_t width = std::size_t(t.size());
    std::copy_n(t.data(), width, ring_.data() + std::size_t(cycles_ % ring_size) * width);
  }

  C c_;
  M model_;
  ph::simulated_device<M> plant_;
  std::unique_ptr<any_control<M>> control_;
  std::optional<shape> shape_;
  std::optional<ph::following_hand<double, d>> hand_;
  ph::task_vector<M> start_ = ph::task_vector<M>::Zero(), pointer_ = ph::task_vector<M>::Zero();
  bool is_pointed_ = false, is_recording_ = false;
  double motion_time_ = 0;  // since the start of the hand's way [s]
  long cycles_ = 0;
  row_columns<E> columns_;
  std::vector<double> ring_;
  ph::contact_meter meter_;
  std::array<double, 8> figures_{};
  std::vector<recorded> record_;
};

}  // namespace explorer
