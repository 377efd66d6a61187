#include "../realtime/allocations.hpp"
#include "fake_device.hpp"

#include <gtest/gtest.h>
#include <passive_haptics/driver/safe_port.hpp>

#include <functional>
#include <vector>

namespace ph = passive_haptics;

namespace {

using safe = ph::safe_port<fake::port, fake::sensor>;

safe::parameters usual() {
  safe::parameters p;
  p.encoders.frozen_travel = 2048;
  p.sensor.range.fill(100);
  p.currents.max_current.fill(1);
  p.currents.continuous.fill(0.9);
  p.currents.heat.fill(0.05);
  return p;
}

// A device that moves slowly and is cycled at 1 kHz.
struct rig {
  explicit rig(const safe::parameters& p = usual(), int counter_bits = 0) : port({&device}, {&device}, p) {
    device.counter_bits = counter_bits;
    if (!port.open().empty()) throw std::runtime_error("the fake device is there");
  }

  // What a good device tells next.
  void take_samples() {
    time += 1e-3;
    device.sample.time = device.force.time = time;
    ++device.sample.sequence;
    ++device.force.sequence;
    for (double& count : device.sample.value) count += 3;
    device.force.value[0] = 1 + 0.1 * time;
  }
  // One cycle; `spoil` changes what the device tells.
  void cycle(const std::function<void(rig&)>& spoil = nullptr) {
    const auto sample = device.sample;
    const auto force = device.force;
    take_samples();
    if (spoil) spoil(*this);
    port.read(time);
    port.write(wanted);
    if (spoil) {  // what was spoilt is not what the device does
      const auto spoilt = device.sample;
      const auto spoilt_force = device.force;
      device.sample = sample;
      device.force = force;
      device.sample.sequence = spoilt.sequence;
      device.force.sequence = spoilt_force.sequence;
      for (double& count : device.sample.value) count += 3;
      device.sample.valid = {true, true};
      device.force.valid = {true, true, true};
      device.read_status = device.sensor_status = device.write_status = ph::port_status::ok;
    }
  }
  void cycles(int count) {
    for (int k = 0; k < count; ++k) cycle();
  }
  void hold() {
    cycle();
    EXPECT_TRUE(port.activate());
    cycles(3);
    EXPECT_EQ(port.state(), ph::port_state::active);
    EXPECT_EQ(device.currents, wanted);
  }
  // Until nothing flows.
  int cycles_to_release(const std::function<void(rig&)>& spoil) {
    for (int k = 1; k <= 200; ++k) {
      cycle(spoil);
      if (!device.flows()) return k;
    }
    return 1000;
  }

  fake::device device;
  double time = 100;
  ph::brake_currents<2> wanted{0.5, 0.25};
  safe port;
};

struct fault_case {
  const char* name;
  ph::fault_record expected;
  int cycles;      // until 0 A, at most
  bool rearmable;  // once it is over
  std::function<void(rig&)> spoil;
};

constexpr int at_once = 1;
constexpr int held_over = 21;  // 20 ms at 1 kHz, and the cycle that sees that they are over
constexpr auto encoders = ph::fault_source::encoders;
constexpr auto sensor = ph::fault_source::force_sensor;
constexpr auto brakes = ph::fault_source::brakes;

const std::vector<fault_case> all_faults{
    {"NaN_encoder",
     {ph::fault::value_not_finite, encoders, 1},
     held_over,
     false,
     [](rig& r) { r.device.sample.value[1] = fake::nan; }},
    {"infinite_encoder",
     {ph::fault::value_not_finite, encoders, 0},
     held_over,
     false,
     [](rig& r) { r.device.sample.value[0] = -fake::infinite; }},
    {"count_beyond_the_counter",
     {ph::fault::count_out_of_range, encoders, 0},
     held_over,
     false,
     [](rig& r) { r.device.sample.value[0] = 1e300; }},
    {"encoder_that_the_device_calls_invalid",
     {ph::fault::channel_invalid, encoders, 0},
     held_over,
     false,
     [](rig& r) { r.device.sample.valid[0] = false; }},
    {"encoder_jump",
     {ph::fault::encoder_jump, encoders, 1},
     held_over,
     false,
     [](rig& r) { r.device.sample.value[1] += 5000; }},
    {"silence_of_the_device",
     {ph::fault::sample_missing, encoders},
     held_over,
     true,
     [](rig& r) { r.device.read_status = ph::port_status::no_sample; }},
    {"bad_checksum_or_truncated_frame",
     {ph::fault::sample_damaged, encoders},
     held_over,
     true,
     [](rig& r) { r.device.read_status = ph::port_status::bad_sample; }},
    {"duplicate",
     {ph::fault::sample_repeated, encoders},
     held_over,
     true,
     [](rig& r) { --r.device.sample.sequence; }},
    {"reordering",
     {ph::fault::sample_out_of_order, encoders},
     held_over,
     false,
     [](rig& r) { r.device.sample.sequence -= 2; }},
    {"wrong_sequence",
     {ph::fault::device_restarted, encoders},
     at_once,
     false,
     [](rig& r) { r.device.sample.sequence += 5000; }},
    {"restart_of_the_device",
     {ph::fault::device_restarted, encoders},
     at_once,
     false,
     [](rig& r) { r.device.sample.sequence -= 5000; }},
    {"sample_of_a_second_ago",
     {ph::fault::sample_late, encoders},
     held_over,
     true,
     [](rig& r) { r.device.sample.time -= 1; }},
    {"sample_of_tomorrow",
     {ph::fault::sample_late, encoders},
     held_over,
     true,
     [](rig& r) { r.device.sample.time += 1e5; }},
    {"sample_without_a_time",
     {ph::fault::sample_late, encoders},
     held_over,
     true,
     [](rig& r) { r.device.sample.time = fake::nan; }},
    {"bus_gone_while_reading",
     {ph::fault::device_lost, encoders},
     at_once,
     false,
     [](rig& r) { r.device.read_status = ph::port_status::failed; }},
    {"bus_gone_while_writing",
     {ph::fault::device_lost, brakes},
     at_once,
     false,
     [](rig& r) { r.device.write_status = ph::port_status::failed; }},
    {"short_write",
     {ph::fault::write_refused, brakes},
     held_over,
     true,
     [](rig& r) { r.device.write_status = ph::port_status::bad_sample; }},
    {"full_buffer",
     {ph::fault::write_refused, brakes},
     held_over,
     true,
     [](rig& r) { r.device.write_status = ph::port_status::no_sample; }},
    {"sensor_saturation",
     {ph::fault::sensor_saturated, sensor, 2},
     held_over,
     true,
     [](rig& r) { r.device.force.value[2] = -100; }},
    {"sensor_not_a_number",
     {ph::fault::value_not_finite, sensor, 0},
     held_over,
     true,
     [](rig& r) { r.device.force.value[0] = fake::nan; }},
    {"sensor_channel_invalid",
     {ph::fault::channel_invalid, sensor, 1},
     held_over,
     true,
     [](rig& r) { r.device.force.valid[1] = false; }},
    {"stale_sensor",
     {ph::fault::sample_repeated, sensor},
     held_over,
     true,
     [](rig& r) { --r.device.force.sequence; }},
    {"silence_of_the_sensor",
     {ph::fault::sample_missing, sensor},
     held_over,
     true,
     [](rig& r) { r.device.sensor_status = ph::port_status::no_sample; }},
    {"damaged_sensor_records",
     {ph::fault::sample_damaged, sensor},
     held_over,
     true,
     [](rig& r) { r.device.sensor_status = ph::port_status::bad_sample; }},
    {"sensor_gone",
     {ph::fault::device_lost, sensor},
     at_once,
     true,
     [](rig& r) { r.device.sensor_status = ph::port_status::failed; }},
    {"NaN_command",
     {ph::fault::current_not_valid, brakes, 1},
     at_once,
     true,
     [](rig& r) { r.wanted[1] = fake::nan; }},
    {"infinite_command",
     {ph::fault::current_not_valid, brakes, 0},
     at_once,
     true,
     [](rig& r) { r.wanted[0] = fake::infinite; }},
    {"negative_command",
     {ph::fault::current_not_valid, brakes, 0},
     at_once,
     true,
     [](rig& r) { r.wanted[0] = -1e-300; }},
    {"loop_that_stood_still",
     {ph::fault::cycle_late},
     at_once,
     true,
     [](rig& r) { r.time += 0.5, r.device.sample.time = r.device.force.time = r.time; }},
    {"clock_that_goes_back", {ph::fault::clock_jump}, at_once, true, [](rig& r) { r.time -= 0.01; }},
    {"clock_that_is_none", {ph::fault::clock_jump}, at_once, true, [](rig& r) { r.time = fake::nan; }},
    {"suspended_machine",
     {ph::fault::suspended},
     at_once,
     false,
     [](rig& r) { r.port.release({ph::fault::suspended}); }},
};

class a_fault : public ::testing::TestWithParam<fault_case> {};

}  // namespace

TEST_P(a_fault, releases_the_brakes_in_time_and_says_why) {
  rig r;
  r.hold();
  EXPECT_LE(r.cycles_to_release(GetParam().spoil), GetParam().cycles);
  EXPECT_EQ(r.port.state(), ph::port_state::released);
  EXPECT_EQ(r.port.reason(), GetParam().expected) << to_string(r.port.reason());
  EXPECT_GE(r.device.releases, 1) << "the device is told by its quickest way";
}

TEST_P(a_fault, stays_released_until_somebody_rearms) {
  rig r;
  r.hold();
  const auto time = r.time;
  r.cycles_to_release(GetParam().spoil);
  r.wanted = {0.5, 0.25};
  if (!(r.time >= time)) r.time = time + 1;
  for (int k = 0; k < 30; ++k) {
    r.cycle();
    ASSERT_FALSE(r.device.flows());
    ASSERT_EQ(r.port.state(), ph::port_state::released);
    ASSERT_EQ(r.port.reason(), GetParam().expected) << "the first reason stays";
    ASSERT_FALSE(r.port.activate());
  }
  EXPECT_EQ(r.port.needs_homing(), !GetParam().rearmable);
  EXPECT_EQ(r.port.rearm(), GetParam().rearmable);
  EXPECT_EQ(r.port.state(), GetParam().rearmable ? ph::port_state::ready : ph::port_state::released);
  r.cycles(2);
  EXPECT_FALSE(r.device.flows()) << "ready gives no current, either";
  if (!GetParam().rearmable) return;
  EXPECT_EQ(r.port.reason(), ph::fault_record{});
  EXPECT_TRUE(r.port.activate());
  r.cycle();
  EXPECT_EQ(r.device.currents, r.wanted);
}

TEST_P(a_fault, of_one_cycle_is_bridged_where_it_can_be) {
  rig r;
  r.hold();
  const auto position = r.port.position();
  r.cycle(GetParam().spoil);
  if (GetParam().cycles == at_once) {
    EXPECT_EQ(r.port.state(), ph::port_state::released);
    return;
  }
  EXPECT_EQ(r.port.state(), ph::port_state::degraded);
  if (GetParam().expected.source == encoders) {
    EXPECT_EQ(r.port.pending_fault(), GetParam().expected);
    EXPECT_EQ(r.port.position(), position) << "the last good one stays";
  }
  EXPECT_TRUE(r.device.flows());
  EXPECT_FALSE(r.port.needs_homing());
  r.cycles(2);
  EXPECT_EQ(r.port.state(), ph::port_state::active);
  EXPECT_EQ(r.port.pending_fault(), ph::fault_record{});
  EXPECT_EQ(r.device.currents, r.wanted);
}

INSTANTIATE_TEST_SUITE_P(named, a_fault, ::testing::ValuesIn(all_faults),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(a_safe_port, gives_no_current_before_it_is_activated) {
  rig r;
  r.cycles(10);
  EXPECT_EQ(r.port.state(), ph::port_state::ready);
  EXPECT_FALSE(r.device.flows());
  EXPECT_EQ(r.device.writes, 10) << "a device with a watchdog hears of it";
  EXPECT_TRUE(r.port.activate());
  EXPECT_FALSE(r.port.activate()) << "a double start";
  EXPECT_NE(r.port.open(), "") << "a double start";
  r.cycle();
  EXPECT_EQ(r.device.currents, r.wanted);
}

TEST(a_safe_port, tells_the_last_good_reading_of_the_force_sensor) {
  rig r;
  r.cycles(3);
  const auto good = r.device.force.value;
  EXPECT_EQ(r.port.force(), good);
  r.cycle([](rig& s) { s.device.force.value[2] = fake::nan; });
  EXPECT_EQ(r.port.force(), good);
  r.cycle();
  EXPECT_EQ(r.port.force(), r.device.force.value);
  EXPECT_NE(r.port.force(), good);
}

TEST(a_safe_port, tells_when_the_encoders_were_where_they_are) {
  rig r;
  EXPECT_EQ(r.port.position_time(), 0) << "never";
  r.cycles(3);
  EXPECT_EQ(r.port.position_time(), r.device.sample.time);
  const double good = r.port.position_time();
  r.cycle([](rig& s) { s.device.sample.value[1] += 5000; });
  EXPECT_EQ(r.port.position_time(), good);
  r.cycle([](rig& s) { s.device.read_status = ph::port_status::no_sample; });
  EXPECT_EQ(r.port.position_time(), good);
  r.take_samples();
  r.device.sample.time -= 0.004;  // what the sample says, not when it was read
  r.port.read(r.time);
  EXPECT_EQ(r.port.position_time(), r.time - 0.004);
}

TEST(a_safe_port, sees_times_that_look_like_those_of_arrival) {
  for (const bool of_arrival : {false, true}) {
    rig r;
    r.hold();
    for (int k = 0; k < 300; ++k) {
      r.take_samples();
      if (of_arrival && k % 2 == 0) r.device.sample.time -= 0.9e-3;
      r.port.read(r.time);
      r.port.write(r.wanted);
    }
    EXPECT_EQ(r.port.arrivals().found(), of_arrival);
    EXPECT_EQ(r.port.state(), ph::port_state::active);
  }
}

TEST(a_safe_port, follows_a_sensor_that_restarted) {
  rig r;
  r.hold();
  r.cycle([](rig& s) { s.device.force.sequence += 5000; });
  EXPECT_EQ(r.port.state(), ph::port_state::degraded);
  EXPECT_EQ(r.port.pending_fault(), (ph::fault_record{ph::fault::device_restarted, sensor}));
  for (int k = 0; k < 30; ++k) {
    r.cycle();
    ASSERT_EQ(r.port.state(), ph::port_state::active) << "a force has no home to lose";
    ASSERT_EQ(r.port.force(), r.device.force.value);
  }
  r.cycle([](rig& s) { --s.device.force.sequence; });
  EXPECT_EQ(r.port.pending_fault().what, ph::fault::sample_repeated) << "its numbers are looked at again";
}

TEST(a_safe_port, is_degraded_from_the_first_bad_sample_to_the_next_good_one) {
  rig r;
  r.hold();
  for (int k = 0; k < 3; ++k) {
    r.take_samples();
    r.device.sample.valid[1] = false;
    EXPECT_EQ(r.port.read(r.time), ph::port_state::degraded);
    EXPECT_EQ(r.port.write(r.wanted), ph::port_state::degraded);
    r.take_samples();
    r.device.sample.valid[1] = true;
    EXPECT_EQ(r.port.read(r.time), ph::port_state::active);
    EXPECT_EQ(r.port.write(r.wanted), ph::port_state::active);
  }
}

TEST(a_safe_port, looks_at_no_command_while_nothing_flows) {
  rig r;
  r.cycle([](rig& s) { s.wanted = {fake::nan, -1}; });
  EXPECT_EQ(r.port.state(), ph::port_state::ready);
  EXPECT_EQ(r.port.reason(), ph::fault_record{});
  EXPECT_FALSE(r.device.flows());
}

TEST(a_safe_port, cannot_be_activated_without_a_good_sample) {
  rig r;
  EXPECT_FALSE(r.port.activate()) << "none yet";
  r.cycle([](rig& s) { s.device.read_status = ph::port_status::no_sample; });
  EXPECT_FALSE(r.port.activate());
  r.cycle([](rig& s) { s.device.force.value[0] = 100; });
  EXPECT_FALSE(r.port.activate());
  EXPECT_FALSE(r.port.rearm()) << "it is not released";
  r.cycle();
  EXPECT_TRUE(r.port.activate());
}

TEST(a_safe_port, that_could_not_be_opened_says_what_is_missing_and_does_nothing) {
  fake::device device;
  device.sensor_missing = "no sensor at 192.0.2.1";
  {
    safe port({&device}, {&device});
    EXPECT_EQ(port.open(), "no sensor at 192.0.2.1");
    EXPECT_EQ(port.state(), ph::port_state::closed);
    device.read_status = ph::port_status::failed;
    EXPECT_EQ(port.read(1), ph::port_state::closed);
    EXPECT_EQ(port.write({1, 1}), ph::port_state::closed);
    EXPECT_FALSE(port.activate() || port.rearm());
    port.release();
    EXPECT_EQ(port.state(), ph::port_state::closed);
    EXPECT_EQ(device.writes, 0);
    device.sensor_missing = "";
    EXPECT_EQ(port.open(), "") << "plugged in meanwhile";
  }
  device.encoders_missing = "no device";
  safe port({&device}, {&device});
  EXPECT_EQ(port.open(), "no device");
}

TEST(a_safe_port, is_opened_once) {
  rig r;
  r.hold();
  EXPECT_EQ(r.port.open(), "open() was called before: the device is open");
  r.cycle();
  EXPECT_EQ(r.device.currents, r.wanted) << "and goes on";
}

TEST(a_safe_port, releases_the_brakes_when_it_ends) {
  fake::device device;
  {
    safe port({&device}, {&device});
    device.currents = {1, 1};
  }
  EXPECT_FALSE(device.flows());
}

TEST(a_safe_port, follows_counters_past_their_wrap) {
  rig r(usual(), 16);
  r.device.sample.value = {65000, 300};
  r.cycle();
  ASSERT_TRUE(r.port.activate());
  for (int k = 1; k <= 4000; ++k) {
    r.cycle([k](rig& s) {
      s.device.sample.value = {std::fmod(65003.0 + 100 * k, 65536),
                               std::fmod(65536 * 8 + 303.0 - 100 * k, 65536)};
    });
    ASSERT_EQ(r.port.state(), ph::port_state::active) << to_string(r.port.pending_fault());
    ASSERT_EQ(r.port.position()[0], 65003 + 100 * k);
    ASSERT_EQ(r.port.position()[1], 303 - 100 * k);
  }
}

// Of all widths and pauses: tests/stress/encoder_pauses.cpp.
TEST(a_counter, that_may_have_wrapped_unseen_needs_homing_in_each_state) {
  const ph::fault_record wrapped{ph::fault::counter_wrapped, encoders};
  EXPECT_EQ(ph::wrap_time(12, 2e5), 2046 / 2e5);
  EXPECT_EQ(ph::wrap_time(0, 2e5), fake::infinite);
  for (const double pause : {2045 / 2e5, 2046 / 2e5, 0.015, 0.5})
    for (const auto state : {ph::port_state::ready, ph::port_state::active, ph::port_state::degraded,
                             ph::port_state::released}) {
      rig r(usual(), 12);
      r.device.sample.value = {1000, 3000};
      r.cycles(20);
      if (state != ph::port_state::ready) {
        ASSERT_TRUE(r.port.activate());
      }
      r.cycle();
      if (state == ph::port_state::degraded) r.cycle([](rig& s) { s.device.force.value[2] = fake::nan; });
      if (state == ph::port_state::released) r.port.release();
      ASSERT_EQ(r.port.state(), state);
      r.time += pause - 1e-3;
      r.cycle();
      const bool lost = pause >= 2046 / 2e5;
      EXPECT_EQ(r.port.needs_homing(), lost) << pause;
      EXPECT_EQ(r.port.pending_fault(), lost ? wrapped : ph::fault_record{}) << pause;
      if (!lost) continue;
      EXPECT_EQ(r.port.state(), ph::port_state::released) << pause;
      if (state == ph::port_state::ready) {
        EXPECT_EQ(r.port.reason(), wrapped) << pause;
      }
      const int releases = r.device.releases;
      r.cycles(30);
      EXPECT_FALSE(r.port.rearm() || r.port.activate() || r.device.flows());
      EXPECT_EQ(r.device.releases, releases) << "not in each cycle again";
    }
}

TEST(a_counter, that_can_wrap_within_the_period_is_refused_when_the_port_opens) {
  const auto opened = [](double period) {
    auto p = usual();
    p.period = period;
    fake::device device;
    device.counter_bits = 12;
    safe port({&device}, {&device}, p);
    const std::string error = port.open();
    EXPECT_EQ(port.state(), error.empty() ? ph::port_state::ready : ph::port_state::closed);
    return error;
  };
  EXPECT_EQ(opened(0.010), "");
  EXPECT_EQ(
      opened(0.0125),
      "period [s] = 0.0125, expected less than 0.01023, within which a counter of 12 bits can wrap unseen: "
      "shorten it, lower encoders.max_rate or use a wider counter");
}

// By the median of the first 20 spacings; the samples themselves are dated nearer to each other.
TEST(a_counter, that_can_wrap_within_the_measured_period_is_not_activated) {
  for (const int slow : {9, 11}) {
    auto p = usual();
    p.hold_over = 1;
    rig r(p, 12);
    for (int k = 0; k <= 40; ++k) {
      r.take_samples();
      r.time += k <= slow || k > 20 ? 0.0125 : 0;
      r.device.sample.time = 100 + 1e-3 * k;
      r.port.read(r.time);
      r.port.write(r.wanted);
    }
    EXPECT_EQ(r.port.activate(), slow == 9) << slow << " of 20 spacings in which it can wrap";
    EXPECT_EQ(r.port.needs_homing(), slow == 11);
  }
}

TEST(a_safe_port, whose_encoder_jumps_for_too_long_is_not_activated_any_more) {
  rig r;
  r.cycles(3);
  for (int k = 0; k < 25; ++k) r.cycle([](rig& s) { s.device.sample.value[0] += 5000; });
  EXPECT_TRUE(r.port.needs_homing());
  r.cycles(3);
  EXPECT_FALSE(r.port.activate());
  EXPECT_EQ(r.port.reason(), (ph::fault_record{ph::fault::encoder_jump, encoders, 0}));
}

TEST(a_safe_port, has_no_position_to_lose_before_its_first_good_sample) {
  rig r;
  for (int k = 0; k < 50; ++k) r.cycle([](rig& s) { s.device.sample.valid[0] = false; });
  r.cycle();
  EXPECT_FALSE(r.port.needs_homing());
  EXPECT_TRUE(r.port.activate());
}

TEST(a_safe_port, holds_over_a_gap_in_the_sequence_and_lets_the_device_go_on_meanwhile) {
  rig r;
  r.hold();
  const auto before = r.port.position();
  for (int k = 0; k < 15; ++k) {
    const auto sample = r.device.sample;
    r.take_samples();
    const auto moved = r.device.sample;
    r.device.read_status = ph::port_status::no_sample;
    r.port.read(r.time);
    r.port.write(r.wanted);
    r.device.read_status = ph::port_status::ok;
    r.device.sample = moved;
    for (std::size_t i = 0; i < 2; ++i)
      r.device.sample.value[i] = sample.value[i] + 150;  // faster than a jump of one cycle
    ASSERT_EQ(r.port.state(), ph::port_state::degraded);
  }
  r.cycle();
  EXPECT_EQ(r.port.state(), ph::port_state::active) << to_string(r.port.pending_fault());
  EXPECT_EQ(r.port.position()[0], before[0] + 15 * 150 + 3);
}

TEST(a_safe_port, counts_samples_past_the_end_of_their_sequence) {
  rig r;
  r.device.sample.sequence = 0xFFFFFFF0u;
  r.hold();
  r.cycles(100);
  EXPECT_EQ(r.port.state(), ph::port_state::active);
}

TEST(a_frozen_encoder, is_noticed_after_the_others_turned_so_far_without_a_brake) {
  rig r;
  r.wanted = {0, 0};
  r.cycle();
  ASSERT_TRUE(r.port.activate());
  const double frozen = r.device.sample.value[1];
  const auto freeze = [&](rig& s) { s.device.sample.value[1] = frozen; };
  int k = 0;
  for (; r.port.state() != ph::port_state::released && k < 2000; ++k) {
    r.cycle(freeze);
    r.device.sample.value[1] = frozen;
  }
  EXPECT_EQ(r.port.reason(), (ph::fault_record{ph::fault::encoder_frozen, encoders, 1}));
  EXPECT_NEAR(k, 2048.0 / 3, 2) << "cycles of 3 counts";
  r.cycles(5);
  EXPECT_FALSE(r.port.rearm()) << "nobody knows how far it went";
  EXPECT_TRUE(r.port.needs_homing());
}

TEST(a_frozen_encoder, is_none_where_a_brake_holds_it) {
  rig r;
  r.hold();
  const double held = r.device.sample.value[1];
  for (int k = 0; k < 3000; ++k) {
    r.cycle([&](rig& s) { s.device.sample.value[1] = held; });
    r.device.sample.value[1] = held;
  }
  EXPECT_EQ(r.port.state(), ph::port_state::active);
}

TEST(a_frozen_encoder, is_none_where_it_moves_now_and_then) {
  rig r;
  r.wanted = {0, 0};
  r.cycle();
  ASSERT_TRUE(r.port.activate());
  double slow = r.device.sample.value[1];
  for (int k = 1; k <= 3000; ++k) {  // 9000 counts of the other
    if (k % 300 == 0) ++slow;
    r.device.sample.value[1] = slow - 3;
    r.cycle();
    r.device.sample.value[1] = slow;
    ASSERT_EQ(r.port.state(), ph::port_state::active) << "cycle " << k << ": " << to_string(r.port.reason());
  }
}

TEST(a_sample, is_of_nothing_by_default) {
  const ph::port_sample<2> sample;
  EXPECT_EQ(sample.time, 0);
  EXPECT_EQ(sample.sequence, 0U);
  for (const std::size_t k : {0U, 1U}) {
    EXPECT_EQ(sample.value[k], 0);
    EXPECT_FALSE(sample.valid[k]);
  }
}

// Unsigned or signed, the first sample too; without a width, as far as a double tells one count from the
// next.
TEST(an_encoder_check, takes_only_counts_that_the_counter_has) {
  const auto takes = [](int bits, double count) {
    bool first = false, later = false;
    {
      ph::encoder_check<1> check({});
      check.set_counter_bits(bits);
      first = check({0, 0, {count}, {true}}, true) == ph::fault_record{};
      EXPECT_EQ(check.position()[0], first ? count : 0);
    }
    ph::encoder_check<1> check({.max_rate = bits > 0 ? 100 : 1e300});
    check.set_counter_bits(bits);
    check({0, 0, {-64}, {true}}, true);  // from where no good count is further than 64
    later = check({1, 1, {count}, {true}}, true) == ph::fault_record{};
    EXPECT_EQ(first, later) << bits << " bits, count " << count;
    return first;
  };
  for (const double good : {0.0, 255.0, 255.75, -1.0, -128.0}) EXPECT_TRUE(takes(8, good)) << good;
  for (const double bad : {256.0, -128.5, 1e6, 1e300, -1e300, fake::nan, fake::infinite})
    EXPECT_FALSE(takes(8, bad)) << bad;
  EXPECT_TRUE(takes(24, 16777215));
  EXPECT_FALSE(takes(24, 16777216));
  for (const double good : {0.0, 1e15, -1e15}) EXPECT_TRUE(takes(0, good)) << good;
  for (const double bad : {1e16, -1e16, 1e300, fake::nan}) EXPECT_FALSE(takes(0, bad)) << bad;
}

TEST(an_encoder_check, loses_no_count_where_each_tenth_sample_is_none) {
  ph::encoder_check<1> check({});
  check.set_counter_bits(24);
  for (std::uint32_t k = 0; k < 3000; ++k) {
    const bool spoilt = k % 10 == 9;
    const auto found = check({1e-3 * k, k, {spoilt ? 1e300 : 10.0 * k}, {true}}, false);
    ASSERT_EQ(found.what, spoilt ? ph::fault::count_out_of_range : ph::fault::none) << k;
    ASSERT_EQ(check.position()[0], 10.0 * (spoilt ? k - 1 : k));
  }
}

TEST(a_jump, cannot_be_waited_out) {
  ph::encoder_check<1> check({.max_rate = 1000});
  ph::port_sample<1> sample{0, 0, {0}, {true}};
  EXPECT_EQ(check(sample, true).what, ph::fault::none);
  for (int k = 1; k <= 5000; ++k) {  // 5 s, in which it could have gone 5000 counts
    sample.time = 1e-3 * k;
    sample.value[0] = 100;
    ASSERT_EQ(check(sample, true).what, ph::fault::encoder_jump) << k;
  }
  EXPECT_EQ(check.position()[0], 0);
}

TEST(a_jump, that_was_only_one_bad_reading_is_forgotten) {
  rig r;
  r.hold();
  for (int k = 0; k < 100; ++k) {
    r.cycle([](rig& s) { s.device.sample.value[0] += 1e9; });
    EXPECT_EQ(r.port.state(), ph::port_state::degraded);
    r.cycles(4);  // a fifth is rejected
    ASSERT_EQ(r.port.state(), ph::port_state::active);
  }
}

// A loose plug: no fault lasts for hold_over.
TEST(rejected_samples, release_the_brakes_if_they_are_a_quarter_of_those_that_arrived) {
  struct plug {
    ph::fault_record expected;
    bool rearmable;
    std::function<void(rig&)> spoil;
  };
  for (const plug& p : std::vector<plug>{
           {{ph::fault::encoder_jump, encoders, 0}, false, [](rig& r) { r.device.sample.value[0] += 1000; }},
           {{ph::fault::count_out_of_range, encoders, 0},
            false,
            [](rig& r) { r.device.sample.value[0] = 1e300; }},
           {{ph::fault::channel_invalid, encoders, 1},
            false,
            [](rig& r) { r.device.sample.valid[1] = false; }},
           {{ph::fault::value_not_finite, encoders, 1},
            false,
            [](rig& r) { r.device.sample.value[1] = fake::nan; }},
           {{ph::fault::sample_damaged, encoders},
            true,
            [](rig& r) { r.device.read_status = ph::port_status::bad_sample; }},
           {{ph::fault::sample_damaged, sensor},
            true,
            [](rig& r) { r.device.sensor_status = ph::port_status::bad_sample; }},
           {{ph::fault::sensor_saturated, sensor, 1}, true, [](rig& r) { r.device.force.value[1] = 100; }}})
    for (const int every : {2, 4, 5}) {
      SCOPED_TRACE(to_string(p.expected) + ", each of " + std::to_string(every));
      rig r;
      r.hold();
      const auto cycles = [&](int count) {
        int k = 0;
        for (; k < count && r.device.flows(); ++k) {
          if (k % every == 0) r.cycle(p.spoil);
          else r.cycle();
        }
        return k;
      };
      if (every == 5) {
        EXPECT_EQ(cycles(1000), 1000);
        EXPECT_EQ(r.port.state(), ph::port_state::active);
        continue;
      }
      r.cycles(300);
      EXPECT_LE(cycles(1000), every == 2 ? 101 : 201) << "ten hold_over";
      EXPECT_EQ(r.port.reason(), p.expected);
      EXPECT_EQ(r.port.needs_homing(), !p.rearmable);
      r.cycles(1);
      EXPECT_FALSE(r.port.rearm()) << "so soon";
      r.cycles(200);
      EXPECT_EQ(r.port.rearm(), p.rearmable);
    }
}

TEST(rejected_samples, are_judged_over_the_last_ten_hold_over) {
  ph::rejected_samples samples(1);
  const auto too_many_after = [&](double begin, double end, ph::fault found) {
    for (double time = begin; time < end; time += 0.125) samples.add(found, time);
    return samples.is_too_many();
  };
  EXPECT_EQ(samples.share(), 0);
  EXPECT_FALSE(too_many_after(0, 9, ph::fault::encoder_jump)) << "too early to say";
  EXPECT_TRUE(too_many_after(9, 10, ph::fault::encoder_jump));
  EXPECT_TRUE(too_many_after(10, 17, ph::fault::none)) << "24 of 80";
  EXPECT_FALSE(too_many_after(17, 18, ph::fault::none)) << "16 of 80";
  EXPECT_EQ(samples.arrived(), 144u);
  EXPECT_EQ(samples.rejected(), 80u);
  EXPECT_TRUE(too_many_after(18, 28, ph::fault::encoder_jump));
  EXPECT_FALSE(too_many_after(40, 49, ph::fault::encoder_jump)) << "too early to say after a pause";
}

TEST(rejected_samples, are_a_share_of_those_that_arrived_not_of_the_reads) {
  // A device slower than the loop, or behind an adapter that waits for 16 samples; each of so many jumps, 0:
  // none
  const auto flows = [](int reads_a_sample, int jumps) {
    rig r;
    r.hold();
    for (int k = 0; k < 2000; ++k)
      r.cycle([&](rig& s) {
        if (k % reads_a_sample != 0) s.device.read_status = ph::port_status::no_sample;
        else if (jumps > 0 && k / reads_a_sample % jumps == 0) s.device.sample.value[0] += 5000;
      });
    return r.device.flows();
  };
  EXPECT_TRUE(flows(2, 0));
  EXPECT_TRUE(flows(16, 0));
  EXPECT_FALSE(flows(2, 3)) << "a third of the samples, a sixth of the reads";
}

TEST(an_encoder_check, allows_the_largest_rate_and_a_count_at_each_end) {
  // After `later` [s], moved so far
  const auto after = [](double later, double moved) {
    ph::encoder_check<2> check({.max_rate = 1000});
    EXPECT_EQ(check({7, 0, {5, -3}, {true, true}}, true), ph::fault_record{});
    const auto found = check({7 + later, 1, {5, -3 + moved}, {true, true}}, true);
    EXPECT_EQ(check.position()[1], found.what == ph::fault::none ? -3 + moved : -3);
    return found;
  };
  const ph::fault_record jump{ph::fault::encoder_jump, encoders, 1};
  for (const double side : {1.0, -1.0}) {
    EXPECT_EQ(after(0.0625, side * 64), ph::fault_record{});
    EXPECT_EQ(after(0.0625, side * 65), jump);
    EXPECT_EQ(after(0, side * 2), ph::fault_record{});
    EXPECT_EQ(after(-0.0625, side * 2), ph::fault_record{}) << "a time that goes back is none that went by";
    EXPECT_EQ(after(-0.0625, side * 3), jump);
  }
  EXPECT_EQ(after(1, fake::nan), (ph::fault_record{ph::fault::count_out_of_range, encoders, 1}));
}

TEST(an_encoder_check, counts_the_way_of_the_others_since_each_encoder_changed) {
  ph::encoder_check<3> check({.max_rate = 1e6, .frozen_travel = 1});
  ph::port_sample<3> sample{0, 0, {0, 0, 0}, {true, true, true}};
  // Each encoder moves so far; which one is frozen, or -1
  const auto frozen = [&](const std::array<double, 3>& moved, bool free) {
    sample.time += 1e-3;
    for (std::size_t i = 0; i < 3; ++i) sample.value[i] += moved[i];
    return check(sample, free).channel;
  };
  EXPECT_EQ(frozen({1, 1, 1}, true), -1);
  EXPECT_EQ(frozen({0.25, 0.25, 0.25}, true), -1);
  EXPECT_EQ(frozen({8, -8, 0}, false), -1) << "a brake may hold it";
  EXPECT_EQ(frozen({0.25, -0.25, 0}, true), -1);
  EXPECT_EQ(frozen({-0.5, 0, 0}, true), -1) << "the way of all others together, 1 so far";
  EXPECT_EQ(frozen({0, 0.25, 0}, true), 2);
  EXPECT_EQ(frozen({1, 1, 1}, true), 2) << "for ever";
}

TEST(an_encoder_check, gives_an_encoder_a_turn_of_8192_counts_by_default) {
  ph::encoder_check<2> check({});
  for (int k = 0; k <= 64; ++k)
    ASSERT_EQ(check({1e-3 * k, 0, {128.0 * k, 0}, {true, true}}, true), ph::fault_record{}) << k;
  EXPECT_EQ(check({0.065, 0, {8193, 0}, {true, true}}, true).channel, 1);
}

TEST(an_encoder_check, without_a_travel_never_asks_whether_an_encoder_froze) {
  ph::encoder_check<2> check({.frozen_travel = 0});
  for (int k = 0; k < 1000; ++k)
    ASSERT_EQ(check({1e-3 * k, 0, {100.0 * k, 0}, {true, true}}, true), ph::fault_record{});
}

TEST(a_current_limiter, clamps_slows_and_spares_each_coil) {
  using currents = ph::brake_currents<2>;
  ph::current_limiter<2> limiter(
      {.max_current = {0.3, 2}, .continuous = {0.2, 1.5}, .heat = {10, 1}, .max_rise_rate = {0.5, 0}});
  EXPECT_FALSE(limiter.lowered_by_heat());
  EXPECT_EQ(limiter({9, 9}, 0.125), (currents{0.0625, 2}));
  EXPECT_FALSE(limiter.lowered_by_heat());
  EXPECT_EQ(limiter({9, 1.75}, 0.5), (currents{0.3, 1.75})) << "4 - 1.5^2 for 0.5 s: 0.875 A^2 s";
  EXPECT_EQ(limiter({9, 9}, 0.125), (currents{0.3, 2})) << "and 1.75^2 - 1.5^2 for 0.125 s: 0.977 A^2 s";
  EXPECT_FALSE(limiter.lowered_by_heat());
  EXPECT_EQ(limiter({0.1, 9}, 0.125), (currents{0.1, 0.95 * 1.5})) << "1.195 A^2 s";
  EXPECT_TRUE(limiter.lowered_by_heat());
  EXPECT_EQ(limiter({0.1, 1.25}, 0.125), (currents{0.1, 1.25}));
  EXPECT_FALSE(limiter.lowered_by_heat()) << "less was asked for";
  EXPECT_EQ(limiter.flowing(), (currents{0.1, 1.25}));

  limiter.release();
  EXPECT_EQ(limiter.flowing(), currents{});
  EXPECT_EQ(limiter({9, 9}, 0.25), (currents{0.125, 0.95 * 1.5})) << "from 0 A on; still 0.547 A^2 s";
  limiter.release();
  EXPECT_EQ(limiter({9, 9}, 0.25), (currents{0.125, 2})) << "0 A cool it to less than half";
}

TEST(the_currents, never_pass_their_limit) {
  rig r;
  r.hold();
  r.wanted = {1e300, 1.0000001};
  r.cycle();
  EXPECT_EQ(r.device.currents, (ph::brake_currents<2>{1, 1}));
  EXPECT_EQ(r.port.applied(), r.device.currents);
}

TEST(the_currents, rise_no_faster_than_they_may_and_fall_at_once) {
  auto p = usual();
  p.currents.max_rise_rate = {100, 0};
  rig r(p);
  r.wanted = {0.5, 0.5};
  r.cycle();
  ASSERT_TRUE(r.port.activate());
  for (int k = 1; k <= 5; ++k) {
    r.cycle();
    EXPECT_NEAR(r.device.currents[0], 0.1 * k, 1e-9);
    EXPECT_EQ(r.device.currents[1], 0.5);
  }
  r.wanted = {0.05, 0};
  r.cycle();
  EXPECT_EQ(r.device.currents, r.wanted);
}

TEST(the_currents, of_a_coil_that_gets_too_warm_are_lowered_until_it_is_cooler) {
  rig r;  // 0.9 A for ever, and 0.05 A^2 s over it
  r.hold();
  r.wanted = {1, 0.25};
  double charge = 0;
  int hot = 0;
  for (int k = 0; k < 20000; ++k) {
    r.cycle();
    charge += (r.device.currents[0] * r.device.currents[0] - 0.81) * 1e-3;
    ASSERT_LE(charge, 0.05 + 0.19e-3 + 1e-12);
    ASSERT_EQ(r.device.currents[1], 0.25) << "the other one is not warm";
    if (r.device.currents[0] < 1) {
      ++hot;
      ASSERT_NEAR(r.device.currents[0], 0.855, 1e-12);
      ASSERT_EQ(r.port.state(), ph::port_state::degraded);
    }
  }
  EXPECT_GT(hot, 1000);
  EXPECT_LT(hot, 19000) << "it gets its full current again";
  r.wanted = {0.5, 0.25};
  r.cycle();
  EXPECT_EQ(r.port.state(), ph::port_state::active) << "less than the lowered current was asked for";
}

TEST(the_currents, rise_from_nothing_after_a_pause_and_after_a_release) {
  auto p = usual();
  p.currents.max_rise_rate = {100, 0};
  p.at_release.policy = ph::release_policy::hold;
  rig r(p);
  r.take_samples();
  r.port.read(r.time);
  ASSERT_TRUE(r.port.activate());
  r.port.write(r.wanted);
  EXPECT_EQ(r.device.currents, (ph::brake_currents<2>{0, 0.25})) << "nobody knows how long it was before";
  r.cycles(10);
  EXPECT_EQ(r.device.currents, r.wanted);
  r.port.release();
  r.cycle();
  EXPECT_EQ(r.device.currents, r.wanted) << "held";
  ASSERT_TRUE(r.port.rearm());
  ASSERT_TRUE(r.port.activate());
  r.cycle();
  EXPECT_NEAR(r.device.currents[0], 0.1, 1e-9);
}

TEST(the_currents, are_held_by_a_clock_that_goes_back) {
  auto p = usual();
  p.currents.max_rise_rate.fill(100);
  p.at_release.policy = ph::release_policy::hold;
  rig r(p);
  r.wanted = {0, 0};
  r.hold();
  r.wanted = {0.5, 0.25};
  r.cycles(10);
  r.cycle([](rig& s) { s.time -= 1; });
  EXPECT_EQ(r.port.reason().what, ph::fault::clock_jump);
  EXPECT_EQ(r.device.currents, r.wanted);
}

TEST(the_currents, warm_no_coil_after_they_were_released) {
  rig r;
  r.wanted = {1, 1};
  r.hold();
  r.port.release();
  r.time += 10;  // in which 1 A would make it far too warm
  r.cycle();
  ASSERT_TRUE(r.port.rearm());
  ASSERT_TRUE(r.port.activate());
  r.cycle();
  EXPECT_EQ(r.device.currents, r.wanted);
}

TEST(a_release_profile, is_known_by_its_time_alone) {
  using currents = ph::brake_currents<2>;
  const ph::release_start<2> start{5, {0.5, 0.25}};
  const auto of = [&](const ph::release_parameters& p) {
    ph::release_profile<2> profile(p);
    EXPECT_EQ(profile.start().time, 0);
    EXPECT_TRUE(profile.over(0)) << "nothing flows that was not begun";
    EXPECT_EQ(profile(0), currents{});
    profile.begin(start);
    EXPECT_EQ(profile.start().time, 5);
    EXPECT_EQ(profile.start().flowing, start.flowing);
    EXPECT_EQ(profile.is_at_once(), p.policy == ph::release_policy::zero);
    return profile;
  };
  const auto zero = of({});
  EXPECT_EQ(ph::release_parameters{}.max_duration(), 0);
  EXPECT_EQ(zero(5), currents{});
  EXPECT_TRUE(zero.over(5));

  const auto ramp = of({.policy = ph::release_policy::ramp, .ramp_time = 2, .hold_time = 8});
  EXPECT_EQ(ramp(5), start.flowing);
  EXPECT_EQ(ramp(5.5), (currents{0.375, 0.1875}));
  EXPECT_EQ(ramp(4.5), start.flowing) << "another process may have begun a little later";
  EXPECT_FALSE(ramp.over(6.875) || ramp.over(3.125));
  for (const double time : {7.0, 8.0, 3.0, fake::nan}) {
    EXPECT_EQ(ramp(time), currents{}) << time;
    EXPECT_TRUE(ramp.over(time)) << time;
  }

  const auto hold = of({.policy = ph::release_policy::hold, .ramp_time = 2, .hold_time = 8});
  for (const double time : {4.5, 5.0, 12.5, fake::nan}) {
    EXPECT_EQ(hold(time), start.flowing) << time;
    EXPECT_FALSE(hold.over(time)) << time;
  }
  for (const double time : {13.0, 1e9}) {
    EXPECT_EQ(hold(time), currents{}) << time;
    EXPECT_TRUE(hold.over(time)) << time;
  }
}

TEST(a_release_profile, holds_while_the_loop_attends_and_never_again_after_its_end) {
  using currents = ph::brake_currents<1>;
  ph::release_profile<1> hold({.policy = ph::release_policy::hold, .hold_time = 8});
  hold.begin({5, {0.5}});
  for (double time = 6; time < 60; time += 7.5) {
    EXPECT_EQ(hold(time), currents{0.5}) << time;
    hold.attend(time);
  }
  EXPECT_EQ(hold(66), currents{0.5});
  EXPECT_EQ(hold(67), currents{0}) << "8 s after 59";
  hold.attend(67);
  EXPECT_EQ(hold(67.1), currents{0}) << "what is over stays so";
  hold.take_over({67, {0.5}});
  EXPECT_EQ(hold(67.1), currents{0}) << "nobody raises what was let go";
  hold.begin({68, {0.25}});
  EXPECT_EQ(hold(69), currents{0.25});
  hold.take_over({67, {0.1}});
  EXPECT_EQ(hold(69), currents{0.1});
  hold.attend(69);
  hold.take_over({67, {0.1}});  // each cycle
  EXPECT_EQ(hold(76), currents{0.1}) << "8 s after the loop ran last";
}

TEST(a_release_policy, ramps_down_where_the_user_says_so) {
  auto p = usual();
  p.at_release = {ph::release_policy::ramp, 0.1};
  rig r(p);
  r.hold();
  r.port.release();
  EXPECT_EQ(r.port.state(), ph::port_state::released);
  double before = 0.5;
  for (int k = 1; k <= 100; ++k) {
    r.cycle();
    EXPECT_NEAR(r.device.currents[0], 0.5 * (1 - k / 100.0), 1e-6);
    EXPECT_NEAR(r.device.currents[1], 0.25 * (1 - k / 100.0), 1e-6);
    ASSERT_LE(r.device.currents[0], before);
    before = r.device.currents[0];
  }
  r.cycle();
  EXPECT_FALSE(r.device.flows());
}

TEST(a_release_policy, begins_its_ramp_with_the_last_cycle_before_a_pause) {
  auto p = usual();
  p.at_release = {ph::release_policy::ramp, 0.1};
  rig r(p);
  r.hold();
  r.time += 0.049;
  r.cycle();
  EXPECT_EQ(r.port.reason().what, ph::fault::cycle_late);
  EXPECT_NEAR(r.device.currents[0], 0.25, 1e-6) << "50 ms of 100";
}

TEST(a_release_policy, holds_where_the_user_says_so_and_lets_go_of_a_lost_device) {
  auto p = usual();
  p.at_release.policy = ph::release_policy::hold;
  rig r(p);
  r.hold();
  r.cycle([](rig& s) { s.wanted[0] = fake::nan; });
  EXPECT_EQ(r.port.state(), ph::port_state::released);
  r.wanted = {0.9, 0.9};
  r.cycles(50);
  EXPECT_EQ(r.device.currents, (ph::brake_currents<2>{0.5, 0.25}));
  r.cycle([](rig& s) { s.device.sensor_status = ph::port_status::failed; });
  EXPECT_TRUE(r.device.flows()) << "the sensor is not what holds";
  r.cycle([](rig& s) { s.device.read_status = ph::port_status::failed; });
  EXPECT_FALSE(r.device.flows());
}

TEST(a_release_policy, that_keeps_current_needs_a_device_with_a_watchdog) {
  for (const auto policy : {ph::release_policy::ramp, ph::release_policy::hold}) {
    auto p = usual();
    p.at_release.policy = policy;
    fake::device device;
    device.watchdog = 0;
    safe port({&device}, {&device}, p);
    EXPECT_EQ(port.open(),
              "at_release.policy, expected zero: a device without a watchdog keeps currents for ever");
    EXPECT_EQ(port.state(), ph::port_state::closed);
    EXPECT_GE(device.releases, 1);
    device.watchdog = 0.02;
    EXPECT_EQ(port.open(), "");
  }
  fake::device device;
  device.watchdog = 0;
  safe port({&device}, {&device});
  EXPECT_EQ(port.open(), "") << "0 A at once needs none";
}

TEST(a_release_policy, goes_on_from_where_another_process_began) {
  auto p = usual();
  p.at_release = {ph::release_policy::ramp, 0.1};
  rig r(p);
  r.hold();
  // 50 ms ago, from less than what flows here
  const ph::release_start<2> begun{r.time - 0.05, {0.4, 0.2}};
  for (int k = 1; k <= 60; ++k) {
    r.port.release({ph::fault::supervisor_lost}, begun);  // each cycle
    r.cycle();
    EXPECT_NEAR(r.device.currents[0], std::max(0.0, 0.4 * (0.5 - k / 100.0)), 1e-6);
  }
  EXPECT_EQ(r.port.reason().what, ph::fault::supervisor_lost);
}

// Stopped for longer than the hold, a loop finds a device that others let go of.
TEST(a_release_policy, that_holds_gives_nothing_after_the_loop_stood_still_for_longer) {
  for (const bool released : {false, true}) {
    auto p = usual();
    p.at_release = {.policy = ph::release_policy::hold, .hold_time = 0.5};
    rig r(p);
    r.hold();
    if (released) {
      r.port.release();
      r.cycles(1000);
      EXPECT_EQ(r.device.currents, r.wanted) << "while the loop runs";
    }
    r.device.currents = {};  // by the supervisor, or the device's watchdog
    r.time += 0.6;
    for (int k = 0; k < 100; ++k) {
      if (k % 2 == 0) r.port.release({ph::fault::supervisor_lost}, {{r.time - 0.59, {0.5, 0.25}}});
      r.cycle();
      ASSERT_EQ(r.device.currents, ph::brake_currents<2>{}) << "cycle " << k << ", released " << released;
      ASSERT_EQ(r.port.state(), ph::port_state::released);
    }
    EXPECT_TRUE(r.port.rearm());
  }
}

TEST(a_release_policy, that_another_process_ended_gives_nothing) {
  auto p = usual();
  p.at_release = {.policy = ph::release_policy::hold, .hold_time = 0.5};
  p.hold_over = 10;  // so that the stop itself is no fault here
  rig r(p);
  r.hold();
  const ph::release_start<2> begun{r.time + 0.01, {0.5, 0.25}};
  r.time += 0.6;
  r.port.release({ph::fault::supervisor_lost}, begun);
  r.cycle();
  EXPECT_EQ(r.device.currents, ph::brake_currents<2>{});
}

TEST(a_release_policy, is_not_begun_anew_after_the_program_let_go) {
  auto p = usual();
  p.at_release.policy = ph::release_policy::hold;
  rig r(p);
  r.hold();
  r.port.release_immediately();
  r.port.release({ph::fault::supervisor_lost}, {{r.time, {0.5, 0.25}}});
  r.cycles(3);
  EXPECT_EQ(r.device.currents, ph::brake_currents<2>{});
}

TEST(a_release_policy, whose_clock_is_none_gives_no_current) {
  for (const double time : {fake::nan, fake::infinite, -1.0}) {
    auto p = usual();
    p.at_release = {ph::release_policy::ramp, 0.1};
    rig r(p);
    r.hold();
    const double good = r.time;
    r.cycle([&](rig& s) { s.time = time; });
    r.time = good;
    EXPECT_EQ(r.port.reason().what, ph::fault::clock_jump);
    r.cycles(101);
    EXPECT_FALSE(r.device.flows()) << time;
  }
}

TEST(a_release_policy, ends_at_once_where_the_program_lets_go) {
  for (const auto policy : {ph::release_policy::zero, ph::release_policy::ramp, ph::release_policy::hold}) {
    auto p = usual();
    p.at_release.policy = policy;
    rig r(p);
    r.hold();
    r.port.release_immediately();
    EXPECT_FALSE(r.device.flows());
    EXPECT_EQ(r.port.applied(), ph::brake_currents<2>{});
    EXPECT_EQ(r.port.state(), ph::port_state::released);
    r.cycles(10);
    EXPECT_FALSE(r.device.flows());
  }
}

// What is told is what is known of the wire.
TEST(the_currents, that_a_device_refuses_are_not_said_to_flow) {
  rig r;
  r.hold();
  const auto refuse = [](rig& s) { s.device.write_status = ph::port_status::no_sample; };
  r.wanted = {0.1, 0.1};
  r.cycle(refuse);
  EXPECT_EQ(r.port.applied(), r.device.currents);
  EXPECT_FALSE(r.port.applied_is_known());
  EXPECT_FALSE(r.port.is_lost());
  EXPECT_EQ(r.port.pending_fault(), (ph::fault_record{ph::fault::write_refused, brakes}));
  r.cycle();
  EXPECT_EQ(r.port.applied(), r.wanted);
  EXPECT_TRUE(r.port.applied_is_known());
  EXPECT_EQ(r.port.pending_fault(), ph::fault_record{});
}

// A device that refuses all, a release too.
TEST(rearming, a_device_that_holds_and_refuses_is_told_as_it_is) {
  auto p = usual();
  p.at_release.policy = ph::release_policy::hold;
  rig r(p);
  r.hold();
  r.port.release();
  r.cycle();
  const auto refuse = [](rig& s) { s.device.write_status = ph::port_status::no_sample; };
  ASSERT_TRUE(r.port.rearm()) << "nobody knows yet";
  for (int k = 0; k < 5000; ++k) {
    r.cycle(refuse);
    const ph::brake_currents<2> applied = r.port.applied();
    ASSERT_TRUE(applied == r.device.currents || (k >= 19 && std::isnan(applied[0])))
        << "what is on the brakes, or after hold_over nobody knows";
    ASSERT_FALSE(r.port.applied_is_known());
    ASSERT_EQ(r.port.pending_fault(), (ph::fault_record{ph::fault::write_refused, brakes}));
    ASSERT_FALSE(r.port.activate());
  }
  EXPECT_EQ(r.port.state(), ph::port_state::released) << "not 'ready' while current flows";
  EXPECT_EQ(r.port.reason(), (ph::fault_record{ph::fault::write_refused, brakes}));
  EXPECT_FALSE(r.port.rearm()) << "while it refuses";
  r.cycles(1);
  EXPECT_TRUE(r.port.rearm());
  r.cycles(1);
  EXPECT_EQ(r.port.applied(), ph::brake_currents<2>{});
  EXPECT_FALSE(r.device.flows());
  EXPECT_TRUE(r.port.applied_is_known());
}

TEST(rearming, needs_good_samples) {
  for (const bool of_sensor : {false, true}) {
    rig r;
    r.hold();
    r.port.release();
    r.cycle([&](rig& s) {
      (of_sensor ? s.device.sensor_status : s.device.read_status) = ph::port_status::no_sample;
    });
    EXPECT_FALSE(r.port.rearm());
    EXPECT_EQ(r.port.state(), ph::port_state::released);
    r.cycle();
    EXPECT_TRUE(r.port.rearm());
  }
}

TEST(a_lost_device, has_no_current_that_anybody_knows) {
  for (const auto policy : {ph::release_policy::zero, ph::release_policy::ramp, ph::release_policy::hold})
    for (const bool reading : {false, true}) {
      auto p = usual();
      p.at_release.policy = policy;
      rig r(p);
      r.hold();
      const auto last = r.device.currents;
      const auto position = r.port.position();
      const int released = r.device.releases, written = r.device.writes;
      r.cycle([&](rig& s) {
        (reading ? s.device.read_status : s.device.write_status) = ph::port_status::failed;
      });
      for (int k = 0; k < 10; ++k) {
        EXPECT_GT(r.device.releases, released);
        EXPECT_EQ(r.port.applied(), last) << "the last that it is known to have taken, for hold_over";
        EXPECT_FALSE(r.port.applied_is_known());
        EXPECT_TRUE(r.port.is_lost());
        EXPECT_TRUE(r.port.needs_homing());
        r.cycle();
      }
      EXPECT_EQ(r.device.writes, written + !reading);
      if (reading) {
        EXPECT_EQ(r.port.position(), position) << "nothing is read any more";
      }
    }
}

// So that a supervisor, for which it is no heartbeat, tries its own way to the device.
TEST(a_release, that_the_device_does_not_take_for_hold_over_is_one_of_which_nobody_knows) {
  const auto unknown = [](const rig& r) { return std::isnan(r.port.applied()[0] + r.port.applied()[1]); };
  for (const bool lost : {false, true}) {
    rig r;
    r.hold();
    const auto spoil = [&](rig& s) {
      s.device.write_status = lost ? ph::port_status::failed : ph::port_status::no_sample;
    };
    int cycles = 0;
    for (; cycles < 100 && !unknown(r); ++cycles) r.cycle(spoil);
    EXPECT_EQ(r.port.state(), ph::port_state::released);
    EXPECT_LE(cycles, 22) << "20 ms without a transfer, and the cycle that sees it";
    EXPECT_GE(cycles, 20);
    r.cycle();
    EXPECT_EQ(unknown(r), lost) << "taken again";
  }
}

TEST(a_release_policy, holds_no_longer_than_a_coil_can_bear) {
  auto p = usual();
  p.at_release.policy = ph::release_policy::hold;
  rig r(p);
  r.wanted = {1, 1};
  r.hold();
  r.port.release();
  r.cycles(1000);
  EXPECT_LE(r.device.currents[0], 0.855 + 1e-12);
}

TEST(a_device_without_a_sensor, needs_none) {
  fake::device device;
  ph::safe_port<fake::port> port({&device});
  ASSERT_EQ(port.open(), "");
  for (int k = 1; k < 10; ++k) {
    device.sample.time = k * 1e-3;
    ++device.sample.sequence;
    port.read(k * 1e-3);
    port.activate();
    port.write({0.1, 0.1});
    EXPECT_EQ(port.state(), ph::port_state::active);
  }
  EXPECT_TRUE(device.flows());
}

TEST(a_safe_port, allocates_nothing_in_a_cycle) {
  rig r;
  r.hold();
  const std::function<void(rig&)> nothing, spoil = [](rig& s) { s.device.sample.value[0] = fake::nan; };
  EXPECT_EQ(allocations_in([&] {
              for (int k = 0; k < 100; ++k) r.cycle(k < 50 ? nothing : spoil);
              r.port.rearm();
              r.cycle();
            }),
            0);
}

TEST(the_parameters, of_a_safe_port_are_checked_by_name) {
  const auto error = [](auto&& change) {
    auto p = usual();
    change(p);
    return validate(p);
  };
  EXPECT_EQ(error([](auto&) {}), "");
  EXPECT_EQ(error([](auto& p) { p.currents.max_current[1] = -1; }),
            "currents.max_current[1] [A] = -1, expected a finite number > 0");
  EXPECT_EQ(error([](auto& p) { p.currents.heat[0] = fake::nan; }),
            "currents.heat[0] [A^2 s] = nan, expected a finite number > 0");
  EXPECT_EQ(error([](auto& p) { p.sensor.range[2] = 0; }),
            "sensor.range[2] = 0, expected a number > 0, or inf");
  EXPECT_EQ(error([](auto& p) { p.hold_over = 0; }), "hold_over [s] = 0, expected a finite number > 0");
  EXPECT_EQ(error([](auto& p) { p.at_release.ramp_time = 0; }),
            "at_release.ramp_time [s] = 0, expected a finite number > 0");
  auto p = usual();
  p.hold_over = -1;
  fake::device device;
  EXPECT_THROW(safe({&device}, {&device}, p), std::invalid_argument);
}
