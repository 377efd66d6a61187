// slow
// Real brakes against closed forms: gain, residual torque, drag, saturation.
#include "../support.hpp"

#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace {

using M = ph::xy_table<double>;  // 0.5 kg each way
using pair = ph::vector<double, 2>;

ph::brake_models_of<M> at_once() {
  const ph::coulomb_brake<double> strong{.torque_limit = 10, .time_constant = 0};
  return {strong, strong};
}

TEST(real_brakes, are_ideal_where_only_the_controllers_are_given) {
  ph::brakes_of<M> believed;
  believed.torque_limit = {2, 3};
  believed.time_constant = {0.01, 0.03};
  const auto real = ph::ideal_brakes(believed);
  for (int i = 0; i < 2; ++i) {
    const ph::coulomb_brake<double>& brake = real[static_cast<std::size_t>(i)];
    EXPECT_EQ(brake.torque_limit, believed.torque_limit[i]);
    EXPECT_EQ(brake.time_constant, believed.time_constant[i]);
    EXPECT_EQ(brake.gain, 1);
    EXPECT_EQ(brake.fall_ratio, 1);
    EXPECT_EQ(brake.residual.strength, 0);
    EXPECT_EQ(brake.residual.drag, 0);
  }
  ph::simulated_device device(M(), believed, 0.5, {0, 0}), same(M(), real, 0.5, {0, 0});
  for (int k = 0; k < 100; ++k) {
    device.advance(1e-3, {0.5, 1}, {3, 4});
    same.advance(1e-3, {0.5, 1}, {3, 4});
    ASSERT_EQ(device.q(), same.q());
  }
}

TEST(real_brakes, name_what_is_wrong_with_them) {
  const auto error_of = [](auto&& change) {
    ph::brake_models_of<M> real;
    change(real);
    try {
      ph::simulated_device<M>(M(), real, 0.0, {0, 0});
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(error_of([](auto&) {}), "");
  const std::string of = "passive_haptics: brakes";
  EXPECT_EQ(error_of([](auto& p) { p[0].torque_limit = -1; }),
            of + "[0].torque_limit [N m] = -1, expected a finite number >= 0");
  EXPECT_EQ(error_of([](auto& p) { p[1].time_constant = -1; }),
            of + "[1].time_constant [s] = -1, expected a finite number >= 0");
  EXPECT_EQ(error_of([](auto& p) { p[0].fall_ratio = 0; }),
            of + "[0].fall_ratio [1] = 0, expected a finite number > 0");
  EXPECT_EQ(error_of([](auto& p) { p[1].gain = -0.5; }),
            of + "[1].gain [1] = -0.5, expected a finite number > 0");
  EXPECT_EQ(error_of([](auto& p) { p[0].residual.strength = std::numeric_limits<double>::infinity(); }),
            of + "[0].residual.strength [N m] = inf, expected a finite number >= 0");
  EXPECT_EQ(error_of([](auto& p) { p[1].residual.drag = -2; }),
            of + "[1].residual.drag [N m s] = -2, expected a finite number >= 0");
}

TEST(real_brakes, gain_acts_before_the_lag_and_the_limit_on_what_is_real) {
  auto real = at_once();
  real[0].time_constant = real[1].time_constant = 0.02;
  real[0].gain = 0.8;
  real[1].gain = 3;
  ph::simulated_device device(M(), real, 0.0, {0, 0});
  for (int k = 1; k <= 100; ++k) {
    device.advance(1e-3, {2, 4}, {0, 0});
    const double rise = 1 - std::exp(-k * 1e-3 / 0.02);
    EXPECT_NEAR(device.brake_strength()[0], 0.8 * 2 * rise, 1e-13);
    EXPECT_NEAR(device.brake_strength()[1], 10 * rise, 1e-13) << "12 wanted, 10 is all";
  }
}

// Remanence: up in 20 ms, down in 60.
TEST(real_brakes, fall_at_a_time_constant_of_their_own) {
  auto real = at_once();
  real[0].time_constant = real[1].time_constant = 0.02;
  real[0].fall_ratio = 3;
  ph::simulated_device device(M(), real, 0.0, {0, 0});
  for (int k = 0; k < 100; ++k) device.advance(1e-3, {2, 2}, {0, 0});
  const double top = 2 * (1 - std::exp(-5.0));
  EXPECT_NEAR(device.brake_strength()[0], top, 1e-13);
  for (int k = 1; k <= 60; ++k) {
    device.advance(1e-3, {0.5, 0.5}, {0, 0});
    EXPECT_NEAR(device.brake_strength()[0], 0.5 + (top - 0.5) * std::exp(-k / 60.0), 1e-13);
    EXPECT_NEAR(device.brake_strength()[1], 0.5 + (top - 0.5) * std::exp(-k / 20.0), 1e-13);
  }
}

// 0.8 of 2 N on 0.5 kg: v = v0 - 3.2 t, to rounding; all kinetic energy goes into the brake.
TEST(real_brakes, gain_error_slows_down_with_the_real_force) {
  auto real = at_once();
  real[0].gain = 0.8;
  ph::simulated_device device(M(), real, 0.0, {0, 0});
  device.set_motion({0, 0}, {1, 0});
  for (int k = 1; k <= 300; ++k) {
    device.advance(1e-3, {2, 0}, {0, 0});
    EXPECT_NEAR(device.qd()[0], 1 - 3.2e-3 * k, 1e-13);
    EXPECT_NEAR(device.brake_torque()[0], -1.6, 1e-12);
    EXPECT_NEAR(device.brake_power()[0], -1.6 * device.qd()[0], 1e-12);
  }
  for (int k = 0; k < 50; ++k) device.advance(1e-3, {2, 0}, {0, 0});
  EXPECT_NEAR(device.energy().brakes, 0.25, 1e-13) << "m v^2 / 2";
  EXPECT_EQ(device.energy().residual_friction, 0);
  EXPECT_NEAR(device.energy().imbalance(), 0, 1e-14);
}

// Without current 0.3 N on 0.5 kg: stops after v0 / 0.6 = 1.67 s, and holds less than 0.3 N.
TEST(real_brakes, residual_torque_is_there_without_current_and_sticks) {
  auto real = at_once();
  real[0].residual.strength = 0.3;
  ph::simulated_device device(M(), real, 0.0, {0, 0});
  device.set_motion({0, 0}, {1, 0});
  for (int k = 1; k <= 1600; ++k) {
    device.advance(1e-3, {0, 0}, {0, 0});
    ASSERT_NEAR(device.qd()[0], 1 - 0.6e-3 * k, 1e-12);
  }
  EXPECT_EQ(device.brake_strength()[0], 0) << "nothing is commanded";
  for (int k = 0; k < 100; ++k) device.advance(1e-3, {0, 0}, {0.29, 0});
  EXPECT_GT(device.qd()[0], 0.01) << "0.01 N are left to stop it";
  device.set_motion({0, 0}, {0, 0});
  for (int k = 0; k < 100; ++k) device.advance(1e-3, {0, 0}, {0.299, 0});
  EXPECT_LE(std::abs(device.qd()[0]), 1e-15);
  EXPECT_NEAR(device.brake_torque()[0], -0.299, 1e-12);
  for (int k = 0; k < 100; ++k) device.advance(1e-3, {0, 0}, {0.301, 0});
  EXPECT_NEAR(device.qd()[0], 0.001 / 0.5 * 0.1, 1e-12);
}

// Commanded and residual friction share what is dissipated as their strengths.
TEST(real_brakes, the_energy_balance_splits_friction_by_its_source) {
  auto real = at_once();
  real[0].residual.strength = 0.5;
  ph::simulated_device device(M(), real, 0.0, {0, 0});
  device.set_motion({0, 0}, {1, 0});
  for (int k = 0; k < 400; ++k) device.advance(1e-3, {1.5, 0}, {0, 0});
  EXPECT_NEAR(device.energy().brakes, 0.75 * 0.25, 1e-13);
  EXPECT_NEAR(device.energy().residual_friction, 0.25 * 0.25, 1e-13);
  EXPECT_NEAR(device.energy().friction(), 0.25, 1e-13);
  EXPECT_EQ(device.energy().drag, 0);
}

// m dv/dt = -b v: v = v0 exp(-b t / m); by implicit Euler v0 (1 + b dt / m)^-k, which is never unstable.
TEST(real_brakes, drag_decays_exponentially_to_first_order) {
  auto real = at_once();
  real[0].residual.drag = 2;
  const auto error = [&](double dt) {
    ph::simulated_device device(M(), real, 0.0, {0, 0});
    device.set_motion({0, 0}, {1, 0});
    const long steps = std::lround(0.25 / dt);
    for (long k = 0; k < steps; ++k) device.advance(dt, {0, 0}, {0, 0});
    EXPECT_NEAR(device.qd()[0], std::pow(1 + real[0].residual.drag / 0.5 * dt, -static_cast<double>(steps)),
                1e-13);
    EXPECT_NEAR(device.energy().drag, (1 - device.qd()[0] * device.qd()[0]) / 4, 1e-13);
    EXPECT_EQ(device.energy().friction(), 0);
    return device.qd()[0] - std::exp(-1.0);
  };
  EXPECT_NEAR(error(1e-3), std::exp(-1.0) * 2e-3, 2e-5) << "(b/m)^2 t dt / 2 of it";
  EXPECT_NEAR(error(1e-3) / error(5e-4), 2, 0.01);
  real[0].residual.drag = 1e6;
  EXPECT_LT(std::abs(error(1e-3) + std::exp(-1.0)), 1e-12) << "stopped, without ringing";
}

TEST(real_brakes, drag_acts_on_the_brakes_own_axes) {
  using five = ph::five_bar<double, 4>;  // brake 3 turns with q1 - q2, brake 4 with q1 + q2
  ph::brake_models_of<five> real;
  real[2].residual.drag = 0.01;
  ph::simulated_device device(five(), real, 0.0, {2.3, 0.8});
  device.set_motion({2.3, 0.8}, {1, 1});
  device.advance(1e-6, ph::vector<double, 4>::Zero(), {0, 0});
  EXPECT_LT(device.energy().drag, 1e-12) << "both together do not turn brake 3";
  device.set_motion({2.3, 0.8}, {1, -1});
  device.advance(1e-6, ph::vector<double, 4>::Zero(), {0, 0});
  EXPECT_NEAR(device.energy().drag, 0.01 * std::pow(device.rates()[2], 2) * 1e-6, 1e-10);
}

TEST(real_brakes, nan_and_negative_commands_release) {
  ph::simulated_device device(M(), at_once(), 0.0, {0, 0});
  device.advance(1e-3, {std::numeric_limits<double>::quiet_NaN(), -1}, {1, 1});
  EXPECT_TRUE(device.brake_strength().isZero(0));
  EXPECT_NEAR(device.qd()[0], 2e-3, 1e-15);
}

// Four brakes on two joints: strong ones hold exactly, and share the load with next to the least torques.
TEST(real_brakes, redundant_brakes_hold_exactly_with_nearly_the_least_torques) {
  using five = ph::five_bar<double, 4>;
  ph::brake_models_of<five> real;
  for (ph::coulomb_brake<double>& brake : real) brake.time_constant = 0;
  ph::simulated_device device(five(), real, 0.2, {2.3, 0.8});
  const pair start = device.q(), F(1, -2);
  for (int k = 0; k < 2000; ++k) device.advance(1e-4, ph::vector<double, 4>::Ones(), F);
  EXPECT_LE(device.rates().norm(), 1e-14);
  EXPECT_LE((device.q() - start).norm(), 1e-14);
  const ph::vector<double, 4> least = -(ph::brake_jacobian(device.mechanism(), start).transpose() * F);
  EXPECT_LE((device.brake_torque() - least).norm(), 1e-6 * least.norm());
  EXPECT_LE((device.brake_force() + F).norm(), 1e-9);
}

}  // namespace
