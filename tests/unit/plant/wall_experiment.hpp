// The devices that follow a wall in an experiment, and how they are measured.
#pragma once

#include "../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/wall_following.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <Eigen/LU>

inline const ph::half_space<2> wall({0, 0.225}, {0, -1});

// A device 4 mm off the wall at x = 0.045 m, moving along it and into it.
template <class M>
struct experiment {
  using T = typename M::scalar;
  M arm;
  ph::brakes_of<M> brakes;
  ph::joint_vector<M> q;
  ph::following_hand<T, 2> hand{{1, 0}, arm.position(q)};
  ph::simulated_device<M> device{arm, brakes, hand.parameters().mass, q};

  experiment(const M& mechanism, const ph::brakes_of<M>& b, const ph::joint_vector<M>& start)
      : arm(mechanism), brakes(b), q(start) {
    const ph::matrix<T, 2, 2> J(ph::jacobian(arm, q));
    device.set_motion(q, J.inverse() * ph::vector<T, 2>(T(0.05), T(0.1)));
  }

  template <class Law>
  auto controller(Law law, double rate) const {
    return ph::controller(arm, brakes, ph::held_scene(ph::scene(ph::wall(wall)), 1 / rate), law);
  }
};

template <class T>
auto table() {
  using M = ph::xy_table<T>;
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(10);          // [N]
  brakes.rate_dead_band.setConstant(T(0.002));  // [m/s]
  return experiment<M>(M(), brakes, {T(0.045), T(0.221)});
}

template <class T>
auto tendon_device(T brake_lag) {
  using M = ph::tendon_two_link<T>;
  ph::brakes_of<M> brakes;
  brakes.time_constant.setConstant(brake_lag);
  const M arm;
  return experiment<M>(arm, brakes, arm.inverse({T(0.045), T(0.221)}, ph::elbow::left).q);
}

// 8192 counts a turn, 0.1 m from the axis [m].
inline ph::wall_following_parameters with_slides(ph::wall_following_parameters p = {}) {
  p.encoder_resolution *= 0.1;
  return p;
}
