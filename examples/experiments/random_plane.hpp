// Runs along the planes of plant/random_device.hpp.
#pragma once

#include "control_of.hpp"

#include <passive_haptics/plant/random_device.hpp>
#include <passive_haptics/plant/wall_following.hpp>

namespace experiments {

// The tendon device with this multiple of its nominal inertia.
inline ph::tendon_two_link<double> tendon_of(double inertia) {
  ph::tendon_two_link_parameters<double> p;
  for (double* mass : {&p.mass_1, &p.mass_2, &p.handle_mass, &p.rotor_inertia_1, &p.rotor_inertia_2})
    *mass *= inertia;
  return ph::tendon_two_link<double>(p);
}

template <class M>
auto velocity_control(const M& believed, const ph::brakes_of<M>& brakes, const ph::random_device<M>& d,
                      const ph::velocity_direct_control_parameters& constants = {}) {
  const ph::half_space<M::task_dimension> wall(d.plane.surface, d.plane.normal);
  return ph::controller(believed, brakes,
                        ph::held_scene(ph::scene(ph::wall(wall, d.wall_stiffness)), 1 / d.environment_rate),
                        ph::velocity_direct_control(constants));
}

template <class M, class Brakes>
ph::contact_metrics follow_plane(const M& real, const Brakes& brakes, const ph::random_device<M>& d,
                                 const any_control<M>& control) {
  constexpr int D = M::task_dimension;
  ph::simulated_device plant(real, brakes, d.hand.mass, d.plane.q);
  plant.set_motion(d.plane.q, d.plane.qd);
  return ph::follow_wall(plant, control, ph::half_space<D>(d.plane.surface, d.plane.normal),
                         ph::following_hand<double, D>(d.plane.direction, d.plane.start, d.hand), d.run);
}

// True if the residual torque of released brakes keeps the hand off the wall.
template <class M, class Brakes>
bool is_held(const M& real, const Brakes& brakes, const ph::random_device<M>& d) {
  const auto released = follow_plane<M>(real, brakes, d, [](const auto&) { return ph::step_result<M>(); });
  return released.never_touches() || released.separates() || released.depth_mean < 0;
}

}  // namespace experiments
