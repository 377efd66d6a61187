/// @file
/// A device of a mechanism that is known to the compiler.
///
/// E describes the mechanism:
///
///   - `mechanism`, `parameters`, and `mechanism make(const parameters&)`;
///   - `id`, `label`, whether its joints are `slides`, and `scene`, the wall at first;
///   - `start()`: joint positions at first;
///   - `inverse(model, x, q)`: joint positions that put the handle at x, on the branch of q, with their
///     status;
///   - `flipped(model, q)`, of a mechanism that has two branches: the joint positions of the other one;
///   - `draw(model, q, drawing)`, and `reach(model)`: half the size of the box about the base [m].
#pragma once

#include "forces.hpp"
#include "map_of.hpp"
#include "replay_of.hpp"

#include <array>

namespace explorer {

/// What all descriptions share.
struct described {
  static constexpr bool slides = false;     ///< Joints turn.
  static constexpr bool has_replay = true;  ///< Device files have the mechanism, as device_type or else id.
  /// There is no wall to go along.
  [[noreturn]] static void refuse_hand() {
    refuse("hand", "along", "pointer, where there is no wall: scene=none");
  }
};

/// Whether a mechanism has another branch at the same handle position.
template <class E>
concept HasBranches = requires(const typename E::mechanism& model,
                               const ph::joint_vector<typename E::mechanism>& q) { E::flipped(model, q); };

/// The device.
template <class E>
class device_of final : public device {
  using C = configuration<E>;
  using M = typename E::mechanism;
  static constexpr int n = C::n, d = C::d, m = C::m;

 public:
  device_of() : model_(E::make(c_.mechanism)), walls_(c_.walls()) { write_state(); }

  void set(const settings& changed) override {
    read_state();
    C next = c_;
    next.take(changed);
    M model = E::make(next.mechanism);
    if (!ph::task_vector<M>(model.position(next.top.q)).allFinite())
      refuse("q", text_of(*find(next.fields(), "q")),
             "joint positions at which the chain closes; change q or the lengths");
    walls_ = next.walls();
    model_ = std::move(model);
    c_ = std::move(next);
    write_state();
  }

  settings changed() const override {
    C now = c_, usual;
    read_state(now);
    usual.law = now.law;
    settings all;
    all.set("mechanism", E::id);
    all.set("law", id_of(now.law));
    const field_list fields = now.fields(), defaults = usual.fields();
    for (std::size_t k = 0; k < fields.size(); ++k) {
      const std::string text = text_of(fields[k]), &name = fields[k].name;
      if (name == "q" || name == "scene" || text != text_of(defaults[k])) all.set(name, text);
    }
    return all;
  }

  std::string form() const override {
    C now = c_, usual;
    read_state(now);
    usual.law = now.law;
    return form_of(now.fields(), usual.fields());
  }

  double* state() override { return state_.data(); }

  bool reach(const drawing::place& x) override {
    read_state();
    const auto found = E::inverse(model_, ph::task_vector<M>(x.template head<d>()), c_.top.q);
    if (!found.q.allFinite() || !ph::task_vector<M>(model_.position(found.q)).allFinite()) return false;
    c_.top.q = found.q;
    write_state();
    return found.outcome == ph::status::ok;
  }

  void move(const drawing::place& v) override {
    read_state();
    const ph::jacobian_matrix<M> J(ph::jacobian(model_, c_.top.q));
    if (!J.allFinite()) return;
    c_.top.qd = ph::pseudo_inverse(J) * ph::task_vector<M>(v.template head<d>());
    write_state();
  }

  bool flip() override {
    if constexpr (HasBranches<E>) {
      read_state();
      const ph::joint_vector<M> other = E::flipped(model_, c_.top.q);
      if (!other.allFinite()) return false;
      c_.top.q = other;
      write_state();
      return true;
    }
    return false;
  }

  void evaluate() override {
    read_state();
    values_.evaluate(c_, model_, walls_);
  }
  value_table& values() override { return values_.table(); }

  drawing& draw() override {
    read_state();
    drawing_.clear();
    E::draw(model_, c_.top.q, drawing_);
    return drawing_;
  }

  double* bounds() override {
    const double r = E::reach(model_);
    bounds_ = {-r, -r, d == 2 ? 0 : -r, r, r, d == 2 ? 0 : r};
    return bounds_.data();
  }

  const std::vector<double>& outline(int region) override {
    read_state();
    points_.clear();
    if (region < -1 || region >= (1 << m)) refuse("region", std::to_string(region), "-1, or a region from 0");
    const auto set = torques_in(region);
    if constexpr (n == d) {
      const ph::brake_matrix<M> G = ph::force_generators(model_, c_.top.q);
      if (G.allFinite()) points_ = outline_of<m>(G, set);
    } else if (region == -1) {
      const ph::jacobian_matrix<M> J(ph::jacobian(model_, c_.top.q));
      points_ = displayable_outline<M>(model_, c_.top.q, ph::task_vector<M>(J * c_.top.qd),
                                       ph::hybrid_brakes<M>(c_.switchable()));
    }
    return points_;
  }

  std::vector<double> locus(int brake, double length) override {
    std::vector<double> points;
    if (brake < 0 || brake >= m) refuse("brake", std::to_string(brake), "one of the device, from 0");
    if constexpr (n == 2 && d == 2) {
      constexpr int steps = 32;  // to each side
      read_state();
      for (int k = -steps; k <= steps; ++k) {
        ph::joint_vector<M> q = c_.top.q;
        for (int i = 0; i < std::abs(k); ++i) {  // by the midpoint rule
          const double way = std::copysign(length / steps, k);
          q += way * held_rates(brake, ph::joint_vector<M>(q + way / 2 * held_rates(brake, q)));
        }
        const ph::task_vector<M> x = model_.position(q);
        if (x.allFinite()) add_force<2>(points, x);
      }
    }
    return points;
  }

  std::vector<double> walls(const ph::vector<double, 2>& low, const ph::vector<double, 2>& high) override {
    return surface_of<d>(c_.top.scene, low, high);
  }

  std::unique_ptr<simulation> simulate() const override {
    C now = c_;
    read_state(now);
    return std::make_unique<simulation_of<E>>(now);
  }
  std::unique_ptr<replayed_log> replay(const std::string& log) const override {
    return std::make_unique<replay_of<E>>(c_, log);
  }
  std::unique_ptr<figure_map> map(int columns, int rows, const ph::vector<double, 2>& low,
                                  const ph::vector<double, 2>& high) const override {
    C now = c_;
    read_state(now);
    return std::make_unique<map_of<E>>(now, columns, rows, low, high);
  }

 private:
  // Joint rates at which a brake is at rest and the handle moves with 1 m/s.
  ph::joint_vector<M> held_rates(int brake, const ph::joint_vector<M>& q) const {
    const auto rate = [&](int j) { return ph::brake_rates(model_, q, ph::joint_vector<M>::Unit(j))[brake]; };
    const ph::joint_vector<M> qd(-rate(1), rate(0));
    const ph::jacobian_matrix<M> J(ph::jacobian(model_, q));
    return qd / (J * qd).norm();
  }

  // The torques of a region: of the present signs, or of all that it names.
  torque_set<m> torques_in(int region) const {
    torque_set<m> set{ph::brake_vector<M>::Zero(), ph::brake_vector<M>::Zero()};
    const ph::brake_vector<M> w = ph::brake_rates(model_, c_.top.q, c_.top.qd);
    const ph::brake_matrix<M> E_of_q(ph::brake_jacobian(model_, c_.top.q));
    const ph::brake_vector<M> s =
        ph::brake_signs(w, ph::brake_vector<M>(ph::brake_torque(E_of_q, c_.top.Fh)), c_.brakes);
    const auto regions = ph::passive_fme_regions<m>();
    for (int i = 0; i < m; ++i) {
      if (!c_.is_present(i)) continue;
      const double size = c_.brakes.torque_limit[i];
      const double sign = region >= 0 ? regions[std::size_t(region)][std::size_t(i)] : -s[i];
      if (sign >= 0) set.upper[i] = size;
      if (sign <= 0) set.lower[i] = -size;
    }
    return set;
  }

  void write_state() {
    state_.fill(0);
    for (int i = 0; i < n; ++i)
      state_[std::size_t(i)] = c_.top.q[i], state_[std::size_t(n + i)] = c_.top.qd[i];
    for (int i = 0; i < d; ++i)
      state_[std::size_t(2 * n + i)] = c_.top.Fh[i], state_[std::size_t(2 * n + 3 + i)] = c_.top.Fd[i];
  }
  void read_state(C& c) const {
    for (int i = 0; i < n; ++i) c.top.q[i] = state_[std::size_t(i)], c.top.qd[i] = state_[std::size_t(n + i)];
    for (int i = 0; i < d; ++i)
      c.top.Fh[i] = state_[std::size_t(2 * n + i)], c.top.Fd[i] = state_[std::size_t(2 * n + 3 + i)];
  }
  void read_state() { read_state(c_); }

  C c_ = {};
  M model_;
  explorer_scene<d> walls_;
  std::array<double, std::size_t(2 * n + 6)> state_{};
  pose_values<E> values_;
  drawing drawing_;
  std::array<double, 6> bounds_{};
  std::vector<double> points_;
};

/// The entry of E in the list of mechanisms.
template <class E>
mechanism_entry entry_of() {
  using M = typename E::mechanism;
  return {E::id,
          E::label,
          M::dof,
          M::task_dimension,
          M::brake_count,
          HasBranches<E>,
          []() -> std::unique_ptr<device> { return std::make_unique<device_of<E>>(); }};
}

}  // namespace explorer
