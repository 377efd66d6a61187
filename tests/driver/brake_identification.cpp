// slow, optimised
// Constants of simulated brakes, found again on a simulated bench within the errors that are told.
#include <simulated_bench.hpp>

#include <passive_haptics/bench/bench_run.hpp>
#include <passive_haptics/bench/current_ramp.hpp>
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

#include <unistd.h>

#include <algorithm>
#include <functional>

namespace {

namespace ph = passive_haptics;
using samples = std::vector<ph::bench_sample>;
using example::simulated_bench;

constexpr double slope = 1.6;  // [N m/A]
constexpr std::array<std::uint64_t, 8> seeds{1, 2, 3, 4, 5, 6, 7, 8};
double line(double current) { return slope * current; }
double steady(double) { return 2; }  // [rad/s]

// What the bench records of a brake.
template <class Model, class Command, class Rate, class Current>
samples record(const Model& brake, Command command, Rate rate, Current current, double duration,
               const example::simulated_bench_parameters& how) {
  const auto bench = std::make_shared<simulated_bench<Model>>(brake, command, rate, how);
  example::simulated_bench_port<Model> port{bench};
  example::simulated_torque_sensor<Model> sensor{bench};
  ph::bench_parameters p;
  p.radians_per_count = how.resolution;
  return ph::record_on_bench(port, sensor, p, duration, current, [&] { return bench->wait(); });
}

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
    const auto up = ph::fit_step_response(
        record(brake, line, steady, [](double t) { return t < 0.1 ? 0.0 : 0.5; }, 0.4, how));
    expect_found(up.before, 0.034, 0.03 * share, "before");
    expect_found(up.change, 0.8, 0.001 * share, "change");
    expect_found(up.time_constant, 0.02, 0.01 * share, "time constant");
    expect_found(up.dead_time, 0.004, 0.03 * share, "dead time");
    EXPECT_NEAR(up.deviation, how.noise, 0.2 * how.noise);
    const auto down = ph::fit_step_response(
        record(brake, line, steady, [](double t) { return t < 0.1 ? 0.5 : 0.0; }, 0.6, how));
    expect_found(down.change, -0.8, 0.001 * share, "change");
    expect_found(down.time_constant, 0.05, 0.01 * share, "time constant");
    expect_found(down.dead_time, 0.004, 0.04 * share, "dead time");
  });
}

TEST_P(brake_identification, needs_one_sample_before_the_step) {
  const ph::delayed_brake<ph::coulomb_brake<double>> brake;
  for_each_seed([&](const auto& how) {
    samples all = record(brake, line, steady, [](double t) { return t < 0.1 ? 0.0 : 0.5; }, 0.4, how);
    const auto stepped = std::ranges::find_if(all, [](const auto& s) { return s.current > 0; });
    ASSERT_GT(stepped - all.begin(), 1);
    all.erase(all.begin(), stepped - 1);
    const auto up = ph::fit_step_response(all);
    EXPECT_NEAR(up.before.value + up.change.value, slope * 0.5, 0.01);
    EXPECT_NEAR(up.deviation, how.noise, 0.2 * how.noise);
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

// Rises from 0.1 N m at 0 A to 1.1 N m at 2 A, in steps that are surer than their error of 0.01 N m.
ph::current_ramp measured_ramp() {
  ph::current_ramp ramp;
  ramp.max_current = 2;
  ramp.residual_torque = {0.1, 0.01};
  for (std::size_t i = 0; i < ramp.rising.size(); ++i)
    ramp.rising[i] = {0.1 + 0.1 * static_cast<double>(i), 0.01};
  ramp.hysteresis = {0.25, 0.01};
  return ramp;
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

// Exact samples of torque = 0.25 + I up, and 0.25 + I + apart(I) down, with 1 s for 1 A.
ph::current_ramp exact_ramp(double (*apart)(double)) {
  samples all;
  for (int k = 0; k <= 2600; ++k) {
    const double t = 1e-3 * k, I = std::clamp(std::min(t - 0.25, 2.5 - t), 0.0, 1.0);
    all.push_back({t, I, 2 * t, 0.25 + I + (t > 1.3 ? apart(I) : 0)});
  }
  return ph::fit_current_ramp(all, {}, ph::sensor_noise::none);
}

TEST(a_measured_ramp, has_the_hysteresis_of_the_current_where_it_is_widest) {
  const auto found = exact_ramp([](double I) { return 0.25 * (1 - I); });
  EXPECT_EQ(found.max_current, 1);
  EXPECT_NEAR(found.residual_torque.value, 0.25, 1e-12);
  EXPECT_NEAR(found.rising[3].value, 0.55, 1e-3);
  EXPECT_NEAR(found.falling[4].value, 0.8, 1e-3);
  EXPECT_NEAR(found.hysteresis.value, 0.25, 1e-3) << "at 0 A";
  EXPECT_NEAR(exact_ramp([](double I) { return I * (1 - I); }).hysteresis.value, 0.25, 2e-3) << "half-way";
  EXPECT_NEAR(exact_ramp([](double) { return -0.125; }).hysteresis.value, 0, 1e-3)
      << "at the greatest current, where the branches meet";
}

// ---- sweeps

TEST_P(brake_identification, finds_stribeck_effect_and_drag) {
  ph::stribeck_brake<double> brake;
  brake.coulomb.residual = {.strength = 0.01, .drag = 0.003};
  const auto rate = [](double t) { return 0.02 * std::pow(500, t / 40); };  // to 10 rad/s
  for_each_seed([&](const auto& how) {
    const auto means =
        ph::mean_over_windows(record(brake, line, rate, [](double) { return 0.5; }, 40, how), 0.5);
    const auto found = ph::fit_stribeck_friction(means);
    const double share = GetParam().share;
    expect_found(found.strength, 0.81, 0.01 * share, "strength");
    expect_found(found.static_ratio, 1 + 0.4 / 0.81, 0.02 * share, "static ratio");
    expect_found(found.stribeck_rate, 0.05, 0.04 * share, "Stribeck rate");
    EXPECT_LT(found.deviation, ph::fit_viscous_friction(means).deviation);
  });
}

TEST_P(brake_identification, finds_drag) {
  ph::coulomb_brake<double> brake;
  brake.residual = {.strength = 0.01, .drag = 0.02};
  for_each_seed([&](const auto& how) {
    const auto found = ph::fit_viscous_friction(ph::mean_over_windows(
        record(brake, line, [](double t) { return 0.5 + t; }, [](double) { return 0.5; }, 10, how), 0.1));
    expect_found(found.strength, 0.81, 0.001 * GetParam().share, "strength");
    expect_found(found.drag, 0.02, 0.01 * GetParam().share, "drag");
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

// ---- what is not to be believed

// 1 s at 1 kHz, turned at 2 rad/s, with a step of the current to `current` half-way.
samples step_to(double current, double torque) {
  samples all;
  for (int k = 0; k <= 1000; ++k) {
    const double t = 1e-3 * k, since = std::max(t - 0.5, 0.0);
    all.push_back({t, k > 500 ? current : 0, 2 * t, 0.01 * (k % 2) + torque * -std::expm1(-since / 0.02)});
  }
  return all;
}

// What f() says, without who says it.
template <class F>
std::string thrown_by(F&& f) {
  constexpr std::string_view library = "passive_haptics: ";
  try {
    f();
  } catch (const std::exception& e) {
    const std::string_view text = e.what();
    return std::string(text.starts_with(library) ? text.substr(library.size()) : text);
  }
  return "nothing";
}
std::string step_error(const samples& all) {
  return thrown_by([&] { ph::fit_step_response(all); });
}

TEST(brake_identification_errors, name_what_is_wrong_with_samples_of_a_step) {
  EXPECT_EQ(step_error(step_to(1, 1)), "nothing");
  EXPECT_EQ(step_error({}), "samples = 0, expected at least 20: record longer or faster");
  samples all = step_to(1, 1);
  all[3].torque = NAN;
  EXPECT_EQ(step_error(all), "samples[3].torque [N m] = nan, expected a finite number");
  all = step_to(1, 1);
  all[0].current = -1;
  EXPECT_EQ(step_error(all), "samples[0].current [A] = -1, expected a finite number >= 0");
  all = step_to(1, 1);
  all[4].time = all[3].time;
  EXPECT_EQ(step_error(all), "samples[4].time [s] = 0.003, expected more than that of the sample before");
  all = step_to(1, 1);
  for (auto& s : all) s.position = std::min(s.position, 1.3);
  EXPECT_EQ(step_error(all),
            "way [rad] from 0.7 s to 0.8 s = 0, expected > 0 throughout: turn the axis faster, or by a motor "
            "that is stronger than the brake");
  EXPECT_EQ(step_error(step_to(0, 1)),
            "steps of the current = 0, expected 1: record one up and one down, apart");
  all = step_to(1, 1);
  all.back().current = 0;
  EXPECT_EQ(step_error(all), "steps of the current = 2, expected 1: record one up and one down, apart");
  EXPECT_NE(step_error(step_to(1, 1e-5)).find("a step beyond the noise: step to a larger current"),
            std::string::npos);
  all = step_to(1, 1);
  all.resize(560);
  EXPECT_NE(step_error(all).find("expected at least t_d + 5 T"), std::string::npos) << step_error(all);
}

TEST(brake_identification_errors, name_what_is_wrong_with_samples_of_a_ramp) {
  const auto ramp_of = [](double max_current, double pause) {
    samples all;
    for (int k = 0; k <= 2000; ++k) {
      const double t = 1e-3 * k, I = max_current * std::clamp(std::min(t - pause, 2 - t), 0.0, 0.9);
      all.push_back({t, I, 2 * t, I + 0.001 * (k % 2)});
    }
    return all;
  };
  const auto error = [](const samples& all, const ph::ramp_delay& delay = {}) {
    return thrown_by([&] { ph::fit_current_ramp(all, delay); });
  };
  EXPECT_EQ(error(ramp_of(1, 0.2)), "nothing");
  EXPECT_EQ(error(ramp_of(0, 0.2)), "greatest current [A] = 0, expected > 0: ramp up");
  EXPECT_EQ(error(ramp_of(1, -0.1)),
            "samples at 0 A before the ramp = 0, expected at least 8: begin with a pause at 0 A");
  EXPECT_EQ(error(ramp_of(1, 0.2), {.rising = 0.09}),
            "delay over the time of the ramp = 0.1, expected less than 0.02: ramp more slowly");
  EXPECT_EQ(error(ramp_of(1, 0.2), {.falling = -1}), "falling [s] = -1, expected a finite number >= 0");
  samples all = ramp_of(1, 0.2);
  all.resize(1300);
  EXPECT_NE(error(all).find("ramp more slowly, and up to the same current and down to 0"), std::string::npos);
}

TEST(brake_identification_errors, name_what_is_wrong_with_samples_of_a_sweep) {
  const auto error = [](const samples& all, double duration) {
    return thrown_by([&] { ph::mean_over_windows(all, duration); });
  };
  EXPECT_EQ(error(step_to(0, 1), 0.1), "nothing");
  EXPECT_EQ(error(step_to(0, 1), 0), "duration [s] = 0, expected a finite number > 0");
  EXPECT_EQ(error(step_to(0, 1), 0.3), "windows = 3, expected at least 8: record longer, or shorter windows");
  EXPECT_EQ(
      error(step_to(1, 1), 0.1),
      "samples[501].current [A] = 1, expected that of the first: a sweep of the rate is at one current");
  const std::vector<ph::rate_and_torque> still(10);
  EXPECT_EQ(thrown_by([&] { ph::fit_viscous_friction(still); }),
            "fastest rate [rad/s] = 0, expected > 0: turn the axis, slowly and fast");
}

// ---- the port

// A bench of two brakes and three torques at 1 kHz of its own time, whose every reading a test may spoil. Its
// second encoder turns by 3 counts a period through the wrap of a 16 bit counter.
struct bench_device {
  int period = 0, released = 0, waits = 0;
  std::vector<double> told;
  std::function<void(bench_device&)> spoil = [](bench_device&) {};

  double now = 0;
  ph::port_sample<2> axes{0, 0, {0, 65530}, {true, true}};
  ph::port_sample<3> torque{0, 0, {0, 0, 7}, {true, true, true}};
  ph::port_status read = ph::port_status::ok, felt = ph::port_status::ok, taken = ph::port_status::ok;

  bool flows() const { return !told.empty() && told[0] + told[1] != 0; }
  double wait() {
    if (++waits > 1'000'000) throw std::logic_error("the test does not end");
    ++period;
    now = axes.time = torque.time = 1e-3 * period;
    axes.sequence = torque.sequence = static_cast<std::uint32_t>(period);
    axes.value[1] = (65530 + 3 * period) % 65536;
    spoil(*this);
    return now;
  }
};
struct bench_device_port {
  static constexpr int encoder_count = 2, brake_count = 2;
  bench_device* of;
  std::string open() { return {}; }
  ph::port_status read(ph::port_sample<2>& s) noexcept {
    s = of->axes;
    return of->read;
  }
  ph::port_status write(const ph::brake_currents<2>& currents) noexcept {
    of->told = {currents[0], currents[1]};
    return of->taken;
  }
  void release() noexcept {
    ++of->released;
    of->told = {0, 0};
  }
  int counter_bits() const noexcept { return 16; }
};
struct bench_device_sensor {
  static constexpr int channel_count = 3;
  bench_device* of;
  std::string open() { return {}; }
  ph::port_status read(ph::port_sample<3>& s) noexcept {
    s = of->torque;
    return of->felt;
  }
};

struct record_on_bench : ::testing::Test {
  bench_device device;
  ph::bench_parameters p{.brake = 1, .encoder = 1, .channel = 2, .settling_time = 0};
  double duration = 0.02;

  template <class Current>
  samples record(const Current& current) {
    bench_device_port port{&device};
    bench_device_sensor sensor{&device};
    samples all = ph::record_on_bench(port, sensor, p, duration, current, [this] { return device.wait(); });
    EXPECT_FALSE(device.flows());
    return all;
  }
  // What is thrown where every period is spoilt so, from the 300th on.
  std::string error_of(const std::function<void(bench_device&)>& spoil) {
    device = {};
    device.spoil = [spoil](bench_device& d) {
      if (d.period >= 300) spoil(d);
    };
    duration = 1;
    const std::string error = thrown_by([&] { record([](double) { return 0.1; }); });
    EXPECT_FALSE(device.flows());
    EXPECT_GE(device.released, 1);
    return error;
  }
};

TEST_F(record_on_bench, follows_a_counter_through_its_wrap_and_keeps_the_limit) {
  p.radians_per_count = 0.5;
  p.torque_per_unit = 2;
  p.torque_at_zero = 4;
  p.current_limit = 0.3;
  std::vector<double> others;
  device.spoil = [&](bench_device& d) {
    if (!d.told.empty()) others.push_back(d.told[0]);
  };
  const samples all = record([](double t) { return t > 0.01 ? 9 : -1; });
  ASSERT_EQ(all.size(), 21u);
  for (std::size_t k = 1; k < all.size(); ++k) {
    EXPECT_EQ(all[k].position - all[k - 1].position, 1.5);
    EXPECT_EQ(all[k].torque, 10);
  }
  EXPECT_EQ(all.front().current, 0);
  EXPECT_EQ(all.back().current, 0.3);
  EXPECT_EQ(others, std::vector<double>(others.size(), 0.0)) << "the other brake is released";
}

TEST_F(record_on_bench, gives_no_current_for_what_is_none) {
  for (const double none : {double(NAN), -1.0, -double(INFINITY)}) {
    device = {};
    for (const auto& s : record([none](double) { return none; })) EXPECT_EQ(s.current, 0);
  }
}

TEST_F(record_on_bench, records_where_port_and_sensor_have_something_new_that_is_valid) {
  p.max_missed = 2;
  duration = 0.03;
  device.spoil = [](bench_device& d) {
    d.felt = d.period % 3 == 0 ? ph::port_status::ok : ph::port_status::no_sample;
    d.axes.valid[0] = d.torque.valid[1] = false;  // of no matter here
  };
  const samples all = record([](double) { return 0.1; });
  ASSERT_EQ(all.size(), 11u);
  for (std::size_t k = 0; k < 11; ++k) EXPECT_NEAR(all[k].time, 0.003 * static_cast<double>(k), 1e-12);
  EXPECT_EQ(device.waits, 33) << "before each read";
}

TEST_F(record_on_bench, lets_the_brake_settle_under_the_first_current) {
  p.settling_time = 0.0095;
  double earliest = 1;
  const samples all = record([&](double t) {
    earliest = std::min(earliest, t);
    return t > 0 ? 0.2 : 0.7;
  });
  EXPECT_EQ(earliest, 0);
  EXPECT_NEAR(all.front().time, 0.0005, 1e-12);
  EXPECT_EQ(all[0].current, 0.7);
  EXPECT_EQ(all[1].current, 0.2);
  EXPECT_EQ(all[0].position, 65563) << "counts, past wraps";
}

TEST_F(record_on_bench, ends_with_the_brakes_released_and_the_name_of_what_was_wrong) {
  const std::string ended = ": the test ended, the brake is released";
  EXPECT_EQ(error_of([](bench_device&) {}), "nothing");
  EXPECT_EQ(error_of([](bench_device& d) { d.read = ph::port_status::failed; }),
            "encoders: device lost" + ended);
  EXPECT_EQ(error_of([](bench_device& d) { d.felt = ph::port_status::failed; }),
            "force sensor: device lost" + ended);
  EXPECT_EQ(error_of([](bench_device& d) { d.read = ph::port_status::no_sample; }),
            "encoders: no sample" + ended);
  EXPECT_EQ(error_of([](bench_device& d) { d.felt = ph::port_status::bad_sample; }),
            "force sensor: damaged samples" + ended);
  EXPECT_EQ(error_of([](bench_device& d) { d.taken = ph::port_status::no_sample; }),
            "brakes: the device takes no currents" + ended);
  EXPECT_EQ(error_of([](bench_device& d) { d.axes.time = 0.3; }), "encoders: samples too late" + ended)
      << "its clock stands still";
  EXPECT_EQ(error_of([](bench_device& d) { d.axes.time = NAN; }), "encoders: samples too late" + ended);
  EXPECT_EQ(error_of([](bench_device& d) { d.axes.time -= 1e6; }), "encoders: samples too late" + ended);
  EXPECT_EQ(error_of([](bench_device& d) { d.axes.sequence = 299; }),
            "encoders: the same sample again and again" + ended);
  EXPECT_EQ(error_of([](bench_device& d) { d.torque.sequence = 299; }),
            "force sensor: the same sample again and again" + ended);
  EXPECT_EQ(error_of([](bench_device& d) { d.axes.value[1] = NAN; }), "encoder 2: NaN or infinity" + ended);
  EXPECT_EQ(error_of([](bench_device& d) { d.torque.value[2] = NAN; }),
            "force channel 3: NaN or infinity" + ended);
  EXPECT_EQ(error_of([](bench_device& d) { d.now = 0.3; }), "the clock went back" + ended)
      << "the time of the loop stands still";
  EXPECT_EQ(error_of([](bench_device& d) { d.now = NAN; }), "the clock went back" + ended);
  EXPECT_EQ(error_of([](bench_device& d) { d.now = d.axes.time = d.torque.time += 0.2; }),
            "a cycle began far too late" + ended);
  p.max_reading = 7;
  EXPECT_EQ(error_of([](bench_device&) {}), "force channel 3: saturated" + ended);
}

// One bad count in each 100 is bridged, and loses none.
TEST_F(record_on_bench, goes_on_after_a_sample_that_is_none) {
  duration = 1;
  device.spoil = [](bench_device& d) {
    if (d.period % 100 == 50) d.axes.value[1] = NAN;
  };
  const samples all = record([](double) { return 0.1; });
  ASSERT_EQ(all.size(), 991u);
  EXPECT_EQ(all.back().position - all.front().position, 3000);
}

// A sensor may be that slow, an encoder may not turn that fast.
TEST_F(record_on_bench, has_limits_of_its_own) {
  p.hold_over = 0.005;
  EXPECT_EQ(error_of([](bench_device& d) {
              if (d.period % 10 != 0) d.felt = ph::port_status::no_sample;
              else d.felt = ph::port_status::ok;
            }),
            "force sensor: no sample: the test ended, the brake is released");
  p.hold_over = 0.02;
  p.max_rate = 500;  // and two counts
  EXPECT_EQ(error_of([](bench_device&) {}), "encoder 2: jumped: the test ended, the brake is released");
}

// Before the first good sample no clock but the number of periods is known to go on.
TEST_F(record_on_bench, ends_where_no_good_sample_ever_comes) {
  p.max_missed = 20;
  for (const bool of_sensor : {false, true}) {
    device = {};
    device.spoil = [&](bench_device& d) { (of_sensor ? d.torque.time : d.axes.time) = -5; };
    EXPECT_EQ(thrown_by([&] { record([](double) { return 0.1; }); }),
              std::string(of_sensor ? "force sensor" : "encoders") +
                  ": samples too late: the test ended, the brake is released");
    EXPECT_EQ(device.waits, 21);
    EXPECT_FALSE(device.flows());
  }
}

TEST_F(record_on_bench, ends_on_the_clock_of_this_machine_whatever_the_samples_say) {
  duration = 0.001;
  device.spoil = [](bench_device& d) {
    usleep(10'000);
    d.now = d.axes.time = d.torque.time = 1e-6 * d.period;
    d.axes.value[1] = 0;
  };
  const std::string error = thrown_by([&] { record([](double) { return 0.1; }); });
  EXPECT_TRUE(error.starts_with("time of the test on this machine's clock [s] = ")) << error;
  EXPECT_TRUE(error.ends_with(
      ", expected at most 1.001: check the clock of the samples, and whether the machine was suspended"))
      << error;
  EXPECT_FALSE(device.flows());
}

// A wait that returns nothing: the samples have times of CLOCK_MONOTONIC.
TEST_F(record_on_bench, takes_the_clock_of_this_machine_where_the_wait_names_none) {
  bench_device_port port{&device};
  bench_device_sensor sensor{&device};
  const auto wait = [this] {
    usleep(500);
    device.wait();
    device.axes.time = device.torque.time = ph::monotonic_seconds();
  };
  EXPECT_GE(ph::record_on_bench(port, sensor, p, 0.02, [](double) { return 0.1; }, wait).back().time, 0.02);
}

TEST_F(record_on_bench, needs_a_brake_an_encoder_and_a_channel_that_are_there) {
  const auto error = [&](const ph::bench_parameters& wrong) {
    p = wrong;
    return thrown_by([&] { record([](double) { return 0.1; }); });
  };
  EXPECT_EQ(error({.brake = 2}), "brake = 2, expected 0 to 1");
  EXPECT_EQ(error({.brake = -1}), "brake = -1, expected 0 to 1");
  EXPECT_EQ(error({.encoder = 2}), "encoder = 2, expected 0 to 1");
  EXPECT_EQ(error({.channel = 3}), "channel = 3, expected 0 to 2");
  EXPECT_EQ(device.waits, 0) << "nothing was read";
}

}  // namespace
