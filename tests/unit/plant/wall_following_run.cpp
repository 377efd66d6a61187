// slow, optimised
// The wall-following experiment: its samples, sensors and figures; devices with a self-motion.
#include "wall_experiment.hpp"

#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace {

TEST(wall_following_run, samples_fit_together) {
  auto e = tendon_device<double>(0.02);
  auto control = e.controller(ph::direct_control(), 1000);
  ph::wall_following_parameters p;
  p.max_duration = 0.1;
  p.sensor_corner = 0;
  double time = 0;
  bool braked = false;
  ph::follow_wall(e.device, control, wall, e.hand, p, [&](const auto& s) {
    time += 1e-4;
    EXPECT_NEAR(s.time, time, 1e-9);
    EXPECT_EQ(s.position, e.device.position());
    EXPECT_EQ(s.depth, -wall.distance(s.position));
    EXPECT_EQ(s.hand_force, e.device.sensed_force()) << "no filter in between";
    EXPECT_EQ(s.rates, e.device.rates());
    const ph::vector<double, 2> t = ph::brake_jacobian(e.arm, e.device.q()).transpose() * s.brake_force;
    EXPECT_LE((t - s.brake_torque).norm(),
              ph::rounding_tolerance<double>(64) * (s.brake_torque.norm() + s.brake_force.norm()));
    EXPECT_TRUE((s.control->capacity.array() >= 0).all());
    braked |= s.brake_torque.norm() > 0;
  });
  EXPECT_TRUE(braked);
}

// The controller sees counts and differences, the figures are the true ones.
TEST(wall_following_run, control_reads_the_encoders) {
  using M = ph::tendon_two_link<double>;
  auto e = tendon_device<double>(0.02);
  ph::wall_following_parameters p;
  p.max_duration = 0.05;
  p.encoder_resolution = 1e-3;
  p.rate_corner = 30;
  ph::joint_encoders<M> expected(e.arm, {1e-3, 30}, 1e-3);
  double largest = 0;
  const auto control = [&](const ph::device_state<M>& state) {
    expected.read(e.device.q(), e.device.qd());
    EXPECT_EQ(state.q, expected.q());
    EXPECT_EQ(state.qd, expected.qd());
    largest = std::max(largest, (state.q - e.device.q()).norm());
    return ph::step_result<M>();
  };
  ph::follow_wall(e.device, control, wall, e.hand, p, [&](const auto& s) {
    EXPECT_EQ(s.depth, -wall.distance(e.device.position()));
    EXPECT_EQ(s.rates, e.device.rates());
  });
  EXPECT_GT(largest, 1e-4);
  EXPECT_LT(largest, 2e-3);
}

TEST(wall_following_run, control_reads_the_noise_of_the_force_sensor) {
  using M = ph::xy_table<double>;
  const auto noise_of = [](double sigma, std::uint64_t seed) {
    auto e = table<double>();
    ph::wall_following_parameters p = with_slides();
    p.max_duration = 0.5;
    p.sensor_noise = sigma;
    p.noise_seed = seed;
    double squares = 0;
    int readings = 0;
    ph::vector<double, 2> filtered(0, 0);
    const auto control = [&](const ph::device_state<M>& state) {
      squares += (state.hand_force - filtered).squaredNorm();
      ++readings;
      return ph::step_result<M>();
    };
    ph::follow_wall(e.device, control, wall, e.hand, p, [&](const auto& s) { filtered = s.hand_force; });
    return std::sqrt(squares / (2 * readings));
  };
  EXPECT_EQ(noise_of(0, 1), 0);
  EXPECT_NEAR(noise_of(0.05, 1), 0.05, 5 * 0.05 / std::sqrt(2 * 1000.0));
  EXPECT_EQ(noise_of(0.05, 1), noise_of(0.05, 1));
  EXPECT_NE(noise_of(0.05, 1), noise_of(0.05, 2));
}

// The brakes of a table that slides along a wall with a known friction: W = F s, and P <= 0.
TEST(wall_following_run, figures_count_the_energy_of_the_brakes) {
  using M = ph::xy_table<double>;
  auto e = table<double>();
  ph::wall_following_parameters p = with_slides();
  p.max_duration = 0.5;
  e.device.set_motion({0.045, 0.2251}, {0.05, 0});
  ph::step_result<M> half_a_newton;
  half_a_newton.capacity = {0.5, 10};
  double way = 0, power = -1, force = 0;
  const auto figures = ph::follow_wall(
      e.device, [&](const auto&) { return half_a_newton; }, wall, e.hand, p,
      [&](const auto& s) {
        way += 1e-4 * s.velocity[0];
        power = std::max(power, s.brake_power.maxCoeff());
        force = -s.brake_force[0];
      });
  EXPECT_GT(way, 0.01);
  EXPECT_NEAR(force, 0.5, 1e-9);
  EXPECT_NEAR(figures.brake_energy, 0.5 * way, 0.05 * 0.5 * way) << "less while the brakes rise";
  EXPECT_NEAR(figures.brake_energy, e.device.energy().friction(), 1e-12) << "in contact from the start";
  EXPECT_LE(figures.max_brake_power, 1e-15);
  EXPECT_LE(power, 1e-15);
  EXPECT_LE(std::abs(e.device.energy().imbalance()), 1e-13 * e.device.energy().hand);
}

// An arm with one joint too many. Its brakes' force at the handle is that which would accelerate the handle
// alike.
TEST(wall_following_run, devices_with_self_motion_follow_a_wall) {
  using M = ph::serial_chain_with_inertia<double, 3, 2>;
  ph::serial_chain_inertia<double, 3, 2> inertia;
  const std::array<double, 3> lengths{0.15, 0.15, 0.1};
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = 0.15 * static_cast<double>(i);
    inertia.links[i] = ph::uniform_rod<double, 2>(0.2, {x, 0}, {x + lengths[i], 0});
  }
  const M arm(ph::planar_arm(lengths), inertia);
  const ph::vector<double, 3> q(2.4, -1.3, -0.6);
  const ph::point<2> start = arm.position(q);
  const ph::half_space<2> surface({0, start[1] + 0.002}, {0, -1});
  ph::brakes_of<M> brakes;
  ph::simulated_device<M> device(arm, brakes, 0.5, q);
  const ph::following_hand<double, 2> hand({1, 0}, start);
  ph::controller control(arm, brakes, ph::scene(ph::wall(surface)), ph::direct_control());
  ph::wall_following_parameters p;
  p.path_end = start[0] + 0.02;
  p.watched_brake = 2;
  double max_force = 0;
  const auto figures = ph::follow_wall(device, control, surface, hand, p, [&](const auto& s) {
    const ph::matrix<double, 2, 3> J = ph::jacobian(arm, device.q());
    const ph::matrix<double, 2, 3> JMi = J * arm.mass_matrix(device.q()).inverse();
    const ph::vector<double, 2> by_brakes = JMi * s.brake_torque,
                                by_force = JMi * (J.transpose() * s.brake_force);
    EXPECT_LE((by_brakes - by_force).norm(), 1e-9 * (by_brakes.norm() + 1));
    max_force = std::max(max_force, s.brake_force.norm());
  });
  EXPECT_GT(figures.duration, 0.1);
  EXPECT_GT(max_force, 0.1);
  EXPECT_GT(figures.brake_energy, 0);
  EXPECT_LE(figures.max_brake_power, 1e-14);
  EXPECT_LE(std::abs(device.energy().imbalance()), 1e-3 * device.energy().hand);
}

}  // namespace
