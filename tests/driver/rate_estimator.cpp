// together
#include <gtest/gtest.h>
#include <passive_haptics/driver/rate_estimator.hpp>
#include <passive_haptics/plant/encoder.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace ph = passive_haptics;
using one = ph::vector<double, 1>;
using ph::testing::random_source;

namespace rate_estimator_tests {

constexpr double T = 0.001;  // [s]
constexpr int window = 16;

int sign(double x) { return (x > 0) - (x < 0); }

// Positions in counts: a sum of three sines, from less than a count to thousands
struct random_motion {
  std::array<double, 3> amplitude{}, pulsation{}, phase{};
  double start = 0, drift = 0;

  explicit random_motion(random_source& random) {
    for (std::size_t i = 0; i < 3; ++i) {
      amplitude[i] = random.positive(0.1, 3000.0);
      pulsation[i] = random.positive(0.5, 200.0);
      phase[i] = random.uniform(0.0, 6.3);
    }
    start = random.uniform(-10.0, 10.0);
    drift = random.wide(0.01, 1000.0);
  }
  double operator()(double t) const {
    double x = start + drift * t;
    for (std::size_t i = 0; i < 3; ++i) x += amplitude[i] * std::sin(pulsation[i] * t + phase[i]);
    return x;
  }
};

// 2 counts each millisecond, with the times of their arrival: each second sample waits for the next one, or
// bursts of samples come together.
TEST(rate_estimator, bears_samples_at_nearly_equal_times) {
  const auto rates = [](const auto& lateness) {
    ph::rate_estimator<1> estimator;
    std::pair<double, double> found{INFINITY, 0};
    for (int k = 0; k < 1000; ++k) {
      const double rate = estimator.add(k * T + lateness(k), one(2. * k))[0];
      if (k > 200) found = {std::min(found.first, rate), std::max(found.second, rate)};
    }
    return found;
  };
  const auto [slowest, fastest] = rates([](int k) { return k % 2 == 0 ? 0.9e-3 : 0; });
  EXPECT_GE(slowest, 1000);
  EXPECT_LE(fastest, 2500);
  for (int burst = 2; burst <= 32; ++burst)
    for (const double spacing : {1e-6, 50e-6, 0.3e-3}) {
      const auto together = [&](int k) { return (burst - 1 - k % burst) * T + (k % burst) * spacing; };
      ASSERT_LE(rates(together).second, 4000) << "twice the rate; bursts of " << burst << ", " << spacing;
    }
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    random_source random(seed);
    const double most = rates([&](int) { return random.uniform(0.0, 0.999) * T; }).second;
    ASSERT_LE(most, 4000 + 1 / (0.5 * T)) << "twice the rate, and a count; seed " << seed;
  }
}

// A pause does not make those after it nearly simultaneous.
TEST(rate_estimator, is_as_quick_after_a_pause) {
  ph::rate_estimator<1> estimator;
  double t = 0, count = 0;
  for (int k = 0; k < 100; ++k) estimator.add(t += T, one(count += 2));
  estimator.add(t += 1, one(count));
  for (int k = 0; k < 3; ++k) estimator.add(t += T, one(count += 50));
  EXPECT_NEAR(estimator.rate()[0], 50 / T, 1 / T);
}

TEST(rate_estimator, tells_no_rate_within_its_dead_band_and_sees_twice_that) {
  const double band = ph::rate_dead_band(1, window, T);
  EXPECT_DOUBLE_EQ(band, 62.5);
  random_source random(12);
  for (int run = 0; run < 300; ++run) {
    const double rate = random.uniform(0.0, 4 * band), start = random.uniform(0.0, 1.0);
    ph::rate_estimator<1> estimator;
    for (int k = 0; k < 500; ++k) {
      const double estimate = estimator.add(k * T, one(std::floor(start + rate * k * T)))[0];
      if (k < window) continue;
      ASSERT_TRUE(estimate == 0 || estimate > band * (1 + 1e-9)) << estimate;
      ASSERT_TRUE(estimate > 0 || rate < 2 * band * (1 + 1e-9)) << rate;
      ASSERT_NEAR(estimator.span(0), window * T, 1e-9) << "a steady motion fits any window";
    }
  }
}

TEST(rate_estimator, lags_behind_an_acceleration_by_no_more_than_documented) {
  random_source random(13);
  double max_share = 0;
  for (int run = 0; run < 500; ++run) {
    const double a = random.positive(100.0, 1e7), v0 = random.wide(1.0, 1e4), x0 = random.uniform(0.0, 1.0);
    const double lag = ph::rate_lag(1, window, T, a);
    ph::rate_estimator<1> estimator;
    for (int k = 0; k < 200; ++k) {
      const double t = k * T;
      const double estimate = estimator.add(t, one(std::floor(x0 + v0 * t + a * t * t / 2)))[0];
      if (k == 0) continue;
      const double span = estimator.span(0);
      ASSERT_LE(span / 2, lag * (1 + 1e-6)) << "a " << a;
      max_share = std::max(max_share, span / 2 / lag);
      const double steps = estimate == 0 ? 2 : 1;
      ASSERT_LT(std::abs(estimate - (v0 + a * (t - span / 2))), steps / span * (1 + 1e-6));
    }
  }
  EXPECT_GT(max_share, 0.9) << "the bound is far from what happens";
}

TEST(rate_estimator, has_the_right_sign_after_a_reversal_or_a_start_within_the_documented_time) {
  random_source random(14);
  double max_share = 0;
  for (int run = 0; run < 1000; ++run) {
    const double a = random.positive(100.0, 1e7), turn = random.uniform(0.03, 0.031),
                 x0 = random.uniform(0.0, 1.0);
    const bool from_rest = run % 2 == 0, down = run % 4 < 2;
    const double onset = ph::rate_onset(1, window, T, a);
    ph::rate_estimator<1> estimator;
    double last_wrong = turn;
    for (int k = 0; k * T < turn + 3 * onset; ++k) {
      const double t = k * T, since = t - turn;
      const double moved = from_rest && since < 0 ? 0 : a * since * since / 2;
      const double estimate = estimator.add(t, one(std::floor(x0 + (down ? -moved : moved))))[0];
      if (since > 0 && sign(estimate) != (down ? -1 : 1)) last_wrong = t;
    }
    // The next sample is right
    ASSERT_LE(last_wrong + T - turn, onset * (1 + 1e-9))
        << "a " << a << (from_rest ? " from rest" : " reversed");
    max_share = std::max(max_share, (last_wrong + T - turn) / onset);
  }
  EXPECT_GT(max_share, 0.8) << "the bound is far from what happens";
}

TEST(rate_estimator, is_not_changed_by_times_that_do_not_go_on_or_by_counts_that_are_no_numbers) {
  ph::rate_estimator<2> plain, disturbed;
  random_source random(15);
  for (int k = 0; k < 200; ++k) {
    const ph::vector<double, 2> counts(std::floor(3.7 * k), std::floor(50 * std::sin(0.1 * k)));
    plain.add(k * T, counts);
    disturbed.add(k * T, counts);
    disturbed.add(k * T, {1e6, -1e6});
    disturbed.add((k - random.uniform(0.0, 5.0)) * T, {1e6, -1e6});
    disturbed.add((k + 0.5) * T, {NAN, INFINITY});
    disturbed.add(NAN, counts);
    disturbed.add(INFINITY, counts);
    ASSERT_EQ(plain.rate(), disturbed.rate()) << k;
  }
}

TEST(rate_estimator, loses_no_axis_to_another_that_is_no_number) {
  ph::rate_estimator<2> estimator;
  for (int k = 0; k < 50; ++k) estimator.add(k * T, {k < 10 ? 5.0 * k : NAN, 5.0 * k});
  EXPECT_NEAR(estimator.rate()[0], 5 / T, 1e-6) << "as it was";
  EXPECT_NEAR(estimator.rate()[1], 5 / T, 1e-6);
}

TEST(rate_estimator, starts_anew) {
  ph::rate_estimator<1> estimator;
  for (int k = 0; k < 50; ++k) estimator.add(k * T, one(5 * k));
  estimator.reset();
  EXPECT_EQ(estimator.rate()[0], 0);
  EXPECT_EQ(estimator.add(0.0, one(0))[0], 0) << "an earlier time is new";
  EXPECT_NEAR(estimator.add(T, one(7))[0], 7 / T, 1e-9);
}

// At a steady rate its sign is that of the motion; samples may be missing or late.
TEST(rate_estimator, agrees_with_a_window_that_is_tested_line_by_line_and_has_its_sign) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    random_source random(seed);
    const random_motion motion(random);
    const double missing = seed % 3 == 0 ? 0.3 : 0, late = seed % 3 == 1 ? 0.2 * T : 0;
    ph::rate_estimator<1> estimator;
    std::vector<std::pair<double, double>> y;
    for (int k = 0; k < 500; ++k) {
      const double now = k * T + random.uniform(-late, late), count = std::floor(motion(now));
      if (k > 100 && random.uniform(0.0, 1.0) < missing) continue;
      y.emplace_back(now, count);
      const double rate = estimator.add(now, one(count))[0];
      double moved = 0, span = 0;
      for (std::size_t n = 1; n < y.size() && n <= window; ++n) {
        const auto [t_n, y_n] = y[y.size() - 1 - n];
        const double slope = (count - y_n) / (now - t_n);
        bool fits = true;
        for (std::size_t i = 1; i < n; ++i) {
          const auto [t_i, y_i] = y[y.size() - 1 - i];
          fits &= std::abs(count - slope * (now - t_i) - y_i) <= 1 + 1e-9;
        }
        if (!fits) break;
        moved = count - y_n;
        span = now - t_n;
      }
      ASSERT_NEAR(estimator.span(0), span, 1e-12) << "seed " << seed << ", sample " << k;
      ASSERT_EQ(rate, std::abs(moved) > 1 ? moved / span : 0.0);
      ASSERT_TRUE(rate == 0 || sign(rate) == sign(motion(now) - motion(now - span))) << seed << ", " << k;
    }
  }
}

TEST(rate_estimator, has_the_bounds_of_its_formulas) {
  // Resolution 2, windows of 8 periods of 10 ms
  EXPECT_DOUBLE_EQ(ph::rate_dead_band(2, 8, 0.01), 25);
  EXPECT_DOUBLE_EQ(ph::rate_lag(2, 8, 0.01, 1), 0.04) << "half a window";
  EXPECT_DOUBLE_EQ(ph::rate_lag(2, 8, 0.01, 32 / 0.0024), 0.025) << "half of sqrt(0.0024 + 0.0001)";
  EXPECT_DOUBLE_EQ(ph::rate_onset(2, 8, 0.01, 3200), 0.07) << "two steps in 0.05 s";
  EXPECT_DOUBLE_EQ(ph::rate_onset(2, 8, 0.01, 200), 0.31) << "two steps in 0.2 s, which no window sees";
}

TEST(rate_estimator, has_no_rate_and_no_span_before_its_second_sample) {
  ph::rate_estimator<1> estimator({.resolution = 0.25});
  EXPECT_EQ(estimator.span(0), 0);
  EXPECT_EQ(estimator.add(3, one(7))[0], 0);
  EXPECT_EQ(estimator.span(0), 0);
  EXPECT_EQ(estimator.add(3.5, one(9))[0], 4);
  EXPECT_EQ(estimator.span(0), 0.5);
}

TEST(rate_estimator, complains_of_what_it_cannot_do) {
  EXPECT_EQ(validate(ph::rate_estimator_parameters{}), "");
  EXPECT_EQ(validate(ph::rate_estimator_parameters{.resolution = 0}),
            "resolution [counts] = 0: expected a finite number > 0");
  EXPECT_EQ(validate(ph::rate_estimator_parameters{.window = 0}),
            "window [periods] = 0: expected a whole number >= 1");
  EXPECT_THROW((ph::rate_estimator<1, 8>({.window = 9})), std::invalid_argument);
}

}  // namespace rate_estimator_tests
