// together
// Samples that are believed and those that are not.
#include "fake_device.hpp"

#include <gtest/gtest.h>
#include <passive_haptics/driver/checks/arrival_check.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <cstdint>

namespace sample_checks_tests {

using namespace fake;
using enum ph::fault;
using enum ph::fault_source;

// What a sequence number tells, at every distance from the last one that could overflow.
ph::fault after_a_jump_of(std::uint32_t jump, std::uint32_t from) {
  ph::sample_check<1> check(0.02);
  ph::port_sample<1> s{1.0, from, {0}, {true}};
  EXPECT_EQ(check(ph::port_status::ok, s, 1.0, encoders).what, none);
  s.sequence += jump;
  return check(ph::port_status::ok, s, 1.0, encoders).what;
}

TEST(sample_check, tells_a_gap_a_repetition_and_a_restart_by_the_distance_modulo_2_to_32) {
  for (const std::uint32_t from : {0u, 5u, 0x7FFF'FFFFu, 0x8000'0000u, 0xFFFF'FFFFu}) {
    EXPECT_EQ(after_a_jump_of(0, from), sample_repeated) << from;
    for (const std::uint32_t ahead : {1u, 2u, 999u, 1000u})
      EXPECT_EQ(after_a_jump_of(ahead, from), none) << from << " + " << ahead;
    for (const std::uint32_t behind : {1u, 2u, 999u, 1000u})
      EXPECT_EQ(after_a_jump_of(0u - behind, from), sample_out_of_order) << from << " - " << behind;
    // Half of all numbers away there is no less negative one
    for (const std::uint32_t far :
         {1001u, 0x7FFF'FFFEu, 0x7FFF'FFFFu, 0x8000'0000u, 0x8000'0001u, 0u - 1001u})
      EXPECT_EQ(after_a_jump_of(far, from), device_restarted) << from << " + " << far;
  }
}

TEST(arrival_check, finds_times_of_arrival_and_no_others) {
  const auto found = [](const auto& time_of, int samples = 1000) {
    ph::arrival_check check;
    for (int k = 0; k < samples; ++k) check.add(time_of(k));
    return check.found();
  };
  constexpr double T = 1e-3;  // [s]
  ph::testing::random_source random(20040627);
  const auto delayed = [&](double most) {
    return [&random, most](int k) { return k * T + random.uniform(0.0, most) * T; };
  };
  EXPECT_TRUE(found([](int k) { return k * T + (k % 2 == 0 ? 0.9e-3 : 0); }));
  for (const int burst : {2, 5, 16, 32})
    EXPECT_TRUE(found([&](int k) { return k / burst * burst * T + 1e-5 * (k % burst); })) << burst;
  EXPECT_TRUE(found(delayed(0.99)));
  EXPECT_FALSE(found([](int k) { return k * T; }));
  EXPECT_FALSE(found(delayed(0.3))) << "no rate is far off";
  EXPECT_FALSE(found([](int k) { return 1.5 * T * k - (k % 20 == 0 ? T : 0); })) << "one in twenty";
  EXPECT_FALSE(found([&](int k) { return (k + k / 10 * 3) * T; })) << "some are missing";
  EXPECT_FALSE(found([](int k) { return k * T + (k % 2 == 0 ? 0.9e-3 : 0); }, 100)) << "too few to say so";
  ph::arrival_check check;
  EXPECT_EQ(check.share(), 0);
  check.add(1), check.add(1), check.add(0);
  EXPECT_EQ(check.share(), 0) << "no time went by";
  rig r;
  for (int k = 0; k < 300; ++k) {
    r.take_samples();
    if (k % 2 == 0) r.sample.time -= 0.9e-3;
    r.transfer();
  }
  EXPECT_TRUE(r.port.arrivals().found()) << "of a port, too, which goes on";
  EXPECT_EQ(r.port.state(), ph::port_state::ready);
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
      "period [s] = 0.0125: expected less than 0.01023, within which a counter of 12 bits can wrap unseen: "
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

TEST(a_frozen_encoder, is_none_where_a_brake_holds_it) {
  rig r;
  r.hold();
  const double still = r.sample.value[1];
  for (int k = 1; k <= 3000; ++k) {  // 9000 counts of the other
    r.sample.value[1] = still - 3;
    r.cycle();
    ASSERT_EQ(r.port.state(), ph::port_state::active) << "cycle " << k << ": " << to_string(r.port.reason());
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

TEST(a_jump, cannot_be_waited_out) {
  ph::encoder_check<1> check({.max_rate = 1000});
  EXPECT_EQ(check({0, 0, {0}, {true}}, true).what, none);
  for (int k = 1; k <= 5000; ++k)  // 5 s, in which it could have gone 5000 counts
    ASSERT_EQ(check({1e-3 * k, 0, {100}, {true}}, true).what, encoder_jump) << k;
  EXPECT_EQ(check.position()[0], 0);
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
  ph::encoder_check<2> usual_travel({}), no_travel({.frozen_travel = 0}), one_encoder({.encoders = 1});
  for (int k = 0; k <= 64; ++k)
    for (auto* check : {&usual_travel, &no_travel, &one_encoder})
      ASSERT_EQ((*check)({1e-3 * k, 0, {128.0 * k, 0}, {true, true}}, true), ph::fault_record{}) << k;
  EXPECT_EQ(usual_travel({0.065, 0, {8193, 0}, {true, true}}, true).channel, 1);
  EXPECT_EQ(no_travel({0.065, 0, {8193, 0}, {true, true}}, true), ph::fault_record{});
  EXPECT_EQ(one_encoder({0.065, 0, {8193, 0}, {true, true}}, true), ph::fault_record{});
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
           {{sample_damaged, force_sensor},
            true,
            [](rig& r) { r.device.sensor_status = status::bad_sample; }},
           {{sensor_saturated, force_sensor, 1}, true, [](rig& r) { r.force.value[1] = 100; }}})
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
  for (const auto read : {sample_missing, sample_repeated}) quarter.add(read, 9.9);
  EXPECT_EQ(quarter.arrived(), 80u) << "nothing came with these reads";
  EXPECT_TRUE(quarter.is_too_many());
}

}  // namespace sample_checks_tests
