/// Controllers with a mechanism, scene and law chosen at run time.
#pragma once

#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/control/pipelines/torque_law.hpp>
#include <passive_haptics/runtime/any_effect.hpp>
#include <passive_haptics/runtime/any_parameters.hpp>
#include <passive_haptics/runtime/any_scene.hpp>
#include <passive_haptics/runtime/brake_numbers.hpp>
#include <passive_haptics/runtime/cycle_record.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

namespace passive_haptics::runtime {

/// States of a batch for any device: the first n or d arrays of a vector are used.
using any_batch_states = batch_states_of<double, max_joints, 3>;
/// Results of a batch for any device: the first m or d arrays of a vector are used.
using any_batch_results = batch_results_of<double, max_joints, 3>;

/// Control cycles of any device.
class any_controller {
 public:
  virtual ~any_controller() = default;
  /// Sizes of the device.
  virtual device_sizes sizes() const noexcept = 0;
  /// True if the law needs a force sensor.
  virtual bool needs_hand_force() const noexcept = 0;
  /// One cycle; neither throws nor allocates. Wrong counts of numbers, or a missing hand force that the law
  /// needs, give status::state_not_finite with all brakes released.
  virtual cycle_record operator()(const state_view& state) noexcept = 0;
  /// As controller::batch().
  virtual void batch(const any_batch_states& states, const any_batch_results& results) const = 0;
  /// Forgets the motion so far, and the scene's state of the handle.
  virtual void reset() = 0;
  /// Sets the brakes from the next cycle on, as many as in sizes(); see controller::set_brakes.
  virtual void set_brakes(const brake_numbers& brakes) = 0;
  /// A copy with its own memories.
  virtual std::unique_ptr<any_controller> copy() const = 0;
};

/// A planar or spatial scene, optionally with effects.
using scene_variant = std::variant<std::monostate, any_scene<2>, any_scene<3>, any_scene_with_effects<2>,
                                   any_scene_with_effects<3>>;

/// Parts of a controller other than its mechanism and law type.
struct controller_parts {
  brake_numbers brakes;               ///< As many as the mechanism has.
  scene_variant scene;                ///< Scene of its dimension.
  any_parameters law;                 ///< Parameters of the law.
  step_options<double> options = {};  ///< Options of a cycle.
};

/// The parameter struct of law L: the law itself, its member, or none.
template <class L>
auto table_of_law() {
  if constexpr (Parameters<L>) return L();
  else if constexpr (requires(const L l) { l.parameters(); }) return L().parameters();
  else if constexpr (requires(const L l) { l.parameters; }) return L().parameters;
  else return no_parameters();
}

/// The parameters of law L.
template <class L>
using law_parameters = decltype(table_of_law<L>());

/// The law with these parameters.
template <class L>
L made_law(const law_parameters<L>& p) {
  if constexpr (Parameters<L>) return p;
  else if constexpr (std::is_same_v<law_parameters<L>, no_parameters>) return L();
  else if constexpr (std::is_constructible_v<L, const law_parameters<L>&>) return L(p);
  else {
    L made;
    made.parameters = p;
    return made;
  }
}

/// The scene of a controller under law L: all contacts, or the strongest one for laws with one contact.
template <class L, int D>
using scene_for = std::conditional_t<saturates_before_scaling<L>, strongest_contact_of<D>, any_scene<D>>;

/// The brakes of a controller; without bounds if M has self-motion, for which cycles would be slower.
template <class M>
using controller_brakes = std::conditional_t<Settles<M>, brakes_of<M>, switchable_brakes<M>>;

/// True if law L displays effects: only direct_control.
template <class L>
inline constexpr bool displays_effects =
    ScalingLaw<L> && nulls_normal_force<L> && !saturates_before_scaling<L>;

/// True if controllers of M under law L accept effects: displays_effects<L> and n = m = d.
template <class M, class L>
inline constexpr bool takes_effects =
    displays_effects<L> && M::dof == M::task_dimension && M::brake_count == M::task_dimension;

/// Controller of M under law L, compiled once per kind of mechanism.
template <class M, class L, class S = scene_for<L, M::task_dimension>>
class controller_of final : public any_controller {
  static constexpr int n = M::dof, d = M::task_dimension, m = M::brake_count;

 public:
  /// Throws std::invalid_argument as controller, or if brakes have bounds and M has self-motion.
  controller_of(const M& mechanism, S scene, const controller_parts& parts)
      : control_(mechanism, brakes_from(parts.brakes), std::move(scene),
                 made_law<L>(parts.law.as<law_parameters<L>>()), parts.options) {}

  device_sizes sizes() const noexcept override { return {n, d, m}; }
  bool needs_hand_force() const noexcept override { return passive_haptics::needs_hand_force<L>; }

  cycle_record operator()(const state_view& state) noexcept override {
    const bool has_force = state.hand_force.size() == d;
    if (state.q.size() != n || state.qd.size() != n || (!has_force && needs_hand_force()))
      return cycle_record(released<step_result<M>>(status::state_not_finite));
    device_state<M> s;
    s.time = state.time;
    s.q = joint_vector<M>(state.q.data());
    s.qd = joint_vector<M>(state.qd.data());
    if (has_force) s.hand_force = task_vector<M>(state.hand_force.data());
    return cycle_record(control_(s));
  }

  void batch(const any_batch_states& states, const any_batch_results& results) const override {
    batch_states<M> s;
    use_first(states.q, s.q);
    use_first(states.qd, s.qd);
    use_first(states.hand_force, s.hand_force);
    s.time = states.time;
    batch_results<M> r;
    use_first(results.capacity, r.capacity);
    r.outcome = results.outcome;
    for_each_optional([](const char*, const auto& from, auto& to) { use_first(from, to); }, results, r);
    control_.batch(s, r);
  }

  void reset() override {
    control_.reset();
    control_.scene().reset();
  }
  void set_brakes(const brake_numbers& brakes) override { control_.set_brakes(brakes_from(brakes)); }
  std::unique_ptr<any_controller> copy() const override { return std::make_unique<controller_of>(*this); }

 private:
  // The arrays of the components that the device has, or the array.
  static void use_first(const auto& from, auto& to) {
    if constexpr (requires { to.front(); }) std::copy_n(from.begin(), to.size(), to.begin());
    else to = from;
  }
  static controller_brakes<M> brakes_from(const brake_numbers& brakes) {
    require_count("brakes", std::ssize(brakes.torque_limit), m);
    if (Settles<M> && !brakes.has_no_bounds())
      throw std::invalid_argument(
          "passive_haptics: brakes have a torque_lower or torque_upper: expected none: a controller of a "
          "mechanism with more joints than task dimensions supports such brakes only in C++");
    return brakes.as<controller_brakes<M>>();
  }
  controller<M, S, L, controller_brakes<M>> control_;
};

/// Makes the controller of a mechanism under law L. Throws std::invalid_argument as controller_of, for a
/// scene of another dimension, or for effects if takes_effects<M, L> is false.
template <class L, class M>
std::unique_ptr<any_controller> make_controller(const M& mechanism, const controller_parts& parts) {
  constexpr int d = M::task_dimension;
  if (const auto* walls = std::get_if<any_scene<d>>(&parts.scene))
    return std::make_unique<controller_of<M, L>>(mechanism, scene_for<L, d>(*walls), parts);
  if (const auto* beside = std::get_if<any_scene_with_effects<d>>(&parts.scene)) {
    if constexpr (takes_effects<M, L>)
      return std::make_unique<controller_of<M, L, any_scene_with_effects<d>>>(mechanism, *beside, parts);
    throw std::invalid_argument(
        "passive_haptics: scene with effects: expected one without: they need direct_control, and "
        "a mechanism with as many joints and brakes as task dimensions");
  }
  throw std::invalid_argument("passive_haptics: dimension of the scene = " + std::to_string(d == 2 ? 3 : 2) +
                              ": expected " + std::to_string(d) + ", the task dimension of the mechanism");
}

}  // namespace passive_haptics::runtime
