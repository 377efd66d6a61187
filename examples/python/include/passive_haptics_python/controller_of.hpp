/// @file
/// The controller of one mechanism, one law and one kind of scene.
#pragma once

#include <passive_haptics_python/any_controller.hpp>
#include <passive_haptics_python/any_device.hpp>
#include <passive_haptics_python/effects.hpp>
#include <passive_haptics_python/laws.hpp>
#include <passive_haptics_python/scenes.hpp>

#include <passive_haptics/brake/models/switchable_brakes.hpp>
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <type_traits>

namespace passive_haptics_python {

/// Batches of a batch_controller.
template <class B>
class batch_of final : public any_batch {
 public:
  /// Of these arguments of a batch_controller.
  template <class... Arguments>
  explicit batch_of(Arguments&&... arguments) : batch_(std::forward<Arguments>(arguments)...) {}
  /// Stores the results of these states.
  void run(const batch_columns& columns) const override {
    using M = typename B::mechanism_type;
    batch_(states_of<M>(columns), results_of<M>(columns));
  }

 private:
  B batch_;
};

/// True if batches of mechanism M under law L at a plane wall are compiled for that wall: half the time for
/// twice the compiler's. Specialise it where that pays.
template <class M, class L>
inline constexpr bool is_compiled_for_planes = false;

/// Batches that are compiled for their wall, a half_space; nullptr for all others. A function of its own, so
/// that a source can instantiate it with other flags than the rest.
template <class M, class L>
std::unique_ptr<any_batch> batch_at_wall([[maybe_unused]] const M& mechanism,
                                         [[maybe_unused]] const ph::brakes_of<M>& brakes,
                                         [[maybe_unused]] const ph::wall<any_shape<M::task_dimension>>& w,
                                         [[maybe_unused]] const L& law,
                                         [[maybe_unused]] const ph::step_options<double>& options) {
  if constexpr (is_compiled_for_planes<M, L>) {
    using plane = ph::half_space<M::task_dimension>;
    if (const plane* found = w.shape.template as<plane>())
      return std::make_unique<batch_of<ph::batch_controller<M, ph::static_scene<plane>, L>>>(
          mechanism, brakes, ph::scene(ph::wall(*found, w.stiffness())), law, options);
  }
  return nullptr;
}

/// The brakes that a controller of M takes: with bounds, unless M has self-motion. There the cycles of all
/// would take a sixth (three joints) to a quarter (seven) longer.
template <class M>
using controller_brakes =
    std::conditional_t<(M::dof > M::task_dimension), ph::brakes_of<M>, ph::switchable_brakes<M>>;

/// Of these numbers; a TypeError where they have bounds and M has self-motion.
template <class M>
controller_brakes<M> controller_brakes_from(const brake_numbers& b) {
  if constexpr (M::dof == M::task_dimension) return switchable_from<M>(b);
  else {
    if (!b.has_no_bounds())
      refuse_type(
          "brakes have a torque_lower or torque_upper, expected none: a controller of a mechanism with "
          "more joints than task dimensions takes such brakes in C++ alone");
    return brakes_from<M>(b);
  }
}

/// Cycles of a scene S, one by one or each the first of a motion.
template <class M, class L, class S>
class controller_of final : public any_controller {
  using controller_type = ph::controller<M, S, L, controller_brakes<M>>;

 public:
  /// at_wall: batches of this set-up that are compiled for its wall, or nullptr.
  controller_of(const M& mechanism, const controller_brakes<M>& brakes, const S& scene, const L& law,
                const ph::step_options<double>& options, std::unique_ptr<any_batch> at_wall)
      : control_(mechanism, brakes, scene, law, options), at_wall_(std::move(at_wall)) {}

  /// One control cycle.
  result_values step(const state_values& state) override {
    ph::device_state<M> s;
    s.time = state.time;
    s.q = sized<M::dof>(state.q, "q", "joints");
    s.qd = sized<M::dof>(state.qd, "qd", "joints");
    if (state.hand_force)
      s.hand_force = sized<M::task_dimension>(*state.hand_force, "hand_force", "task dimensions");
    else if (ph::needs_hand_force<L>)
      refuse_value(
          "hand_force = None, expected a force [N]: the law needs one; or take a law that needs none");
    return values_of(control_(s));
  }

  /// Stores the results of these states.
  void run(const batch_columns& columns) const override {
    if (at_wall_) return at_wall_->run(columns);
    const auto states = states_of<M>(columns);
    const auto results = results_of<M>(columns);
    if constexpr (ph::needs_hand_force<L>) ph::require_no_error(ph::check_hand_force(states));
    controller_type control = control_;
    for (std::size_t k = 0; k < columns.count; ++k) {
      reset(control);
      ph::detail::store(results, k, control(states[k]));
    }
  }

  /// Forgets the motion so far, and the scene the handle.
  void reset() override { reset(control_); }

  /// Other brakes from the next cycle on; batches are those of the scene, not of the wall, from here on.
  void set_brakes(const brake_numbers& brakes) override {
    control_.set_brakes(controller_brakes_from<M>(brakes));
    at_wall_ = nullptr;
  }

 private:
  static void reset(controller_type& control) {
    control.reset();
    if constexpr (requires(S& scene) { scene.reset(); }) control.scene().reset();
  }

  controller_type control_;
  std::unique_ptr<any_batch> at_wall_;
};

/// The controller of a scene with effects; a ValueError if an effect does not fit, or the mechanism and the
/// law take none.
template <class M, class L>
std::unique_ptr<any_controller> controller_with_effects(
    [[maybe_unused]] const M& mechanism, [[maybe_unused]] const controller_brakes<M>& brakes,
    [[maybe_unused]] const scene& walls, [[maybe_unused]] const py::tuple& effects,
    [[maybe_unused]] const L& law, [[maybe_unused]] const ph::step_options<double>& options) {
  if constexpr (takes_effects<M, L>) {
    constexpr int D = M::task_dimension;
    using S = scene_with_effects<D, D>;
    S of(walls.made(std::type_identity<any_scene<D>>()));
    add_effects(of, effects);
    return std::make_unique<controller_of<M, L, S>>(mechanism, brakes, of, law, options, nullptr);
  } else {
    refuse_value(
        "scene has effects, expected none: they need direct_control and a mechanism with as many "
        "joints and brakes as task dimensions, such as two_link or delta");
  }
}

/// The controller of a mechanism, one of its laws and a scene; a ValueError if the scene is of another
/// dimension, or of several walls where the law takes one. at_wall: batches that are compiled for its wall,
/// or nullptr.
template <class M, class L>
std::unique_ptr<any_controller> make_controller(const M& mechanism, const controller_brakes<M>& brakes,
                                                const scene& walls, const L& law,
                                                const ph::step_options<double>& options,
                                                std::unique_ptr<any_batch> at_wall) {
  constexpr int D = M::task_dimension;
  if (walls.dimension() != D)
    refuse_value("scene has dimension " + std::to_string(walls.dimension()) + ", expected " +
                 std::to_string(D) + ", the task dimension of the mechanism");
  if (const py::tuple effects = walls.effects(); !effects.empty())
    return controller_with_effects<M, L>(mechanism, brakes, walls, effects, law, options);
  using S = any_scene<D, ph::saturates_before_scaling<L> ? 1 : D + 1>;
  return std::make_unique<controller_of<M, L, S>>(mechanism, brakes, walls.made(std::type_identity<S>()), law,
                                                  options, std::move(at_wall));
}

}  // namespace passive_haptics_python
