// together
#include <gtest/gtest.h>
#include <passive_haptics/driver/calibration/brake_calibration.hpp>
#include <passive_haptics/testing/support/random.hpp>

namespace ph = passive_haptics;
using ph::testing::random_source;
using one = ph::vector<double, 1>;

namespace brake_calibration_tests {

ph::brake_curve random_curve(random_source& random) {
  ph::brake_curve p;
  p.residual_torque = random.uniform(0.0, 0.1);
  p.current_limit = random.positive(0.1, 3.0);
  if (random.coin()) {
    p.points = 2 + static_cast<int>(random.uniform(0.0, 14.99));
    p.table[0] = {0, p.residual_torque};
    for (int i = 1; i < p.points; ++i) {
      const auto k = static_cast<std::size_t>(i);
      p.table[k] = {p.table[k - 1].current + random.positive(0.01, 1.0),
                    p.table[k - 1].torque + random.positive(0.001, 1.0)};
    }
    p.current_limit = p.table[static_cast<std::size_t>(p.points - 1)].current * random.uniform(0.3, 1.0);
  }
  if (p.points == 0) p.torque_per_ampere = random.positive(0.05, 20.0);
  if (random.coin()) p.loss_per_kelvin = random.uniform(0.0, 0.01);
  return p;
}

double random_temperature(random_source& random) {
  return random.uniform(0.0, 1.0) < 0.2 ? NAN : random.uniform(273.0, 400.0);
}

// A brake with remanence: a play as wide as its hysteresis, at its true temperature
struct simulated_brake {
  ph::brake_curve p;
  double torque = p.residual_torque;
  double make(double current, double temperature) {
    const double rising = torque_of_current(p, current, temperature);
    return torque = std::clamp(torque, rising, rising + p.hysteresis);
  }
};

TEST(brake_curve, gives_the_current_of_a_torque_back_and_more_for_more) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    random_source random(seed);
    const ph::brake_curve p = random_curve(random);
    ASSERT_EQ(validate(p), "") << seed;
    const double temperature = random_temperature(random);
    double before = 0;
    for (int k = 0; k <= 40; ++k) {
      const double current = p.current_limit * random.uniform(0.0, 1.0);
      const double made = torque_of_current(p, current, temperature);
      ASSERT_NEAR(current_of_torque(p, made, temperature), current, 1e-12 * p.current_limit) << seed;
      const double torque = 0.05 * k * torque_of_current(p, p.current_limit);
      const double given = current_of_torque(p, torque, temperature);
      ASSERT_GE(given, before) << seed;
      ASSERT_LE(given, p.current_limit);
      ASSERT_TRUE(given == 0 || torque > p.residual_torque);
      before = given;
    }
  }
}

TEST(brake_curve, meets_the_points_of_a_table) {
  ph::brake_curve p{.residual_torque = 0.02, .current_limit = 1};
  p.table[0] = {0, 0.02};
  p.table[1] = {0.2, 0.1};
  p.table[2] = {1, 1.1};
  p.points = 3;
  ASSERT_EQ(validate(p), "");
  EXPECT_DOUBLE_EQ(torque_of_current(p, 0.2), 0.1);
  EXPECT_DOUBLE_EQ(torque_of_current(p, 0.6), 0.6);
  EXPECT_DOUBLE_EQ(current_of_torque(p, 0.06), 0.1);
  EXPECT_DOUBLE_EQ(current_of_torque(p, 1.1), 1);
  EXPECT_DOUBLE_EQ(current_of_torque(p, 7), 1);
}

TEST(brake_curve, gives_no_current_for_what_is_no_torque) {
  const ph::brake_curve p{.residual_torque = 0.1, .current_limit = 0.5};
  EXPECT_EQ(current_of_torque(p, NAN), 0);
  EXPECT_EQ(current_of_torque(p, -1), 0);
  EXPECT_EQ(current_of_torque(p, -INFINITY), 0);
  EXPECT_EQ(current_of_torque(p, INFINITY), 0.5) << "all that there is";
}

TEST(brake_curve, takes_an_unknown_temperature_for_the_coldest) {
  const ph::brake_curve p{.current_limit = 10, .loss_per_kelvin = 0.005};
  EXPECT_DOUBLE_EQ(current_of_torque(p, 1, 333.15), 1 / 0.8);
  for (const double t : {double(NAN), double(INFINITY), -double(INFINITY), 293.15, 0.0})
    EXPECT_DOUBLE_EQ(current_of_torque(p, 1, t), 1) << t;
  EXPECT_DOUBLE_EQ(current_of_torque(p, 1, 1e6), 1 / 0.7) << "no hotter than the hottest";
}

TEST(brake_calibration, never_makes_more_torque_than_asked_but_what_is_there_without_current) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    random_source random(seed);
    ph::brake_curve p = random_curve(random);
    if (random.coin()) p.hysteresis = random.uniform(0.0, 0.3);
    ph::brake_calibration<1> calibration({p});
    simulated_brake brake{p};
    const double most = 1.3 * (torque_of_current(p, p.current_limit) + p.hysteresis);
    double capacity = 0;
    for (int k = 0; k < 300; ++k) {
      const double chance = random.uniform(0.0, 1.0);
      if (chance < 0.3) capacity = random.uniform(-0.1, 1.0) * most;
      else if (chance < 0.8) capacity += random.uniform(-0.05, 0.05) * most;
      else if (chance < 0.82) capacity = NAN;
      else if (chance < 0.84) capacity = INFINITY;
      const double current = calibration.currents(one(capacity))[0];
      ASSERT_TRUE(current >= 0 && current <= p.current_limit);
      const double allowed = std::max(capacity > 0 ? capacity : 0, p.residual_torque + p.hysteresis);
      const double made = brake.make(current, random_temperature(random));
      ASSERT_LE(made, allowed + 1e-12) << "seed " << seed << ", step " << k;
      if (std::isnan(capacity)) capacity = 0;
    }
  }
}

TEST(brake_calibration, makes_just_the_torque_asked_with_hysteresis_both_ways_and_keeps_its_current) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    random_source random(seed);
    ph::brake_curve p = random_curve(random);
    p.loss_per_kelvin = 0;
    const double most = torque_of_current(p, p.current_limit);
    p.hysteresis = random.uniform(0.0, 0.3) * (most - p.residual_torque);
    ph::brake_calibration<1> calibration({p});
    simulated_brake brake{p};
    for (int k = 0; k < 200; ++k) {
      const double capacity = random.uniform(p.residual_torque + p.hysteresis, most);
      const double current = calibration.currents(one(capacity))[0], made = brake.make(current, NAN);
      ASSERT_NEAR(made, capacity, 1e-12) << "seed " << seed << ", step " << k;
      ASSERT_NEAR(calibration.torque()[0], made, 1e-12);
      for (int i = 0; i < 3; ++i) ASSERT_EQ(calibration.currents(one(capacity))[0], current) << seed;
    }
  }
}

TEST(brake_calibration, knows_what_a_brake_at_its_limit_makes) {
  const ph::brake_curve p{.current_limit = 2, .hysteresis = 0.1, .loss_per_kelvin = 0.005};
  ph::brake_calibration<1> calibration({p});
  EXPECT_EQ(calibration.currents(one(5))[0], 2);
  EXPECT_EQ(calibration.torque()[0], 2);
  EXPECT_EQ(calibration.currents(one(2.05))[0], 2) << "more than it makes: not falling";
  EXPECT_DOUBLE_EQ(calibration.currents(one(1.95))[0], 1.85);
  calibration.currents(one(5));
  EXPECT_EQ(calibration.currents(one(5), one(333.15))[0], 2);
  EXPECT_DOUBLE_EQ(calibration.torque()[0], 1.7) << "hot: 0.8 of it and the remanence";
}

TEST(brake_calibration, is_back_at_rest_after_a_restart) {
  ph::brake_calibration<2> calibration({ph::brake_curve{.hysteresis = 0.2}, ph::brake_curve{}});
  calibration.currents({0.8, 0.8});
  calibration.currents({0.0, 0.0});
  EXPECT_DOUBLE_EQ(calibration.torque()[0], 0.2) << "remanence";
  EXPECT_EQ(calibration.currents({0.1, 0.1})[0], 0) << "which makes this already";
  calibration.reset();
  EXPECT_DOUBLE_EQ(calibration.currents({0.1, 0.1})[0], 0.1);
}

TEST(brake_calibration, takes_what_is_no_torque_for_none) {
  for (const double none : {double(NAN), -0.5, -double(INFINITY)}) {
    ph::brake_calibration<1> calibration({ph::brake_curve{.hysteresis = 0.2}}), of_zero = calibration;
    for (auto* one_of : {&calibration, &of_zero}) one_of->currents(one(0.8));
    EXPECT_EQ(calibration.currents(one(none)), of_zero.currents(one(0)));
    EXPECT_EQ(calibration.torque(), of_zero.torque()) << none;
    EXPECT_EQ(calibration.currents(one(0.2)), of_zero.currents(one(0.2))) << "its remanence: still falling";
  }
}

// Of the second of two brakes, each with a table.
TEST(brake_calibration, names_what_is_wrong) {
  using curve = ph::brake_curve;
  struct row {
    void (*change)(curve&);
    const char* error;
  };
  for (const auto& [change, error] : {
           row{[](curve&) {}, ""},
           {[](curve& p) { p.residual_torque = -1; },
            "residual_torque [N m] = -1: expected a finite number >= 0"},
           {[](curve& p) { p = {.torque_per_ampere = 0}; },
            "torque_per_ampere [N m/A] = 0: expected a finite number > 0"},
           {[](curve& p) { p.current_limit = INFINITY; },
            "current_limit [A] = inf: expected a finite number > 0"},
           {[](curve& p) { p.hysteresis = NAN; }, "hysteresis [N m] = nan: expected a finite number >= 0"},
           {[](curve& p) { p.points = 1; }, "points = 1: expected 0 for a straight line, or 2 to 16"},
           {[](curve& p) { p.table[2].current = 0.5; },
            "table[2].current [A] = 0.5: expected more than in the point before it"},
           {[](curve& p) { p.table[2].torque = 0.4; },
            "table[2].torque [N m] = 0.4: expected more than in the point before it"},
           {[](curve& p) { p.table[1].torque = NAN; },
            "table[1].torque [N m] = nan: expected a finite number"},
           {[](curve& p) { p.table[0].current = -1; }, "table[0].current [A] = -1: expected 0"},
           {[](curve& p) { p.residual_torque = 0.1; },
            "table[0].torque [N m] = 0: expected the residual_torque"},
           {[](curve& p) { p.current_limit = 1.5; },
            "current_limit [A] = 1.5: expected at most the last current of the table"},
           {[](curve& p) { p.max_temperature = 290; },
            "max_temperature [K] = 290: expected at least reference_temperature"},
           {[](curve& p) { p.loss_per_kelvin = 0.02; },
            "loss_per_kelvin [1/K] = 0.02: expected less than 1 / (max_temperature - reference_temperature)"},
           // What would not be read
           {[](curve& p) { p.points = 0; },
            "points = 0: expected 3, as the last entry of the table that is not 0 is table[2]; set points, "
            "or "
            "set the unused entries to 0"},
           {[](curve& p) { p.points = 2; }, "points = 2: expected 3, as"},
           {[](curve& p) { p.table[15].torque = NAN; }, "points = 3: expected 16, as"},
           {[](curve& p) { p.table[3].current = 1; }, "points = 3: expected 4, as"},
           {[](curve& p) { p = {}, p.table[0].torque = 1; }, "points = 0: expected 1, as"},
           {[](curve& p) { p.torque_per_ampere = 1.6; },
            "torque_per_ampere [N m/A] = 1.6: expected its default, 1, as the table is used instead; "
            "remove "
            "one of the two"},
       }) {
    ph::brake_curves<2> curves{};
    curves[1].points = 3;
    curves[1].table[1] = {0.5, 0.4};
    curves[1].table[2] = {1, 1};
    change(curves[1]);
    const std::string told = validate(curves), expected = error;
    if (expected.ends_with(", as")) EXPECT_TRUE(told.starts_with("brakes[1]." + expected)) << told;
    else EXPECT_EQ(told, expected.empty() ? "" : "brakes[1]." + expected);
  }
}

}  // namespace brake_calibration_tests
