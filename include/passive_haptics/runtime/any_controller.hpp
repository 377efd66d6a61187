/// @file
/// A controller whose mechanism, scene and law are known at run time only.
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

#include <memory>
#include <optional>
#include <utility>
#include <variant>

namespace passive_haptics::runtime {

/// One control cycle after the other, of any device.
class any_controller {
 public:
  virtual ~any_controller() = default;
  /// Of the device.
  virtual device_sizes sizes() const noexcept = 0;
  /// True if the law needs a force sensor.
  virtual bool needs_hand_force() const noexcept = 0;
  /// One cycle; neither throws nor allocates. Numbers that are not as many as sizes() says, or no hand force
  /// where the law needs one: status::state_not_finite, all brakes released.
  virtual cycle_record operator()(const state_view& state) noexcept = 0;
  /// Forgets the motion so far, and the scene the handle.
  virtual void reset() = 0;
  /// Other brakes from the next cycle on, as many as sizes() says; see controller::set_brakes.
  virtual void set_brakes(const brake_numbers& brakes) = 0;
  /// A copy with memories of its own.
  virtual std::unique_ptr<any_controller> copy() const = 0;
};

/// A scene in the plane or in space, perhaps with effects.
using scene_variant = std::variant<std::monostate, any_scene<2>, any_scene<3>, any_scene_with_effects<2>,
                                   any_scene_with_effects<3>>;

/// Parts of a controller, except its mechanism and the type of its law.
struct controller_parts {
  brake_numbers brakes;               ///< As many as the mechanism has.
  scene_variant scene;                ///< Of its dimension.
  any_parameters law;                 ///< The law's.
  step_options<double> options = {};  ///< As of any controller.
};

/// The struct with the table of law L: the law itself, its member, or none.
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

/// The law of these parameters.
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

/// The scene of a controller under law L: all contacts, or the strongest for a law that takes one.
template <class L, int D>
using scene_for = std::conditional_t<saturates_before_scaling<L>, strongest_contact_of<D>, any_scene<D>>;

/// The brakes of a controller: with bounds, unless M has self-motion. There the cycles of all would take a
/// sixth (three joints) to a quarter (seven) longer.
template <class M>
using controller_brakes = std::conditional_t<Settles<M>, brakes_of<M>, switchable_brakes<M>>;

/// True if law L displays effects: only direct_control.
template <class L>
inline constexpr bool displays_effects =
    ScalingLaw<L> && nulls_normal_force<L> && !saturates_before_scaling<L>;

/// True if controllers of M under law L take effects: those of a law that displays them, with n = m = d.
template <class M, class L>
inline constexpr bool takes_effects =
    displays_effects<L> && M::dof == M::task_dimension && M::brake_count == M::task_dimension;

/// Controller of M under law L, compiled once for each kind of mechanism.
template <class M, class L, class S = scene_for<L, M::task_dimension>>
class controller_of final : public any_controller {
  static constexpr int n = M::dof, d = M::task_dimension, m = M::brake_count;

 public:
  /// Throws std::invalid_argument where a controller does, or if brakes have bounds and M has self-motion.
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

  void reset() override {
    control_.reset();
    control_.scene().reset();
  }
  void set_brakes(const brake_numbers& brakes) override { control_.set_brakes(brakes_from(brakes)); }
  std::unique_ptr<any_controller> copy() const override { return std::make_unique<controller_of>(*this); }

 private:
  static controller_brakes<M> brakes_from(const brake_numbers& brakes) {
    require_count("brakes", std::ssize(brakes.torque_limit), m);
    if (Settles<M> && !brakes.has_no_bounds())
      throw std::invalid_argument(
          "passive_haptics: brakes have a torque_lower or torque_upper, expected none: a controller of a "
          "mechanism with more joints than task dimensions takes such brakes in C++ alone");
    return brakes.as<controller_brakes<M>>();
  }
  controller<M, S, L, controller_brakes<M>> control_;
};

/// The controller of a mechanism under law L. Throws std::invalid_argument where controller_of does, if the
/// scene is of another dimension, or if it has effects and takes_effects<M, L> is false.
template <class L, class M>
std::unique_ptr<any_controller> make_controller(const M& mechanism, const controller_parts& parts) {
  constexpr int d = M::task_dimension;
  if (const auto* walls = std::get_if<any_scene<d>>(&parts.scene))
    return std::make_unique<controller_of<M, L>>(mechanism, scene_for<L, d>(*walls), parts);
  if (const auto* beside = std::get_if<any_scene_with_effects<d>>(&parts.scene)) {
    if constexpr (takes_effects<M, L>)
      return std::make_unique<controller_of<M, L, any_scene_with_effects<d>>>(mechanism, *beside, parts);
    throw std::invalid_argument(
        "passive_haptics: scene with effects, expected one without: they need direct_control, and "
        "a mechanism with as many joints and brakes as task dimensions");
  }
  throw std::invalid_argument("passive_haptics: scene, expected one of dimension " + std::to_string(d) +
                              ", the task dimension of the mechanism");
}

}  // namespace passive_haptics::runtime
