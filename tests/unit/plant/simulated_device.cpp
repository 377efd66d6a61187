// The simulated device: what its brakes hold and what its sensor feels.
#include "../support.hpp"

#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

#include <cmath>
#include <limits>
#include <type_traits>

namespace {

// Brakes that follow their command at once, or with a lag [s].
template <class M>
ph::brakes_of<M> brakes_with(typename M::scalar lag, typename M::scalar limit) {
  ph::brakes_of<M> brakes;
  brakes.time_constant.setConstant(lag);
  brakes.torque_limit.setConstant(limit);
  return brakes;
}

template <class T>
struct simulated : ::testing::Test {
  using table = ph::simulated_device<ph::xy_table<T>>;  // 0.5 kg each way
  using tendon = ph::simulated_device<ph::tendon_two_link<T>>;
  using pair = ph::vector<T, 2>;
  static table make_table(T lag, T limit, T hand_mass) {
    return table(ph::xy_table<T>(), brakes_with<ph::xy_table<T>>(lag, limit), hand_mass, {0, 0});
  }
  static tendon make_tendon(T lag, T limit, T hand_mass) {
    using M = ph::tendon_two_link<T>;
    return tendon(M(), brakes_with<M>(lag, limit), hand_mass, {T(2), T(-1.2)});
  }
  static constexpr T tiny = std::is_same_v<T, double> ? T(1e-15) : T(1e-6);
};
TYPED_TEST_SUITE(simulated, scalars);

TYPED_TEST(simulated, starts_at_rest_where_it_is_put) {
  const auto device = this->make_tendon(0, 1, 0);
  EXPECT_EQ(device.q(), (ph::vector<TypeParam, 2>(2, TypeParam(-1.2))));
  EXPECT_TRUE(device.qd().isZero(0) && device.velocity().isZero(0) && device.rates().isZero(0));
  EXPECT_TRUE(device.brake_torque().isZero(0) && device.sensed_force().isZero(0));
  EXPECT_EQ(device.position(), device.mechanism().position(device.q()));
}

TYPED_TEST(simulated, waits_where_the_time_step_is_none) {
  using T = TypeParam;
  using real = std::numeric_limits<T>;
  auto device = this->make_tendon(T(0.02), 1, T(0.5)), other = device;
  for (int k = 0; k < 100; ++k) {
    for (const T dt : {T(0), T(-1e-3), real::quiet_NaN(), real::infinity(), -real::infinity()})
      device.advance(dt, {T(0.1), T(0.2)}, {T(3), T(-2)});
    for (auto* d : {&device, &other}) d->advance(T(1e-3), {T(0.1), T(0.2)}, {T(3), T(-2)});
    ASSERT_EQ(device.q(), other.q());
    ASSERT_EQ(device.brake_torque(), other.brake_torque());
  }
}

TYPED_TEST(simulated, brakes_that_are_strong_enough_hold_exactly) {
  using T = TypeParam;
  auto device = this->make_tendon(0, 100, T(0.5));
  const auto start = device.q();
  for (int k = 0; k < 2000; ++k) device.advance(T(1e-4), {100, 100}, {T(3), T(-2)});
  EXPECT_LE(device.rates().norm(), this->tiny);
  EXPECT_LE((device.q() - start).norm(), T(0.2) * this->tiny) << "not even a creep";
  // Held: the brakes carry the hand's torque, t = -E^T F
  const ph::vector<T, 2> expected =
      -(ph::brake_jacobian(device.mechanism(), device.q()).transpose() * ph::vector<T, 2>(T(3), T(-2)));
  expect_near(device.brake_torque(), expected, 1, 1e3);
  expect_near(device.sensed_force(), ph::vector<T, 2>(T(3), T(-2)), 4, 1e3);
}

TYPED_TEST(simulated, one_brake_holds_its_own_axis_only) {
  using T = TypeParam;
  auto device = this->make_tendon(0, 100, 0);
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
    EXPECT_NEAR(device.qd()[0], T(1) - T(4) * dt * static_cast<T>(k), ph::rounding_tolerance<T>(64));
    EXPECT_NEAR(device.brake_torque()[0], T(-2), T(1e-3));
  }
  for (int k = 0; k < 10; ++k) device.advance(dt, {2, 2}, {0, 0});
  EXPECT_LE(device.qd().norm(), this->tiny);
  EXPECT_NEAR(device.q()[0], T(0.125), T(1e-3)) << "v^2 / (2 a)";
}

TYPED_TEST(simulated, strength_follows_the_command_within_the_limit_with_the_brakes_lag) {
  using T = TypeParam;
  auto device = this->make_table(T(0.02), 3, 0);
  for (int k = 1; k <= 100; ++k) {
    device.advance(T(1e-3), {T(2), T(50)}, {0, 0});
    const T rise = T(1) - std::exp(-static_cast<T>(k) * T(1e-3) / T(0.02));
    EXPECT_NEAR(device.brake_strength()[0], T(2) * rise, ph::rounding_tolerance<T>(100));
    EXPECT_NEAR(device.brake_strength()[1], T(3) * rise, ph::rounding_tolerance<T>(100)) << "limited to 3";
  }
  for (int k = 0; k < 5; ++k) device.advance(T(10), {-1, -1}, {0, 0});
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

}  // namespace
