// together
// Limits of the currents and of the coils' heat.
#include "fake_device.hpp"

#include <gtest/gtest.h>

namespace currents_tests {

using namespace fake;
using enum ph::fault;
using enum ph::fault_source;

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

TEST(a_release_policy, holds_no_longer_than_a_coil_can_bear) {
  rig r(hold);
  r.wanted = {1, 1};
  r.hold();
  r.port.release();
  r.cycles(1000);
  EXPECT_LE(r.device.currents[0], 0.855 + 1e-12);
}

}  // namespace currents_tests
