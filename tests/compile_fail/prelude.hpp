// A device, a scene and an effect that are right in themselves: the tables put one mistake next to them.
#pragma once

#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

template <int Joints, int Brakes = Joints>
struct slides {
  using scalar = double;
  static constexpr int dof = Joints, task_dimension = 2, brake_count = Brakes;
  template <class S>
  ph::vector<S, 2> position(const ph::vector<S, Joints>& q) const {
    return q.template head<2>();
  }
};
using device = slides<2>;
using table = ph::xy_table<double>;
using V2 = ph::vector<double, 2>;

const ph::half_space<2> plane({0, 1}, {0, -1});
const auto room = ph::scene(ph::wall(plane));
const ph::viscous_field<double, 2> honey({.viscosity = ph::matrix<double, 2, 2>::Identity()});

// One cycle.
template <class M, class B, class Scene, class Law, class State = ph::device_state<M>>
void run(const M& mechanism, const B& brakes, const Scene& scene, const Law& law, const State& state = {}) {
  ph::controller control(mechanism, brakes, scene, law);
  control(state);
}
