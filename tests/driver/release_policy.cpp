// together
// What flows after a release, by its policy.
#include "fake_device.hpp"

#include <gtest/gtest.h>

namespace release_policy_tests {

using namespace fake;
using enum ph::fault;
using enum ph::fault_source;

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
  // By a clock that is none
  for (const double begun : {double(NAN), infinite, -1.0}) {
    ph::release_profile<2> profile({.policy = ph::release_policy::ramp});
    profile.begin({begun, start.flowing});
    expect_over(profile, {5});
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
                std::string("at_release.policy = ") +
                    (at_release.policy == ph::release_policy::ramp ? "ramp" : "hold") +
                    ": expected zero: a device without a watchdog keeps its currents; set zero, or use a "
                    "device with a watchdog");
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

}  // namespace release_policy_tests
