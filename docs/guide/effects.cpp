#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

#include <cmath>
#include <iostream>

namespace ph = passive_haptics;
using device = ph::xy_table<double>;
using vector = ph::vector<double, 2>;

// Distance [m] that the handle of a simulated table moves in half a second under this push [N].
template <class Scene>
vector way(const char* name, const Scene& scene, const vector& push) {
  const device table;
  ph::brakes_of<device> brakes;
  brakes.torque_limit = {20, 20};          // [N]
  brakes.rate_dead_band = {0.002, 0.002};  // [m/s]
  ph::controller control(table, brakes, scene, ph::direct_control());
  ph::simulated_device<device> simulated(table, brakes, 0.5, {0, 0});
  for (int k = 0; k < 500; ++k) {
    const auto result = control(ph::device_state<device>{1e-3 * k, simulated.q(), simulated.qd(), push});
    for (int i = 0; i < 10; ++i) simulated.advance(1e-4, result.capacity, push);
  }
  std::cout << name << ": " << 1e3 * simulated.position().transpose() << " mm\n";
  return simulated.position();
}

int main() {
  const ph::viscous_field<double, 2> honey(
      {.viscosity = 20 * ph::matrix<double, 2, 2>::Identity()});  // [N s/m]
  const ph::detents<double, 2> knob({.direction = {1, 0}, .spacing = 0.02, .strength = 6});
  const ph::guide<double, 2> rail({.direction = {1, 0}, .stiffness = 2000});
  const ph::rough_walls<double, 2> rough({.coefficient = 0.5});
  const ph::end_stops<double, 2> stops({.upper = {0.03, 0.03}, .stiffness = {2000, 2000}});

  // In free space
  const ph::no_walls<2> nothing;
  const auto slowed = way("honey", ph::with_effects(nothing, honey), {2, 0});
  const auto held = way("detents", ph::with_effects(nothing, knob), {2, 0});
  const auto guided = way("guide", ph::with_effects(nothing, rail), {1, 3});
  const auto stopped = way("end stops", ph::with_effects(nothing, stops), {2, 0});

  // Next to a wall
  const auto floor = ph::scene(ph::wall(ph::half_space<2>({0, 1e-3}, {0, 1}), 1e4));
  const auto stuck = way("wall friction", ph::with_effects(floor, rough), {3, -8});
  const auto both = way("honey on a rough wall", ph::with_effects(floor, rough, honey), {6, -8});

  // The desired forces are in the result
  ph::controller control(device(), ph::brakes_of<device>(), ph::with_effects(floor, honey),
                         ph::direct_control());
  const auto result = control(ph::device_state<device>{0, {0, 1}, {0.04, 0}, {0, 0}});
  std::cout << "wall " << result.wall_number << ", desired " << result.effect_force.transpose() << " N, made "
            << result.torque.transpose() << " N\n";

  const bool holds = std::abs(held.x()) < 0.01 && guided.y() < 0.01 && guided.x() > 0.1 && stuck.x() < 3e-3;
  const bool slows = slowed.x() < 0.06 && both.x() < 0.06 && stopped.x() < 0.05;
  return holds && slows && result.wall_number == -1 && std::abs(result.torque.x() + 0.8) < 1e-9 ? 0 : 1;
}
