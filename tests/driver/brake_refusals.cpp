// slow, optimised
// What no test of a brake can have found is refused by name, and no result is made of it.
#include <passive_haptics/bench/measured_brake.hpp>
#include <passive_haptics/bench/rate_sweep.hpp>
#include <passive_haptics/plant/random_numbers.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace ph = passive_haptics;
using samples = std::vector<ph::bench_sample>;
using means = std::vector<ph::rate_and_torque>;

constexpr auto exact = ph::sensor_noise::none;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// What f() says, without who says it; "nothing" where it returns.
template <class F>
std::string thrown_by(F&& f) {
  try {
    f();
  } catch (const std::invalid_argument& e) {
    return std::string(e.what()).substr(std::string("passive_haptics: ").size());
  }
  return "nothing";
}

// 1 s at 1 kHz with a step of the current up after 0.2 s, or down. torque(t, current), t after the step [s].
samples step(bool up, const std::function<double(double, double)>& torque) {
  samples all;
  for (int k = 0; k <= 1000; ++k) {
    const double t = 1e-3 * k, current = (k > 200) == up ? 1 : 0;
    all.push_back({t, current, 2 * t, torque(std::max(t - 0.2, 0.0), current)});
  }
  return all;
}
double rise(double t) { return 0.02 - 0.8 * std::expm1(-t / 0.03); }
double noise(std::mt19937_64& bits) { return 0.005 * ph::normal_number(bits); }

// A pause of 0.3 s, 2 s up to 1 A, 0.3 s there, 2 s down, at 1 kHz. torque(current).
samples ramp(const std::function<double(double)>& torque) {
  samples all;
  for (int k = 0; k <= 4800; ++k) {
    const double t = 1e-3 * k, current = std::clamp(std::min(t - 0.3, 4.6 - t) / 2, 0.0, 1.0);
    all.push_back({t, current, 2 * t, torque(current)});
  }
  return all;
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

const std::string or_none =
    ": read the sensor anew for each sample, or give sensor_noise::none where there is none";

// ---- a sensor that hangs

TEST(a_frozen_sensor, gives_no_time_constant_whatever_it_reads) {
  for (const double frozen : {-0.9, -0.001, 0.0, 0.001, 0.002, 0.1, 0.3, 0.7, 1e-9, 1e6}) {
    const samples all = step(true, [&](double, double) { return frozen; });
    ASSERT_NE(thrown_by([&] { ph::fit_step_response(all); }).find("torque of all samples [N m] = "),
              std::string::npos)
        << frozen;
    ASSERT_THROW(ph::fit_step_response(all, exact), std::invalid_argument) << frozen;
  }
  EXPECT_EQ(thrown_by([] { ph::fit_step_response(step(true, [](double, double) { return 0.25; })); }),
            "torque of all samples [N m] = 0.25, expected readings that differ" + or_none);
}

TEST(a_frozen_sensor, gives_no_curve) {
  const samples all = ramp([](double) { return 0.25; });
  EXPECT_EQ(thrown_by([&] { ph::fit_current_ramp(all); }),
            "torque of all samples before the ramp [N m] = 0.25, expected readings that differ" + or_none);
  EXPECT_EQ(thrown_by([&] { ph::fit_current_ramp(all, {}, exact); }),
            "ramp.rising[10] [N m] = 0.25, expected more than residual_torque: ramp up to a larger current");
}

TEST(a_frozen_sensor, gives_no_friction) {
  for (const std::string& error : sweep_errors(sweep([](double) { return 0.25; })))
    EXPECT_EQ(error, "torque of all means [N m] = 0.25, expected readings that differ" + or_none);
}

TEST(a_sensor_without_noise, is_declared) {
  const samples up = step(true, [](double t, double) { return rise(t); });
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
  const samples up = step(true, [](double t, double) { return bit * std::round(rise(t) / bit); });
  EXPECT_NEAR(ph::fit_step_response(up).time_constant.value, 0.03, 1e-6);
}

// ---- numbers that are none, and too few

TEST(a_number_that_is_none, among_means_is_named) {
  std::mt19937_64 bits(1);
  const means good = sweep([&](double w) { return 1 + 0.1 * w + noise(bits); });
  for (const std::string& error : sweep_errors(good)) EXPECT_EQ(error, "nothing");
  means one = good;
  one[7].torque = nan;
  for (const std::string& error : sweep_errors(one))
    EXPECT_EQ(error, "means[7].torque [N m] = nan, expected a finite number");
  one = good;
  one[7].rate = -std::numeric_limits<double>::infinity();
  for (const std::string& error : sweep_errors(one))
    EXPECT_EQ(error, "means[7].rate [rad/s] = -inf, expected a finite number");
  one = good;
  for (auto& mean : one) mean.torque *= 1e200;
  for (const std::string& error : sweep_errors(one))
    EXPECT_EQ(error,
              "sum of the squared residuals where a fit begins = inf, expected a finite number: give finite "
              "samples, in the units of the formula");
}

TEST(means_that_are_no_more_than_constants, determine_nothing) {
  std::mt19937_64 bits(1);
  const means all = sweep([&](double w) { return 1 + 0.1 * w + noise(bits); });
  const auto errors = [&](std::ptrdiff_t count) {
    return sweep_errors(means(all.begin(), all.begin() + count));
  };
  const auto too_few = [](int count, int constants) {
    return "samples of a fit = " + std::to_string(count) + ", expected more than its " +
           std::to_string(constants) + " constants: record longer or faster";
  };
  EXPECT_EQ(errors(2)[0], too_few(2, 2));
  EXPECT_EQ(errors(3)[0], "nothing");
  EXPECT_EQ(errors(4)[1], too_few(4, 4));
  EXPECT_EQ(errors(5)[1], "nothing");
  EXPECT_EQ(errors(3)[2], too_few(3, 3));
  EXPECT_EQ(errors(4)[2], "nothing");
}

TEST(a_loop, needs_a_ramp_and_a_step_needs_a_loop) {
  EXPECT_EQ(thrown_by([] { ph::fit_magnetorheological_loop({}); }),
            "ramp.max_current [A] = 0, expected > 0: record a ramp, and give its fit_current_ramp");
  std::mt19937_64 bits(1);
  const samples up = step(true, [&](double t, double) { return rise(t) + noise(bits); });
  EXPECT_EQ(thrown_by([&] { ph::fit_magnetorheological_step(up, {}); }),
            "loop.max_current [A] = 0, expected > 0: give the fit_magnetorheological_loop of a ramp");
}

// ---- signs and units

TEST(a_torque_of_the_wrong_sign, is_refused) {
  std::mt19937_64 bits(1);
  const auto up = [&](double t, double) { return -rise(t) + noise(bits); };
  const auto down = [&](double t, double) { return rise(t) + noise(bits); };
  const std::string fix = ": give torque_per_unit of the bench the other sign";
  const std::string rising = thrown_by([&] { ph::fit_step_response(step(true, up)); });
  EXPECT_TRUE(rising.starts_with("change of the torque [N m] = -0.799")) << rising;
  EXPECT_TRUE(rising.ends_with(", expected > 0 as the current rises" + fix)) << rising;
  const std::string falling = thrown_by([&] { ph::fit_step_response(step(false, down)); });
  EXPECT_TRUE(falling.ends_with(", expected < 0 as the current falls" + fix)) << falling;
  const std::string of_ramp =
      thrown_by([&] { ph::fit_current_ramp(ramp([&](double I) { return -0.02 - I + noise(bits); })); });
  EXPECT_TRUE(of_ramp.starts_with("ramp.rising[10] [N m] = -1.0")) << of_ramp;
  EXPECT_TRUE(of_ramp.ends_with(", expected more than residual_torque" + fix)) << of_ramp;
  for (const std::string& error : sweep_errors(sweep([&](double w) { return -1 - 0.1 * w + noise(bits); }))) {
    EXPECT_TRUE(error.starts_with("mean torque against the turn [N m] = -1.52")) << error;
    EXPECT_TRUE(error.ends_with(", expected >= 0" + fix)) << error;
  }
}

TEST(no_torque_at_all, is_neither_of_the_wrong_sign_nor_below_zero) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 bits(seed);
    EXPECT_EQ(sweep_errors(sweep([&](double) { return noise(bits); }))[0], "nothing") << seed;
    const auto found = ph::fit_current_ramp(ramp([&](double I) { return I + noise(bits); }));
    EXPECT_EQ(validate(found.curve()), "") << seed;
  }
}

TEST(a_torque_below_zero, is_refused) {
  std::mt19937_64 bits(1);
  const std::string error =
      thrown_by([&] { ph::fit_current_ramp(ramp([&](double I) { return I - 0.1 + noise(bits); })); });
  EXPECT_TRUE(error.starts_with("ramp.residual_torque [N m] = -0.1")) << error;
  EXPECT_TRUE(error.ends_with(", expected >= 0: set torque_at_zero of the bench while nothing pulls"))
      << error;
}

TEST(a_torque_that_falls_at_last, is_refused) {
  std::mt19937_64 bits(1);
  const std::string error = thrown_by(
      [&] { ph::fit_current_ramp(ramp([&](double I) { return std::min(I, 1.5 - I) + noise(bits); })); });
  EXPECT_TRUE(error.starts_with("ramp.rising[10] [N m] = 0.5")) << error;
  EXPECT_TRUE(error.ends_with(": ramp up to where the torque still rises, and let the brake cool before"))
      << error;
}

TEST(a_brake_that_is_saturated, has_a_curve_that_can_be) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
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
            "torque of all samples near 0.7 A [N m] = 0.55, expected readings that differ" + or_none);
}

TEST(milliseconds, are_no_seconds) {
  std::mt19937_64 bits(1);
  samples all = step(true, [&](double t, double) { return rise(t) + noise(bits); });
  const double seconds = ph::fit_step_response(all).time_constant.value;
  EXPECT_NEAR(seconds, 0.03, 0.001);
  for (auto& s : all) s.time *= 1000;
  EXPECT_EQ(thrown_by([&] { ph::fit_step_response(all); }),
            "mean time between two samples [s] = 1, expected at most 0.2: give times in seconds, not "
            "milliseconds, or record faster");
  // Of a bench so fast that this does not show
  samples quick;
  for (int k = 0; k <= 10000; ++k) {
    const double t = 0.1 * k;
    quick.push_back({t, k > 2000 ? 1.0 : 0.0, 2 * t, rise(std::max(1e-3 * t - 0.2, 0.0)) + noise(bits)});
  }
  const std::string error = thrown_by([&] { ph::fit_step_response(quick); });
  EXPECT_TRUE(error.starts_with("time constant [s] = ")) << error;
  EXPECT_TRUE(
      error.ends_with("expected at most 5: give the times of the samples in seconds, not milliseconds"))
      << error;
}

}  // namespace
