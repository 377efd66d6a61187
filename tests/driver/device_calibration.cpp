// slow, together
// A device of known calibration tells counts and readings; the state that comes out is the one that went in.
#include "bench_samples.hpp"

#include <gtest/gtest.h>
#include <passive_haptics/driver/calibration/device_calibration.hpp>
#include <passive_haptics/mechanism/adaptors/braked_joints.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/two_link.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <cmath>

namespace ph = passive_haptics;
using ph::testing::random_source;
using vec = ph::vector<double, 2>;
using arm = ph::tendon_two_link<double>;

namespace {

// The sensor sits on the first distal link of a five-bar: no combination of joint angles, so a function of
// its own
struct distal_frame {
  ph::five_bar<double> mechanism;
  ph::matrix<double, 2, 2> operator()(const vec& q) const {
    const vec along = vec(mechanism.pose(q).link.row(0)).normalized();
    return ph::matrix_of<2, 2>(along[0], -along[1], along[1], along[0]);
  }
};

template <class M>
ph::device_calibration_parameters<M> measured() {
  ph::device_calibration_parameters<M> p;
  for (int i = 0; i < ph::encoder_axes<M>::count; ++i) {
    p.encoders.counts_per_turn[i] = (i % 2 == 0 ? 1 : -1) * 8192;
    p.encoders.zero_count[i] = 1000 * i - 300;
  }
  p.force.tare = {0.3, -0.2};
  p.force.handle_mass = 0.2;
  p.force.gravity = {0, -9.81};
  return p;
}

// Follows a motion through the sensors.
template <class M, class Frame>
void expect_state(const M& mechanism, const vec& middle, double speed, const Frame& frame) {
  const auto p = measured<M>();
  ph::device_calibration device(mechanism, p, frame);
  const ph::encoder_axes<M> axes(mechanism);
  const ph::encoder_calibration<ph::encoder_axes<M>::count> encoders(p.encoders);
  const auto one_count = encoders.resolution();
  const vec max_acceleration = speed * vec(3, 4.0 / 3), hand(3, -2);
  const auto acceleration = axes.from_joints(max_acceleration);
  for (int k = 0; k < 2000; ++k) {
    const double t = 1e-3 * k;
    const vec q = middle + speed * vec(std::sin(3 * t), std::sin(2 * t)) / 3;
    const vec qd = speed * vec(std::cos(3 * t), std::cos(2 * t) * 2 / 3);
    auto counts = typename decltype(device)::counts_array{};
    const auto exact = encoders.counts(axes.from_joints(q));
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] = std::floor(exact[static_cast<int>(i)]);
    const vec raw = frame(q).transpose() * (hand + p.force.handle_mass * p.force.gravity) + p.force.tare;
    const ph::device_state<M> state = device.state(t, counts, {raw[0], raw[1]});
    ASSERT_EQ(state.time, t);
    // A count on each axis, through T^+
    const auto bound = [&](const auto& per_axis) { return 2 * per_axis.norm() + 1e-12; };
    ASSERT_LT((state.q - q).norm(), bound(one_count)) << k;
    ASSERT_LT((state.hand_force - hand).norm(), 100 * (state.q - q).norm() + 1e-12) << k;
    if (k < 30) continue;
    const ph::vector<double, ph::encoder_axes<M>::count> off = axes.from_joints(state.qd - qd);
    for (int i = 0; i < off.size(); ++i) {
      const double lag = ph::rate_lag(one_count[i], 16, 1e-3, acceleration[i]);
      ASSERT_LT(std::abs(off[i]), acceleration[i] * lag + 2 * one_count[i] / 1e-3) << k;
    }
  }
}

TEST(device_calibration, tells_the_state_of_an_arm_with_tendons) {
  expect_state(arm(), {0.4, 1.2}, 3.0, ph::planar_sensor_frame<2>{.link = {1, 1}, .mounting = 0.3});
}
TEST(device_calibration, tells_the_state_of_a_five_bar) {
  const ph::five_bar<double> mechanism;
  expect_state(mechanism, {2.1, 1.0}, 1.0, distal_frame{mechanism});
}

TEST(device_calibration, tells_the_same_without_a_force_sensor) {
  ph::device_calibration with(arm(), measured<arm>(), ph::planar_sensor_frame<2>{.link = {1, 1}});
  ph::device_calibration without(arm(), measured<arm>());
  for (int k = 0; k < 100; ++k) {
    const std::array<double, 2> counts{3.0 * k, -7.0 * k};
    const auto a = with.state(1e-3 * k, counts, {0, 0});
    const auto b = without.state(1e-3 * k, counts);
    EXPECT_TRUE(a.q == b.q && a.qd == b.qd && a.time == b.time) << k;
    EXPECT_LT(
        (with.encoders.counts(with.axis_positions(a.q)) - ph::vector<double, 2>(counts[0], counts[1])).norm(),
        1e-9);
  }
}

TEST(device_calibration, is_exactly_at_rest_at_rest) {
  ph::device_calibration device(ph::five_bar<double, 4>(), measured<ph::five_bar<double, 4>>());
  for (int k = 0; k < 100; ++k) EXPECT_EQ(device.state(1e-3 * k, {5, double(k % 2), 7, 8}).qd, vec(0, 0));
}

TEST(device_calibration, homes_and_tares_in_a_reference_pose) {
  const auto truth = measured<arm>();
  auto unknown = truth;
  unknown.encoders.zero_count.setZero();
  unknown.force.tare.setZero();
  const ph::planar_sensor_frame<2> frame{.link = {1, 1}};
  ph::device_calibration device(arm(), unknown, frame);
  const ph::encoder_calibration<2> encoders(truth.encoders);

  const vec q0(0.3, 0.9);
  ph::homing<2> home(device.encoders, device.axis_positions(q0));
  ph::steady_mean<2> readings;
  const vec counts = encoders.counts(device.axis_positions(q0)).array().floor();
  const vec raw = frame(q0).transpose() * (truth.force.handle_mass * truth.force.gravity) + truth.force.tare;
  double t = 0;
  for (; t < 1; t += 1e-3) {
    home.add(t, counts);
    readings.add(t, raw);
  }
  device.encoders.set_zero_count(home.zero_count());
  device.force.set_tare(device.force.tare_of(readings.mean(), device.sensor_frame(q0)));

  const auto state = device.state(t, {counts[0], counts[1]}, {raw[0], raw[1]});
  EXPECT_LT((state.q - q0).norm(), 1e-12);
  EXPECT_LT(state.hand_force.norm(), 1e-12);
}

TEST(device_calibration, turns_capacities_to_currents) {
  auto p = measured<arm>();
  p.brakes[1].torque_per_ampere = 4;
  ph::device_calibration device(arm(), p);
  const auto currents = device.currents({0.5, 0.5});
  EXPECT_DOUBLE_EQ(currents[0], 0.5);
  EXPECT_DOUBLE_EQ(currents[1], 0.125);
}

TEST(device_calibration, tells_no_number_where_a_sensor_does) {
  ph::device_calibration device(arm(), measured<arm>());
  device.state(0, {0, 0}, {0, 0});
  EXPECT_TRUE(std::isnan(device.state(0.001, {NAN, 0}, {0, 0}).q[0]));
  EXPECT_TRUE(std::isnan(device.state(0.002, {0, 0}, {NAN, 0}).hand_force[0]));
  EXPECT_TRUE(ph::all_finite(device.state(0.003, {0, 0}, {0, 0}).q)) << "and is well afterwards";
}

TEST(device_calibration, is_there_in_single_precision) {
  using single = ph::tendon_two_link<float>;
  const ph::device_calibration_parameters<single> p;
  ph::device_calibration device(single(), p, ph::planar_sensor_frame<2>{.link = {1, 1}});
  const auto state = device.state(0, {1000, 1000}, {1, 0});
  EXPECT_NEAR(state.q[0], 1000 * 2 * std::numbers::pi / 8192, 1e-6);
  EXPECT_NEAR(state.hand_force.norm(), 1, 1e-6);
}

// A default link would turn the forces of other mechanisms
TEST(device_calibration, refuses_a_sensor_frame_whose_link_was_not_given) {
  const auto error = [](const ph::planar_sensor_frame<2>& frame) {
    return bench_samples::thrown_by(
        [&] { ph::device_calibration(arm(), ph::device_calibration_parameters<arm>(), frame); });
  };
  EXPECT_EQ(error({.link = {0, 0}}), "nothing");
  EXPECT_EQ(
      error({}),
      "link[0] [1] = nan: expected a finite number; set link to {1, 1} on the last link of a two_link or "
      "tendon_two_link, {0, 1} where q2 is measured from the base, {0, 0} where the sensor does not turn");
  EXPECT_TRUE(error({.link = {1, INFINITY}}).starts_with("link[1] [1] = inf: expected"));
  EXPECT_EQ(error({.link = {1, 1}, .mounting = NAN}), "mounting [rad] = nan: expected a finite number");
}

struct slack_arm : arm {
  ph::matrix<double, 2, 2> transmission() const { return ph::matrix_of<2, 2>(1.0, 0.0, 1.0, 0.0); }
};

TEST(device_calibration, names_what_is_wrong) {
  using parameters = ph::device_calibration_parameters<arm>;
  const auto error = [](auto change) {
    parameters p;
    change(p);
    return validate(p);
  };
  EXPECT_EQ(error([](parameters&) {}), "");
  EXPECT_EQ(error([](parameters& p) { p.rates.window = 0; }),
            "rates.window [periods] = 0: expected a whole number >= 1");
  EXPECT_EQ(error([](parameters& p) { p.brakes[1].current_limit = 0; }),
            "brakes[1].current_limit [A] = 0: expected a finite number > 0");
  EXPECT_EQ(error([](parameters& p) { p.force.handle_mass = NAN; }),
            "force.handle_mass [kg] = nan: expected a finite number >= 0");
  EXPECT_THROW(ph::device_calibration(slack_arm(), ph::device_calibration_parameters<slack_arm>()),
               std::invalid_argument);
}

using device = ph::device_calibration<arm>;
static_assert(noexcept(std::declval<device&>().state(0.0, std::declval<const device::counts_array&>())));
static_assert(noexcept(std::declval<device&>().state(0.0, std::declval<const device::counts_array&>(),
                                                     std::declval<const device::readings_array&>())));

// Encoders sit on all joints, also on those without a brake.
TEST(device_calibration, of_a_brake_on_one_of_two_joints_has_encoders_on_both) {
  using one_brake = ph::braked_joints<ph::two_link<double>, 1>;
  static_assert(ph::encoder_axes<one_brake>::count == 2 && !ph::encoder_axes<one_brake>::on_brakes);
  const one_brake device{ph::two_link<double>()};
  expect_state(device, {0.4, 1.2}, 0.6, ph::fixed_sensor_frame<2>());
  ph::device_calibration calibration(device, measured<one_brake>());
  EXPECT_EQ(calibration.currents(ph::vector<double, 1>(0.0)).size(), 1u);
}

}  // namespace
