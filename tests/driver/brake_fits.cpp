// slow, together
// Samples of one formula without noise: a fit finds its constants, in any unit, from any clock and in any
// order.
#include "bench_samples.hpp"

#include <passive_haptics/bench/rate_sweep.hpp>
#include <passive_haptics/bench/step_response.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace brake_fits_tests {

using namespace bench_samples;

// ---- steps

// Up or down, as the torque changes.
struct exact_step {
  double before = 0.03, change = 0.8;               // [N m]
  double time_constant = 0.02, dead_time = 0.0045;  // [s]
  double begin = 0;                                 // of the clock [s]

  // 0.5 s, with a step of the current after 0.1 s.
  std::vector<ph::bench_sample> samples() const {
    return at_1_khz(
        500, [&](int k) { return (k > 100) == (change > 0) ? 1.0 : 0.0; },
        [&](int k, double) {
          const double since = std::max(1e-3 * k - 0.1 - dead_time, 0.0);
          return before + change * -std::expm1(-since / time_constant);
        },
        begin);
  }
};

void expect_found(const exact_step& one) {
  const auto found = ph::fit_step_response(one.samples(), exact);
  EXPECT_NEAR(found.before.value, one.before, 1e-4 * std::abs(one.change));
  EXPECT_NEAR(found.change.value, one.change, 1e-4 * std::abs(one.change));
  EXPECT_NEAR(found.time_constant.value, one.time_constant, 1e-4 * one.time_constant);
  EXPECT_NEAR(found.dead_time.value, one.dead_time, 1e-4 * one.dead_time);
}

TEST(a_step_response, is_found_in_any_unit_over_any_torque_on_any_clock_late_or_slow) {
  for (const double unit : {1e-9, 1e-6, 1.0, 1e6})
    expect_found({.before = 0.03 * unit, .change = 0.8 * unit});
  for (const double change : {0.5, -0.5}) expect_found({.before = 40, .change = change});
  expect_found({.begin = 4096});
  expect_found({.time_constant = 0.004, .dead_time = 0.1505});
  for (const double time_constant : {0.03, 0.05, 0.07})
    for (const double dead_time : {0.0002, 0.02, 0.045})
      expect_found({.time_constant = time_constant, .dead_time = dead_time});
}

TEST(a_step_response, needs_one_sample_before_the_step) {
  const auto all = exact_step{}.samples();
  const auto found = ph::fit_step_response(std::span(all).subspan(100), exact);
  EXPECT_NEAR(found.before.value + found.change.value, 0.83, 1e-6);
  EXPECT_NEAR(found.time_constant.value, 0.02, 1e-5);
}

// From a single start one of these is missed, whichever it is: the dead time has a kink in the formula.
TEST(a_step_response, may_be_quicker_than_the_samples) {
  for (const auto& [time_constant, dead_time] : {std::pair(0.0005984, 0.003974),
                                                 {0.0003498, 0.00714},
                                                 {0.0003477, 0.006519},
                                                 {0.0004499, 0.04423},
                                                 {0.0004776, 0.01289},
                                                 {0.0005896, 0.01405}}) {
    const exact_step quick{.time_constant = time_constant, .dead_time = dead_time};
    const auto found = ph::fit_step_response(quick.samples(), exact);
    EXPECT_LT(found.deviation, 1e-6) << time_constant << ' ' << dead_time;
  }
}

// More than it will be in the end, at once: the area between the end and the way there is negative.
TEST(a_step_response, may_overshoot) {
  auto all = exact_step{.time_constant = 0.0005, .dead_time = 0.0015}.samples();
  for (std::size_t k = 103; k < all.size(); ++k)
    all[k].torque += 0.1 * std::exp(-(all[k].time - 0.103) / 0.1);
  const auto found = ph::fit_step_response(all, exact);
  EXPECT_NEAR(found.change.value, 0.8, 0.1);
  EXPECT_LT(found.time_constant.value + found.dead_time.value, 0.005);
}

TEST(a_step_response, is_told_from_noise_by_five_standard_errors_of_the_last_fifth) {
  // 80 samples, 0.005 N m to either side
  const double least = 5 * 0.005 / std::sqrt(80);
  const auto fit = [](double change) {
    auto all = exact_step{.change = change}.samples();
    for (std::size_t k = 0; k < all.size(); ++k) all[k].torque += k % 2 == 0 ? 0.005 : -0.005;
    ph::fit_step_response(all);
  };
  for (const double sign : {1.0, -1.0}) {
    EXPECT_NO_THROW(fit(sign * 1.1 * least));
    EXPECT_THROW(fit(sign * 0.9 * least), std::invalid_argument);
  }
}

// ---- standard errors

// s^2 = sum_ij f_i f_j C_ij, f_i the derivatives of f.
TEST(a_curve_fit, tells_the_standard_error_of_what_follows) {
  ph::curve_fit<2> fit;
  fit.value = {2, 3};
  fit.covariance = ph::matrix_of<2, 2>(0.04, 0.01, 0.01, 0.09);
  const ph::estimate product = fit.of([](const auto& p) { return p[0] * p[1]; });
  EXPECT_DOUBLE_EQ(product.value, 6);
  EXPECT_DOUBLE_EQ(product.standard_error, std::sqrt(9 * 0.04 + 2 * 3 * 2 * 0.01 + 4 * 0.09));
  EXPECT_EQ(fit[0].value, 2);
  EXPECT_DOUBLE_EQ(fit[0].standard_error, 0.2);
  EXPECT_DOUBLE_EQ(fit[1].standard_error, 0.3);
}

// ---- ramps

// A period of 1 ms: a pause, up from 0.25 s to 2 A at 1.25 s, down from 1.5 s to 0 A at 2.5 s, a pause.
double ramp(int k) { return 0.002 * std::clamp(std::min(k - 250, 2500 - k), 0, 1000); }
bool is_within(int k, int corner, int width) { return k > corner && k < corner + width; }
samples line_of_ramp(int last) {
  return at_1_khz(last, ramp, [](int, double I) { return 1 + I; });
}

TEST(a_ramp_with_a_lag, leaves_out_what_is_bent_by_it_after_each_corner) {
  constexpr double way_up = 1, way_down = 5, bent = 100;  // beside 1 N m for each of 2 A [N m]
  constexpr int after_rise = 54, after_fall = 108;        // six delays [ms]
  std::ptrdiff_t straight = 0;
  const samples all = at_1_khz(2800, ramp, [&](int k, double I) {
    const bool is_bent = is_within(k, 250, after_rise) || is_within(k, 1250, after_rise) ||
                         is_within(k, 1500, after_fall) || is_within(k, 2500, after_fall);
    if (k > 250 && !is_bent) ++straight;
    return I + (is_bent ? bent : k > 1500 ? way_down : way_up);
  });
  const auto found = ph::fit_current_ramp(all, {.rising = 0.0090001, .falling = 0.0180001}, exact);
  for (const auto& s : found.samples) {
    ASSERT_LT(s.torque, bent) << s.current;
    ASSERT_EQ(s.torque >= way_down, s.falling) << s.current;
  }
  // The end of each stretch belongs to it within rounding of its time
  EXPECT_NEAR(static_cast<double>(std::ssize(found.samples) - straight), 0, 4);
  EXPECT_NEAR(found.hysteresis.value, way_down - way_up, 0.1);
}

TEST(a_ramp_with_a_lag, takes_fifty_of_the_longer_delay_at_least) {
  samples all = line_of_ramp(2800);
  const auto fit = [&](double rising, double falling) {
    ph::fit_current_ramp(all, {rising, falling}, exact);
  };
  EXPECT_NO_THROW(fit(0.0199, 0));
  EXPECT_NO_THROW(fit(0, 0.0199));
  EXPECT_THROW(fit(0.0201, 0), std::invalid_argument);
  EXPECT_THROW(fit(0, 0.0201), std::invalid_argument);
}

TEST(a_bench, turns_its_axis_from_the_first_sample_to_the_last) {
  const auto all = exact_step{}.samples();
  EXPECT_NO_THROW(ph::require_turning(all, 10));
  for (const std::size_t part : {0u, 3u, 9u}) {
    auto still = all;
    for (std::size_t k = 50 * part; k <= 50 * (part + 1); ++k) still[k].position = all[50 * part].position;
    EXPECT_THROW(ph::require_turning(still, 10), std::invalid_argument) << part;
  }
}

TEST(a_ramp_without_a_lag, is_read_up_to_its_last_sample_and_no_further) {
  samples all = line_of_ramp(2600);
  all.push_back({2.601, 50, 5.202, 0});
  const auto found = ph::fit_current_ramp(std::span(all).first(2601), {}, exact);
  EXPECT_EQ(found.samples.size(), 2600u - 251) << "of the last one nobody knows when its current ends";
  for (const auto& s : found.samples) ASSERT_LE(s.current, 2);
}

TEST(a_ramp_without_a_lag, takes_a_current_for_held_over_the_period_before_its_sample) {
  const auto torque = [](int k, double I) { return (I + ramp(k + 1)) / 2; };
  const samples all = at_1_khz(2800, ramp, torque, 100);  // on a clock that began long ago
  const auto found = ph::fit_current_ramp(all, {}, exact);
  EXPECT_NEAR(found.rising[5].value, 1, 1e-9);
  EXPECT_NEAR(found.falling[5].value, 1, 1e-9);
}

TEST(a_ramp_without_a_lag, tells_the_residual_torque_from_the_whole_pause) {
  samples all = line_of_ramp(2600);
  // The last two samples at 0 A
  all[249].torque += 62.75;
  all[250].torque += 62.75;
  EXPECT_NEAR(ph::fit_current_ramp(all, {}, exact).residual_torque.value, 1.5, 1e-9);
}

TEST(a_measured_ramp, becomes_a_curve_of_the_points_that_rise_beyond_doubt) {
  ph::current_ramp ramp = measured_ramp();
  ph::brake_curve curve = ramp.curve();
  EXPECT_EQ(validate(curve), "");
  EXPECT_EQ(curve.points, 11);
  EXPECT_EQ(curve.residual_torque, 0.1);
  EXPECT_EQ(curve.current_limit, 2);
  EXPECT_EQ(curve.hysteresis, 0.25);
  for (std::size_t i = 0; i < 11; ++i) {
    EXPECT_DOUBLE_EQ(curve.table[i].current, 0.2 * static_cast<double>(i));
    EXPECT_DOUBLE_EQ(curve.table[i].torque, 0.1 + 0.1 * static_cast<double>(i));
  }

  ramp.rising[1].value = 0.12;   // within three errors of the point before it
  ramp.rising[2].value = 0.125;  // and so is this
  ramp.rising[3].value = 0.135;
  ramp.rising[9].value = 1.09;
  ramp.hysteresis.value = -0.01;
  curve = ramp.curve();
  EXPECT_EQ(validate(curve), "");
  EXPECT_EQ(curve.hysteresis, 0) << "noise";
  ASSERT_EQ(curve.points, 9);
  EXPECT_DOUBLE_EQ(curve.table[1].current, 0.6);
  EXPECT_EQ(curve.table[1].torque, 0.135);
  EXPECT_DOUBLE_EQ(curve.table[7].current, 1.8);
  EXPECT_DOUBLE_EQ(curve.table[8].current, 2) << "the last one, so that there is torque for the limit";
  EXPECT_DOUBLE_EQ(curve.table[8].torque, 1.1);
}

// Exact samples of torque = 0.25 + i up, and 0.25 + i + apart(i) down, i from 0 to 1 of the largest current.
ph::current_ramp exact_ramp(double (*apart)(double)) {
  const samples all =
      at_1_khz(2600, ramp, [&](int k, double I) { return 0.25 + I / 2 + (k > 1300 ? apart(I / 2) : 0); });
  return ph::fit_current_ramp(all, {}, exact);
}

TEST(a_measured_ramp, has_the_hysteresis_of_the_current_where_it_is_widest) {
  const auto found = exact_ramp([](double i) { return 0.25 * (1 - i); });
  EXPECT_EQ(found.max_current, 2);
  EXPECT_NEAR(found.residual_torque.value, 0.25, 1e-12);
  EXPECT_NEAR(found.rising[3].value, 0.55, 1e-3);
  EXPECT_NEAR(found.falling[4].value, 0.8, 1e-3);
  EXPECT_NEAR(found.hysteresis.value, 0.25, 1e-3) << "at 0 A";
  EXPECT_NEAR(exact_ramp([](double i) { return i * (1 - i); }).hysteresis.value, 0.25, 2e-3) << "half-way";
  EXPECT_NEAR(exact_ramp([](double) { return -0.125; }).hysteresis.value, 0, 1e-3)
      << "at the greatest current, where the branches meet";
}

// ---- sweeps

TEST(windows, are_of_samples_that_can_be) {
  samples all = at_1_khz(100, [](int) { return 1.0; }, [](int, double) { return 2.0; });
  EXPECT_EQ(ph::mean_over_windows(all, 0.00995).size(), 10u);
  all[50].torque = NAN;
  EXPECT_THROW(ph::mean_over_windows(all, 0.01), std::invalid_argument);
  EXPECT_THROW(ph::mean_over_windows(std::span(all).first(1), 0.01), std::invalid_argument);
}

// From 20 rad/s to rest, one way round or both in turn.
template <class Torque>
std::vector<ph::rate_and_torque> sweep_to_rest(bool both, const Torque& torque) {
  std::vector<ph::rate_and_torque> means;
  for (int k = 100; k >= 0; --k) {
    const double w = 0.2 * k, sign = both && k % 2 == 1 ? -1 : 1;
    means.push_back({sign * w, sign * torque(w)});
  }
  return means;
}

TEST(a_sweep_of_the_rate, may_end_at_rest_and_turn_either_way) {
  for (const bool both : {false, true}) {
    SCOPED_TRACE(both);
    const auto viscous =
        ph::fit_viscous_friction(sweep_to_rest(both, [](double w) { return 0.3 + 0.02 * w; }), exact);
    EXPECT_NEAR(viscous.strength.value, 0.3, 1e-9);
    EXPECT_NEAR(viscous.drag.value, 0.02, 1e-9);
    const auto eddy = ph::fit_eddy_current_torque(
        sweep_to_rest(both, [](double w) { return w / (6 + w * w / 24); }), exact);
    EXPECT_NEAR(eddy.strength.value, 0, 1e-6);
    EXPECT_NEAR(eddy.drag.value, 1.0 / 6, 1e-6);
    EXPECT_NEAR(eddy.critical_rate.value, 12, 1e-4);
    EXPECT_NEAR(eddy.peak_torque.value, 1, 1e-6);
  }
}

TEST(eddy_currents, are_found_whatever_part_of_the_curve_is_swept) {
  for (const double critical_rate : {0.06, 0.2, 0.5, 1.5, 5.0, 20.0, 60.0})
    for (const double friction : {0.0, 0.3, 3.0}) {
      const auto torque = [&](double w) {
        const double x = w / critical_rate;
        return friction + 2 * x / (1 + x * x);
      };
      const auto found = ph::fit_eddy_current_torque(sweep_to_rest(true, torque), exact);
      SCOPED_TRACE(testing::Message() << critical_rate << ' ' << friction);
      EXPECT_LT(found.deviation, 1e-6);
      EXPECT_NEAR(found.critical_rate.value, critical_rate, 1e-4 * critical_rate);
      EXPECT_NEAR(found.peak_torque.value, 1, 1e-4);
    }
}

// ---- any formula

TEST(a_curve_fit, is_infinitely_unsure_of_a_constant_that_no_sample_tells) {
  const std::array<double, 4> samples{1, 2, 4, 5};
  const auto fit = ph::fit_curve<2>(samples, {0, 7}, []<class S>(double s, const ph::vector<S, 2>& p) -> S {
    return p[0] + 0.0 * p[1] - s;
  });
  EXPECT_NEAR(fit[0].value, 3, 1e-9);
  EXPECT_EQ(fit[1].value, 7) << "where it began";
  EXPECT_TRUE(std::isinf(fit[1].standard_error));
}

}  // namespace brake_fits_tests
