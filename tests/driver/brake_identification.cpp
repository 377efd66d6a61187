// slow, optimised, together
// Constants of simulated brakes, found again on a simulated bench within the errors that are told.
#include "bench_samples.hpp"

#include <simulated_bench.hpp>

#include <passive_haptics/bench/bench_run.hpp>
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

#include <functional>

namespace brake_identification_tests {

using namespace bench_samples;
using example::simulated_bench;

constexpr double slope = 1.6;  // [N m/A]
constexpr std::array<std::uint64_t, 3> seeds{1, 2, 3};
double line(double current) { return slope * current; }
double steady(double) { return 2; }  // [rad/s]
double half(double) { return 0.5; }  // [A]
double up(double t) { return t < 0.1 ? 0 : 0.5; }
double down(double t) { return 0.5 - up(t); }

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

TEST_P(brake_identification, needs_one_sample_before_the_step) {
  const ph::delayed_brake<ph::coulomb_brake<double>> brake;
  for_each_seed([&](const auto& how) {
    samples all = record(brake, line, steady, up, 0.4, how);
    const auto stepped = std::ranges::find_if(all, [](const auto& s) { return s.current > 0; });
    ASSERT_GT(stepped - all.begin(), 1);
    all.erase(all.begin(), stepped - 1);
    const auto found = ph::fit_step_response(all);
    EXPECT_NEAR(found.before.value + found.change.value, slope * 0.5, 0.01);
    EXPECT_NEAR(found.deviation, how.noise, 0.2 * how.noise);
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

TEST_P(brake_identification, finds_drag) {
  ph::coulomb_brake<double> brake;
  brake.residual = {.strength = 0.01, .drag = 0.02};
  for_each_seed([&](const auto& how) {
    const auto rate = [](double t) { return 0.5 + t; };
    const auto means = ph::mean_over_windows(record(brake, line, rate, half, 10, how), 0.1);
    const auto found = ph::fit_viscous_friction(means);
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

// ---- the port

// A bench of two brakes and three torques at 1 kHz of its own time, whose every reading a test may spoil. Its
// second encoder turns by 3 counts a period through the wrap of a 16 bit counter.
struct bench_device {
  int period = 0, released = 0, waits = 0;
  ph::brake_currents<2> told{};
  std::function<void(bench_device&)> spoil = [](bench_device&) {};

  double now = 0;
  ph::port_sample<2> axes{0, 0, {0, 65530}, {true, true}};
  ph::port_sample<3> torque{0, 0, {0, 0, 7}, {true, true, true}};
  ph::port_status read = ph::port_status::ok, felt = ph::port_status::ok, taken = ph::port_status::ok;

  bool flows() const { return told[0] + told[1] != 0; }
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
    of->told = currents;
    return of->taken;
  }
  void release() noexcept {
    ++of->released;
    of->told = {};
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

double tenth(double) { return 0.1; }  // [A]

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
    const std::string error = error_of_the_test();
    EXPECT_GE(device.released, 1);
    return error;
  }
  // Without what all of them say.
  std::string error_of_the_test() {
    const std::string error = thrown_by([&] { record(tenth); });
    EXPECT_FALSE(device.flows());
    constexpr std::string_view end = ": the test ended, the brake is released";
    return error.ends_with(end) ? error.substr(0, error.size() - end.size()) : error + "!";
  }
};

TEST_F(record_on_bench, follows_a_counter_through_its_wrap_and_keeps_the_limit) {
  p.radians_per_count = 0.5;
  p.torque_per_unit = 2;
  p.torque_at_zero = 4;
  p.current_limit = 0.3;
  double other = 0;
  device.spoil = [&](bench_device& d) { other = std::max(other, d.told[0]); };
  const samples all = record([](double t) { return t > 0.01 ? 9 : -1; });
  ASSERT_EQ(all.size(), 21u);
  for (std::size_t k = 1; k < all.size(); ++k) {
    EXPECT_EQ(all[k].position - all[k - 1].position, 1.5);
    EXPECT_EQ(all[k].torque, 10);
  }
  EXPECT_EQ(all.front().current, 0);
  EXPECT_EQ(all.back().current, 0.3);
  EXPECT_EQ(other, 0) << "the other brake is released";
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
  const samples all = record(tenth);
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
  using status = ph::port_status;
  const auto expect = [&](const std::string& error, const std::function<void(bench_device&)>& spoil) {
    EXPECT_EQ(error_of(spoil), error);
  };
  expect("nothing!", [](bench_device&) {});
  expect("encoders: device lost", [](bench_device& d) { d.read = status::failed; });
  expect("force sensor: device lost", [](bench_device& d) { d.felt = status::failed; });
  expect("encoders: no sample", [](bench_device& d) { d.read = status::no_sample; });
  expect("force sensor: damaged samples", [](bench_device& d) { d.felt = status::bad_sample; });
  expect("brakes: the device takes no currents", [](bench_device& d) { d.taken = status::no_sample; });
  // Its clock stands still
  expect("encoders: samples too late", [](bench_device& d) { d.axes.time = 0.3; });
  expect("encoders: samples too late", [](bench_device& d) { d.axes.time = NAN; });
  expect("encoders: samples too late", [](bench_device& d) { d.axes.time -= 1e6; });
  expect("encoders: the same sample again and again", [](bench_device& d) { d.axes.sequence = 299; });
  expect("force sensor: the same sample again and again", [](bench_device& d) { d.torque.sequence = 299; });
  expect("encoder 2: NaN or infinity", [](bench_device& d) { d.axes.value[1] = NAN; });
  expect("force channel 3: NaN or infinity", [](bench_device& d) { d.torque.value[2] = NAN; });
  // The time of the loop stands still
  expect("the clock went back", [](bench_device& d) { d.now = 0.3; });
  expect("the clock went back", [](bench_device& d) { d.now = NAN; });
  expect("a cycle began far too late", [](bench_device& d) { d.now = d.axes.time = d.torque.time += 0.2; });
  p.max_reading = 7;
  expect("force channel 3: saturated", [](bench_device&) {});
}

// One bad count in each 100 is bridged, and loses none.
TEST_F(record_on_bench, goes_on_after_a_sample_that_is_none) {
  duration = 1;
  device.spoil = [](bench_device& d) {
    if (d.period % 100 == 50) d.axes.value[1] = NAN;
  };
  const samples all = record(tenth);
  ASSERT_EQ(all.size(), 991u);
  EXPECT_EQ(all.back().position - all.front().position, 3000);
}

// A sensor may be that slow, an encoder may not turn that fast.
TEST_F(record_on_bench, has_limits_of_its_own) {
  p.hold_over = 0.005;
  EXPECT_EQ(error_of([](bench_device& d) {
              d.felt = d.period % 10 == 0 ? ph::port_status::ok : ph::port_status::no_sample;
            }),
            "force sensor: no sample");
  p.hold_over = 0.02;
  p.max_rate = 500;  // and two counts
  EXPECT_EQ(error_of([](bench_device&) {}), "encoder 2: jumped");
}

// Before the first good sample no clock but the number of periods is known to go on.
TEST_F(record_on_bench, ends_where_no_good_sample_ever_comes) {
  p.max_missed = 20;
  for (const bool of_sensor : {false, true}) {
    device = {};
    device.spoil = [&](bench_device& d) { (of_sensor ? d.torque.time : d.axes.time) = -5; };
    EXPECT_EQ(error_of_the_test(),
              std::string(of_sensor ? "force sensor" : "encoders") + ": samples too late");
    EXPECT_EQ(device.waits, 21);
  }
}

TEST_F(record_on_bench, ends_on_the_clock_of_this_machine_whatever_the_samples_say) {
  duration = 0.001;
  device.spoil = [](bench_device& d) {
    usleep(10'000);
    d.now = d.axes.time = d.torque.time = 1e-6 * d.period;
    d.axes.value[1] = 0;
  };
  const std::string error = thrown_by([&] { record(tenth); });
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
  EXPECT_GE(ph::record_on_bench(port, sensor, p, 0.02, tenth, wait).back().time, 0.02);
}

TEST_F(record_on_bench, needs_a_brake_an_encoder_and_a_channel_that_are_there) {
  const auto error = [&](const ph::bench_parameters& wrong) {
    p = wrong;
    return thrown_by([&] { record(tenth); });
  };
  EXPECT_EQ(error({.brake = 2}), "brake = 2, expected 0 to 1");
  EXPECT_EQ(error({.brake = -1}), "brake = -1, expected 0 to 1");
  EXPECT_EQ(error({.encoder = 2}), "encoder = 2, expected 0 to 1");
  EXPECT_EQ(error({.channel = 3}), "channel = 3, expected 0 to 2");
  EXPECT_EQ(device.waits, 0) << "nothing was read";
}

}  // namespace brake_identification_tests
