// Encoders and the force sensor of the simulated device.
#include "../support.hpp"

#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/encoder.hpp>
#include <passive_haptics/plant/force_sensor.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace {

template <class T>
struct encoders : ::testing::Test {};
TYPED_TEST_SUITE(encoders, scalars);

TYPED_TEST(encoders, are_late_by_less_than_one_count) {
  using T = TypeParam;
  ph::encoder<T, 2> encoder({}, 1e-3);
  const T count = T(2 * std::numbers::pi / 8192);
  const T rounding = std::is_same_v<T, double> ? T(1e-15) : T(1e-6);
  ph::testing::random_source random(51);
  for (int k = 0; k < 300; ++k) {
    const ph::vector<T, 2> angle(random.uniform(T(-4), T(4)), random.uniform(T(-4), T(4)));
    encoder.read(angle, {0, 0});
    for (int i = 0; i < 2; ++i) {
      const T late = angle[i] - encoder.position()[i];
      EXPECT_GE(late, -rounding) << "seed 51, trial " << k;
      EXPECT_LT(late, count + rounding) << "seed 51, trial " << k;
      const T counts = encoder.position()[i] / count;
      EXPECT_NEAR(counts, std::round(counts), rounding * T(1e4)) << "whole counts";
    }
  }
}

TYPED_TEST(encoders, start_at_the_true_rate_and_lag_by_their_corner) {
  using T = TypeParam;
  ph::encoder<T, 1> encoder({.resolution = 1e-3, .rate_corner = 50}, 1e-3);
  // One count a reading, first at rate 2 although it moves with 1 rad/s
  for (int k = 0; k <= 40; ++k) {
    encoder.read(ph::vector<T, 1>((static_cast<T>(k) + T(0.5)) * T(1e-3)), ph::vector<T, 1>(T(2)));
    const T expected = T(1) + std::exp(-T(2 * std::numbers::pi * 50) * T(1e-3) * static_cast<T>(k));
    EXPECT_NEAR(encoder.rate()[0], expected, ph::rounding_tolerance<T>(200)) << "reading " << k;
  }
}

TYPED_TEST(encoders, without_a_low_pass_rates_are_whole_counts_a_period) {
  using T = TypeParam;
  ph::encoder<T, 1> encoder({.resolution = 0.01, .rate_corner = 0}, 0.5);
  const auto rate_at = [&](double angle) {
    encoder.read(ph::vector<T, 1>(T(angle)), ph::vector<T, 1>(T(7)));
    return encoder.rate()[0];
  };
  EXPECT_EQ(rate_at(0.005), T(7)) << "the first reading";
  EXPECT_EQ(rate_at(0.009), T(0));
  EXPECT_NEAR(rate_at(0.011), T(0.02), T(1e-8));
  EXPECT_NEAR(rate_at(-0.001), T(-0.04), T(1e-8)) << "floor, also below zero";
}

TYPED_TEST(encoders, without_resolution_are_ideal) {
  using T = TypeParam;
  using M = ph::tendon_two_link<T>;
  ph::joint_encoders<M> ideal(M(), {.resolution = 0}, 1e-3);
  const ph::vector<T, 2> q(T(0.1), T(-0.7)), qd(T(1) / 3, T(5));
  ideal.read(q, qd);
  EXPECT_EQ(ideal.q(), q);
  EXPECT_EQ(ideal.qd(), qd);
}

// On the brakes' axes: T q is what is in whole counts.
TYPED_TEST(encoders, sit_on_the_brakes_axes) {
  using T = TypeParam;
  using M = ph::tendon_two_link<T>;
  const M arm;
  ph::joint_encoders<M> axes(arm, {.resolution = 1e-3}, 1e-3);
  const ph::vector<T, 2> q(T(1.2345), T(-0.777)), qd(T(0.3), T(0.2));
  axes.read(q, qd);
  const ph::vector<T, 2> late = arm.transmission() * (q - axes.q()), counts = arm.transmission() * axes.q();
  for (int i = 0; i < 2; ++i) {
    EXPECT_GE(late[i], -ph::rounding_tolerance<T>(4));
    EXPECT_LT(late[i], T(1e-3) + ph::rounding_tolerance<T>(4));
    EXPECT_NEAR(counts[i] / T(1e-3), std::round(counts[i] / T(1e-3)), T(1e-2));
  }
  expect_near(axes.qd(), qd, 1);
}

TEST(redundant_encoders, are_reconciled_in_the_mean) {
  using M = ph::five_bar<double, 4>;
  const M arm;
  const ph::matrix<double, 4, 2> transmission = arm.transmission();
  const double count = 1e-3;
  ph::joint_encoders<M> encoders(arm, {.resolution = count}, 1e-3);
  ph::testing::random_source random(53);
  for (int k = 0; k < 100; ++k) {
    const auto q = random.normal_vector<double, 2>();
    encoders.read(q, {0.1, -0.2});
    ph::vector<double, 4> read = transmission * q;
    for (int i = 0; i < 4; ++i) read[i] = count * std::floor(read[i] / count);
    const ph::vector<double, 2> normal = transmission.transpose() * (read - transmission * encoders.q());
    EXPECT_LE(normal.norm(), 1e-14) << "least squares, seed 53, trial " << k;
    if (k > 0) continue;  // the rate of the first reading is the true one
    EXPECT_LE((encoders.qd() - ph::vector<double, 2>(0.1, -0.2)).norm(), 1e-15);
  }
}

// A transmission that depends on the pose has no angle to invert.
struct cam : ph::xy_table<double> {
  ph::matrix<double, 2, 2> transmission(const ph::vector<double, 2>& q) const {
    return ph::matrix<double, 2, 2>{{2 + q[0], 0}, {0, 1}};
  }
};

TEST(encoders_of_cams, sit_on_the_joints) {
  ph::joint_encoders<cam> encoders(cam(), {.resolution = 0.01}, 1e-3);
  encoders.read({0.123, 0.456}, {3, 4});
  expect_near(encoders.q(), ph::vector<double, 2>(0.12, 0.45), 1);
  EXPECT_EQ(encoders.qd(), (ph::vector<double, 2>(3, 4)));
}

TEST(sensor_parameters, are_checked) {
  const auto encoder = [](ph::encoder_parameters p, double period = 1e-3) {
    return thrown_by([&] { ph::encoder<double, 2>(p, period); });
  };
  EXPECT_EQ(encoder({}), "nothing");
  EXPECT_EQ(encoder({.resolution = -1}),
            "passive_haptics: resolution [rad or m] = -1: expected a finite number >= 0");
  EXPECT_EQ(encoder({.rate_corner = -1}),
            "passive_haptics: rate_corner [Hz] = -1: expected a finite number >= 0");
  EXPECT_EQ(encoder({}, 0), "passive_haptics: period [s] = 0: expected a finite number > 0");
  const auto sensor = [](ph::force_sensor_parameters p) {
    return thrown_by([&] { ph::force_sensor<double, 2>{p}; });
  };
  EXPECT_EQ(sensor({}), "nothing");
  EXPECT_EQ(sensor({.corner = -1}), "passive_haptics: corner [Hz] = -1: expected a finite number >= 0");
  EXPECT_EQ(sensor({.scale = 0}), "passive_haptics: scale [1] = 0: expected a finite number > 0");
  EXPECT_EQ(sensor({.noise = std::numeric_limits<double>::infinity()}),
            "passive_haptics: noise [N] = inf: expected a finite number >= 0");
}

template <class T>
struct force_sensor : ::testing::Test {};
TYPED_TEST_SUITE(force_sensor, scalars);

// 3 dB and 45 deg at the corner: the response to a sine of 200 Hz, after its start has decayed.
TYPED_TEST(force_sensor, passes_its_corner_with_one_over_root_two) {
  using T = TypeParam;
  ph::force_sensor<T, 1> sensor({.corner = 200});
  const double w = 2 * std::numbers::pi * 200, dt = 1e-6;
  double in_phase = 0, behind = 0;
  const int period = 5000, settled = 2;
  for (int k = 0; k < (settled + 1) * period; ++k) {
    const double phase = w * dt * (k + 0.5);  // the mean of the step
    sensor.advance(T(dt), ph::vector<T, 1>(static_cast<T>(std::sin(phase))));
    if (k < settled * period) continue;
    in_phase += static_cast<double>(sensor.filtered()[0]) * std::sin(phase) * 2 / period;
    behind -= static_cast<double>(sensor.filtered()[0]) * std::cos(phase) * 2 / period;
  }
  EXPECT_NEAR(in_phase, 0.5, 2e-3);
  EXPECT_NEAR(behind, 0.5, 2e-3);
}

TYPED_TEST(force_sensor, reads_by_its_scale_and_adds_noise_behind_it) {
  using T = TypeParam;
  ph::force_sensor<T, 2> off({.corner = 0, .scale = 1.5}), noisy({.corner = 0, .noise = 1, .seed = 9}),
      both({.corner = 0, .noise = 1, .seed = 9, .scale = 1.5});
  for (auto* sensor : {&off, &noisy, &both}) sensor->advance(T(1e-3), {2, -1});
  EXPECT_EQ(off.read(), (ph::vector<T, 2>(3, T(-1.5))));
  EXPECT_EQ(off.filtered(), (ph::vector<T, 2>(2, -1)));
  expect_near(both.read(), ph::vector<T, 2>(noisy.read() + ph::vector<T, 2>(1, T(-0.5))), 1);
}

// Mean, deviation, tails and whiteness of 20 000 readings of two components.
TYPED_TEST(force_sensor, noise_is_white_and_as_strong_as_stated) {
  using T = TypeParam;
  const double sigma = 0.05;
  ph::force_sensor<T, 2> sensor({.corner = 0, .noise = sigma, .seed = 54}),
      same({.corner = 0, .noise = sigma, .seed = 54}), other({.corner = 0, .noise = sigma, .seed = 55});
  for (auto* each : {&sensor, &same, &other}) each->advance(T(1e-2), {3, -2});
  const int N = 20000;
  double squares = 0, next = 0, across = 0, beyond_two = 0;
  ph::vector<double, 2> sum = {0, 0}, before = {0, 0};
  for (int k = 0; k < N; ++k) {
    const ph::vector<T, 2> reading = sensor.read();
    ASSERT_EQ(reading, same.read());
    ASSERT_NE(reading, other.read());
    const ph::vector<double, 2> e = reading.template cast<double>() - ph::vector<double, 2>(3, -2);
    sum += e;
    squares += e.squaredNorm() / 2;
    next += e.dot(before) / 2;
    across += e[0] * e[1];
    beyond_two += (e.array().abs() > 2 * sigma).template cast<double>().sum() / 2;
    before = e;
  }
  const double variance = sigma * sigma, five_sigma = 5 / std::sqrt(double(N));
  EXPECT_LE(sum.cwiseAbs().maxCoeff() / N, five_sigma * sigma);
  EXPECT_NEAR(squares / N, variance, five_sigma * variance);
  EXPECT_NEAR(next / N, 0, five_sigma * variance) << "each reading has noise of its own";
  EXPECT_NEAR(across / N, 0, five_sigma * variance);
  EXPECT_NEAR(beyond_two / N, 0.0455, five_sigma * std::sqrt(0.0455 / 2));
  EXPECT_EQ(sensor.filtered(), (ph::vector<T, 2>(3, -2))) << "noise stays out of the low-pass";
}

}  // namespace
