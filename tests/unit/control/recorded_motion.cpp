// States as a loop should give them, and as it does on a first afternoon.
#include <passive_haptics/design/recorded_motion.hpp>
#include <passive_haptics/mechanism/models/two_link.hpp>
#include <passive_haptics/plant/simulated_device.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace ph = passive_haptics;

namespace {

using device = ph::two_link<double>;
using recording = std::vector<ph::device_state<device>>;

// Two seconds at 1 kHz of a hand that moves the handle to and fro in both directions, brakes released.
recording to_and_fro() {
  const ph::brakes_of<device> brakes;
  ph::simulated_device<device> simulated(device(), brakes, 0.1, {0.6, 1.2});
  recording all;
  for (int k = 0; k < 2000; ++k) {
    const double t = 1e-3 * k;
    const ph::vector<double, 2> push(0.6 * std::cos(9 * t), 0.5 * std::sin(7 * t));
    all.push_back({t, simulated.q(), simulated.qd(), push});
    for (int j = 0; j < 10; ++j) simulated.advance(1e-4, {0, 0}, push);
  }
  return all;
}

// What is said of it after `change(state)`.
template <class Change>
std::string said_after(const Change& change) {
  recording states = to_and_fro();
  for (auto& s : states) change(s);
  return ph::plausibility(device(), states);
}

// Positions in counts of 4096 a turn, rates as their differences, a noisy sensor.
TEST(recorded_motion, of_real_sensors_has_nothing_odd) {
  recording states = to_and_fro();
  const double count = 2 * std::numbers::pi / 4096;
  for (auto& s : states) s.q = count * (s.q / count).array().floor().matrix();
  for (std::size_t k = states.size() - 1; k >= 10; --k)
    states[k].qd = (states[k].q - states[k - 10].q) / (states[k].time - states[k - 10].time);
  ph::testing::random_source random(20040627);
  for (auto& s : states) s.hand_force += 0.02 * random.normal_vector<double, 2>();
  EXPECT_EQ(ph::plausibility(device(), states), "");
}

TEST(recorded_motion, has_nothing_odd) {
  EXPECT_EQ(said_after([](auto&) {}), "");
  EXPECT_EQ(ph::plausibility(device(), recording()), "");
  EXPECT_EQ(ph::plausibility(device(), recording(1)), "");
}

TEST(recorded_motion, shows_a_wrong_clock) {
  const auto starts = [](const std::string& text, const char* with) { return text.rfind(with, 0) == 0; };
  EXPECT_EQ(said_after([](auto& s) { s.time = 7; }),
            "cycles in which the time stands still = 1999, usually none: is the state updated in each?\n");
  EXPECT_TRUE(starts(said_after([](auto& s) { s.time *= 1000; }),
                     "longest time step [s] = 1, usually 0.0001 to 0.01: milliseconds?\n"));
  EXPECT_TRUE(starts(said_after([](auto& s) { s.time = -s.time; }),
                     "cycles in which the time runs backwards = 1999, usually none: another clock?\n"));
}

TEST(recorded_motion, shows_rates_that_are_none) {
  const auto contains = [](const std::string& text, const char* part) {
    return text.find(part) != text.npos;
  };
  EXPECT_TRUE(contains(said_after([](auto& s) { s.qd *= 57.3; }), "degrees, or another unit of time?"));
  EXPECT_TRUE(contains(said_after([](auto& s) { s.qd *= 1e-3; }), "degrees, or another unit of time?"));
  EXPECT_TRUE(contains(said_after([](auto& s) { s.qd = -s.qd; }), "usually 1: a wrong sign?"));
  EXPECT_TRUE(contains(said_after([](auto& s) { s.qd.setZero(); }), "is qd never filled?"));
}

TEST(recorded_motion, shows_a_hand_force_of_another_frame) {
  EXPECT_NE(said_after([](auto& s) { s.hand_force *= -1; }).find("the force on the hand, not on the handle?"),
            std::string::npos);
  EXPECT_NE(said_after([](auto& s) {
              s.hand_force = ph::vector<double, 2>(-s.hand_force[1], s.hand_force[0]);
            }).find("of the sensor's frame, not the base's?"),
            std::string::npos);
}

}  // namespace
