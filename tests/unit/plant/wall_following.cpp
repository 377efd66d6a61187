// The wall-following experiment (section 5): what the paper claims, and that the experiment is run as it
// says.
#include "../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/saturated_direct_control.hpp>
#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/wall_following.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
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
    device.set_motion(q, J.inverse() * ph::vector<T, 2>(T(0.05), T(0.1)));
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
// 8192 counts a turn, 0.1 m from the axis [m].
ph::wall_following_parameters with_slides(ph::wall_following_parameters p = {}) {
  p.encoder_resolution *= 0.1;
  return p;
}

TYPED_TEST(wall_following, xy_table_never_leaves_an_unslanted_wall) {
  const double most_power = std::is_same_v<TypeParam, double> ? 1e-14 : 1e-5;  // rounding [W]
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
      EXPECT_NEAR(r.depth_mean, r.depth_max, 1e-5);
      EXPECT_LT(std::abs(r.depth_drift), 1e-5);
      EXPECT_LE(r.largest_brake_power, most_power);
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

// Figs. 8 and 9: what the paper reports comes out where the limits stand before alpha, the brakes are weak
// and the hand yields; as printed it does not.
TEST(wall_following, reproduces_the_paper_where_the_limits_come_before_alpha) {
  ph::following_hand_parameters<double> yielding;
  yielding.push = 1.75;
  yielding.normal_stiffness = 300;
  yielding.target_depth = 0.003;
  for (const double rate : {1000.0, 20.0}) {
    for (const double time_step : {1e-4, 5e-5}) {
      const auto run = [&](auto law) {
        auto e = tendon_device<double>(0.020);
        e.brakes.torque_limit.setConstant(1.25 / 17 * yielding.push);
        experiment<ph::tendon_two_link<double>> weak(e.arm, e.brakes, e.q);
        auto control = weak.controller(law, rate);
        return ph::follow_wall(weak.device, control, wall,
                               ph::following_hand<double, 2>({1, 0}, weak.arm.position(weak.q), yielding),
                               {.time_step = time_step});
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
      EXPECT_LT(read.largest_brake_power, 1e-14);
      EXPECT_TRUE(none.arrived && printed.arrived && read.arrived);
    }
  }
}

// Steady sliding without brake lag under direct control: in every cycle that scales, nothing of hand and
// brakes together is left normal to the wall.
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

// Nobody brakes: the hand pushes the handle through the wall.
TEST(wall_following_run, stops_where_the_handle_is_too_deep) {
  auto e = tendon_device(0.02);
  ph::wall_following_parameters p;
  p.deepest = 0.005;
  double deepest = 0;
  const auto figures = ph::follow_wall(
      e.device, [](const auto&) { return ph::step_result<ph::tendon_two_link<double>>{}; }, wall, e.hand, p,
      [&](const auto& now) { deepest = now.depth; });
  EXPECT_FALSE(figures.arrived);
  EXPECT_GT(deepest, 0.005);
  EXPECT_LT(deepest, 0.0051);
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

// The controller sees counts and differences, the figures are the true ones.
TEST(wall_following_run, control_reads_the_encoders) {
  using M = ph::tendon_two_link<double>;
  auto e = tendon_device<double>(0.02);
  ph::wall_following_parameters p;
  p.longest = 0.05;
  p.encoder_resolution = 1e-3;
  p.rate_corner = 30;
  ph::joint_encoders<M> expected(e.arm, {1e-3, 30}, 1e-3);
  double largest = 0;
  const auto control = [&](const ph::device_state<M>& state) {
    expected.read(e.device.q(), e.device.qd());
    EXPECT_EQ(state.q, expected.q());
    EXPECT_EQ(state.qd, expected.qd());
    largest = std::max(largest, (state.q - e.device.q()).norm());
    return ph::step_result<M>();
  };
  ph::follow_wall(e.device, control, wall, e.hand, p, [&](const auto& s) {
    EXPECT_EQ(s.depth, -wall.distance(e.device.position()));
    EXPECT_EQ(s.rates, e.device.rates());
  });
  EXPECT_GT(largest, 1e-4);
  EXPECT_LT(largest, 2e-3);
}

TEST(wall_following_run, control_reads_the_noise_of_the_force_sensor) {
  using M = ph::xy_table<double>;
  const auto noise_of = [](double sigma, std::uint64_t seed) {
    auto e = table<double>();
    ph::wall_following_parameters p = with_slides();
    p.longest = 0.5;
    p.sensor_noise = sigma;
    p.noise_seed = seed;
    double squares = 0;
    int readings = 0;
    ph::vector<double, 2> filtered(0, 0);
    const auto control = [&](const ph::device_state<M>& state) {
      squares += (state.hand_force - filtered).squaredNorm();
      ++readings;
      return ph::step_result<M>();
    };
    ph::follow_wall(e.device, control, wall, e.hand, p, [&](const auto& s) { filtered = s.hand_force; });
    return std::sqrt(squares / (2 * readings));
  };
  EXPECT_EQ(noise_of(0, 1), 0);
  EXPECT_NEAR(noise_of(0.05, 1), 0.05, 5 * 0.05 / std::sqrt(2 * 1000.0));
  EXPECT_EQ(noise_of(0.05, 1), noise_of(0.05, 1));
  EXPECT_NE(noise_of(0.05, 1), noise_of(0.05, 2));
}

// The brakes of a table that slides along a wall with a known friction: W = F s, and P <= 0.
TEST(wall_following_run, figures_count_the_energy_of_the_brakes) {
  using M = ph::xy_table<double>;
  auto e = table<double>();
  ph::wall_following_parameters p = with_slides();
  p.longest = 0.5;
  e.device.set_motion({0.045, 0.2251}, {0.05, 0});
  ph::step_result<M> half_a_newton;
  half_a_newton.capacity = {0.5, 10};
  double way = 0, power = -1, force = 0;
  const auto figures = ph::follow_wall(
      e.device, [&](const auto&) { return half_a_newton; }, wall, e.hand, p,
      [&](const auto& s) {
        way += 1e-4 * s.velocity[0];
        power = std::max(power, s.brake_power.maxCoeff());
        force = -s.brake_force[0];
      });
  EXPECT_GT(way, 0.01);
  EXPECT_NEAR(force, 0.5, 1e-9);
  EXPECT_NEAR(figures.brake_energy, 0.5 * way, 0.05 * 0.5 * way) << "less while the brakes rise";
  EXPECT_NEAR(figures.brake_energy, e.device.energy().friction(), 1e-12) << "in contact from the start";
  EXPECT_LE(figures.largest_brake_power, 1e-15);
  EXPECT_LE(power, 1e-15);
  EXPECT_LE(std::abs(e.device.energy().imbalance()), 1e-13 * e.device.energy().hand);
}

// Not only step_result: what has a capacity is a decision.
TEST(wall_following_run, any_decision_with_a_capacity_will_do) {
  struct decision {
    ph::vector<double, 2> capacity;
    int cycle;
  };
  auto e = table<double>();
  ph::wall_following_parameters p = with_slides();
  p.longest = 0.01;
  int cycles = 0, last = 0;
  ph::follow_wall(
      e.device, [&](const auto&) { return decision{{0, 0}, ++cycles}; }, wall, e.hand, p,
      [&](const auto& s) { last = s.control->cycle; });
  EXPECT_EQ(last, 10);
}

// An arm with one joint too many. Its brakes' force at the handle is that which would accelerate the handle
// alike.
TEST(wall_following_run, devices_with_self_motion_follow_a_wall) {
  using M = ph::serial_chain_with_inertia<double, 3, 2>;
  ph::serial_chain_inertia<double, 3, 2> inertia;
  const std::array<double, 3> lengths{0.15, 0.15, 0.1};
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = 0.15 * static_cast<double>(i);
    inertia.links[i] = ph::uniform_rod<double, 2>(0.2, {x, 0}, {x + lengths[i], 0});
  }
  const M arm(ph::planar_arm(lengths), inertia);
  const ph::vector<double, 3> q(2.4, -1.3, -0.6);
  const ph::point<2> start = arm.position(q);
  const ph::half_space<2> surface({0, start[1] + 0.002}, {0, -1});
  ph::brakes_of<M> brakes;
  ph::simulated_device<M> device(arm, brakes, 0.5, q);
  const ph::following_hand<double, 2> hand({1, 0}, start);
  ph::controller control(arm, brakes, ph::scene(ph::wall(surface)), ph::direct_control());
  ph::wall_following_parameters p;
  p.path_end = start[0] + 0.05;
  p.watched_brake = 2;
  double strongest = 0;
  const auto figures = ph::follow_wall(device, control, surface, hand, p, [&](const auto& s) {
    const ph::matrix<double, 2, 3> J = ph::jacobian(arm, device.q());
    const ph::matrix<double, 2, 3> JMi = J * arm.mass_matrix(device.q()).inverse();
    const ph::vector<double, 2> by_brakes = JMi * s.brake_torque,
                                by_force = JMi * (J.transpose() * s.brake_force);
    EXPECT_LE((by_brakes - by_force).norm(), 1e-9 * (by_brakes.norm() + 1));
    strongest = std::max(strongest, s.brake_force.norm());
  });
  EXPECT_GT(figures.duration, 0.1);
  EXPECT_GT(strongest, 0.1);
  EXPECT_GT(figures.brake_energy, 0);
  EXPECT_LE(figures.largest_brake_power, 1e-14);
  EXPECT_LE(std::abs(device.energy().imbalance()), 1e-3 * device.energy().hand);
}

}  // namespace
