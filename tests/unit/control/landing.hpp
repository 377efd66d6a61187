// Random devices that touch a wall: how they land, for the tests of the wall calculator and of what it
// serves.
#pragma once

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/design/wall_limits.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/plant/random_device.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <algorithm>
#include <cmath>

namespace landings {

namespace ph = passive_haptics;
using tendon = ph::tendon_two_link<double>;
using V = ph::vector<double, 2>;
using device = ph::random_device<tendon>;

constexpr double rigid = 1e7, deep = 10e-3;  // [N/m], [m]
inline const ph::workspace<tendon> where{{-3.1, -2.5}, {3.1, -0.6}, 0.1};

inline tendon tendon_of(double inertia) {
  ph::tendon_two_link_parameters<double> p;
  auto& a = p.arm;
  for (double* mass : {&a.mass_1, &a.mass_2, &a.handle_mass, &a.rotor_inertia_1, &a.rotor_inertia_2})
    *mass *= inertia;
  return tendon(p);
}

// How the handle touched the wall, and how deep it got.
struct landing {
  bool touched = false;
  V q, velocity;                       // at the touch
  double first = ph::deepest_landing;  // depth where it first came to rest [m]
  double deepest = 0;                  // within 0.2 s of the touch [m]
  double drift = 0;                    // root mean square of its normal velocity from 0.3 s on [m/s]
};

template <class Law>
landing land(const device& d, const Law& law, double stiffness, double environment_period, double longest) {
  const tendon real = tendon_of(d.inertia);
  const V n = d.plane.normal;
  const ph::half_space<2> wall(d.plane.surface, n);
  ph::controller control(tendon_of(1), d.known_brakes,
                         ph::held_scene(ph::scene(ph::wall(wall, stiffness)), environment_period), law);
  ph::simulated_device<tendon> plant(real, d.brakes, d.hand.mass, d.plane.q);
  plant.set_motion(d.plane.q, d.plane.qd);
  landing l;
  double touch = 0;
  bool rests = false;
  int settled = 0;
  auto run = d.run;
  run.longest = longest;
  ph::follow_wall(plant, control, wall,
                  ph::following_hand<double, 2>(d.plane.direction, d.plane.start, d.hand), run,
                  [&](const auto& now) {
                    if (!l.touched && now.depth > 0) {
                      l.touched = true;
                      l.q = plant.q();
                      l.velocity = plant.velocity();
                      touch = now.time;
                    }
                    if (!l.touched) return;
                    if (!rests && now.velocity.dot(n) >= 0) {
                      rests = true;
                      l.first = now.depth;
                    }
                    if (now.time < touch + 0.2) l.deepest = std::max(l.deepest, now.depth);
                    if (now.time < touch + 0.3) return;
                    l.drift += std::pow(now.velocity.dot(n), 2);
                    ++settled;
                  });
  l.drift = std::sqrt(l.drift / std::max(settled, 1));
  if (!rests || l.first > deep) l.deepest = std::max(l.deepest, l.first);
  return l;
}

}  // namespace landings
