// together
// Each fault of a device, a command or a clock releases the brakes, and who may rearm then.
#include "fake_device.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace safe_port_tests {

using namespace fake;
using enum ph::fault;
using enum ph::fault_source;

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

auto reads(status s) {
  return [s](rig& r) { r.device.read_status = s; };
}
auto feels(status s) {
  return [s](rig& r) { r.device.sensor_status = s; };
}
auto writes(status s) {
  return [s](rig& r) { r.device.write_status = s; };
}
const std::vector<fault_case> all_faults{
    {"NaN_encoder", {value_not_finite, encoders, 1}, held_home, [](rig& r) { r.sample.value[1] = NAN; }},
    {"infinity", {value_not_finite, encoders, 0}, held_home, [](rig& r) { r.sample.value[0] = -infinite; }},
    {"no_count", {count_out_of_range, encoders, 0}, held_home, [](rig& r) { r.sample.value[0] = 1e300; }},
    {"invalid_axis", {channel_invalid, encoders, 0}, held_home, [](rig& r) { r.sample.valid[0] = false; }},
    {"encoder_jump", {encoder_jump, encoders, 1}, held_home, [](rig& r) { r.sample.value[1] += 5000; }},
    {"silence_of_the_device", {sample_missing, encoders}, held, say_nothing},
    {"torn", {sample_damaged, encoders}, held, reads(status::bad_sample)},
    {"duplicate", {sample_repeated, encoders}, held, [](rig& r) { --r.sample.sequence; }},
    {"reordering", {sample_out_of_order, encoders}, held_home, [](rig& r) { r.sample.sequence -= 2; }},
    {"wrong_sequence", {device_restarted, encoders}, once_home, [](rig& r) { r.sample.sequence += 5000; }},
    {"restart", {device_restarted, encoders}, once_home, [](rig& r) { r.sample.sequence -= 5000; }},
    {"sample_of_a_second_ago", {sample_late, encoders}, held, [](rig& r) { r.sample.time -= 1; }},
    {"sample_of_tomorrow", {sample_late, encoders}, held, [](rig& r) { r.sample.time += 1e5; }},
    {"sample_without_a_time", {sample_late, encoders}, held, [](rig& r) { r.sample.time = NAN; }},
    {"no_reading", {device_lost, encoders}, once_home, reads(status::failed)},
    {"no_writing", {device_lost, brakes}, once_home, writes(status::failed)},
    {"short", {write_refused, brakes}, held, writes(status::bad_sample)},
    {"full_buffer", {write_refused, brakes}, held, refuse},
    {"sensor_saturation", {sensor_saturated, force_sensor, 2}, held, [](rig& r) { r.force.value[2] = -100; }},
    {"NaN_force", {value_not_finite, force_sensor, 0}, held, [](rig& r) { r.force.value[0] = NAN; }},
    {"invalid_force", {channel_invalid, force_sensor, 1}, held, [](rig& r) { r.force.valid[1] = false; }},
    {"stale_sensor", {sample_repeated, force_sensor}, held, [](rig& r) { --r.force.sequence; }},
    {"no_force", {sample_missing, force_sensor}, held, feels(status::no_sample)},
    {"torn_force", {sample_damaged, force_sensor}, held, feels(status::bad_sample)},
    {"sensor_gone", {device_lost, force_sensor}, once, feels(status::failed)},
    {"NaN_command", {current_not_valid, brakes, 1}, once, [](rig& r) { r.wanted[1] = NAN; }},
    {"infinite_command", {current_not_valid, brakes, 0}, once, [](rig& r) { r.wanted[0] = infinite; }},
    {"negative_command", {current_not_valid, brakes, 0}, once, [](rig& r) { r.wanted[0] = -1e-300; }},
    {"pause_of_the_loop", {cycle_late}, once, [](rig& r) { r.sample.time = r.force.time = r.time += 0.5; }},
    {"clock_that_goes_back", {clock_jump}, once, [](rig& r) { r.time -= 0.01; }},
    {"clock_that_is_none", {clock_jump}, once, [](rig& r) { r.time = NAN; }},
    {"suspended_machine", {suspended}, once_home, [](rig& r) { r.port.release({suspended}); }},
};

class a_fault : public ::testing::TestWithParam<fault_case> {};

TEST_P(a_fault, releases_the_brakes_in_time_and_says_why) {
  const auto& [name, why, end, spoil] = GetParam();
  rig r;
  r.hold();
  const double held_since = r.time;
  EXPECT_LE(r.cycles_to_release(spoil), end.cycles);
  EXPECT_GE(r.device.releases, 1) << "the device is told by its quickest way";
  r.wanted = {0.5, 0.25};
  if (!(r.time >= held_since)) r.time = held_since + 1;
  for (int k = 0; k < 30; ++k) {
    ASSERT_EQ(r.port.state(), ph::port_state::released);
    ASSERT_EQ(r.port.reason(), why) << "the first reason stays: " << to_string(r.port.reason());
    ASSERT_FALSE(r.port.activate());
    r.cycle();
    ASSERT_FALSE(r.device.flows());
  }
  EXPECT_EQ(r.port.needs_homing(), !end.rearmable);
  EXPECT_EQ(r.port.rearm(), end.rearmable);
  r.cycles(2);
  EXPECT_EQ(r.port.state(), end.rearmable ? ph::port_state::ready : ph::port_state::released);
  EXPECT_FALSE(r.device.flows()) << "ready gives no current, either";
  if (!end.rearmable) return;
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
  EXPECT_EQ(r.port.position()[0], position[0] + 9) << "no count is lost";
  EXPECT_EQ(r.port.pending_fault(), ph::fault_record{});
  EXPECT_EQ(r.device.currents, r.wanted);
}

INSTANTIATE_TEST_SUITE_P(named, a_fault, ::testing::ValuesIn(all_faults),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(a_safe_port, gives_no_current_before_it_is_activated) {
  rig r;
  r.wanted = {NAN, -1};  // at which nobody looks
  r.cycles(10);
  EXPECT_EQ(r.port.reason(), ph::fault_record{});
  r.wanted = {0.5, 0.25};
  EXPECT_EQ(r.port.state(), ph::port_state::ready);
  EXPECT_FALSE(r.device.flows());
  EXPECT_EQ(r.device.writes, 10) << "a device with a watchdog hears of it";
  EXPECT_TRUE(r.port.activate());
  EXPECT_FALSE(r.port.activate()) << "a double start";
  EXPECT_EQ(r.port.open(), "open() was called twice: the device is open; call it once");
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

TEST(a_safe_port, follows_a_sensor_that_restarted) {
  rig r;
  r.hold();
  r.cycle([](rig& s) { s.force.sequence += 5000; });
  EXPECT_EQ(r.port.state(), ph::port_state::degraded);
  EXPECT_EQ(r.port.pending_fault(), (ph::fault_record{device_restarted, force_sensor}));
  for (int k = 0; k < 30; ++k) {
    r.cycle();
    ASSERT_EQ(r.port.state(), ph::port_state::active) << "a force has no home to lose";
    ASSERT_EQ(r.port.force(), r.force.value);
  }
  r.cycle([](rig& s) { --s.force.sequence; });
  EXPECT_EQ(r.port.pending_fault().what, sample_repeated) << "its numbers are looked at again";
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

TEST(a_safe_port, whose_encoder_jumps_for_too_long_before_it_is_active_needs_homing) {
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
  for (const bool silent_sensor : {false, true}) {
    rig r;
    r.hold();
    r.port.release();
    r.cycle(
        [&](rig& s) { (silent_sensor ? s.device.sensor_status : s.device.read_status) = status::no_sample; });
    EXPECT_FALSE(r.port.rearm());
    EXPECT_EQ(r.port.state(), ph::port_state::released);
    r.cycle();
    EXPECT_TRUE(r.port.rearm());
  }
}

TEST(a_lost_device, has_no_current_that_anybody_knows) {
  for (const auto& at_release : {ph::release_parameters{}, ramp, hold})
    for (const bool reading : {false, true})
      for (const bool active : {false, true}) {
        rig r(at_release);
        if (active) r.hold();
        else r.cycles(3);
        const auto last = r.device.currents;
        const auto position = r.port.position();
        const int released = r.device.releases, written = r.device.writes;
        r.cycle([&](rig& s) { (reading ? s.device.read_status : s.device.write_status) = status::failed; });
        for (int k = 0; k < 10; ++k) {
          EXPECT_EQ(r.port.state(), ph::port_state::released) << "not ready any more, either";
          EXPECT_GT(r.device.releases, released);
          EXPECT_EQ(r.port.applied(), last) << "the last that it is known to have taken, for hold_over";
          EXPECT_TRUE(!r.port.applied_is_known() && r.port.is_lost() && r.port.needs_homing());
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
    const auto spoil = [&](rig& s) { s.device.write_status = lost ? status::failed : status::no_sample; };
    int cycles = 0;
    for (; cycles < 100 && !unknown(r); ++cycles) r.cycle(spoil);
    EXPECT_EQ(r.port.state(), ph::port_state::released);
    EXPECT_LE(cycles, 22) << "20 ms without a transfer, and the cycle that sees it";
    EXPECT_GE(cycles, 20);
    const int releases = r.device.releases;
    r.cycle(spoil);
    EXPECT_EQ(r.device.releases > releases, !lost) << "asked again, as current may flow";
    r.cycle();
    EXPECT_EQ(unknown(r), lost) << "taken again";
  }
}

TEST(the_parameters, of_a_safe_port_are_checked_by_name) {
  auto p = usual();
  EXPECT_EQ(validate(p), "");
  p.currents.max_current[1] = -1;
  EXPECT_EQ(validate(p), "currents.max_current[1] [A] = -1: expected a finite number > 0");
  p = usual();
  p.sensor.range[2] = 0;
  EXPECT_EQ(validate(p), "sensor.range[2] = 0: expected a number > 0, or inf");
  p = usual();
  p.hold_over = 0;
  EXPECT_EQ(validate(p), "hold_over [s] = 0: expected a finite number > 0");
  p = released_by({.ramp_time = 0});
  EXPECT_EQ(validate(p), "at_release.ramp_time [s] = 0: expected a finite number > 0");
  EXPECT_THROW(safe({nullptr}, {nullptr}, p), std::invalid_argument);
}

}  // namespace safe_port_tests
