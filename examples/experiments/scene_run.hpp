// A hand at a specimen in a scene, in closed loop under every law: cells of the scene tables.
#pragma once

#include "control_of.hpp"
#include "plants.hpp"
#include "scene_kinds.hpp"

#include <passive_haptics/plant/wall_following.hpp>
#include <passive_haptics/runtime/any_controller.hpp>

#include <algorithm>
#include <optional>

namespace experiments {

inline constexpr std::uint64_t scene_seed = 3000;  // of the hands

// A device and the place of specimens.
template <class M>
struct scene_device {
  std::string name;
  M mechanism;
  place<M::task_dimension> where;
  ph::joint_vector<M> home;  // near it
  ph::brakes_of<M> brakes = {};
};

// Hand number k: 2 N, 5 cm/s.
inline ph::following_hand_parameters<double> random_hand(std::size_t k) {
  auto between = evenly(scene_seed, k);
  ph::following_hand_parameters<double> hand;
  hand.mass = between(0.3, 0.8);
  hand.damping = between(12, 30);
  hand.normal_damping = between(12, 30);
  hand.stiffness = between(100, 300);
  return hand;
}

// Commands of the brakes for the state of the device.
template <class M>
using loop_control = std::function<ph::brake_command<M>(const ph::device_state<M>&)>;

// One law, with or without a force sensor: a column of the tables.
template <class M>
struct law_column : scene_law {
  std::function<loop_control<M>(const M&, const ph::brakes_of<M>&, const scene_kind&,
                                const placed_specimen<M::task_dimension>&, const place<M::task_dimension>&,
                                double)>
      control;
};

// A law as from a device file: a `lead` is the lag of the slowest brake.
template <class Law>
Law with_lead(Law law, const auto& brakes) {
  if constexpr (requires { law.parameters.lead; }) law.parameters.lead = brakes.time_constant.maxCoeff();
  return law;
}

template <class M, class Law>
law_column<M> column(const std::string& name, bool has_sensor, const Law& law) {
  constexpr bool takes_one_wall = ph::saturates_before_scaling<Law>;
  const auto control = [=](const M& mechanism, const ph::brakes_of<M>& brakes,
                           const auto&... scene) -> loop_control<M> {
    const ph::runtime::scene_for<Law, M::task_dimension> walls(scene_of(scene...));
    const auto made = [](auto controller, auto state_of) {
      return [=](const ph::device_state<M>& state) mutable {
        const auto result = controller(state_of(state));
        return ph::brake_command<M>{result.capacity, result.outcome};
      };
    };
    const auto whole = [](const auto& state) { return state; };
    const auto blind = [](const auto& s) { return ph::sensorless_device_state<M>{s.time, s.q, s.qd}; };
    if (has_sensor) return made(with_sensor{law}(mechanism, brakes, walls), whole);
    if constexpr (ph::needs_hand_force<Law>)
      return made(without_sensor{law}(mechanism, brakes, walls), blind);
    else return made(with_sensor{law}(mechanism, brakes, walls), blind);
  };
  return {{name, has_sensor, takes_one_wall ? 1 : 1000}, control};
}

// The walls at their present place.
template <int D>
struct carried_shape {
  static constexpr int dimension = D;
  const placed_specimen<D>& of;
  const ph::point<D>& displacement;
  double distance(const ph::point<D>& x) const { return of.felt->distance(x - displacement); }
  ph::point<D> gradient(const ph::point<D>& x) const { return of.meant->gradient(x - displacement); }
};

// Joint positions for the handle at x.
template <class M>
ph::joint_vector<M> joints_at(const scene_device<M>& device, const ph::task_vector<M>& x) {
  ph::joint_vector<M> q = device.home;
  for (int i = 0; i < 50; ++i)
    q -= ph::jacobian_matrix<M>(ph::jacobian(device.mechanism, q))
             .partialPivLu()
             .solve(ph::task_vector<M>(device.mechanism.position(q) - x));
  if (!((device.mechanism.position(q) - x).norm() < 1e-9))
    throw std::logic_error(device.name + ": out of reach");
  return q;
}

// Hand number k at a specimen: glides 50 mm along it, then pulls out with 2 N.
template <class M>
scene_figures follow_scene(const scene_device<M>& device, const any_specimen<M::task_dimension>& specimen,
                           const scene_kind& kind, const law_column<M>& law, std::size_t k) {
  constexpr int D = M::task_dimension;
  using V = ph::point<D>;
  constexpr double length = 0.05, gap = 4e-3, approach = 0.1, middle = 0.6,
                   time_step = D == 2 ? 2.5e-4 : 5e-4;  // [m], [m], [m/s], [s], [s]
  ph::following_hand_parameters<double> p = random_hand(k);
  place<D> where = device.where;
  auto between = evenly(scene_seed + 1, k);
  if constexpr (D == 3)
    where.along = Eigen::AngleAxisd(between(0, 2 * std::numbers::pi), where.normal) * where.along;
  where.at += between(-5e-3, 5e-3) * where.along;
  const placed_specimen<D> placed = specimen.at(where);
  const V velocity = kind.speed * where.normal;
  V displacement = -middle * velocity, x = where.at - length / 2 * where.along;
  for (int i = 0; i < 50; ++i) x += (gap - placed.meant->distance(x)) * placed.meant->gradient(x);
  const V n = placed.meant->gradient(x), along = (where.along - n * n.dot(where.along)).normalized();
  x += displacement;
  const ph::joint_vector<M> q = joints_at(device, x);
  ph::simulated_device<M> plant(device.mechanism, device.brakes, p.mass, q);
  plant.set_motion(q, ph::jacobian_matrix<M>(ph::jacobian(device.mechanism, q))
                          .partialPivLu()
                          .solve(ph::task_vector<M>(p.speed * along - approach * n)));
  scene_figures figures{.hands = 1};
  double start = 0, now = 0;
  bool is_released = false;  // out of reach
  const auto controller = law.control(device.mechanism, device.brakes, kind, placed, where, middle);
  const auto control = [&](ph::device_state<M> state) {
    now = state.time += start;
    displacement = (now - middle) * velocity;
    const auto command = controller(state);
    is_released = is_released || command.outcome != ph::status::ok;
    return command;
  };
  const carried_shape<D> shape{placed, displacement};
  const ph::following_hand<double, D> hand(where.along, x, p);
  ph::wall_following_parameters run{.time_step = time_step, .max_duration = 2.5, .max_depth = 0.02};
  run.path_end = hand.progress(x) + length;
  const ph::contact_metrics glide = ph::follow_wall(plant, control, shape, hand, run);
  figures.separations = glide.separations;
  figures.max_depth = glide.max_depth;
  figures.deviation = glide.depth_std;
  figures.drag = glide.retarding_force;
  figures.arrived = glide.arrived;
  figures.through = glide.end == ph::run_end::too_deep || !glide.touched || is_released;
  const double depth = -shape.distance(plant.position());
  if (figures.through > 0 || !(depth > 0)) return figures;

  start = now + 1e-3;
  const V out = shape.gradient(plant.position());
  p = {.speed = 0, .stiffness = 0, .damping = 0, .push = -p.push, .mass = p.mass};
  const ph::following_hand<double, D> puller(out, plant.position(), p);
  run.path_end = puller.progress(plant.position()) + depth;
  run.max_duration = 1;
  const ph::contact_metrics leaving = ph::follow_wall(plant, control, shape, puller, run);
  figures.leave = leaving.duration;
  figures.not_left = !leaving.arrived;
  return figures;
}

// The device with these laws.
template <class M>
scene_bench bench_of(const scene_device<M>& device, const std::vector<law_column<M>>& laws) {
  const auto listed = all_specimens<M::task_dimension>();
  scene_bench bench{device.name, {listed.begin(), listed.end()}, {laws.begin(), laws.end()}, {}};
  bench.run = [=](const scene_kind& kind, std::size_t i, std::size_t j, std::uint64_t hands) {
    scene_figures worst;
    for (std::uint64_t k = 0; k < hands; ++k) worst.add(follow_scene(device, listed[i], kind, laws[j], k));
    return worst;
  };
  return bench;
}

inline scene_device<ph::tendon_two_link<double>> planar_scene_device() {
  const ph::tendon_two_link<double> arm;
  return {
      "tendon_two_link", arm, {{0.105, 0.222}, {0, -1}, {1, 0}}, arm.inverse({0.1, 0.2}, ph::elbow::left).q};
}

}  // namespace experiments
