/// @file
/// The simulation of a device: a control cycle of 1 ms, ten time steps of the plant in it, and a hand.
#pragma once

#include "device.hpp"
#include "motion_record.hpp"
#include "simulation_row.hpp"

#include <passive_haptics/plant/contact_metrics.hpp>
#include <passive_haptics/plant/following_hand.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

#include <array>
#include <optional>

namespace explorer {

/// The simulation of E's device.
template <class E>
class simulation_of final : public simulation {
  using C = configuration<E>;
  using M = typename E::mechanism;
  using shape = any_shape<M::task_dimension>;
  static constexpr int n = C::n, d = C::d, m = C::m;
  static constexpr double cycle = 1e-3, time_step = 1e-4;  // [s]
  static constexpr int steps_per_cycle = 10;

 public:
  /// Begins at the state of the settings.
  explicit simulation_of(const C& c)
      : c_(c),
        model_(E::make(c.mechanism)),
        plant_(model_, c.brakes, mass_of(c_), c.top.q),
        meter_(way_of_meter, time_step) {
    check_hand(c_, plant_);
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
    ph::simulated_device<M> plant(model, next.brakes, mass_of(next), q);
    check_hand(next, plant);
    c_ = std::move(next);
    if (is_new) {
      model_ = std::move(model);
      plant_ = std::move(plant);
      plant_.set_motion(q, qd);
    }
    // A hand that takes over leaves the controller its memory, so that a log of both is that of one
    // controller
    if (!has_only_hand(changed)) control_ = c_.control(model_, c_.law, c_.walls());
    prepare_hand();
  }

  void restart() override {
    plant_ = ph::simulated_device<M>(model_, c_.brakes, mass_of(c_), c_.top.q);
    plant_.set_motion(c_.top.q, c_.top.qd);
    control_ = c_.control(model_, c_.law, c_.walls());
    meter_ = ph::contact_meter(way_of_meter, time_step);
    separations_ = 0;
    is_in_contact_ = false;
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
    figures_ = {double(separations_), f.max_depth,       f.depth_mean,      f.depth_std,
                f.stick_share,        f.retarding_force, f.max_brake_power, f.duration};
    return figures_.data();
  }

  void record(bool is_on) override {
    if (is_on) record_.clear();
    is_recording_ = is_on;
  }

  std::string log() const override { return record_.log(); }
  std::string device_file() const override { return explorer::device_file(c_); }

 private:
  static constexpr double way_of_meter =
      3;  // [s]; its settling share of it, 0.3 s, stays out of the mean depth

  static double mass_of(const C& c) { return c.top.hand == hand_kind::along ? c.along.mass : c.hand.mass; }

  // Throws std::invalid_argument if the time step is too long for the hand of these settings.
  static void check_hand(const C& c, const ph::simulated_device<M>& plant) {
    const double moved = plant.min_mass();
    const double fastest = c.top.hand == hand_kind::along
                               ? ph::following_hand<double, d>(c.path.direction, plant.position(), c.along)
                                     .min_time_constant(moved)
                               : ph::min_time_constant(moved, c.hand.stiffness, c.hand.damping);
    ph::require_no_error(ph::check_time_step(time_step, fastest));
  }

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
    const recorded_cycle<M> now{state, r, plant_.position(), depth(), plant_.rates(), plant_.brake_torque()};
    for (int k = 0; k < steps_per_cycle; ++k) {
      muscle = muscle_force(is_held, motion_time_ + k * time_step);
      const double friction = plant_.energy().friction();
      plant_.advance(time_step, r.capacity, muscle);
      if (shape_) {
        const ph::task_vector<M> n_out = normal(), v = plant_.velocity();
        const ph::task_vector<M> along = v - n_out * n_out.dot(v);
        const double speed = along.norm();
        count_separation(depth(), (hand_ || is_held) && muscle.dot(n_out) < 0);
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
    if (is_recording_) record_.add(now);
    ++cycles_;
    if (!plant_.q().allFinite() || !plant_.position().allFinite()) stop_at(state.q);
  }

  // The handle leaves the wall while the hand pushes; one that is pulled off does not count.
  void count_separation(double depth, bool is_pushed) {
    constexpr double hysteresis = ph::contact_meter::hysteresis;
    if (is_in_contact_ && depth < -hysteresis && is_pushed) ++separations_;
    is_in_contact_ = depth > (is_in_contact_ ? -hysteresis : hysteresis);
  }

  // Where the loop of a closed chain can no longer be closed: at rest at the last pose that is one.
  void stop_at(const ph::joint_vector<M>& q) {
    plant_ = ph::simulated_device<M>(model_, c_.brakes, mass_of(c_), q);
    plant_.set_motion(q, ph::joint_vector<M>::Zero());
  }

  void put_row(const ph::device_state<M>& state, const ph::step_result<M>& r,
               const ph::task_vector<M>& muscle) {
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
    for (int i = 0; i < m; ++i) t.put(columns_.brake_state + i, int(doing_of(c_, i, w[i], r.capacity[i])));
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
  bool is_pointed_ = false, is_recording_ = false, is_in_contact_ = false;
  int separations_ = 0;
  double motion_time_ = 0;  // since the start of the hand's way [s]
  long cycles_ = 0;
  row_columns<E> columns_;
  std::vector<double> ring_;
  ph::contact_meter meter_;
  std::array<double, 8> figures_{};
  motion_record<E> record_;
};

}  // namespace explorer
