// slow, optimised
// What motors beside the brakes would do for 300 random devices under velocity_direct_control: the figures of
// docs/guide/design.md with PASSIVE_HAPTICS_STRESS=full, else those of 30.
#include "../../stress/effort.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/force/torques/nearest_torque.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/plant/random_device.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace {

namespace ph = passive_haptics;
using hybrid_arm = ph::tendon_two_link<double>;
using vec2 = ph::vector<double, 2>;

hybrid_arm hybrid_arm_of(double inertia) {
  ph::tendon_two_link_parameters<double> p;
  for (double* mass : {&p.mass_1, &p.mass_2, &p.handle_mass, &p.rotor_inertia_1, &p.rotor_inertia_2})
    *mass *= inertia;
  return hybrid_arm(p);
}

// Torques of motors within +-limit that make what the brakes leave missing of the normal force that
// velocity_direct_control demands, without its bias: f = f_ff + Lambda_n (v_ref - n . v) / tau_v.
vec2 motor_torques(const hybrid_arm& arm, const ph::brakes_of<hybrid_arm>& brakes,
                   const ph::device_state<hybrid_arm>& state, const vec2& brake_torque,
                   const ph::half_space<2>& wall, double limit) {
  const ph::velocity_direct_control_parameters p;
  const ph::mechanism_pose<hybrid_arm> pose(arm, state.q);
  const ph::pose_dynamics<hybrid_arm> dynamics(pose, state.qd, p.hand_mass);
  const vec2 x = pose.position(), n = wall.gradient(x);
  const auto along = ph::response_along(n, dynamics, vec2(p.force_share * state.hand_force));
  const double v_ref =
      std::clamp(p.depth_gain * (-wall.distance(x) - p.rest_depth), -p.velocity_limit, p.velocity_limit);
  const double lag = p.velocity_lag_for(brakes.time_constant.maxCoeff());
  const double demand = along.inertia * ((v_ref - n.dot(dynamics.velocity)) / lag - along.free);
  const ph::matrix<double, 1, 2> per_torque = along.inertia * along.g.transpose();
  const double missing = demand - per_torque.dot(brake_torque.transpose());
  if (!(missing > 0)) return vec2::Zero();
  const ph::torque_box<double, 2> box{vec2::Constant(-limit), vec2::Constant(limit)};
  return ph::nearest_torque<double, 1, 2>(per_torque, box, ph::vector<double, 1>(missing)).torque;
}

struct hybrid_run {
  ph::contact_metrics figures;
  double given = 0;     // most that the motors had given beyond what friction had taken [J]
  bool driven = false;  // motors and brakes together gave power to the device
};

// share: torque of each motor for the torque limit of its brake.
hybrid_run follow_with_motors(std::uint64_t seed, std::uint64_t number, double share) {
  static const ph::workspace<hybrid_arm> where{{-3.1, -2.5}, {3.1, -0.6}, 0.1};
  auto d = ph::draw_device(hybrid_arm_of(1), where, seed, number);
  d.run.time_step = 2e-4;
  const hybrid_arm known = hybrid_arm_of(1), real = hybrid_arm_of(d.inertia);
  const ph::half_space<2> wall(d.plane.surface, d.plane.normal);
  ph::controller control(known, d.known_brakes,
                         ph::held_scene(ph::scene(ph::wall(wall, d.wall_stiffness)), 1 / d.environment_rate),
                         ph::velocity_direct_control());
  ph::simulated_device<hybrid_arm> plant(real, d.brakes, d.hand.mass, d.plane.q);
  plant.set_motion(d.plane.q, d.plane.qd);
  const ph::following_hand<double, 2> hand(d.plane.direction, d.plane.start, d.hand);
  const auto& p = d.run;
  ph::force_sensor<double, 2> sensor({p.sensor_corner, p.sensor_noise, p.noise_seed, p.sensor_scale});
  ph::contact_meter meter(p.path_end, p.time_step);
  const long cycle = std::lround(p.control_period / p.time_step),
             steps = std::lround(p.max_duration / p.time_step);
  ph::joint_encoders<hybrid_arm> encoders(real, {p.encoder_resolution, p.rate_corner}, p.control_period);
  vec2 capacity = vec2::Zero(), motors = vec2::Zero();
  double depth = -wall.distance(plant.position()), motor_energy = 0;
  hybrid_run run;
  for (long k = 0; k < steps; ++k) {
    const double time = static_cast<double>(k) * p.time_step;
    if (k % cycle == 0) {
      encoders.read(plant.q(), plant.qd());
      const ph::device_state<hybrid_arm> state{time, encoders.q(), encoders.qd(), sensor.read()};
      const auto r = control(state);
      capacity = r.capacity;
      motors.setZero();
      if (share > 0 && r.wall_number >= 0)
        motors = motor_torques(known, d.known_brakes, state, r.torque, wall,
                               share * d.known_brakes.torque_limit[0]);
    }
    const vec2 x = plant.position(), n = wall.gradient(x);
    const vec2 by_motors = ph::force_generators(real, plant.q()) * motors, before = plant.rates();
    plant.advance(p.time_step, capacity, hand.force(time, x, plant.velocity(), n, depth) + by_motors);
    const vec2 felt = plant.sensed_force() - by_motors;
    sensor.advance(p.time_step, felt);
    motor_energy += p.time_step * motors.dot((before + plant.rates()) / 2);
    run.driven = run.driven || (motors + plant.brake_torque()).dot(plant.rates()) > 1e-9;
    run.given = std::max(run.given, motor_energy - plant.energy().friction());
    depth = -wall.distance(plant.position());
    const double progress = hand.progress(plant.position());
    meter.add({.progress = progress, .depth = depth, .rate = plant.rates()[1], .hand_force = -felt.dot(n)});
    if (progress >= p.path_end || !(depth <= p.max_depth)) break;
  }
  run.figures = meter.result();
  return run;
}

TEST(hybrid_brakes, hold_some_more_devices_and_are_active) {
  const auto devices = stress::effort(30, 300);
  const bool full = devices == 300;
  for (const std::uint64_t seed : {20040627u, 555u}) {
    if (!full && seed == 555) break;
    int deep_without = 0;
    for (const double share : {0.0, 0.02, 0.05, 0.1}) {
      if (!full && share > 0 && share < 0.1) continue;
      int deep = 0, driven = 0, giving = 0;
      for (std::uint64_t k = 0; k < devices; ++k) {
        const hybrid_run run = follow_with_motors(seed, k, share);
        deep += run.figures.is_deep();
        giving += run.given > 0;
        driven += run.driven;
      }
      std::printf("seed %d, motors of %2.0f %%: %d deep, %d driven, %d got more than friction took\n",
                  int(seed), 100 * share, deep, driven, giving);
      if (share == 0) {
        EXPECT_EQ(driven + giving, 0) << "brakes only take energy";
        deep_without = deep;
      } else if (share == 0.1) {
        EXPECT_LE(deep, deep_without);
        EXPECT_GT(deep, deep_without / 2) << "a tenth is far from enough";
        EXPECT_GT(driven, int(devices) / 10);
      }
    }
  }
}

}  // namespace
