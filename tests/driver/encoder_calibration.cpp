// slow, together
#include <gtest/gtest.h>
#include <passive_haptics/brake/models/encoder_axes.hpp>
#include <passive_haptics/driver/calibration/encoder_calibration.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <limits>
#include <stdexcept>
#include <utility>

namespace ph = passive_haptics;
using vec = ph::vector<double, 2>;
using parameters = ph::encoder_calibration_parameters<2>;
using status = ph::steady_status;

namespace {

// An arm whose second tendon's reduction depends on the pose
struct varying_arm : ph::two_link<double> {
  ph::matrix<double, 2, 2> transmission(const vec& q) const {
    return ph::matrix_of<2, 2>(1.0, 0.0, 1.0, 2 + std::sin(q[1]));
  }
};

static_assert(ph::encoder_axes<ph::tendon_two_link<double>>::on_brakes);
static_assert(ph::encoder_axes<ph::five_bar<double, 4>>::count == 4);
static_assert(!ph::encoder_axes<ph::xy_table<double>>::on_brakes);
static_assert(!ph::encoder_axes<varying_arm>::on_brakes);
static_assert(noexcept(std::declval<ph::encoder_axes<varying_arm>>().to_joints(std::declval<const vec&>())));

parameters turn_and_slide() {
  parameters p;
  p.counts_per_turn = {-8192, 1e6};
  p.slides = {false, true};
  p.zero_count = {100, -50};
  return p;
}

template <class M>
void expect_there_and_back(const M& mechanism) {
  const ph::encoder_axes<M> axes(mechanism);
  ph::testing::random_source random(1);
  for (int k = 0; k < 100; ++k) {
    const vec q = random.normal_vector<double, 2>();
    EXPECT_LT((axes.to_joints(axes.from_joints(q)) - q).norm(), 1e-14 * (1 + q.norm()));
  }
}

TEST(encoder_axes, turn_joint_positions_to_axes_and_back) {
  expect_there_and_back(ph::tendon_two_link<double>());
  expect_there_and_back(ph::xy_table<double>());
  expect_there_and_back(ph::five_bar<double, 4>());
  expect_there_and_back(varying_arm());
}

TEST(encoder_axes, are_the_brakes_of_tendons) {
  const ph::encoder_axes<ph::tendon_two_link<double>> axes{ph::tendon_two_link<double>()};
  EXPECT_LT((axes.from_joints({0.1, 0.2}) - vec(0.1, 0.1 + 0.2 / 0.4)).norm(), 1e-15);
}

TEST(encoder_calibration, turns_counts_to_radians_and_metres) {
  const ph::encoder_calibration<2> encoders(turn_and_slide());
  const vec at = encoders.position({100 - 2048, -50 + 1000});
  EXPECT_DOUBLE_EQ(at[0], std::numbers::pi / 2) << "counts fall in the positive sense";
  EXPECT_DOUBLE_EQ(at[1], 1e-3);
  EXPECT_LT((encoders.counts(at) - vec(100 - 2048, -50 + 1000)).norm(), 1e-9) << "and back";
  EXPECT_DOUBLE_EQ(encoders.rate({8192, -1e6})[0], -2 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(encoders.rate({8192, -1e6})[1], -1);
  EXPECT_DOUBLE_EQ(encoders.resolution()[0], 2 * std::numbers::pi / 8192);
  EXPECT_DOUBLE_EQ(encoders.resolution()[1], 1e-6);
}

TEST(encoder_calibration, keeps_its_zero_counts_if_the_new_ones_are_no_numbers) {
  ph::encoder_calibration<2> encoders(turn_and_slide());
  encoders.set_zero_count({NAN, 3});
  EXPECT_EQ(encoders.zero_count(), vec(100, -50));
  encoders.set_zero_count({7, 3});
  EXPECT_EQ(encoders.zero_count(), vec(7, 3));
}

TEST(encoder_calibration, names_what_is_wrong) {
  const auto error = [](auto change) {
    parameters p = turn_and_slide();
    change(p);
    return validate(p);
  };
  EXPECT_EQ(error([](parameters&) {}), "");
  EXPECT_EQ(error([](parameters& p) { p.counts_per_turn[1] = 0; }),
            "counts_per_turn[1] = 0: expected a finite number, not 0; negative if counts fall in the "
            "positive sense");
  EXPECT_EQ(error([](parameters& p) { p.counts_per_turn[0] = 0; }).substr(0, 22), "counts_per_turn[0] = 0");
  EXPECT_EQ(error([](parameters& p) { p.zero_count[0] = NAN; }),
            "zero_count[0] = nan: expected a finite number");
}

// Homing of encoders whose zero counts are known to the test alone
struct homed {
  ph::encoder_calibration<2> truth{turn_and_slide()};
  ph::encoder_calibration<2> believed;
  vec reference{0.4, 0.02};
  homed() {
    parameters p = turn_and_slide();
    p.zero_count = {7, -3};  // any
    believed = ph::encoder_calibration<2>(p);
  }
  vec counts(const vec& moved = vec::Zero()) const {
    return vec((truth.counts(reference).array() + 0.5).floor()) + moved;
  }
};

TEST(homing, finds_the_zero_counts_of_a_handle_held_still) {
  const homed device;
  ph::homing<2> home(device.believed, device.reference);
  ph::testing::random_source random(3);
  int k = 0;
  status s = status::collecting;
  for (; s != status::done && k < 10000; ++k) {
    EXPECT_TRUE(std::isnan(home.zero_count()[0]));
    s = home.add(1e-3 * k, device.counts({random.coin() ? 1.0 : 0.0, random.coin() ? 1.0 : -1.0}));
    ASSERT_TRUE(s == status::collecting || s == status::done) << to_string(s);
  }
  EXPECT_NEAR(k, 501, 1);
  const vec found = home.zero_count();
  EXPECT_NEAR(found[0], 100.5, 0.7);
  EXPECT_NEAR(found[1], -50, 0.7);
  ph::encoder_calibration<2> encoders = device.believed;
  encoders.set_zero_count(found);
  const double worst = 2 * encoders.resolution().maxCoeff();
  EXPECT_LT((encoders.position(device.counts()) - device.reference).norm(), worst);
  EXPECT_EQ(home.add(1000, {1e6, 1e6}), status::done) << "and stays so";
  home.reset();
  EXPECT_FALSE(ph::all_finite(home.zero_count()));
  EXPECT_EQ(home.add(0, device.counts()), status::collecting);
}

TEST(steady_mean, is_of_all_readings_and_begins_anew_when_it_is_told) {
  ph::steady_mean<2> mean({.duration = 0.25, .tolerance = 3, .max_gap = 0.125});
  const auto add = [&](double time, const vec& reading) { return mean.add(time, reading); };
  for (const double start : {4.0, 1.0}) {
    EXPECT_EQ(mean.status(), status::collecting);
    EXPECT_EQ(add(start, {1, 10}), status::collecting);
    EXPECT_EQ(add(start + 0.125, {2, 7}), status::collecting) << "just within gap and tolerance";
    EXPECT_TRUE(std::isnan(mean.mean()[1]));
    EXPECT_EQ(add(start + 0.25, {3, 8.5}), status::done);
    EXPECT_EQ(mean.mean(), vec(2, 8.5));
    EXPECT_EQ(mean.status(), status::done);
    mean.reset();
    EXPECT_TRUE(std::isnan(mean.mean()[0]));
  }
  EXPECT_EQ(add(9, {1, 10}), status::collecting);
  EXPECT_EQ(add(9.125, {1, 6.9}), status::moved) << "down, too";
  EXPECT_EQ(add(9.25, {1, 6.9}), status::collecting);
  EXPECT_EQ(add(9.375, {1, 6.9}), status::done) << "0.25 s after it moved";
  EXPECT_EQ(mean.mean(), vec(1, 6.9));

  // Slowly over the tolerance, after a gap, with a time that stands still or goes back, of what is no number
  struct row {
    double time;
    vec reading;
    status told;
  };
  for (const auto& [time, reading, told] : {row{9.125, {4, 13}, status::collecting},
                                            {9.125, {4, 13.5}, status::moved},
                                            {9.1875, {1, 10}, status::interrupted},
                                            {9, {1, 10}, status::interrupted},
                                            {8, {1, 10}, status::interrupted},
                                            {9.0625, {NAN, 10}, status::interrupted}}) {
    mean.reset();
    add(8.9375, {1, 10});
    add(9, {2, 11});
    EXPECT_EQ(add(time, reading), told) << time;
  }
}

TEST(homing, complains_of_its_parameters) {
  EXPECT_EQ(validate(ph::steady_parameters{.duration = 0}), "duration [s] = 0: expected a finite number > 0");
  EXPECT_EQ(validate(ph::steady_parameters{.tolerance = -1}),
            "tolerance [counts] = -1: expected a finite number >= 0");
  EXPECT_EQ(validate(ph::steady_parameters{.max_gap = NAN}),
            "max_gap [s] = nan: expected a finite number > 0");
  for (const double bad : {double(NAN), double(INFINITY)})
    EXPECT_THROW(ph::homing<2>(homed().believed, {0, bad}), std::invalid_argument) << bad;
}

}  // namespace
