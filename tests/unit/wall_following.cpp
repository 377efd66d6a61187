// The wall-following experiment (section 5): what the paper claims, and that the experiment is run as it says.
#include "support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/mechanism/tendon_two_link.hpp>
#include <passive_haptics/mechanism/xy_table.hpp>
#include <passive_haptics/plant/wall_following.hpp>
#include <passive_haptics/scene/half_space.hpp>
#include <passive_haptics/scene/held_scene.hpp>

#include <cmath>
#include <type_traits>

namespace {

const ph::half_space<2> wall({0, 0.225}, {0, -1});

// A device 4 mm off the wall at x = 0.045 m, moving along it and into it.
template <class M>
struct experiment {
  using T = typename M::scalar;
  M arm;
  ph::brakes_of<M> brakes;
  ph::joint_vector<M> q;
  ph::following_hand<T, 2> hand{{1, 0}, arm.position(q)};
  ph::simulated_device<M> device{arm, brakes, hand.parameters().mass, q};

  experiment(const M& mechanism, const ph::brakes_of<M>& b, const ph::joint_vector<M>& start)
      : arm(mechanism), brakes(b), q(start) {
    const ph::matrix<T, 2, 2> J(ph::jacobian(arm, q));
    device.set_motion(q, J.partialPivLu().solve(ph::vector<T, 2>(T(0.05), T(0.1))));
  }

  template <class Law>
  auto controller(Law law, double rate) const {
    return ph::controller(arm, brakes, ph::held_scene(ph::scene(ph::wall(wall)), 1 / rate), law);
  }
};

template <class T>
auto table() {
  using M = ph::xy_table<T>;
  ph::brakes_of<M> brakes;
  brakes.torque_limit.setConstant(10);          // [N]
  brakes.rate_dead_band.setConstant(T(0.002));  // [m/s]
  return experiment<M>(M(), brakes, {T(0.045), T(0.221)});
}

template <class T>
auto tendon_device(T brake_lag) {
  using M = ph::tendon_two_link<T>;
  ph::brakes_of<M> brakes;
  brakes.time_constant.setConstant(brake_lag);
  const M arm;
  return experiment<M>(arm, brakes, arm.inverse({T(0.045), T(0.221)}, ph::elbow::left).q);
}

// Exact positions and rates.
ph::wall_following_parameters with_ideal_encoders(ph::wall_following_parameters p = {}) {
  p.encoder_resolution = 0;
  return p;
}

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
  for (const double rate : {1000.0, 20.0}) {
    auto plain = table<TypeParam>(), direct = table<TypeParam>();
    auto without = plain.controller(ph::no_direct_control(), rate);
    auto with = direct.controller(ph::direct_control(), rate);
    for (const ph::contact_metrics& r :
         {ph::follow_wall(plain.device, without, wall, plain.hand, this->way()),
          ph::follow_wall(direct.device, with, wall, direct.hand, this->way())}) {
      EXPECT_TRUE(r.arrived) << rate << " Hz";
      EXPECT_EQ(r.separations, 0) << rate << " Hz";
      EXPECT_EQ(r.recontacts, 0) << rate << " Hz";
      EXPECT_LT(r.depth_range, 1e-5) << "locked in y once it is in, " << rate << " Hz";
      EXPECT_GT(r.duration, 0.2);
    }
  }
}

TYPED_TEST(wall_following, names_a_brake_that_is_not_there) {
  auto e = table<TypeParam>();
  auto control = e.controller(ph::no_direct_control(), 1000);
  auto way = this->way();
  way.watched_brake = 2;
  try {
    ph::follow_wall(e.device, control, wall, e.hand, way);
    FAIL() << "brake 2 of two was watched";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "passive_haptics: watched_brake = 2, expected a brake of the device, from 0");
  }
}

// Steady sliding without brake lag under direct control: in every cycle that scales, nothing of hand and brakes
// together is left normal to the wall.
TYPED_TEST(wall_following, direct_control_leaves_nothing_normal_in_any_cycle) {
  using T = TypeParam;
  auto e = tendon_device<T>(0);
  auto control = e.controller(ph::direct_control(), 1000);
  const ph::vector<T, 2> n(0, -1);
  int scaled = 0;
  const auto watched = [&](const auto& state) {
    const auto result = control(state);
    EXPECT_EQ(result.outcome, ph::status::ok);
    if (result.wall < 0 || result.display == ph::display_class::none || result.saturated) return result;
    if (!(result.alpha > T(0) && result.alpha < T(1))) return result;
    const T left = (state.hand_force + result.alpha * result.control_force).dot(n);
    const T cosine = result.approximation_cosine;
    EXPECT_LE(std::abs(left), ph::rounding_tolerance<T>(8) / (cosine * cosine) * state.hand_force.norm())
        << "at " << state.time << " s";
    ++scaled;
    return result;
  };
  const ph::contact_metrics figures =
      ph::follow_wall(e.device, watched, wall, e.hand, with_ideal_encoders(this->way()));
  EXPECT_TRUE(figures.arrived);
  EXPECT_GT(figures.retarding_force, 0.01) << "R_2- leans against the motion";
  EXPECT_LT(figures.retarding_force, 2);
  EXPECT_GT(scaled, 100) << "direct control hardly ever scaled";
}

TEST(wall_following_run, runs_each_part_at_its_own_rate) {
  using T = double;
  auto e = tendon_device<T>(T(0.02));
  ph::wall_following_parameters p = with_ideal_encoders();
  p.time_step = 1e-4;
  p.control_period = 5e-4;
  p.longest = 0.01;
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
  EXPECT_GE(last, T(0.06));
}

TEST(wall_following_run, samples_fit_together) {
  using T = double;
  auto e = tendon_device<T>(T(0.02));
  auto control = e.controller(ph::direct_control(), 1000);
  ph::wall_following_parameters p;
  p.longest = 0.3;
  p.sensor_corner = 0;
  double time = 0;
  bool braked = false;
  ph::follow_wall(e.device, control, wall, e.hand, p, [&](const auto& s) {
    time += 1e-4;
    EXPECT_NEAR(s.time, time, 1e-9);
    EXPECT_EQ(s.position, e.device.position());
    EXPECT_EQ(s.depth, -wall.distance(s.position.template cast<double>()));
    EXPECT_EQ(s.hand_force, e.device.sensed_force()) << "no filter in between";
    EXPECT_EQ(s.rates, e.device.rates());
    const ph::vector<T, 2> t = ph::brake_jacobian(e.arm, e.device.q()).transpose() * s.brake_force;
    EXPECT_LE((t - s.brake_torque).norm(),
              ph::rounding_tolerance<T>(64) * (s.brake_torque.norm() + s.brake_force.norm()));
    EXPECT_TRUE((s.control->capacity.array() >= 0).all());
    braked |= s.brake_torque.norm() > 0;
  });
  EXPECT_TRUE(braked);
}

// The sensor lags by its corner frequency: after a step of force it has 1 - 1/e of it after 0.8 ms.
TEST(wall_following_run, force_sensor_is_a_low_pass) {
  using T = double;
  auto e = table<T>();
  ph::wall_following_parameters p;
  p.longest = 8e-4;
  e.device.set_motion(e.q, {0, 0});
  T last = 0, filtered = 0;
  ph::follow_wall(
      e.device, [](const auto&) { return ph::step_result<ph::xy_table<T>>(); }, wall, e.hand, p,
      [&](const auto& s) {
        last = e.device.sensed_force()[1];
        filtered = s.hand_force[1];
      });
  EXPECT_NEAR(filtered / last, T(1) - std::exp(T(-8e-4 / 7.9577e-4)), T(0.02));
}

}  // namespace
