// slow, together
// Impossible results of a test of a brake are rejected by name, and no result is made of them.
#include "bench_samples.hpp"

#include <passive_haptics/bench/measured_brake.hpp>
#include <passive_haptics/bench/rate_sweep.hpp>
#include <passive_haptics/plant/random_numbers.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>

namespace brake_refusals_tests {

using namespace bench_samples;
using means = std::vector<ph::rate_and_torque>;

// 1 s with a step of the current up after 0.2 s, or down; t after the step [s].
samples step(bool up, const std::function<double(double t)>& torque) {
  return at_1_khz(
      1000, [&](int k) { return (k > 200) == up ? 1.0 : 0.0; },
      [&](int k, double) { return torque(std::max(1e-3 * k - 0.2, 0.0)); });
}
double rise(double t) { return 0.02 - 0.8 * std::expm1(-t / 0.03); }
double noise(std::mt19937_64& bits) { return 0.005 * ph::normal_number(bits); }

samples noisy_step() {
  std::mt19937_64 bits(1);
  return step(true, [&](double t) { return rise(t) + noise(bits); });
}

// A pause of 0.3 s, 2 s up to 1 A, 0.3 s there, 2 s down; torque(current).
samples ramp(const std::function<double(double)>& torque) {
  return at_1_khz(
      4800, [](int k) { return std::clamp(std::min(k - 300, 4600 - k) / 2000.0, 0.0, 1.0); },
      [&](int, double I) { return torque(I); });
}
// The error of its fit, with noise.
std::string ramp_error(const std::function<double(double)>& torque) {
  std::mt19937_64 bits(1);
  return thrown_by([&] { ph::fit_current_ramp(ramp([&](double I) { return torque(I) + noise(bits); })); });
}

// Means of 20 rates up to 10 rad/s.
means sweep(const std::function<double(double)>& torque) {
  means all;
  for (int k = 1; k <= 20; ++k) all.push_back({0.5 * k, torque(0.5 * k)});
  return all;
}

// The error of each of the three fits.
std::vector<std::string> sweep_errors(const means& of, ph::sensor_noise noise = ph::sensor_noise::present) {
  return {thrown_by([&] { ph::fit_viscous_friction(of, noise); }),
          thrown_by([&] { ph::fit_stribeck_friction(of, noise); }),
          thrown_by([&] { ph::fit_eddy_current_torque(of, noise); })};
}

means noisy_sweep(const std::function<double(double)>& torque) {
  std::mt19937_64 bits(1);
  return sweep([&](double w) { return torque(w) + noise(bits); });
}

void expect_within(const std::string& text, const std::string& begin, const std::string& end) {
  EXPECT_TRUE(text.starts_with(begin) && text.ends_with(end)) << text;
}

const std::string or_none =
    ": read the sensor again for each sample, or pass sensor_noise::none for one without noise";

// ---- a sensor that hangs

TEST(a_frozen_sensor, gives_no_result_whatever_it_reads) {
  for (const double frozen : {-0.9, 0.0, 1e-9, 1e6}) {
    const samples all = step(true, [&](double) { return frozen; });
    expect_within(thrown_by([&] { ph::fit_step_response(all); }),
                  "torque of all samples [N m] = ", ": expected readings that differ" + or_none);
    ASSERT_THROW(ph::fit_step_response(all, exact), std::invalid_argument) << frozen;
  }
  const samples all = ramp([](double) { return 0.25; });
  EXPECT_EQ(thrown_by([&] { ph::fit_current_ramp(all); }),
            "torque of all samples before the ramp [N m] = 0.25: expected readings that differ" + or_none);
  EXPECT_EQ(thrown_by([&] { ph::fit_current_ramp(all, {}, exact); }),
            "ramp.rising[10] [N m] = 0.25: expected more than residual_torque: ramp up to a larger current");
  for (const std::string& error : sweep_errors(sweep([](double) { return 0.25; })))
    EXPECT_EQ(error, "torque of all means [N m] = 0.25: expected readings that differ" + or_none);
}

TEST(a_sensor_without_noise, is_declared) {
  const samples up = step(true, rise);
  EXPECT_NE(thrown_by([&] { ph::fit_step_response(up); }).find("noise of the samples [N m] = "),
            std::string::npos);
  EXPECT_NEAR(ph::fit_step_response(up, exact).time_constant.value, 0.03, 1e-6);
  const means exact_sweep = sweep([](double w) { return 0.5 + 0.1 * w; });
  for (const std::string& error : sweep_errors(exact_sweep))
    EXPECT_NE(error.find("noise of the means [N m] = "), std::string::npos) << error;
  const auto found = ph::fit_viscous_friction(exact_sweep, exact);
  EXPECT_NEAR(found.drag.value, 0.1, 1e-12);
  EXPECT_LT(found.drag.standard_error, 1e-12);
  EXPECT_EQ(sweep_errors(sweep([](double) { return 0.5; }), exact)[0], "nothing") << "Coulomb friction";
}

TEST(a_sensor_of_24_bits, has_noise) {
  constexpr double bit = 2.0 / (1 << 24);
  const samples up = step(true, [](double t) { return bit * std::round(rise(t) / bit); });
  EXPECT_NEAR(ph::fit_step_response(up).time_constant.value, 0.03, 1e-6);
}

// ---- numbers that are none, and too few

TEST(a_number_that_is_none, among_means_is_named) {
  const auto expect = [](const std::function<void(means&)>& spoil, const std::string& expected) {
    means all = noisy_sweep([](double w) { return 1 + 0.1 * w; });
    spoil(all);
    for (const std::string& error : sweep_errors(all)) EXPECT_EQ(error, expected);
  };
  expect([](means&) {}, "nothing");
  expect([](means& all) { all[7].torque = NAN; }, "means[7].torque [N m] = nan: expected a finite number");
  expect([](means& all) { all[7].rate = -INFINITY; },
         "means[7].rate [rad/s] = -inf: expected a finite number");
  expect(
      [](means& all) {
        for (auto& mean : all) mean.torque *= 1e200;
      },
      "sum of the squared residuals where a fit begins = inf: expected a finite number: pass finite "
      "samples, in the units of the formula");
}

TEST(means_that_are_no_more_than_constants, determine_nothing) {
  const means all = noisy_sweep([](double w) { return 1 + 0.1 * w; });
  const auto expect = [&](std::size_t fit, int constants) {
    const auto error = [&](int count) { return sweep_errors(means(all.begin(), all.begin() + count))[fit]; };
    const std::string number = std::to_string(constants);
    EXPECT_EQ(error(constants), "samples of a fit = " + number + ": expected more than its " + number +
                                    " constants: record longer or faster");
    EXPECT_EQ(error(constants + 1), "nothing");
  };
  expect(0, 2);
  expect(1, 4);
  expect(2, 3);
}

TEST(a_loop, needs_a_ramp_and_a_step_needs_a_loop) {
  EXPECT_EQ(thrown_by([] { ph::fit_magnetorheological_loop({}); }),
            "ramp.max_current [A] = 0: expected > 0: record a ramp, and pass its fit_current_ramp");
  EXPECT_EQ(thrown_by([] { ph::fit_magnetorheological_step(noisy_step(), {}); }),
            "loop.max_current [A] = 0: expected > 0: pass the fit_magnetorheological_loop of a ramp");
}

// ---- signs and units

TEST(a_torque_of_the_wrong_sign, is_refused) {
  const std::string fix = ": change the sign of torque_per_unit of the bench";
  for (const bool up : {true, false}) {
    std::mt19937_64 bits(1);
    const samples all = step(up, [&](double t) { return (up ? -rise(t) : rise(t)) + noise(bits); });
    expect_within(thrown_by([&] { ph::fit_step_response(all); }), "change of the torque [N m] = ",
                  (up ? ": expected > 0 as the current rises" : ": expected < 0 as the current falls") + fix);
  }
  expect_within(ramp_error([](double I) { return -0.02 - I; }), "ramp.rising[10] [N m] = -1.0",
                ": expected more than residual_torque" + fix);
  for (const std::string& error : sweep_errors(noisy_sweep([](double w) { return -1 - 0.1 * w; })))
    expect_within(error, "mean torque against the turn [N m] = -1.52", ": expected >= 0" + fix);
}

TEST(no_torque_at_all, is_neither_of_the_wrong_sign_nor_below_zero) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    std::mt19937_64 bits(seed);
    EXPECT_EQ(sweep_errors(sweep([&](double) { return noise(bits); }))[0], "nothing") << seed;
    const auto found = ph::fit_current_ramp(ramp([&](double I) { return I + noise(bits); }));
    EXPECT_EQ(validate(found.curve()), "") << seed;
  }
}

TEST(a_torque_that_is_below_zero_or_falls_at_last, is_refused) {
  expect_within(ramp_error([](double I) { return I - 0.1; }), "ramp.residual_torque [N m] = -0.1",
                ": expected >= 0: set torque_at_zero of the bench while no load acts");
  expect_within(
      ramp_error([](double I) { return std::min(I, 1.5 - I); }), "ramp.rising[10] [N m] = 0.5",
      ", the maximum, which was at a lower current: ramp up only as long as the torque rises, and let "
      "the brake cool first");
}

TEST(a_brake_that_is_saturated, has_a_curve_that_can_be) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    std::mt19937_64 bits(seed);
    const auto found = ph::fit_current_ramp(ramp([&](double I) { return std::min(I, 0.5) + noise(bits); }));
    const ph::brake_curve curve = found.curve();
    EXPECT_EQ(validate(curve), "") << seed;
    EXPECT_NEAR(torque_of_current(curve, 0.4), 0.4, 0.005) << seed;
    EXPECT_NEAR(torque_of_current(curve, 0.8), 0.5, 0.005) << seed;
  }
}

TEST(a_sensor_that_is_saturated, gives_no_curve) {
  std::mt19937_64 bits(1);
  const auto clipped = [&](double I) { return std::min(I + noise(bits), 0.55); };
  EXPECT_EQ(thrown_by([&] { ph::fit_current_ramp(ramp(clipped)); }),
            "torque of all samples near 0.7 A [N m] = 0.55: expected readings that differ" + or_none);
}

TEST(milliseconds, are_no_seconds) {
  samples all = noisy_step();
  const double seconds = ph::fit_step_response(all).time_constant.value;
  EXPECT_NEAR(seconds, 0.03, 0.001);
  for (auto& s : all) s.time *= 1000;
  EXPECT_EQ(thrown_by([&] { ph::fit_step_response(all); }),
            "mean time between two samples [s] = 1: expected at most 0.2: pass times in seconds, not "
            "milliseconds, or record faster");
  // Of a bench so fast that this does not show
  std::mt19937_64 bits(1);
  samples quick = at_1_khz(
      10000, [](int k) { return k > 2000 ? 1.0 : 0.0; },
      [&](int k, double) { return rise(std::max(1e-4 * k - 0.2, 0.0)) + noise(bits); });
  for (auto& s : quick) s.time *= 100;
  expect_within(thrown_by([&] { ph::fit_step_response(quick); }), "time constant [s] = ",
                "expected at most 5: pass the times of the samples in seconds, not milliseconds");
}

// ---- samples of each test

TEST(brake_identification_errors, name_what_is_wrong_with_samples_of_a_step) {
  struct row {
    void (*spoil)(samples&);
    const char *begin, *end = "";
  };
  for (const auto& [spoil, begin, end] : {
           row{[](auto&) {}, "nothing"},
           row{[](auto& all) { all = {}; }, "samples = 0: expected at least 20: record longer or faster"},
           row{[](auto& all) { all[3].torque = NAN; },
               "samples[3].torque [N m] = nan: expected a finite number"},
           row{[](auto& all) { all[0].current = -1; },
               "samples[0].current [A] = -1: expected a finite number >= 0"},
           row{[](auto& all) { all[4].time = all[3].time; },
               "samples[4].time [s] = 0.003: expected more than that of the sample before"},
           row{[](auto& all) {
                 for (auto& s : all) s.position = std::min(s.position, 1.3);
               },
               "way [rad] from 0.7 s to 0.8 s = 0: expected > 0 throughout: turn the axis faster, or by a "
               "motor "
               "that is stronger than the brake"},
           row{[](auto& all) {
                 for (auto& s : all) s.current = 0;
               },
               "steps of the current = 0: expected 1: record the step up and the step down separately"},
           row{[](auto& all) { all.back().current = 0; },
               "steps of the current = 2: expected 1: record the step up and the step down separately"},
           row{[](auto& all) {
                 for (auto& s : all) s.torque = 0.01 * (std::lround(1e3 * s.time) % 2);
               },
               "change of the torque [N m] = ", "a step above the noise: step to a larger current"},
           row{[](auto& all) { all.resize(290); }, "record after the step [s] = 0.08", ": record longer"},
       }) {
    samples all = noisy_step();
    spoil(all);
    expect_within(thrown_by([&] { ph::fit_step_response(all); }), begin, end);
  }
}

TEST(brake_identification_errors, name_what_is_wrong_with_samples_of_a_ramp) {
  const auto ramp_of = [](double max_current, int pause) {
    return at_1_khz(
        2000, [&](int k) { return max_current * std::clamp(1e-3 * std::min(k - pause, 2000 - k), 0.0, 0.9); },
        [](int k, double I) { return I + 0.001 * (k % 2); });
  };
  const auto error = [](const samples& all, const ph::ramp_delay& delay = {}) {
    return thrown_by([&] { ph::fit_current_ramp(all, delay); });
  };
  EXPECT_EQ(error(ramp_of(1, 200)), "nothing");
  EXPECT_EQ(error(ramp_of(0, 200)), "greatest current [A] = 0: expected > 0: ramp up");
  EXPECT_EQ(error(ramp_of(1, -100)),
            "samples at 0 A before the ramp = 0: expected at least 8: begin with a pause at 0 A");
  EXPECT_EQ(error(ramp_of(1, 200), {.rising = 0.09}),
            "delay over the time of the ramp = 0.1: expected less than 0.02: ramp more slowly");
  EXPECT_EQ(error(ramp_of(1, 200), {.falling = -1}), "falling [s] = -1: expected a finite number >= 0");
  samples all = ramp_of(1, 200);
  all.resize(1300);
  expect_within(error(all), "samples near ", "ramp more slowly, and up to the same current and down to 0");
}

TEST(brake_identification_errors, name_what_is_wrong_with_samples_of_a_sweep) {
  const auto error = [](double highest, double duration) {
    const samples all =
        at_1_khz(1000, [&](int k) { return k > 500 ? highest : 0; }, [](int, double) { return 1.0; });
    return thrown_by([&] { ph::mean_over_windows(all, duration); });
  };
  EXPECT_EQ(error(0, 0.1), "nothing");
  EXPECT_EQ(error(0, 0), "duration [s] = 0: expected a finite number > 0");
  EXPECT_EQ(error(0, 0.3), "windows = 3: expected at least 8: record longer, or shorter windows");
  EXPECT_EQ(error(1, 0.1),
            "samples[501].current [A] = 1: expected that of the first: record the sweep at one current");
  EXPECT_EQ(sweep_errors(means(10))[0],
            "fastest rate [rad/s] = 0: expected > 0: turn the axis, slowly and fast");
}

}  // namespace brake_refusals_tests
