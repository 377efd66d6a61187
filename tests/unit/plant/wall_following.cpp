// optimised
// The wall-following experiment (section 5): what the paper claims.
#include "wall_experiment.hpp"

#include <passive_haptics/control/laws/saturated_direct_control.hpp>
#include <passive_haptics/control/pipelines/with_effects.hpp>
#include <passive_haptics/force/effects/viscous_field.hpp>

#include <cmath>
#include <limits>
#include <type_traits>

namespace {

// The whole way in double, its first part in float.
template <class T>
struct wall_following : ::testing::Test {
  static ph::wall_following_parameters way() {
    ph::wall_following_parameters p;
    if (std::is_same_v<T, float>) p.path_end = 0.08;
    return p;
  }
};
TYPED_TEST_SUITE(wall_following, scalars);

// Fig. 4: without force approximation there is no pullback, at any rate of the environment.
TYPED_TEST(wall_following, xy_table_never_leaves_an_unslanted_wall) {
  const double max_power = std::is_same_v<TypeParam, double> ? 1e-14 : 1e-5;  // rounding [W]
  for (const double rate : {1000.0, 20.0}) {
    auto plain = table<TypeParam>(), direct = table<TypeParam>();
    auto without = plain.controller(ph::no_direct_control(), rate);
    auto with = direct.controller(ph::direct_control(), rate);
    for (const ph::contact_metrics& r :
         {ph::follow_wall(plain.device, without, wall, plain.hand, with_slides(this->way())),
          ph::follow_wall(direct.device, with, wall, direct.hand, with_slides(this->way()))}) {
      EXPECT_TRUE(r.arrived) << rate << " Hz";
      EXPECT_EQ(r.separations, 0) << rate << " Hz";
      EXPECT_EQ(r.recontacts, 0) << rate << " Hz";
      EXPECT_LT(r.depth_range, 1e-5) << "locked in y once it is in, " << rate << " Hz";
      EXPECT_NEAR(r.depth_mean, r.max_depth, 1e-5);
      EXPECT_LT(std::abs(r.depth_drift), 1e-5);
      EXPECT_LE(r.max_brake_power, max_power);
      EXPECT_GT(r.duration, 0.2);
    }
  }
}

TEST(wall_following_run, names_a_brake_that_is_not_there) {
  auto e = table<double>();
  const auto released = [](const auto&) { return ph::step_result<ph::xy_table<double>>(); };
  EXPECT_EQ(thrown_by([&] { ph::follow_wall(e.device, released, wall, e.hand, {.watched_brake = 2}); }),
            "passive_haptics: watched_brake = 2: expected a brake of the device, from 0");
}

// Figs. 8 and 9: what the paper reports comes out where the limits stand before alpha, the brakes are weak
// and the hand yields; as printed it does not.
TEST(wall_following, reproduces_the_paper_where_the_limits_come_before_alpha) {
  ph::following_hand_parameters<double> yielding;
  yielding.push = 1.75;
  yielding.normal_stiffness = 300;
  yielding.target_depth = 0.003;
  for (const double rate : {1000.0, 20.0}) {
    const auto run = [&](auto law) {
      auto e = tendon_device<double>(0.020);
      e.brakes.torque_limit.setConstant(1.25 / 17 * yielding.push);
      experiment<ph::tendon_two_link<double>> weak(e.arm, e.brakes, e.q);
      auto control = weak.controller(law, rate);
      return ph::follow_wall(weak.device, control, wall,
                             ph::following_hand<double, 2>({1, 0}, weak.arm.position(weak.q), yielding), {});
    };
    const auto none = run(ph::no_direct_control()), printed = run(ph::direct_control()),
               read = run(ph::saturated_direct_control());
    EXPECT_GE(none.separations, 3) << rate << " Hz";
    EXPECT_GE(printed.separations, 3) << rate << " Hz";
    EXPECT_LE(read.separations, 1) << rate << " Hz";
    EXPECT_LT(read.depth_std, none.depth_std);
    EXPECT_LT(read.stick_share, none.stick_share / 2);
    EXPECT_LT(read.hand_force_std, none.hand_force_std);
    EXPECT_LT(read.retarding_force, none.retarding_force) << "conclusion 2";
    EXPECT_LT(read.max_brake_power, 1e-14);
    EXPECT_TRUE(none.arrived && printed.arrived && read.arrived);
  }
}

// Drag of 40 N s/m along the wall, which stays what it was.
TEST(wall_following_run, takes_a_controller_with_effects) {
  const auto figures = [](double viscosity) {
    auto e = table<double>();
    const ph::viscous_field<double, 2> field({.viscosity = viscosity * ph::matrix<double, 2, 2>::Identity()});
    ph::controller control(e.arm, e.brakes, ph::with_effects(ph::scene(ph::wall(wall)), field),
                           ph::direct_control());
    return ph::follow_wall(e.device, control, wall, e.hand, with_slides({.path_end = 0.08}));
  };
  const auto smooth = figures(0), sticky = figures(40);
  EXPECT_TRUE(smooth.arrived && sticky.arrived);
  EXPECT_GT(sticky.retarding_force, smooth.retarding_force + 1.5)
      << "2 N at 5 cm/s, less until it is so fast";
  EXPECT_LE(sticky.max_brake_power, 1e-14);
  EXPECT_LE(sticky.max_depth, smooth.max_depth + 1e-5);
}

TEST(wall_following_run, runs_each_part_at_its_own_rate) {
  using T = double;
  auto e = tendon_device<T>(T(0.02));
  ph::wall_following_parameters p;
  p.encoder_resolution = 0;  // exact positions and rates
  p.time_step = 1e-4;
  p.control_period = 5e-4;
  p.max_duration = 0.01;
  int cycles = 0, samples = 0;
  const auto control = [&](const ph::device_state<ph::tendon_two_link<T>>& state) {
    EXPECT_NEAR(state.time, cycles * 5e-4, 1e-12);
    EXPECT_EQ(state.q, e.device.q());
    EXPECT_EQ(state.qd, e.device.qd());
    ++cycles;
    return ph::step_result<ph::tendon_two_link<T>>();
  };
  ph::follow_wall(e.device, control, wall, e.hand, p, [&](const auto&) { ++samples; });
  EXPECT_EQ(cycles, 20);
  EXPECT_EQ(samples, 100);
}

TEST(wall_following_run, refuses_a_time_step_longer_than_the_fastest_time_constant) {
  auto e = tendon_device<double>(0.02);
  const auto control = [](const auto&) { return ph::step_result<ph::tendon_two_link<double>>(); };
  const double fastest = e.hand.min_time_constant(e.device.min_mass());
  ph::wall_following_parameters p{.control_period = 1, .max_duration = 100 * fastest};
  p.time_step = 1.01 * fastest;
  EXPECT_THROW(ph::follow_wall(e.device, control, wall, e.hand, p), std::invalid_argument);
  p.time_step = 0.99 * fastest;
  EXPECT_NE(ph::follow_wall(e.device, control, wall, e.hand, p).end, ph::run_end::not_finite);
  EXPECT_LT(e.device.velocity().norm(), 0.2);
}

TEST(wall_following_run, stops_at_the_end_of_the_path) {
  using T = double;
  auto e = table<T>();
  ph::wall_following_parameters p;
  p.path_end = 0.06;
  T last = 0;
  const auto figures = ph::follow_wall(
      e.device, [](const auto&) { return ph::step_result<ph::xy_table<T>>(); }, wall, e.hand, p,
      [&](const auto& s) {
        EXPECT_LT(last, T(0.06));
        last = s.position[0];
      });
  EXPECT_TRUE(figures.arrived);
  EXPECT_EQ(figures.end, ph::run_end::arrived);
  EXPECT_GE(last, T(0.06));
}

TEST(wall_following_run, says_how_it_ended) {
  using M = ph::xy_table<double>;
  const auto released = [](const auto&) { return ph::step_result<M>(); };
  const auto end_of = [&](const ph::wall_following_parameters& p) {
    auto e = table<double>();
    const auto figures = ph::follow_wall(e.device, released, wall, e.hand, p);
    EXPECT_LT(figures.max_depth, 1.1 * p.max_depth);
    return figures.end;
  };
  EXPECT_EQ(end_of({.max_duration = 0.05}), ph::run_end::time_over);
  EXPECT_EQ(end_of({.path_end = 1, .max_depth = 0.002}), ph::run_end::too_deep);
  auto lost = table<double>();
  lost.device.set_motion({0, std::numeric_limits<double>::quiet_NaN()}, {0, 0});
  EXPECT_EQ(ph::follow_wall(lost.device, released, wall, lost.hand, {}).end, ph::run_end::not_finite);
  EXPECT_EQ(to_string(ph::run_end::too_deep), "too deep");
}

}  // namespace
