// slow, optimised, together
// Constants of simulated brakes, found again on a simulated bench within the errors that are told.
#include "bench_samples.hpp"

#include <passive_haptics/bench/magnetorheological_loop.hpp>
#include <passive_haptics/bench/rate_sweep.hpp>
#include <passive_haptics/bench/step_response.hpp>
#include <passive_haptics/driver/calibration/brake_calibration.hpp>
#include <passive_haptics/plant/brakes/coulomb_brake.hpp>
#include <passive_haptics/plant/brakes/delayed_brake.hpp>
#include <passive_haptics/plant/brakes/eddy_current_brake.hpp>
#include <passive_haptics/plant/brakes/magnetorheological_brake.hpp>
#include <passive_haptics/plant/brakes/stribeck_brake.hpp>

#include <gtest/gtest.h>

namespace brake_identification_tests {

using namespace bench_samples;

constexpr double slope = 1.6;  // [N m/A]
constexpr std::array<std::uint64_t, 3> seeds{1, 2, 3};
double line(double current) { return slope * current; }
double steady(double) { return 2; }  // [rad/s]
double half(double) { return 0.5; }  // [A]
double up(double t) { return t < 0.1 ? 0 : 0.5; }
double down(double t) { return 0.5 - up(t); }

// Within four of its standard errors, which are at most `share` of it.
void expect_found(const ph::estimate& found, double truth, double share, const char* what) {
  EXPECT_LE(std::abs(found.value - truth), 4 * found.standard_error) << what << " = " << found.value;
  EXPECT_LE(found.standard_error, share * std::abs(truth)) << what;
}

// A fine and a coarse bench.
struct bench_case {
  const char* name;
  double resolution, noise, share;
};
struct brake_identification : ::testing::TestWithParam<bench_case> {
  template <class Test>
  void for_each_seed(Test&& test) {
    for (const std::uint64_t seed : seeds) {
      SCOPED_TRACE(::testing::Message() << "seed " << seed);
      example::simulated_bench_parameters how;
      how.resolution = GetParam().resolution;
      how.noise = GetParam().noise;
      how.seed = seed;
      test(how);
    }
  }
};
constexpr double turn = 2 * std::numbers::pi;
INSTANTIATE_TEST_SUITE_P(at_a, brake_identification,
                         ::testing::Values(bench_case{"fine_bench", turn / 8192, 0.005, 1},
                                           bench_case{"coarse_bench", turn / 1000, 0.02, 4}),
                         [](const auto& one) { return one.param.name; });

// ---- steps

TEST_P(brake_identification, finds_time_constants_up_and_down_and_the_dead_time) {
  ph::delayed_brake<ph::coulomb_brake<double>> brake;
  brake.model.fall_ratio = 2.5;
  brake.dead_time = 0.004;
  brake.model.residual = {.strength = 0.03, .drag = 0.002};
  for_each_seed([&](const auto& how) {
    const double share = GetParam().share;
    const auto rise = ph::fit_step_response(record(brake, line, steady, up, 0.4, how));
    expect_found(rise.before, 0.034, 0.03 * share, "before");
    expect_found(rise.change, 0.8, 0.001 * share, "change");
    expect_found(rise.time_constant, 0.02, 0.01 * share, "time constant");
    expect_found(rise.dead_time, 0.004, 0.03 * share, "dead time");
    EXPECT_NEAR(rise.deviation, how.noise, 0.2 * how.noise);
    const auto fall = ph::fit_step_response(record(brake, line, steady, down, 0.6, how));
    expect_found(fall.change, -0.8, 0.001 * share, "change");
    expect_found(fall.time_constant, 0.05, 0.01 * share, "time constant");
    expect_found(fall.dead_time, 0.004, 0.04 * share, "dead time");
  });
}

// ---- ramps

// 0.5 s of pause, 5 s up, 0.5 s there, 5 s down
double ramp(double t) { return 0.16 * std::clamp(std::min(t - 0.5, 11 - t), 0.0, 5.0); }
constexpr double ramp_time = 11.2, greatest = 0.8;

TEST_P(brake_identification, takes_a_lag_for_no_hysteresis) {
  ph::coulomb_brake<double> brake;
  brake.torque_limit = 2;
  brake.fall_ratio = 2;
  brake.residual = {.strength = 0.03};
  for_each_seed([&](const auto& how) {
    const samples all = record(brake, line, steady, ramp, ramp_time, how);
    const auto found = ph::fit_current_ramp(all, {.rising = 0.02, .falling = 0.04});
    expect_found(found.residual_torque, 0.03, 0.02 * GetParam().share, "residual torque");
    for (std::size_t i = 1; i < found.rising.size(); ++i) {
      const double torque = 0.03 + slope * greatest * static_cast<double>(i) / 10;
      expect_found(found.rising[i], torque, 0.003 * GetParam().share, "rising");
      expect_found(found.falling[i], torque, 0.003 * GetParam().share, "falling");
    }
    EXPECT_LE(found.hysteresis.value, 4 * found.hysteresis.standard_error);
    const double lag_as_hysteresis = 0.16 * slope * (0.02 + 0.04);
    EXPECT_NEAR(ph::fit_current_ramp(all).hysteresis.value, lag_as_hysteresis, 0.5 * lag_as_hysteresis);
  });
}

TEST_P(brake_identification, finds_the_loop_of_a_magnetorheological_brake) {
  ph::magnetorheological_brake<double> brake;
  brake.torque_limit = 2;
  brake.saturation = 1.5;
  brake.coercive_current = 0.05;
  brake.residual = {.strength = 0.02};
  const auto told = [&](double current) { return brake.torque_of(std::min(current / greatest, 1.0)); };
  const auto up = [](double t) { return t < 0.1 ? 0 : greatest; };
  const auto down = [](double t) { return t < 0.1 ? greatest : 0; };
  for_each_seed([&](const auto& how) {
    const double share = GetParam().share;
    const samples rise = record(brake, told, steady, up, 0.4, how);
    const samples fall = record(brake, told, steady, down, 0.4, how);
    const samples all = record(brake, told, steady, ramp, ramp_time, how);

    EXPECT_GT(ph::fit_step_response(fall).deviation, 1.01 * how.noise) << "no first-order lag";
    const auto [loop, rising, falling, found] = ph::fit_magnetorheological_brake(rise, fall, all);
    for (const auto& step : {rising, falling}) {
      expect_found(step.time_constant, brake.time_constant, 0.01 * share, "time constant");
      EXPECT_LE(std::abs(step.dead_time.value), 4 * step.dead_time.standard_error);
      EXPECT_NEAR(step.deviation, how.noise, 0.2 * how.noise);
    }
    samples late = rise;  // each torque comes four samples later
    for (std::size_t k = late.size(); k-- > 4;) late[k].torque = rise[k - 4].torque;
    const auto dead_time = ph::fit_magnetorheological_step(late, loop).dead_time;
    EXPECT_NEAR(dead_time.value, late[4].time - late[0].time, 1e-4 + 4 * dead_time.standard_error);
    expect_found(loop.torque_limit, 2, 0.0002 * share, "torque limit");
    expect_found(loop.saturation, 1.5, 0.0005 * share, "saturation");
    expect_found(loop.coercive_current, 0.05, 0.001 * share, "coercive current");
    expect_found(loop.residual_torque, 0.02, 0.02 * share, "residual torque");
    // Its widest, between f(j - c) and f(j + c), is at 1 of the 11 points
    EXPECT_NEAR(found.hysteresis.value, told(greatest * 0.15) - told(greatest * 0.05), 0.003 * share);

    // The driver's curve makes what the brake makes on its way up
    const ph::brake_curve curve = found.curve();
    ASSERT_EQ(validate(curve), "");
    for (const double current : {0.1, 0.35, 0.7})
      EXPECT_NEAR(torque_of_current(curve, current), 0.02 + told(current - greatest * 0.05), 0.006 * share);
  });
}

// ---- sweeps

TEST_P(brake_identification, finds_stribeck_effect_and_drag) {
  ph::stribeck_brake<double> brake;
  brake.coulomb.residual = {.strength = 0.01, .drag = 0.003};
  const auto rate = [](double t) { return 0.02 * std::pow(500, t / 40); };  // to 10 rad/s
  for_each_seed([&](const auto& how) {
    const auto means = ph::mean_over_windows(record(brake, line, rate, half, 40, how), 0.5);
    const auto found = ph::fit_stribeck_friction(means);
    const double share = GetParam().share;
    expect_found(found.strength, 0.81, 0.01 * share, "strength");
    expect_found(found.static_ratio, 1 + 0.4 / 0.81, 0.02 * share, "static ratio");
    expect_found(found.stribeck_rate, 0.05, 0.04 * share, "Stribeck rate");
    EXPECT_LT(found.deviation, ph::fit_viscous_friction(means).deviation);
  });
}

TEST_P(brake_identification, tells_eddy_currents_by_a_torque_that_falls_beyond_a_rate) {
  ph::eddy_current_brake<double> brake;
  brake.peak_torque = 1.2;
  brake.critical_rate = 12;
  brake.residual = {.strength = 0.02};
  for_each_seed([&](const auto& how) {
    const auto sweep = [&](double fastest) {
      const auto rate = [fastest](double t) { return 0.05 * fastest + fastest * t / 10; };
      const auto current = [](double) { return 1 / slope; };
      return ph::mean_over_windows(record(brake, line, rate, current, 10, how), 0.1);
    };
    const double share = GetParam().share;
    const auto means = sweep(20);
    const auto found = ph::fit_eddy_current_torque(means);
    expect_found(found.strength, 0.02, 0.03 * share, "strength");
    expect_found(found.drag, 2.0 / 12, 0.002 * share, "drag");
    expect_found(found.critical_rate, 12, 0.002 * share, "critical rate");
    expect_found(found.peak_torque, 1, 0.002 * share, "peak torque");
    EXPECT_LT(found.deviation, 0.1 * ph::fit_viscous_friction(means).deviation);
    EXPECT_LT(found.deviation, 0.5 * ph::fit_stribeck_friction(means).deviation);
    // From low rates it is drag, and the critical rate is not told
    const auto slow = ph::fit_eddy_current_torque(sweep(0.5));
    EXPECT_LE(std::abs(slow.drag.value - 2.0 / 12), 4 * slow.drag.standard_error);
    EXPECT_TRUE(std::isinf(slow.critical_rate.value) && std::isinf(slow.peak_torque.standard_error));
  });
}

}  // namespace brake_identification_tests
