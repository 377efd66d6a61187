// The simulated device against closed forms: what its brakes hold and how they slow it down, gain, residual
// friction and drag, what its sensor feels.
#include "../support.hpp"

#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

#include <cmath>
#include <limits>
#include <type_traits>

namespace {

namespace simulated_devices {

template <class T>
struct simulated : ::testing::Test {
  using slides = ph::xy_table<T>;  // 0.5 kg each way
  using arm = ph::tendon_two_link<T>;
  using pair = ph::vector<T, 2>;

  template <class M>
  static ph::simulated_device<M> make(const pair& q, T lag, T limit, T hand_mass) {
    ph::brakes_of<M> brakes;
    brakes.time_constant.setConstant(lag);
    brakes.torque_limit.setConstant(limit);
    return {M(), brakes, hand_mass, q};
  }
  static auto make_table(T lag, T limit, T hand_mass) { return make<slides>({0, 0}, lag, limit, hand_mass); }
  static auto make_arm(T lag, T limit, T hand_mass) {
    return make<arm>({T(2), T(-1.2)}, lag, limit, hand_mass);
  }
  static constexpr T tiny = std::is_same_v<T, double> ? T(1e-15) : T(1e-6);
};
TYPED_TEST_SUITE(simulated, scalars);

TYPED_TEST(simulated, starts_at_rest_where_it_is_put) {
  const auto device = this->make_arm(0, 1, 0);
  EXPECT_EQ(device.q(), (ph::vector<TypeParam, 2>(2, TypeParam(-1.2))));
  EXPECT_TRUE(device.qd().isZero(0) && device.velocity().isZero(0) && device.rates().isZero(0));
  EXPECT_TRUE(device.brake_torque().isZero(0) && device.sensed_force().isZero(0));
  EXPECT_EQ(device.position(), device.mechanism().position(device.q()));
}

TYPED_TEST(simulated, waits_if_the_time_step_is_none) {
  using T = TypeParam;
  using real = std::numeric_limits<T>;
  auto device = this->make_arm(T(0.02), 1, T(0.5)), other = device;
  for (int k = 0; k < 10; ++k) {
    for (const T dt : {T(0), T(-1e-3), real::quiet_NaN(), real::infinity(), -real::infinity()})
      device.advance(dt, {T(0.1), T(0.2)}, {T(3), T(-2)});
    for (auto* d : {&device, &other}) d->advance(T(1e-3), {T(0.1), T(0.2)}, {T(3), T(-2)});
    ASSERT_EQ(device.q(), other.q());
    ASSERT_EQ(device.brake_torque(), other.brake_torque());
  }
}

TYPED_TEST(simulated, brakes_that_are_strong_enough_hold_exactly) {
  using T = TypeParam;
  auto device = this->make_arm(0, 100, T(0.5));
  const auto start = device.q();
  const ph::vector<T, 2> F(T(3), T(-2));
  for (int k = 0; k < 1000; ++k) device.advance(T(1e-4), {100, 100}, F);
  EXPECT_LE(device.rates().norm(), this->tiny);
  EXPECT_LE((device.q() - start).norm(), T(0.2) * this->tiny) << "not even a creep";
  const ph::vector<T, 2> t = ph::brake_jacobian(device.mechanism(), device.q()).transpose() * F;
  expect_near(device.brake_torque(), ph::vector<T, 2>(-t), 1, 1e3);
  expect_near(device.sensed_force(), F, 4, 1e3);
}

TYPED_TEST(simulated, one_brake_holds_only_its_own_axis) {
  using T = TypeParam;
  auto device = this->make_arm(0, 100, 0);
  for (int k = 0; k < 100; ++k) device.advance(T(1e-4), {0, 100}, {T(0.5), T(0.5)});
  EXPECT_LE(std::abs(device.rates()[1]), this->tiny * 10);
  EXPECT_GT(std::abs(device.rates()[0]), T(0.01));
}

TYPED_TEST(simulated, a_sliding_brake_slows_down_at_its_force_and_stops_without_turning_back) {
  using T = TypeParam;
  auto device = this->make_table(0, 10, 0);
  device.set_motion({0, 0}, {1, 0});
  const T dt = T(1e-3);
  for (int k = 1; k <= 249; ++k) {  // 2 N on 0.5 kg: 4 m/s^2, so 0.25 s
    device.advance(dt, {2, 2}, {0, 0});
    ASSERT_NEAR(device.qd()[0], T(1) - T(4) * dt * static_cast<T>(k), ph::rounding_tolerance<T>(64));
    ASSERT_NEAR(device.brake_torque()[0], T(-2), T(1e-3));
    ASSERT_NEAR(device.brake_power()[0], T(-2) * device.qd()[0], T(1e-3));
  }
  for (int k = 0; k < 10; ++k) device.advance(dt, {2, 2}, {0, 0});
  EXPECT_LE(device.qd().norm(), this->tiny);
  EXPECT_NEAR(device.q()[0], T(0.125), T(1e-3)) << "v^2 / (2 a)";
  EXPECT_NEAR(device.energy().brakes, 0.25, 1e-5) << "m v^2 / 2";
}

TYPED_TEST(simulated, strength_follows_the_command_within_the_limit_with_the_brakes_lag) {
  using T = TypeParam;
  auto device = this->make_table(T(0.02), 3, 0);
  for (int k = 1; k <= 100; ++k) {
    device.advance(T(1e-3), {T(2), T(50)}, {0, 0});
    const T rise = T(1) - std::exp(-static_cast<T>(k) * T(1e-3) / T(0.02));
    ASSERT_NEAR(device.brake_strength()[0], T(2) * rise, ph::rounding_tolerance<T>(100));
    ASSERT_NEAR(device.brake_strength()[1], T(3) * rise, ph::rounding_tolerance<T>(100)) << "limited to 3";
  }
  for (int k = 0; k < 5; ++k) device.advance(T(10), {-1, std::numeric_limits<T>::quiet_NaN()}, {0, 0});
  EXPECT_LE(device.brake_strength().norm(), this->tiny) << "a brake does not push";
}

// Free: hand and device share the muscle's force by their masses. Held: the sensor feels all of it.
TYPED_TEST(simulated, sensor_feels_what_reaches_the_device) {
  using T = TypeParam;
  auto device = this->make_table(0, 100, T(1.5));  // hand three times the 0.5 kg of the table
  device.advance(T(1e-3), {0, 100}, {T(4), T(4)});
  EXPECT_NEAR(device.sensed_force()[0], T(1), T(1e-4));
  EXPECT_NEAR(device.sensed_force()[1], T(4), T(1e-4));
  EXPECT_NEAR(device.qd()[0], T(4) / T(2) * T(1e-3), T(1e-7));
  EXPECT_LE(std::abs(device.qd()[1]), this->tiny);
}

using M = ph::xy_table<double>;
using pair = ph::vector<double, 2>;

// A hand that only holds on: the handle feels the resistance of its mass, -m a.
TEST(simulated_device, sensor_feels_the_hands_mass_on_a_curved_path) {
  const double hand_mass = 0.3, dt = 1e-5;
  auto device = simulated<double>::make_arm(0, 1, hand_mass);
  device.set_motion({2, -1.2}, {3, -4});
  for (int k = 0; k < 100; ++k) {
    const pair before = device.velocity();
    device.advance(dt, {0, 0}, {0, 0});
    const pair acceleration = (device.velocity() - before) / dt;
    EXPECT_GT(acceleration.norm(), 0.1);
    EXPECT_LE((device.sensed_force() + hand_mass * acceleration).norm(),
              0.01 * hand_mass * acceleration.norm());
  }
}

ph::brake_models_of<M> at_once() {
  const ph::coulomb_brake<double> strong{.torque_limit = 10, .time_constant = 0};
  return {strong, strong};
}

TEST(simulated_device, has_ideal_brakes_if_it_has_only_the_controllers) {
  ph::brakes_of<M> believed;
  believed.torque_limit = {2, 3};
  believed.time_constant = {0.01, 0.03};
  const auto real = ph::ideal_brakes(believed);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(real[i].torque_limit, believed.torque_limit[static_cast<int>(i)]);
    EXPECT_EQ(real[i].time_constant, believed.time_constant[static_cast<int>(i)]);
  }
  ph::simulated_device device(M(), believed, 0.5, {0, 0}), same(M(), real, 0.5, {0, 0});
  for (int k = 0; k < 100; ++k) {
    device.advance(1e-3, {0.5, 1}, {3, 4});
    same.advance(1e-3, {0.5, 1}, {3, 4});
    ASSERT_EQ(device.q(), same.q());
  }
}

TEST(simulated_device, names_what_is_wrong_with_its_brakes) {
  const auto error_of = [](const auto& change) {
    ph::brake_models_of<M> real;
    change(real);
    return thrown_by([&] { ph::simulated_device<M>(M(), real, 0.0, {0, 0}); });
  };
  EXPECT_EQ(error_of([](auto&) {}), "nothing");
  EXPECT_EQ(error_of([](auto& p) { p[1].time_constant = -1; }),
            "passive_haptics: brakes[1].time_constant [s] = -1: expected a finite number >= 0");
  EXPECT_EQ(error_of([](auto& p) { p[1].residual.drag = -2; }),
            "passive_haptics: brakes[1].residual.drag [N m s] = -2: expected a finite number >= 0");
}

// Without current 0.3 N on 0.5 kg: stops after v0 / 0.6 = 1.67 s, and holds less than 0.3 N.
TEST(simulated_device, has_residual_friction_without_current_that_sticks) {
  auto real = at_once();
  real[0].residual.strength = 0.3;
  ph::simulated_device device(M(), real, 0.0, {0, 0});
  device.set_motion({0, 0}, {1, 0});
  for (int k = 1; k <= 100; ++k) {
    device.advance(1e-3, {0, 0}, {0, 0});
    ASSERT_NEAR(device.qd()[0], 1 - 0.6e-3 * k, 1e-12);
  }
  EXPECT_EQ(device.brake_strength()[0], 0) << "nothing is commanded";
  device.set_motion({0, 0}, {0, 0});
  for (int k = 0; k < 100; ++k) device.advance(1e-3, {0, 0}, {0.299, 0});
  EXPECT_LE(std::abs(device.qd()[0]), 1e-15);
  EXPECT_NEAR(device.brake_torque()[0], -0.299, 1e-12);
  for (int k = 0; k < 100; ++k) device.advance(1e-3, {0, 0}, {0.301, 0});
  EXPECT_NEAR(device.qd()[0], 0.001 / 0.5 * 0.1, 1e-12);
}

// Commanded and residual friction share the dissipated energy as their strengths.
TEST(simulated_device, splits_friction_by_its_source) {
  auto real = at_once();
  real[0].gain = 0.5;
  real[0].residual.strength = 0.5;
  ph::simulated_device device(M(), real, 0.0, {0, 0});
  device.set_motion({0, 0}, {1, 0});
  for (int k = 0; k < 400; ++k) device.advance(1e-3, {3, 0}, {0, 0});
  EXPECT_NEAR(device.energy().brakes, 0.75 * 0.25, 1e-13);
  EXPECT_NEAR(device.energy().residual_friction, 0.25 * 0.25, 1e-13);
  EXPECT_NEAR(device.energy().friction(), 0.25, 1e-13);
  EXPECT_EQ(device.energy().drag, 0);
}

// m dv/dt = -b v: v = v0 exp(-b t / m); by implicit Euler v0 (1 + b dt / m)^-k, which is never unstable.
TEST(simulated_device, is_slowed_by_drag_exponentially_to_first_order) {
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
  real[0].residual.drag = 1e6;
  EXPECT_LT(std::abs(error(1e-3) + std::exp(-1.0)), 1e-12) << "stopped, without ringing";
}

}  // namespace simulated_devices

}  // namespace
