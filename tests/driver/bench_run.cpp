// slow, together
// A test on a bench records what its brake does, and ends with the brake released, whatever goes wrong.
#include "bench_samples.hpp"
#include "fake_device.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

namespace bench_run_tests {

using namespace bench_samples;

// A bench of two brakes and three torques at 1 kHz of its own time, whose every reading a test may spoil. Its
// second encoder turns by 3 counts a period through the wrap of a 16 bit counter.
struct bench_device : fake::device {
  bench_device() {
    counter_bits = 16;
    sample.value[1] = 65530;
    force.value[2] = 7;
  }

  int period = 0, waits = 0;
  double now = 0;
  std::function<void(bench_device&)> spoil = [](bench_device&) {};

  double wait() {
    if (++waits > 1'000'000) throw std::logic_error("the test does not end");
    ++period;
    now = sample.time = force.time = 1e-3 * period;
    sample.sequence = force.sequence = static_cast<std::uint32_t>(period);
    sample.value[1] = (65530 + 3 * period) % 65536;
    spoil(*this);
    return now;
  }
};

double tenth(double) { return 0.1; }  // [A]

struct record_on_bench : ::testing::Test {
  bench_device device;
  ph::bench_parameters p{.brake = 1, .encoder = 1, .channel = 2, .settling_time = 0};
  double duration = 0.02;

  template <class Current>
  samples record(const Current& current) {
    fake::port port{&device};
    fake::sensor sensor{&device};
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
    EXPECT_GE(device.releases, 1);
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
  device.spoil = [&](bench_device& d) { other = std::max(other, d.currents[0]); };
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
    d.sensor_status = d.period % 3 == 0 ? ph::port_status::ok : ph::port_status::no_sample;
    d.sample.valid[0] = d.force.valid[1] = false;  // of no matter here
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
  expect("encoders: device lost", [](bench_device& d) { d.read_status = status::failed; });
  expect("force sensor: device lost", [](bench_device& d) { d.sensor_status = status::failed; });
  expect("encoders: no sample", [](bench_device& d) { d.read_status = status::no_sample; });
  expect("force sensor: damaged samples", [](bench_device& d) { d.sensor_status = status::bad_sample; });
  expect("brakes: the device rejects currents", [](bench_device& d) { d.write_status = status::no_sample; });
  // Its clock stands still
  expect("encoders: samples too late", [](bench_device& d) { d.sample.time = 0.3; });
  expect("encoders: samples too late", [](bench_device& d) { d.sample.time = NAN; });
  expect("encoders: samples too late", [](bench_device& d) { d.sample.time -= 1e6; });
  expect("encoders: the same sample repeatedly", [](bench_device& d) { d.sample.sequence = 299; });
  expect("force sensor: the same sample repeatedly", [](bench_device& d) { d.force.sequence = 299; });
  expect("encoder 2: NaN or infinity", [](bench_device& d) { d.sample.value[1] = NAN; });
  expect("force channel 3: NaN or infinity", [](bench_device& d) { d.force.value[2] = NAN; });
  // The time of the loop stands still
  expect("the clock went back", [](bench_device& d) { d.now = 0.3; });
  expect("the clock went back", [](bench_device& d) { d.now = NAN; });
  expect("a cycle began too late", [](bench_device& d) { d.now = d.sample.time = d.force.time += 0.2; });
  p.max_reading = 7;
  expect("force channel 3: saturated", [](bench_device&) {});
}

// One bad count in each 100 is bridged, and loses none.
TEST_F(record_on_bench, goes_on_after_a_sample_that_is_none) {
  duration = 1;
  device.spoil = [](bench_device& d) {
    if (d.period % 100 == 50) d.sample.value[1] = NAN;
  };
  const samples all = record(tenth);
  ASSERT_EQ(all.size(), 991u);
  EXPECT_EQ(all.back().position - all.front().position, 3000);
}

// A sensor may be that slow, an encoder may not turn that fast.
TEST_F(record_on_bench, has_limits_of_its_own) {
  p.hold_over = 0.005;
  EXPECT_EQ(error_of([](bench_device& d) {
              d.sensor_status = d.period % 10 == 0 ? ph::port_status::ok : ph::port_status::no_sample;
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
    device.spoil = [&](bench_device& d) { (of_sensor ? d.force.time : d.sample.time) = -5; };
    EXPECT_EQ(error_of_the_test(),
              std::string(of_sensor ? "force sensor" : "encoders") + ": samples too late");
    EXPECT_EQ(device.waits, 21);
  }
}

TEST_F(record_on_bench, ends_on_the_clock_of_this_machine_whatever_the_samples_say) {
  duration = 0.001;
  device.spoil = [](bench_device& d) {
    usleep(10'000);
    d.now = d.sample.time = d.force.time = 1e-6 * d.period;
    d.sample.value[1] = 0;
  };
  const std::string error = thrown_by([&] { record(tenth); });
  EXPECT_TRUE(error.starts_with("time of the test on this machine's clock [s] = ")) << error;
  EXPECT_TRUE(error.ends_with(
      ": expected at most 1.001: check the clock of the samples, and whether the machine was suspended"))
      << error;
  EXPECT_FALSE(device.flows());
}

// A wait that returns nothing: the samples have times of CLOCK_MONOTONIC.
TEST_F(record_on_bench, takes_the_clock_of_this_machine_where_the_wait_names_none) {
  fake::port port{&device};
  fake::sensor sensor{&device};
  const auto wait = [this] {
    usleep(500);
    device.wait();
    device.sample.time = device.force.time = ph::monotonic_seconds();
  };
  EXPECT_GE(ph::record_on_bench(port, sensor, p, 0.02, tenth, wait).back().time, 0.02);
}

TEST_F(record_on_bench, needs_a_brake_an_encoder_and_a_channel_that_are_there) {
  const auto error = [&](const ph::bench_parameters& wrong) {
    p = wrong;
    return thrown_by([&] { record(tenth); });
  };
  EXPECT_EQ(error({.brake = 2}), "brake = 2: expected 0 to 1");
  EXPECT_EQ(error({.brake = -1}), "brake = -1: expected 0 to 1");
  EXPECT_EQ(error({.encoder = 2}), "encoder = 2: expected 0 to 1");
  EXPECT_EQ(error({.channel = 3}), "channel = 3: expected 0 to 2");
  EXPECT_EQ(device.waits, 0) << "nothing was read";
}

}  // namespace bench_run_tests
