#include "simulation.hpp"

#include "pose.hpp"

#include <log/decision.hpp>

#include <passive_haptics/plant/brakes/coulomb_brake.hpp>

#include <algorithm>

namespace explorer {
namespace {

constexpr double cycle = 1e-3, time_step = 1e-4;  // [s]
constexpr int steps_per_cycle = 10;
constexpr std::size_t max_recorded = 120'000;  // [cycles]

bool has_prefix(const settings& changed, std::string_view prefix) {
  const auto& lines = changed.lines();
  return std::any_of(lines.begin(), lines.end(), [&](const auto& l) { return l.first.starts_with(prefix); });
}

ph::following_hand<double, 3> hand_at(const place& start, const configuration& c) {
  return {place_of(c.path.direction), start, c.along};
}

// Throws std::invalid_argument if the time step is too long for the hand of these settings.
void check_hand(const device_parts& of, const runtime::any_plant& plant) {
  const configuration& c = of.settings;
  const double moved = plant.min_mass();
  const double fastest = c.state.hand == hand_kind::along
                             ? hand_at(place_of(plant.position()), c).min_time_constant(moved)
                             : ph::min_time_constant(moved, c.hand.stiffness, c.hand.damping);
  ph::require_no_error(ph::check_time_step(time_step, fastest));
}

}  // namespace

value_table row_table(const configuration& c) {
  const auto [n, d, m] = c.sizes;
  const bool slides = c.about->slides;
  const std::string torque = slides ? "N" : "N m", rate = slides ? "m/s" : "rad/s";
  const char* group = "simulation";
  return value_table(
      {{"t", "time", "t", "", "s", group},
       {"q", "joint positions", "q", "", slides ? "m" : "rad", group, n, n},
       {"qd", "joint rates", "q̇", "", rate, group, n, n},
       {"x", "handle", "x", "", "m", group, 3, 3},
       {"v", "velocity of the handle", "v", "", "m/s", group, 3, 3},
       {"pointer", "pointer", "", "", "m", group, 3, 3},
       {"hand_force", "sensed hand force", "Fₕ", "", "N", group, 3, 3},
       {"muscle_force", "force of the hand's muscles", "", "", "N", group, 3, 3},
       {"depth", "depth in the wall", "", "", "m", group},
       {"w", "rates of the brakes", "θ̇", "", rate, group, m, m},
       {"capacity", "commanded capacity", "|τ_c|", "", torque, group, m, m},
       {"brake_torque", "torque of the brakes", "τ", "", torque, group, m, m},
       {"brake_force", "force of the brakes at the handle", "", "", "N", group, 3, 3},
       {"Fd", "desired force", "F_d", "", "N", group, 3, 3},
       {"Fc", "control force, before α and the torque limits", "F_c", "", "N", group, 3, 3},
       {"gamma", "approximation angle", "γ", "", "rad", group},
       {"alpha", "scale factor", "α", "", "1", group},
       {"display", "how it is displayed, before the torque limits", "", "", "", group, 1, 1, display_words()},
       {"power", "region of the desired force", "", "", "", group, 1, 1, power_words()},
       {"status", "status", "", "", "", group, 1, 1, status_words()},
       {"brake_state", "state of the brakes", "", "", "", group, m, m, brake_words()},
       {"progress", "share of the way", "", "", "1", group}});
}

void put_cycle(value_table& row, const runtime::state_view& state, const runtime::cycle_record& r) {
  row.put("t", state.time);
  row.put("q", state.q);
  row.put("qd", state.qd);
  row.put("hand_force", state.hand_force);
  row.put("capacity", r.capacity);
  row.put("Fd", r.desired_force);
  row.put("Fc", r.control_force);
  row.put("gamma", r.approximation_angle());
  row.put("alpha", r.alpha);
  row.put("display", display_number(r));
  row.put("power", int(r.power));
  row.put("status", int(r.outcome));
}

simulation::simulation(const configuration& c) : parts_(c), row_(row_table(c)) {
  parts_.require_wall_for_hand();
  restart();
  check_hand(parts_, *plant_);
}

std::unique_ptr<runtime::any_plant> simulation::plant_of(const device_parts& of, numbers q) const {
  const configuration& c = of.settings;
  std::vector<runtime::run_time_brake> brakes;
  for (std::size_t i = 0; i < c.brakes.present.size(); ++i) {
    ph::coulomb_brake<double> brake;
    brake.torque_limit = c.brakes.torque_limit[i];
    brake.time_constant = c.brakes.time_constant[i];
    brakes.emplace_back(brake);
  }
  return of.kind->plant(brakes, c.state.hand == hand_kind::along ? c.along.mass : c.hand.mass, q);
}

void simulation::set(const settings& changed) {
  configuration next = parts_.settings;
  next.take(changed);
  device_parts parts(next);
  parts.require_wall_for_hand();
  const joint_numbers q = plant_->q(), qd = plant_->qd();
  auto plant = plant_of(parts, q);
  check_hand(parts, *plant);
  parts_ = std::move(parts);
  if (has_prefix(changed, "mechanism.") || has_prefix(changed, "brakes.") || has_prefix(changed, "hand.")) {
    plant_ = std::move(plant);
    plant_->set_motion(q, qd);
  }
  // A hand that takes over leaves the controller its memory, so that a log of both is that of one controller
  const auto& lines = changed.lines();
  if (!std::all_of(lines.begin(), lines.end(), [](const auto& l) { return l.first == "hand"; }))
    prepare_control();
  prepare_hand();
}

void simulation::restart() {
  const state_settings& s = parts_.settings.state;
  plant_ = plant_of(parts_, s.q);
  plant_->set_motion(s.q, s.qd);
  prepare_control();
  separations_ = contact_time_ = 0;
  is_in_contact_ = is_pointed_ = false;
  start_ = position();
  motion_time_ = 0;
  prepare_hand();
}

void simulation::prepare_control() {
  const configuration& c = parts_.settings;
  control_ = c.controller(*parts_.kind, c.scene_of(parts_.wall));
}

void simulation::prepare_hand() {
  hand_.reset();
  if (parts_.settings.state.hand != hand_kind::along) return;
  start_ = position();
  motion_time_ = 0;
  hand_.emplace(hand_at(start_, parts_.settings));
}

void simulation::step(int cycles, const place& pointer, bool is_held) {
  if (!is_pointed_) pointer_ = pointer;
  is_pointed_ = true;
  const place from = pointer_;
  rows_.clear();
  for (int k = 1; k <= cycles; ++k) {
    pointer_ = from + double(k) / cycles * (pointer - from);
    one_cycle(is_held);
  }
}

void simulation::record(bool is_on) {
  if (is_on) record_.clear();
  is_recording_ = is_on;
}

std::string simulation::log() const {
  example::joint_kinds kinds;
  kinds.slides.assign(runtime::max_joints, parts_.settings.about->slides);
  example::log_row row;
  std::string text;
  for (const recorded& now : record_) {
    row.start();
    put_motion(row, kinds, now);
    put_decision(row, kinds, now.decision);
    row.put_axes("x", "m", now.position);
    row.put("depth", "m", now.depth);
    row.put("w", kinds.rate(), now.rates);
    row.put("brake_torque", kinds.torque(), now.brake_torque);
    if (text.empty()) text = row.header();
    text += row.csv();
  }
  return text;
}

double simulation::depth() const { return parts_.wall ? -parts_.wall.distance(position()) : 0.0; }

place simulation::muscle_force(bool is_held, double time) const {
  const place x = position(), v = velocity();
  if (hand_) return hand_->force(time, x, v, parts_.wall.gradient(x), depth());
  const pointer_hand& hand = parts_.settings.hand;
  if (!is_held) return -hand.damping * v;
  const place pull = hand.stiffness * (pointer_ - x);
  const double size = pull.norm(), share = size > hand.strength ? hand.strength / size : 1.0;
  return share * pull - hand.damping * v;
}

void simulation::one_cycle(bool is_held) {
  const recorded before{double(cycles_) * cycle, plant_->q(), plant_->qd(),    plant_->sensed_force(), {},
                        plant_->position(),      depth(),     plant_->rates(), plant_->brake_torque()};
  const runtime::state_view state{before.time, before.q, before.qd, before.hand_force};
  const runtime::cycle_record r = control_.decide(state);
  place muscle = place::Zero();
  for (int k = 0; k < steps_per_cycle; ++k) {
    muscle = muscle_force(is_held, motion_time_ + k * time_step);
    plant_->advance(time_step, r.capacity, first(muscle, parts_.d()));
    if (!parts_.wall) continue;
    const place out = parts_.wall.gradient(position());
    count_separation(depth(), (hand_ || is_held) && muscle.dot(out) < 0);
  }
  motion_time_ += cycle;
  put_row(state, r, muscle);
  if (is_recording_ && record_.size() < max_recorded) {
    record_.push_back(before);
    record_.back().decision = r;
  }
  ++cycles_;
  // At rest at the last pose, if the loop of a closed chain can no longer be closed
  const joint_numbers q = plant_->q();
  const bool is_finite = std::all_of(q.data(), q.data() + q.count, [](double x) { return std::isfinite(x); });
  if (is_finite && position().allFinite()) return;
  plant_ = plant_of(parts_, before.q);
}

// The handle leaves the wall while the hand pushes; one that is pulled off does not count.
void simulation::count_separation(double depth, bool is_pushed) {
  constexpr double hysteresis = 10e-6;  // [m], as of contact_meter
  if (is_in_contact_ && depth < -hysteresis && is_pushed) ++separations_;
  is_in_contact_ = depth > (is_in_contact_ ? -hysteresis : hysteresis);
  if (is_in_contact_ || contact_time_ > 0) contact_time_ += time_step;
}

void simulation::put_row(const runtime::state_view& state, const runtime::cycle_record& r,
                         const place& muscle) {
  const configuration& c = parts_.settings;
  const joint_numbers rates = plant_->rates();
  put_cycle(row_, state, r);
  row_.put("x", plant_->position());
  row_.put("v", plant_->velocity());
  row_.put("pointer", pointer_);
  row_.put("muscle_force", muscle);
  row_.put("depth", depth());
  row_.put("w", rates);
  row_.put("brake_torque", plant_->brake_torque());
  row_.put("brake_force", plant_->brake_force());
  put_brake_states(row_, c, rates, r.capacity);
  const place way = ph::direction_of(place_of(c.path.direction));
  row_.put("progress", way.dot(position() - start_) / c.path.length);
  rows_.insert(rows_.end(), row_.data(), row_.data() + row_.size());
}

}  // namespace explorer
