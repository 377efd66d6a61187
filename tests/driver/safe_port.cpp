#include "../realtime/allocations.hpp"
#include "fake_device.hpp"

#include <gtest/gtest.h>
#include <passive_haptics/driver/safe_port.hpp>

#include <functional>
#include <vector>

namespace ph = passive_haptics;

namespace {

using safe = ph::safe_port<fake::port, fake::sensor>;
using status = ph::port_status;
using currents = ph::brake_currents<2>;
using fake::infinite;
using enum ph::fault;
constexpr auto encoders = ph::fault_source::encoders;
constexpr auto sensor = ph::fault_source::force_sensor;
constexpr auto brakes = ph::fault_source::brakes;

safe::parameters usual() {
  safe::parameters p;
  p.encoders.frozen_travel = 2048;
  p.sensor.range.fill(100);
  p.currents.max_current.fill(1);
  p.currents.continuous.fill(0.9);
  p.currents.heat.fill(0.05);
  return p;
}
safe::parameters released_by(const ph::release_parameters& at_release) {
  auto p = usual();
  p.at_release = at_release;
  return p;
}
constexpr ph::release_parameters ramp{.policy = ph::release_policy::ramp, .ramp_time = 0.1},
    hold{.policy = ph::release_policy::hold}, hold_half_a_second{.policy = hold.policy, .hold_time = 0.5};

// A device that moves slowly and is cycled at 1 kHz.
struct rig {
  explicit rig(const safe::parameters& p = usual(), int counter_bits = 0) : port({&device}, {&device}, p) {
    device.counter_bits = counter_bits;
    if (!port.open().empty()) throw std::runtime_error("the fake device is there");
  }
  explicit rig(const ph::release_parameters& at_release) : rig(released_by(at_release)) {}

  // What a good device tells next.
  void take_samples() {
    time += 1e-3;
    sample.time = force.time = time;
    ++sample.sequence;
    ++force.sequence;
    for (double& count : sample.value) count += 3;
    force.value[0] = 1 + 0.1 * time;
  }
  void transfer() {
    port.read(time);
    port.write(wanted);
  }
  void cycle() {
    take_samples();
    transfer();
  }
  // One cycle; `spoil` changes what the device tells, not what it does.
  void cycle(const std::function<void(rig&)>& spoil) {
    const auto counts = sample.value;
    const auto forces = force.value;
    take_samples();
    spoil(*this);
    transfer();
    sample.value = {counts[0] + 3, counts[1] + 3};
    force.value = forces;
    sample.valid = {true, true};
    force.valid = {true, true, true};
    device.read_status = device.sensor_status = device.write_status = ph::port_status::ok;
  }
  void cycles(int count) {
    for (int k = 0; k < count; ++k) cycle();
  }
  void activate() {
    cycle();
    ASSERT_TRUE(port.activate());
  }
  void hold() {
    activate();
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
  ph::port_sample<2>& sample = device.sample;
  ph::port_sample<3>& force = device.force;
  double time = 100;
  ph::brake_currents<2> wanted{0.5, 0.25};
  safe port;
};
void say_nothing(rig& r) { r.device.read_status = status::no_sample; }
void refuse(rig& r) { r.device.write_status = status::no_sample; }

// Cycles until 0 A, at most; and what is there to do once the fault is over.
struct ending {
  int cycles;
  bool rearmable;
};
// 20 ms at 1 kHz, and the cycle that sees that they are over
constexpr ending held{21, true}, held_home{21, false}, once{1, true}, once_home{1, false};

struct fault_case {
  const char* name;
  ph::fault_record expected;
  ending end;
  std::function<void(rig&)> spoil;
};

const std::vector<fault_case> all_faults{
    {"NaN_encoder", {value_not_finite, encoders, 1}, held_home, [](rig& r) { r.sample.value[1] = NAN; }},
    {"infinity", {value_not_finite, encoders, 0}, held_home, [](rig& r) { r.sample.value[0] = -infinite; }},
    {"no_count", {count_out_of_range, encoders, 0}, held_home, [](rig& r) { r.sample.value[0] = 1e300; }},
    {"invalid_axis", {channel_invalid, encoders, 0}, held_home, [](rig& r) { r.sample.valid[0] = false; }},
    {"encoder_jump", {encoder_jump, encoders, 1}, held_home, [](rig& r) { r.sample.value[1] += 5000; }},
    {"silence_of_the_device", {sample_missing, encoders}, held, say_nothing},
    {"torn", {sample_damaged, encoders}, held, [](rig& r) { r.device.read_status = status::bad_sample; }},
    {"duplicate", {sample_repeated, encoders}, held, [](rig& r) { --r.sample.sequence; }},
    {"reordering", {sample_out_of_order, encoders}, held_home, [](rig& r) { r.sample.sequence -= 2; }},
    {"wrong_sequence", {device_restarted, encoders}, once_home, [](rig& r) { r.sample.sequence += 5000; }},
    {"restart", {device_restarted, encoders}, once_home, [](rig& r) { r.sample.sequence -= 5000; }},
    {"sample_of_a_second_ago", {sample_late, encoders}, held, [](rig& r) { r.sample.time -= 1; }},
    {"sample_of_tomorrow", {sample_late, encoders}, held, [](rig& r) { r.sample.time += 1e5; }},
    {"sample_without_a_time", {sample_late, encoders}, held, [](rig& r) { r.sample.time = NAN; }},
    {"no_reading", {device_lost, encoders}, once_home, [](rig& r) { r.device.read_status = status::failed; }},
    {"no_writing", {device_lost, brakes}, once_home, [](rig& r) { r.device.write_status = status::failed; }},
    {"short", {write_refused, brakes}, held, [](rig& r) { r.device.write_status = status::bad_sample; }},
    {"full_buffer", {write_refused, brakes}, held, refuse},
    {"sensor_saturation", {sensor_saturated, sensor, 2}, held, [](rig& r) { r.force.value[2] = -100; }},
    {"sensor_not_a_number", {value_not_finite, sensor, 0}, held, [](rig& r) { r.force.value[0] = NAN; }},
    {"invalid_force", {channel_invalid, sensor, 1}, held, [](rig& r) { r.force.valid[1] = false; }},
    {"stale_sensor", {sample_repeated, sensor}, held, [](rig& r) { --r.force.sequence; }},
    {"no_force", {sample_missing, sensor}, held, [](rig& r) { r.device.sensor_status = status::no_sample; }},
    {"torn_force",
     {sample_damaged, sensor},
     held,
     [](rig& r) { r.device.sensor_status = status::bad_sample; }},
    {"sensor_gone", {device_lost, sensor}, once, [](rig& r) { r.device.sensor_status = status::failed; }},
    {"NaN_command", {current_not_valid, brakes, 1}, once, [](rig& r) { r.wanted[1] = NAN; }},
    {"infinite_command", {current_not_valid, brakes, 0}, once, [](rig& r) { r.wanted[0] = infinite; }},
    {"negative_command", {current_not_valid, brakes, 0}, once, [](rig& r) { r.wanted[0] = -1e-300; }},
    {"pause_of_the_loop", {cycle_late}, once, [](rig& r) { r.sample.time = r.force.time = r.time += 0.5; }},
    {"clock_that_goes_back", {clock_jump}, once, [](rig& r) { r.time -= 0.01; }},
    {"clock_that_is_none", {clock_jump}, once, [](rig& r) { r.time = NAN; }},
    {"suspended_machine", {suspended}, once_home, [](rig& r) { r.port.release({suspended}); }},
};

class a_fault : public ::testing::TestWithParam<fault_case> {};

}  // namespace

TEST_P(a_fault, releases_the_brakes_in_time_and_says_why) {
  rig r;
  r.hold();
  EXPECT_LE(r.cycles_to_release(GetParam().spoil), GetParam().end.cycles);
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
  EXPECT_EQ(r.port.needs_homing(), !GetParam().end.rearmable);
  EXPECT_EQ(r.port.rearm(), GetParam().end.rearmable);
  EXPECT_EQ(r.port.state(), GetParam().end.rearmable ? ph::port_state::ready : ph::port_state::released);
  r.cycles(2);
  EXPECT_FALSE(r.device.flows()) << "ready gives no current, either";
  if (!GetParam().end.rearmable) return;
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
  if (GetParam().end.cycles == 1) {
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
  EXPECT_EQ(r.port.open(), "open() was called before: the device is open");
  r.cycle();
  EXPECT_EQ(r.device.currents, r.wanted);
}

TEST(a_safe_port, tells_the_last_good_reading_of_each_sensor_and_when_that_was) {
  rig r;
  EXPECT_EQ(r.port.position_time(), 0) << "never";
  r.cycles(3);
  const auto good = r.force.value;
  const double last = r.port.position_time();
  EXPECT_EQ(r.port.force(), good);
  EXPECT_EQ(last, r.sample.time);
  r.cycle([](rig& s) { s.force.value[2] = NAN, s.sample.value[1] += 5000; });
  EXPECT_EQ(r.port.force(), good);
  EXPECT_EQ(r.port.position_time(), last);
  r.cycle(say_nothing);
  EXPECT_EQ(r.port.position_time(), last);
  r.take_samples();
  r.sample.time -= 0.004;  // what the sample says, not when it was read
  r.port.read(r.time);
  EXPECT_EQ(r.port.position_time(), r.time - 0.004);
  EXPECT_EQ(r.port.force(), r.force.value);
  EXPECT_NE(r.port.force(), good);
}

TEST(a_safe_port, sees_times_that_look_like_those_of_arrival) {
  for (const bool of_arrival : {false, true}) {
    rig r;
    r.hold();
    for (int k = 0; k < 300; ++k) {
      r.take_samples();
      if (of_arrival && k % 2 == 0) r.sample.time -= 0.9e-3;
      r.transfer();
    }
    EXPECT_EQ(r.port.arrivals().found(), of_arrival);
    EXPECT_EQ(r.port.state(), ph::port_state::active);
  }
}

TEST(a_safe_port, follows_a_sensor_that_restarted) {
  rig r;
  r.hold();
  r.cycle([](rig& s) { s.force.sequence += 5000; });
  EXPECT_EQ(r.port.state(), ph::port_state::degraded);
  EXPECT_EQ(r.port.pending_fault(), (ph::fault_record{device_restarted, sensor}));
  for (int k = 0; k < 30; ++k) {
    r.cycle();
    ASSERT_EQ(r.port.state(), ph::port_state::active) << "a force has no home to lose";
    ASSERT_EQ(r.port.force(), r.force.value);
  }
  r.cycle([](rig& s) { --s.force.sequence; });
  EXPECT_EQ(r.port.pending_fault().what, sample_repeated) << "its numbers are looked at again";
}

TEST(a_safe_port, looks_at_no_command_while_nothing_flows) {
  rig r;
  r.cycle([](rig& s) { s.wanted = {NAN, -1}; });
  EXPECT_EQ(r.port.state(), ph::port_state::ready);
  EXPECT_EQ(r.port.reason(), ph::fault_record{});
  EXPECT_FALSE(r.device.flows());
}

TEST(a_safe_port, cannot_be_activated_without_a_good_sample) {
  rig r;
  EXPECT_FALSE(r.port.activate()) << "none yet";
  r.cycle(say_nothing);
  EXPECT_FALSE(r.port.activate());
  for (int k = 0; k < 50; ++k) r.cycle([](rig& s) { s.sample.valid[0] = false; });
  r.cycle([](rig& s) { s.force.value[0] = 100; });
  EXPECT_FALSE(r.port.activate());
  EXPECT_FALSE(r.port.rearm()) << "it is not released";
  r.cycle();
  EXPECT_TRUE(r.port.activate()) << "nor had it a position to lose before";
}

TEST(a_safe_port, whose_encoder_jumps_for_too_long_is_not_activated_any_more) {
  rig r;
  r.cycles(3);
  for (int k = 0; k < 25; ++k) r.cycle([](rig& s) { s.sample.value[0] += 5000; });
  EXPECT_TRUE(r.port.needs_homing());
  r.cycles(3);
  EXPECT_FALSE(r.port.activate());
  EXPECT_EQ(r.port.reason(), (ph::fault_record{encoder_jump, encoders, 0}));
}

TEST(a_safe_port, that_could_not_be_opened_says_what_is_missing_and_does_nothing) {
  fake::device device;
  device.sensor_missing = "no sensor at 192.0.2.1";
  {
    safe port({&device}, {&device});
    EXPECT_EQ(port.open(), "no sensor at 192.0.2.1");
    device.read_status = status::failed;
    EXPECT_EQ(port.read(1), ph::port_state::closed);
    EXPECT_EQ(port.write({1, 1}), ph::port_state::closed);
    EXPECT_FALSE(port.activate() || port.rearm());
    port.release();
    EXPECT_EQ(port.state(), ph::port_state::closed);
    EXPECT_EQ(device.writes, 0);
    device.sensor_missing = "";
    EXPECT_EQ(port.open(), "") << "plugged in meanwhile";
    device.currents = {1, 1};
  }
  EXPECT_FALSE(device.flows()) << "released when the port ends";
  device.encoders_missing = "no device";
  safe port({&device}, {&device});
  EXPECT_EQ(port.open(), "no device");
}

TEST(a_safe_port, follows_counters_past_their_wrap) {
  rig r(usual(), 16);
  r.sample.value = {65000, 300};
  r.activate();
  for (int k = 1; k <= 4000; ++k) {
    r.cycle([k](rig& s) {
      s.sample.value = {std::fmod(65003.0 + 100 * k, 65536), std::fmod(65536 * 8 + 303.0 - 100 * k, 65536)};
    });
    ASSERT_EQ(r.port.state(), ph::port_state::active) << to_string(r.port.pending_fault());
    ASSERT_EQ(r.port.position(), (std::array<double, 2>{65003.0 + 100 * k, 303.0 - 100 * k}));
  }
}

// Of all widths and pauses: tests/stress/encoder_pauses.cpp.
TEST(a_counter, that_may_have_wrapped_unseen_needs_homing_in_each_state) {
  const ph::fault_record wrapped{counter_wrapped, encoders};
  EXPECT_EQ(ph::wrap_time(12, 2e5), 2046 / 2e5);
  EXPECT_EQ(ph::wrap_time(0, 2e5), infinite);
  for (const double pause : {2045 / 2e5, 2046 / 2e5, 0.5})
    for (const auto state : {ph::port_state::ready, ph::port_state::active, ph::port_state::degraded,
                             ph::port_state::released}) {
      rig r(usual(), 12);
      r.sample.value = {1000, 3000};
      r.cycles(20);
      if (state != ph::port_state::ready) r.activate();
      r.cycle();
      if (state == ph::port_state::degraded) r.cycle([](rig& s) { s.force.value[2] = NAN; });
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
      r.sample.time = 100 + 1e-3 * k;
      r.transfer();
    }
    EXPECT_EQ(r.port.activate(), slow == 9) << slow << " of 20 spacings in which it can wrap";
    EXPECT_EQ(r.port.needs_homing(), slow == 11);
  }
}

TEST(a_safe_port, holds_over_a_gap_in_the_sequence_and_lets_the_device_go_on_meanwhile) {
  rig r;
  r.sample.sequence = 0xFFFFFFF0u;  // and counts past the end
  r.hold();
  const auto before = r.port.position();
  for (int k = 0; k < 15; ++k) {
    r.cycle(say_nothing);
    for (double& count : r.sample.value) count += 147;  // faster than a jump of one cycle
    ASSERT_EQ(r.port.state(), ph::port_state::degraded);
  }
  r.cycle();
  EXPECT_EQ(r.port.state(), ph::port_state::active) << to_string(r.port.pending_fault());
  EXPECT_EQ(r.port.position()[0], before[0] + 15 * 150 + 3);
}

TEST(a_frozen_encoder, is_noticed_after_the_others_turned_so_far_without_a_brake) {
  rig r;
  r.wanted = {0, 0};
  r.activate();
  const double frozen = r.sample.value[1];
  int k = 0;
  for (; r.port.state() != ph::port_state::released && k < 2000; ++k) {
    r.cycle([&](rig& s) { s.sample.value[1] = frozen; });
    r.sample.value[1] = frozen;
  }
  EXPECT_EQ(r.port.reason(), (ph::fault_record{encoder_frozen, encoders, 1}));
  EXPECT_NEAR(k, 2048.0 / 3, 2) << "cycles of 3 counts";
  r.cycles(5);
  EXPECT_FALSE(r.port.rearm()) << "nobody knows how far it went";
  EXPECT_TRUE(r.port.needs_homing());
}

TEST(a_frozen_encoder, is_none_where_a_brake_holds_it_or_where_it_moves_now_and_then) {
  for (const bool braked : {true, false}) {
    rig r;
    if (!braked) r.wanted = {0, 0};
    r.hold();
    double slow = r.sample.value[1];
    for (int k = 1; k <= 3000; ++k) {  // 9000 counts of the other
      if (!braked && k % 300 == 0) ++slow;
      r.sample.value[1] = slow - 3;
      r.cycle();
      ASSERT_EQ(r.port.state(), ph::port_state::active)
          << "cycle " << k << ": " << to_string(r.port.reason());
    }
  }
}

TEST(a_sample, is_of_nothing_by_default) {
  const ph::port_sample<2> sample;
  EXPECT_EQ(sample.time + sample.value[0] + sample.value[1] + sample.sequence, 0);
  EXPECT_FALSE(sample.valid[0] || sample.valid[1]);
}

// Unsigned or signed, the first sample too; without a width, as far as a double tells one count from the
// next.
TEST(an_encoder_check, takes_only_counts_that_the_counter_has) {
  const auto takes = [](int bits, double count) {
    ph::encoder_check<1> first({}), later({.max_rate = bits > 0 ? 100 : 1e300});
    first.set_counter_bits(bits);
    later.set_counter_bits(bits);
    const bool taken = first({0, 0, {count}, {true}}, true) == ph::fault_record{};
    EXPECT_EQ(first.position()[0], taken ? count : 0);
    later({0, 0, {-64}, {true}}, true);  // from where no good count is further than 64
    EXPECT_EQ(later({1, 1, {count}, {true}}, true) == ph::fault_record{}, taken) << bits << ", " << count;
    return taken;
  };
  for (const double good : {0.0, 255.0, 255.75, -1.0, -128.0}) EXPECT_TRUE(takes(8, good)) << good;
  for (const double bad : {256.0, -128.5, 1e6, 1e300, -1e300, double(NAN), infinite})
    EXPECT_FALSE(takes(8, bad)) << bad;
  EXPECT_TRUE(takes(24, 16777215));
  EXPECT_FALSE(takes(24, 16777216));
  for (const double good : {0.0, 1e15, -1e15}) EXPECT_TRUE(takes(0, good)) << good;
  for (const double bad : {1e16, -1e16, 1e300, double(NAN)}) EXPECT_FALSE(takes(0, bad)) << bad;
}

TEST(an_encoder_check, loses_no_count_where_each_tenth_sample_is_none) {
  ph::encoder_check<1> check({});
  check.set_counter_bits(24);
  for (std::uint32_t k = 0; k < 3000; ++k) {
    const bool spoilt = k % 10 == 9;
    const auto found = check({1e-3 * k, k, {spoilt ? 1e300 : 10.0 * k}, {true}}, false);
    ASSERT_EQ(found.what, spoilt ? count_out_of_range : none) << k;
    ASSERT_EQ(check.position()[0], 10.0 * (spoilt ? k - 1 : k));
  }
}

TEST(a_jump, cannot_be_waited_out) {
  ph::encoder_check<1> check({.max_rate = 1000});
  EXPECT_EQ(check({0, 0, {0}, {true}}, true).what, none);
  for (int k = 1; k <= 5000; ++k)  // 5 s, in which it could have gone 5000 counts
    ASSERT_EQ(check({1e-3 * k, 0, {100}, {true}}, true).what, encoder_jump) << k;
  EXPECT_EQ(check.position()[0], 0);
}

// A loose plug: no fault lasts for hold_over.
TEST(rejected_samples, release_the_brakes_if_they_are_a_quarter_of_those_that_arrived) {
  struct plug {
    ph::fault_record expected;
    bool rearmable;
    std::function<void(rig&)> spoil;
  };
  for (const plug& p : std::vector<plug>{
           {{encoder_jump, encoders, 0}, false, [](rig& r) { r.sample.value[0] += 1000; }},
           {{count_out_of_range, encoders, 0}, false, [](rig& r) { r.sample.value[0] = 1e300; }},
           {{channel_invalid, encoders, 1}, false, [](rig& r) { r.sample.valid[1] = false; }},
           {{value_not_finite, encoders, 1}, false, [](rig& r) { r.sample.value[1] = NAN; }},
           {{sample_damaged, encoders}, true, [](rig& r) { r.device.read_status = status::bad_sample; }},
           {{sample_damaged, sensor}, true, [](rig& r) { r.device.sensor_status = status::bad_sample; }},
           {{sensor_saturated, sensor, 1}, true, [](rig& r) { r.force.value[1] = 100; }}})
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
  EXPECT_FALSE(too_many_after(0, 9, encoder_jump)) << "too early to say";
  EXPECT_TRUE(too_many_after(9, 10, encoder_jump));
  EXPECT_TRUE(too_many_after(10, 17, none)) << "24 of 80";
  EXPECT_FALSE(too_many_after(17, 18, none)) << "16 of 80";
  EXPECT_EQ(samples.arrived(), 144u);
  EXPECT_EQ(samples.rejected(), 80u);
  EXPECT_TRUE(too_many_after(18, 28, encoder_jump));
  EXPECT_FALSE(too_many_after(40, 49, encoder_jump)) << "too early to say after a pause";
  ph::rejected_samples quarter(1);
  for (int k = 0; k < 80; ++k) quarter.add(k % 4 == 0 ? encoder_jump : none, 0.125 * k);
  EXPECT_TRUE(quarter.is_too_many()) << "20 of 80";
}

TEST(rejected_samples, are_a_share_of_those_that_arrived_not_of_the_reads) {
  // A device slower than the loop, or behind an adapter that waits for 16 samples; each of so many jumps, 0:
  // none
  const auto flows = [](int reads_a_sample, int jumps) {
    rig r;
    r.hold();
    for (int k = 0; k < 2000; ++k)
      r.cycle([&](rig& s) {
        if (k % reads_a_sample != 0) say_nothing(s);
        else if (jumps > 0 && k / reads_a_sample % jumps == 0) s.sample.value[0] += 5000;
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
    EXPECT_EQ(check.position()[1], found.what == none ? -3 + moved : -3);
    return found;
  };
  const ph::fault_record jump{encoder_jump, encoders, 1};
  for (const double side : {1.0, -1.0}) {
    EXPECT_EQ(after(0.0625, side * 64), ph::fault_record{});
    EXPECT_EQ(after(0.0625, side * 65), jump);
    EXPECT_EQ(after(0, side * 2), ph::fault_record{});
    EXPECT_EQ(after(-0.0625, side * 2), ph::fault_record{}) << "a time that goes back is none that went by";
    EXPECT_EQ(after(-0.0625, side * 3), jump);
  }
  EXPECT_EQ(after(1, NAN), (ph::fault_record{count_out_of_range, encoders, 1}));
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

TEST(an_encoder_check, gives_an_encoder_a_turn_of_8192_counts_by_default_or_for_ever) {
  ph::encoder_check<2> usual_travel({}), no_travel({.frozen_travel = 0});
  for (int k = 0; k <= 64; ++k)
    for (auto* check : {&usual_travel, &no_travel})
      ASSERT_EQ((*check)({1e-3 * k, 0, {128.0 * k, 0}, {true, true}}, true), ph::fault_record{}) << k;
  EXPECT_EQ(usual_travel({0.065, 0, {8193, 0}, {true, true}}, true).channel, 1);
  EXPECT_EQ(no_travel({0.065, 0, {8193, 0}, {true, true}}, true), ph::fault_record{});
}

TEST(a_current_limiter, clamps_slows_and_spares_each_coil) {
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

TEST(the_currents, rise_no_faster_than_they_may_fall_at_once_and_rise_again_after_a_release) {
  auto p = released_by(hold);
  p.currents.max_rise_rate = {100, 0};
  rig r(p);
  r.take_samples();
  r.port.read(r.time);
  ASSERT_TRUE(r.port.activate());
  r.wanted = {1e300, 0.25};
  r.port.write(r.wanted);
  EXPECT_EQ(r.device.currents, (currents{0, 0.25})) << "nobody knows how long it was before";
  for (int k = 1; k <= 10; ++k) {
    r.cycle();
    EXPECT_NEAR(r.device.currents[0], 0.1 * k, 1e-9);
    EXPECT_EQ(r.port.applied(), r.device.currents);
  }
  r.cycle();
  EXPECT_EQ(r.device.currents, (currents{1, 0.25})) << "the limit";
  r.wanted = {0.5, 0};
  r.cycle();
  EXPECT_EQ(r.device.currents, r.wanted);
  r.port.release();
  r.cycle();
  EXPECT_EQ(r.device.currents, r.wanted) << "held";
  ASSERT_TRUE(r.port.rearm());
  ASSERT_TRUE(r.port.activate());
  r.cycle();
  EXPECT_NEAR(r.device.currents[0], 0.1, 1e-9);
  r.cycles(10);
  r.cycle([](rig& s) { s.time -= 1; });
  EXPECT_EQ(r.port.reason().what, clock_jump);
  EXPECT_EQ(r.device.currents, r.wanted) << "held by a clock that goes back";
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
  EXPECT_EQ(ph::release_parameters{}.max_duration(), 0);
  const auto expect_over = [](const ph::release_profile<2>& profile, std::initializer_list<double> times) {
    for (const double time : times) {
      EXPECT_EQ(profile(time), currents{}) << time;
      EXPECT_TRUE(profile.over(time)) << time;
    }
  };
  expect_over(of({}), {5});

  const auto ramp = of({.policy = ph::release_policy::ramp, .ramp_time = 2, .hold_time = 8});
  EXPECT_EQ(ramp(5), start.flowing);
  EXPECT_EQ(ramp(5.5), (currents{0.375, 0.1875}));
  EXPECT_EQ(ramp(4.5), start.flowing) << "another process may have begun a little later";
  EXPECT_FALSE(ramp.over(6.875) || ramp.over(3.125));
  expect_over(ramp, {7.0, 8.0, 3.0, NAN});

  const auto hold = of({.policy = ph::release_policy::hold, .ramp_time = 2, .hold_time = 8});
  for (const double time : {4.5, 5.0, 12.5, double(NAN)}) {
    EXPECT_EQ(hold(time), start.flowing) << time;
    EXPECT_FALSE(hold.over(time)) << time;
  }
  expect_over(hold, {13.0, 1e9});
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
  rig r(ramp);
  r.hold();
  r.port.release();
  EXPECT_EQ(r.port.state(), ph::port_state::released);
  for (int k = 1; k <= 100; ++k) {
    r.cycle();
    EXPECT_NEAR(r.device.currents[0], 0.5 * (1 - k / 100.0), 1e-6);
    EXPECT_NEAR(r.device.currents[1], 0.25 * (1 - k / 100.0), 1e-6);
  }
  r.cycle();
  EXPECT_FALSE(r.device.flows());
}

TEST(a_release_policy, begins_its_ramp_with_the_last_cycle_before_a_pause) {
  rig r(ramp);
  r.hold();
  r.time += 0.049;
  r.cycle();
  EXPECT_EQ(r.port.reason().what, cycle_late);
  EXPECT_NEAR(r.device.currents[0], 0.25, 1e-6) << "50 ms of 100";
}

TEST(a_release_policy, holds_where_the_user_says_so_and_lets_go_of_a_lost_device) {
  rig r(hold);
  r.hold();
  r.cycle([](rig& s) { s.wanted[0] = NAN; });
  EXPECT_EQ(r.port.state(), ph::port_state::released);
  r.wanted = {0.9, 0.9};
  r.cycles(50);
  EXPECT_EQ(r.device.currents, (currents{0.5, 0.25}));
  r.cycle([](rig& s) { s.device.sensor_status = status::failed; });
  EXPECT_TRUE(r.device.flows()) << "the sensor is not what holds";
  r.cycle([](rig& s) { s.device.read_status = status::failed; });
  EXPECT_FALSE(r.device.flows());
}

TEST(a_release_policy, that_keeps_current_needs_a_device_with_a_watchdog) {
  for (const auto& at_release : {ramp, hold, ph::release_parameters{}}) {
    fake::device device;
    device.watchdog = 0;
    safe port({&device}, {&device}, released_by(at_release));
    if (at_release.policy != ph::release_policy::zero) {  // 0 A at once needs none
      EXPECT_EQ(port.open(),
                "at_release.policy, expected zero: a device without a watchdog keeps currents for ever");
      EXPECT_EQ(port.state(), ph::port_state::closed);
      EXPECT_GE(device.releases, 1);
      device.watchdog = 0.02;
    }
    EXPECT_EQ(port.open(), "");
  }
}

TEST(a_release_policy, goes_on_from_where_another_process_began) {
  rig r(ramp);
  r.hold();
  // 50 ms ago, from less than what flows here
  const ph::release_start<2> begun{r.time - 0.05, {0.4, 0.2}};
  for (int k = 1; k <= 60; ++k) {
    r.port.release({supervisor_lost}, begun);  // each cycle
    r.cycle();
    EXPECT_NEAR(r.device.currents[0], std::max(0.0, 0.4 * (0.5 - k / 100.0)), 1e-6);
  }
  EXPECT_EQ(r.port.reason().what, supervisor_lost);
}

// Stopped for longer than the hold, a loop finds a device that others let go of.
TEST(a_release_policy, that_holds_gives_nothing_after_the_loop_stood_still_for_longer) {
  for (const bool released : {false, true}) {
    rig r(hold_half_a_second);
    r.hold();
    if (released) {
      r.port.release();
      r.cycles(1000);
      EXPECT_EQ(r.device.currents, r.wanted) << "while the loop runs";
    }
    r.device.currents = {};  // by the supervisor, or the device's watchdog
    r.time += 0.6;
    for (int k = 0; k < 100; ++k) {
      if (k % 2 == 0) r.port.release({supervisor_lost}, {{r.time - 0.59, {0.5, 0.25}}});
      r.cycle();
      ASSERT_EQ(r.device.currents, currents{}) << "cycle " << k << ", released " << released;
      ASSERT_EQ(r.port.state(), ph::port_state::released);
    }
    EXPECT_TRUE(r.port.rearm());
  }
}

TEST(a_release_policy, that_another_process_ended_gives_nothing) {
  auto p = released_by(hold_half_a_second);
  p.hold_over = 10;  // so that the stop itself is no fault here
  rig r(p);
  r.hold();
  const ph::release_start<2> begun{r.time + 0.01, {0.5, 0.25}};
  r.time += 0.6;
  r.port.release({supervisor_lost}, begun);
  r.cycle();
  EXPECT_EQ(r.device.currents, currents{});
}

TEST(a_release_policy, whose_clock_is_none_gives_no_current) {
  for (const double time : {double(NAN), infinite, -1.0}) {
    rig r(ramp);
    r.hold();
    const double good = r.time;
    r.cycle([&](rig& s) { s.time = time; });
    r.time = good;
    EXPECT_EQ(r.port.reason().what, clock_jump);
    r.cycles(101);
    EXPECT_FALSE(r.device.flows()) << time;
  }
}

TEST(a_release_policy, ends_at_once_and_for_good_where_the_program_lets_go) {
  for (const auto& at_release : {ph::release_parameters{}, ramp, hold}) {
    rig r(at_release);
    r.hold();
    r.port.release_immediately();
    EXPECT_FALSE(r.device.flows());
    EXPECT_EQ(r.port.applied(), currents{});
    EXPECT_EQ(r.port.state(), ph::port_state::released);
    r.port.release({supervisor_lost}, {{r.time, {0.5, 0.25}}});
    r.cycles(10);
    EXPECT_FALSE(r.device.flows());
  }
}

TEST(a_release_policy, holds_no_longer_than_a_coil_can_bear) {
  rig r(hold);
  r.wanted = {1, 1};
  r.hold();
  r.port.release();
  r.cycles(1000);
  EXPECT_LE(r.device.currents[0], 0.855 + 1e-12);
}

// What is told is what is known of the wire.
TEST(the_currents, that_a_device_refuses_are_not_said_to_flow) {
  rig r;
  r.hold();
  r.wanted = {0.1, 0.1};
  r.cycle(refuse);
  EXPECT_EQ(r.port.applied(), r.device.currents);
  EXPECT_FALSE(r.port.applied_is_known());
  EXPECT_FALSE(r.port.is_lost());
  EXPECT_EQ(r.port.pending_fault(), (ph::fault_record{write_refused, brakes}));
  r.cycle();
  EXPECT_EQ(r.port.applied(), r.wanted);
  EXPECT_TRUE(r.port.applied_is_known());
  EXPECT_EQ(r.port.pending_fault(), ph::fault_record{});
}

// A device that refuses all, a release too.
TEST(rearming, a_device_that_holds_and_refuses_is_told_as_it_is) {
  rig r(hold);
  r.hold();
  r.port.release();
  r.cycle();
  ASSERT_TRUE(r.port.rearm()) << "nobody knows yet";
  for (int k = 0; k < 5000; ++k) {
    r.cycle(refuse);
    const currents applied = r.port.applied();
    ASSERT_TRUE(applied == r.device.currents || (k >= 19 && std::isnan(applied[0])))
        << "what is on the brakes, or after hold_over nobody knows";
    ASSERT_FALSE(r.port.applied_is_known());
    ASSERT_EQ(r.port.pending_fault(), (ph::fault_record{write_refused, brakes}));
    ASSERT_FALSE(r.port.activate());
  }
  EXPECT_EQ(r.port.state(), ph::port_state::released) << "not 'ready' while current flows";
  EXPECT_EQ(r.port.reason(), (ph::fault_record{write_refused, brakes}));
  EXPECT_FALSE(r.port.rearm()) << "while it refuses";
  r.cycles(1);
  EXPECT_TRUE(r.port.rearm());
  r.cycles(1);
  EXPECT_EQ(r.port.applied(), currents{});
  EXPECT_FALSE(r.device.flows());
  EXPECT_TRUE(r.port.applied_is_known());
}

TEST(rearming, needs_good_samples) {
  for (const bool of_sensor : {false, true}) {
    rig r;
    r.hold();
    r.port.release();
    r.cycle([&](rig& s) { (of_sensor ? s.device.sensor_status : s.device.read_status) = status::no_sample; });
    EXPECT_FALSE(r.port.rearm());
    EXPECT_EQ(r.port.state(), ph::port_state::released);
    r.cycle();
    EXPECT_TRUE(r.port.rearm());
  }
}

TEST(a_lost_device, has_no_current_that_anybody_knows) {
  for (const auto& at_release : {ph::release_parameters{}, ramp, hold})
    for (const bool reading : {false, true}) {
      rig r(at_release);
      r.hold();
      const auto last = r.device.currents;
      const auto position = r.port.position();
      const int released = r.device.releases, written = r.device.writes;
      r.cycle([&](rig& s) { (reading ? s.device.read_status : s.device.write_status) = status::failed; });
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

TEST(a_lost_device, is_not_ready_any_more) {
  for (const bool reading : {true, false}) {
    rig r;
    r.cycles(3);
    r.cycle([&](rig& s) { (reading ? s.device.read_status : s.device.write_status) = status::failed; });
    EXPECT_EQ(r.port.state(), ph::port_state::released) << reading;
    EXPECT_TRUE(r.port.is_lost()) << reading;
  }
}

// So that a supervisor, for which it is no heartbeat, tries its own way to the device.
TEST(a_release, that_the_device_does_not_take_for_hold_over_is_one_of_which_nobody_knows) {
  const auto unknown = [](const rig& r) { return std::isnan(r.port.applied()[0] + r.port.applied()[1]); };
  for (const bool lost : {false, true}) {
    rig r;
    r.hold();
    const auto spoil = [&](rig& s) { s.device.write_status = lost ? status::failed : status::no_sample; };
    int cycles = 0;
    for (; cycles < 100 && !unknown(r); ++cycles) r.cycle(spoil);
    EXPECT_EQ(r.port.state(), ph::port_state::released);
    EXPECT_LE(cycles, 22) << "20 ms without a transfer, and the cycle that sees it";
    EXPECT_GE(cycles, 20);
    r.cycle();
    EXPECT_EQ(unknown(r), lost) << "taken again";
  }
}

TEST(a_safe_port, allocates_nothing_in_a_cycle) {
  rig r;
  r.hold();
  const std::function<void(rig&)> nothing = [](rig&) {}, spoil = [](rig& s) { s.sample.value[0] = NAN; };
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
  EXPECT_EQ(error([](auto& p) { p.sensor.range[2] = 0; }),
            "sensor.range[2] = 0, expected a number > 0, or inf");
  EXPECT_EQ(error([](auto& p) { p.hold_over = 0; }), "hold_over [s] = 0, expected a finite number > 0");
  auto p = released_by({.ramp_time = 0});
  EXPECT_EQ(validate(p), "at_release.ramp_time [s] = 0, expected a finite number > 0");
  fake::device device;
  EXPECT_THROW(safe({&device}, {&device}, p), std::invalid_argument);
}
