// Runs for any planar mechanism.
#pragma once

#include "control_of.hpp"
#include "planar.hpp"

#if PASSIVE_HAPTICS_MUJOCO
#include <passive_haptics/interop/mujoco.hpp>
#endif

#include <Eigen/LU>

#include <algorithm>

namespace experiments {

inline constexpr double start_x = 0.045, end_x = 0.17;  // [m]
inline constexpr double trace_period = 5e-3;            // [s]

// Differences between the devices.
template <class M, class Brakes = ph::brakes_of<M>, class Model = ph::coulomb_brake<double>>
struct device {
  M real, believed;
  Brakes brakes;  // as known to the controller
  ph::brake_models_of<M, Model> real_brakes;
  double encoder_resolution;  // [rad or m]
  ph::joint_vector<M> start;  // joint positions
};

// Start of the handle at this distance from the wall, at start_x.
inline plane_vector start_beside(const test_wall& wall, double gap) {
  return {start_x, height_before(wall, start_x, gap)};
}

template <class M, class Brakes, class Model, class Law>
any_control<M> control_of(const device<M, Brakes, Model>& d, const Law& control_law, const test_wall& wall,
                          const setup& how) {
  return ph::controller(d.believed, d.brakes,
                        ph::held_scene(ph::scene(ph::wall(wall)), 1 / how.environment_rate), control_law);
}

template <class Plant, class M, class Brakes, class Model>
run_result follow_in(Plant plant, const device<M, Brakes, Model>& d, const any_control<M>& control,
                     const test_wall& wall, const setup& how) {
  const plane_vector x0 = d.real.position(d.start), n = wall.gradient(x0), along(-n[1], n[0]);
  const ph::following_hand<double, 2> hand({1, 0}, x0, how.hand);
  const ph::matrix<double, 2, 2> J(ph::jacobian(d.real, d.start));
  plant.set_motion(d.start, J.partialPivLu().solve(how.hand.speed * along - how.approach * n));

  ph::wall_following_parameters p;
  p.time_step = how.time_step;
  p.sensor_noise = how.noise;
  p.noise_seed = how.seed;
  p.encoder_resolution = d.encoder_resolution;
  p.path_end = end_x;

  run_result result;
  double kept = -trace_period;
  result.figures = ph::follow_wall(plant, control, wall, hand, p, [&](const ph::wall_following_sample<M>& s) {
    if (s.control->wall_number >= 0) result.min_alpha = std::min(result.min_alpha, s.control->alpha);
    if (s.time - kept < trace_period * (1 - 1e-9)) return;
    kept = s.time;
    result.trace.push_back({s.time, s.depth, s.control->alpha, s.position, s.rates, s.control->capacity,
                            s.brake_torque, s.hand_force, s.brake_force});
  });
  result.energy = plant.energy();
  return result;
}

template <class M, class Brakes, class Model>
run_result follow(const device<M, Brakes, Model>& d, const any_control<M>& control, const test_wall& wall,
                  const setup& how) {
#if PASSIVE_HAPTICS_MUJOCO
  if constexpr (std::same_as<Model, ph::coulomb_brake<double>>)  // as all that run there
    if (how.plant == simulation::mujoco)
      return follow_in(ph::mujoco_device(d.real, d.real_brakes, how.hand.mass, d.start), d, control, wall,
                       how);
#endif
  if (how.plant == simulation::mujoco)
    throw std::runtime_error(
        "--plant mujoco: expected an example that was built with MuJoCo; install Debian's "
        "libmujoco-dev and build it again");
  return follow_in(ph::simulated_device(d.real, d.real_brakes, how.hand.mass, d.start), d, control, wall,
                   how);
}

// Under any of the laws.
template <class M, class Brakes, class Model>
run_result follow(const device<M, Brakes, Model>& d, law which, const test_wall& wall, const setup& how) {
  const any_control<M> control =
      with_law(which, [&](const auto& control_law) { return control_of(d, control_law, wall, how); });
  return follow(d, control, wall, how);
}

}  // namespace experiments
