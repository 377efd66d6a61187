// A hand that pushes against an effect, with or without a wall, and then returns.
#pragma once

#include "any_effects.hpp"
#include "scene_run.hpp"

namespace experiments {

// A type-erased effect or wall effect.
template <class E>
struct one_effect final : any_effect<E::dimension> {
  using base = any_effect<E::dimension>;
  using typename base::contacts;
  using typename base::vector;
  explicit one_effect(E e) : effect(std::move(e)) {}
  vector force(const vector& x, const vector& v, const vector& hand, const contacts& touched) const override {
    if constexpr (ph::Effect<E>) return effect.force(x, v, hand);
    else return effect.force_at(touched, v, hand);
  }
  E effect;
};
template <int N>
struct one_joint_effect final : any_joint_effect<N> {
  using typename any_joint_effect<N>::vector;
  explicit one_joint_effect(ph::end_stops<double, N> e) : effect(std::move(e)) {}
  vector torque(const vector& q, const vector& qd, const vector& hand) const override {
    return effect.torque(q, qd, hand);
  }
  ph::end_stops<double, N> effect;
};

// Adds the effects' part to the result, for a sensorless_controller.
template <int D, int N>
struct scene_of_effects : scene_with_effects<D, N> {
  using base = scene_with_effects<D, N>;
  using base::base;
  using contacts_type = std::remove_cvref_t<decltype(std::declval<base&>().touched_at(
      std::declval<const ph::point<D>&>(), 0.0))>;
};

// The list of effects: each holds a hand that pushes along p.along from p.at, or slows it; q: at p.at.
template <class M>
struct effect_row {
  static constexpr int D = M::task_dimension;
  using scene = scene_of_effects<D, M::dof>;
  scene_effect row;
  std::function<void(scene&, const place<D>& p, const ph::joint_vector<M>& q)> add;
};
template <class M>
std::vector<effect_row<M>> all_effects() {
  constexpr int D = M::task_dimension;
  using scene = typename effect_row<M>::scene;
  std::vector<effect_row<M>> all{{{"none", false}, [](scene&, const auto&, const auto&) {}}};
  const auto add = [&](const char* name, bool holds, auto make) {
    all.push_back({{name, holds}, [=](scene& s, const place<D>& p, const auto&) {
                     s.on_handle().add(std::make_shared<one_effect<decltype(make(p))>>(make(p)));
                   }});
  };
  add("viscous_field", false,
      [](const auto&) { return ph::viscous_field<double, D>({20 * ph::matrix<double, D, D>::Identity()}); });
  add("detents", true, [](const auto& p) {
    return ph::detents<double, D>({.origin = p.at, .direction = p.along, .spacing = 0.02, .strength = 6});
  });
  add("guide along a plane", true, [](const auto& p) {
    return ph::guide<double, D>(
        {.along = ph::guide_along::plane, .point = p.at, .direction = p.along, .stiffness = 2000});
  });
  add("guide along a line", true, [](const auto& p) {
    return ph::guide<double, D>({.point = p.at, .direction = p.normal, .stiffness = 2000});
  });
  add("rough_walls", false, [](const auto&) { return ph::rough_walls<double, D>({.coefficient = 0.3}); });
  all.push_back({{"end_stops", true}, [](scene& s, const auto&, const ph::joint_vector<M>& q) {
                   using V = ph::joint_vector<M>;
                   const ph::end_stops<double, M::dof> stops({.lower = q - V::Constant(0.01),
                                                              .upper = q + V::Constant(0.01),
                                                              .stiffness = V::Constant(50)});
                   s.on_joints().add(std::make_shared<one_joint_effect<M::dof>>(stops));
                 }});
  return all;
}

// Hand number k pushes with 2 N for a second, at a wall also with 2 N into it, and then returns, at a wall
// also outwards.
template <class M, class Sensor>
effect_figures follow_effect(const scene_device<M>& device, const effect_row<M>& effect,
                             const Sensor& control_of, bool has_wall, std::size_t k) {
  constexpr int D = M::task_dimension;
  place<D> where = device.where;
  auto between = evenly(scene_seed + 2, k);
  if constexpr (D == 3)
    where.along = Eigen::AngleAxisd(between(0, 2 * std::numbers::pi), where.normal) * where.along;
  where.at += between(-5e-3, 5e-3) * where.along;
  const ph::joint_vector<M> q = joints_at(device, where.at);
  const auto wall = has_wall ? where.plane(0) : where.plane(-100);
  typename effect_row<M>::scene scene(
      scene_of<D, D + 1>(scene_kinds[0], {{any_shape<D>(wall)}, {}, {}, {}}, where, 0));
  effect.add(scene, where, q);
  auto controller = control_of(device.mechanism, device.brakes, scene);
  double now = 0, start = 0;
  const auto control = [&](ph::device_state<M> state) {
    now = state.time += start;
    const auto result = [&] {
      if constexpr (requires { controller.hand(); })
        return controller(ph::sensorless_device_state<M>{state.time, state.q, state.qd});
      else return controller(state);
    }();
    return ph::brake_command<M>{result.capacity, result.outcome};
  };
  ph::following_hand_parameters<double> p = random_hand(k);
  p = {.speed = 0.1, .stiffness = 0, .damping = 20, .push = has_wall ? 2.0 : 0.0, .mass = p.mass};
  ph::simulated_device<M> plant(device.mechanism, device.brakes, p.mass, q);
  const auto go = [&](const ph::point<D>& way, double length, double longest) {
    const ph::following_hand<double, D> hand(way, plant.position(), p);
    const double from = hand.progress(plant.position());
    const auto figures =
        ph::follow_wall(plant, control, where.plane(0), hand,
                        {.time_step = 2.5e-4, .path_end = from + length, .max_duration = longest});
    start = now + 1e-3;
    return std::pair(figures, hand.progress(plant.position()) - from);
  };
  effect_figures figures{.hands = 1};
  const auto first = go(where.along, 0.02, 0.5), second = go(where.along, 0.02, 0.5);
  figures.moved = first.second + second.second;
  figures.creep = second.second / 0.5;
  figures.max_depth = std::max(first.first.max_depth, second.first.max_depth);
  const double turned = now;
  p.push = -p.push;
  const auto back = go(-where.along, 0.5e-3, 2);
  figures.leave = now - turned;
  figures.not_left = !back.first.arrived;
  return figures;
}

}  // namespace experiments
