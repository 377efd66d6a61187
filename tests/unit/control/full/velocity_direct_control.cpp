// Direct control at the level of velocities, and what it is made of.
#include "../../support.hpp"

#include <passive_haptics/brake/models/first_order_lag.hpp>
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/velocity_direct_control.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/simulated_device.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/shapes/offset.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <cmath>
#include <stdexcept>

namespace {

using table = ph::xy_table<double>;
using pair = ph::vector<double, 2>;
using law = ph::velocity_direct_control;
using constants = ph::velocity_direct_control_parameters;

// A floor at y = 0, free above; the table at x, y with velocity v, pushed by Fh.
ph::contact<2> floor_at(double x, double y) {
  return {.normal = {0, 1}, .depth = -y, .stiffness = 1e7, .position = {x, y}};
}

ph::brakes_of<table> without_lag() {
  ph::brakes_of<table> brakes;
  brakes.torque_limit.setConstant(100);
  brakes.time_constant.setZero();
  return brakes;
}

ph::step_result<table> once(const law& control, double y, const pair& v, const pair& Fh,
                            const ph::brakes_of<table>& brakes = without_lag()) {
  ph::contacts<2, 1> touched;
  touched.push_back(floor_at(0, y));
  ph::step_memory<law> memory;
  return ph::step(table(), brakes, touched, control, state_of<table>({0, y}, v, Fh), memory);
}

double slide_mass() { return table().mass_matrix({0, 0})(1, 1); }

TEST(velocity_direct_control, brakes_what_is_missing_of_the_wanted_acceleration) {
  const constants p;
  const law control(p);
  // Sinking at 0.1 m/s, 1 mm deep, not landed: the reference is to stand still
  const auto sinking = once(control, -1e-3, {0, -0.1}, {0, -2});
  EXPECT_NEAR(sinking.capacity[1], slide_mass() * 0.1 / p.velocity_lag + 2, 1e-12);
  EXPECT_EQ(sinking.capacity[0], 0) << "along the wall";
  EXPECT_LT(sinking.torque[1] * -0.1, 0) << "it resists";
  // The account tells the force that the torques make, not the wall's 1e4 N
  EXPECT_EQ(sinking.display, ph::display_class::approximate);
  EXPECT_NEAR(sinking.control_force[1], slide_mass() * 0.1 / p.velocity_lag + 2, 1e-12);
  EXPECT_NEAR(sinking.approximation_angle(), 0, 1e-7);
  // Not so deep as it shall rest: it may go on as fast as k_d allows
  const double inward = p.depth_gain * (p.rest_depth - 1e-4);
  EXPECT_EQ(once(control, -1e-4, {0, -0.9 * inward}, {0, 0}).capacity[1], 0);
  EXPECT_NEAR(once(control, -1e-4, {0, -inward - 0.01}, {0, 0}).capacity[1],
              slide_mass() * 0.01 / p.velocity_lag, 1e-12);
}

TEST(velocity_direct_control, never_holds_a_handle_that_leaves) {
  for (const double Fh : {-2.0, 0.0, 2.0}) {
    const auto leaving = once(law(), -1e-3, {0, 0.05}, {0, Fh});
    EXPECT_TRUE(leaving.capacity.isZero(0)) << "hand force " << Fh;
  }
  EXPECT_TRUE(once(law(), -1e-3, {0, 0}, {0, 1}).capacity.isZero(0)) << "a pull at rest";
  EXPECT_GT(once(law(), -1e-3, {0, 0}, {0, -1}).capacity[1], 0) << "a push at rest";
}

TEST(velocity_direct_control, keeps_the_depth_of_landing_until_the_wall_is_left) {
  const constants p;
  const law control(p);
  ph::step_memory<law> memory;
  const auto at = [&](double y, double v) {
    ph::contacts<2, 1> touched;
    if (y < 0) touched.push_back(floor_at(0, y));
    return ph::step(table(), without_lag(), touched, control, state_of<table>({0, y}, {0.1, v}, {0, -10}),
                    memory)
        .capacity[1];
  };
  at(-2e-3, 0);  // lands 2 mm deep
  const double rest = at(-2e-3, 0);
  EXPECT_NEAR(rest, 10, 1e-9) << "holds what the hand does";
  EXPECT_NEAR(at(-2.1e-3, 0), 10 + slide_mass() * p.depth_gain * 1e-4 / p.velocity_lag, 1e-9) << "deeper";
  EXPECT_NEAR(at(-1.9e-3, 0), 10 - slide_mass() * p.depth_gain * 1e-4 / p.velocity_lag, 1e-9) << "shallower";
  EXPECT_EQ(at(0.01, 0), 0) << "free";
  at(-1e-3, 0);
  EXPECT_NEAR(at(-1e-3, 0), 10, 1e-9) << "lands anew";
}

// Landed less deep than it shall rest, it is let sink on; deeper, it is held there. Neither way faster than
// v_max.
TEST(velocity_direct_control, rests_at_the_rest_depth_or_where_it_landed_deeper) {
  const constants p;
  constexpr double push = 100;  // [N], more than any part of the law takes off
  for (const double landed : {0.1e-3, 0.5e-3, 0.9e-3, 1.5e-3, 3e-3}) {
    for (const double depth : {0.1e-3, 0.4e-3, 1e-3, 2e-3, 4e-3}) {
      const law control(p);
      ph::step_memory<law> memory;
      const auto braked_at = [&](double d) {
        ph::contacts<2, 1> touched;
        touched.push_back(floor_at(0, -d));
        return ph::step(table(), without_lag(), touched, control,
                        state_of<table>({0, -d}, {0, 0}, {0, -push}), memory)
            .capacity[1];
      };
      braked_at(landed);
      const double rest = std::max(landed, p.rest_depth);
      const double wanted = std::clamp(p.depth_gain * (depth - rest), -p.velocity_limit, p.velocity_limit);
      const double expected = std::clamp(push + slide_mass() * wanted / p.velocity_lag, 0.0, 100.0);
      EXPECT_NEAR(braked_at(depth), expected, 1e-9) << "landed at " << landed << ", now at " << depth;
    }
  }
}

// Faster than the landing velocity it has not landed, and its depth is not kept.
TEST(velocity_direct_control, lands_where_it_sinks_slower_than_the_landing_velocity) {
  const constants p;
  const law control(p);
  for (const double share : {0.5, 0.99, 1.01, 2.0}) {
    ph::step_memory<law> memory;
    const auto braked_at = [&](double d, double v) {
      ph::contacts<2, 1> touched;
      touched.push_back(floor_at(0, -d));
      return ph::step(table(), without_lag(), touched, control, state_of<table>({0, -d}, {0, v}, {0, -10}),
                      memory)
          .capacity[1];
    };
    braked_at(2e-3, -share * p.landing_velocity);
    const double rest = share < 1 ? 2e-3 : 3e-3;
    const double wanted = std::min(p.depth_gain * (3e-3 - rest), p.velocity_limit);
    EXPECT_NEAR(braked_at(3e-3, 0), 10 + slide_mass() * wanted / p.velocity_lag, 1e-9) << share;
  }
}

// A wall that moves is met as by a handle that moves the other way; one sensed elsewhere, as where the handle
// is.
TEST(velocity_direct_control, sees_the_wall_from_where_the_handle_is_and_how_it_moves) {
  const auto braked = [&](double v, double wall_v, double sensed_higher) {
    ph::contacts<2, 1> touched;
    auto floor = floor_at(0, -2e-3 + sensed_higher);
    floor.wall_velocity = {5, wall_v};
    touched.push_back(floor);
    ph::step_memory<law> memory;
    return ph::step(table(), without_lag(), touched, law(), state_of<table>({0, -2e-3}, {0, v}, {0, -2}),
                    memory)
        .capacity[1];
  };
  const double as_it_is = braked(-0.1, 0, 0);
  EXPECT_GT(as_it_is, 2);
  EXPECT_NEAR(braked(-0.06, 0.04, 0), as_it_is, 1e-9);
  EXPECT_NEAR(braked(-0.14, -0.04, 0), as_it_is, 1e-9);
  for (const double higher : {-1.5e-3, 1e-3}) EXPECT_NEAR(braked(-0.1, 0, higher), as_it_is, 1e-9);
  EXPECT_NEAR(braked(-0.011, 0, 1.9e-3), braked(-0.011, 0, 0), 1e-9);
}

TEST(velocity_direct_control, with_a_margin_depth_counts_from_the_shapes_own_surface) {
  constants p;
  p.margin = 0.005;
  const law control(p);
  // 2 mm off the surface: the wall grown by 5 mm is 3 mm deep
  const auto approaching = [&](double speed) {
    return once(control, -0.003, {0, -speed}, {0, 0}).capacity[1];
  };
  const double allowed = p.depth_gain * (p.rest_depth + 0.002);
  EXPECT_EQ(approaching(0.99 * allowed), 0);
  EXPECT_NEAR(approaching(allowed + 0.02), slide_mass() * 0.02 / p.velocity_lag, 1e-9);
}

TEST(velocity_direct_control, a_held_contact_is_carried_on_to_second_order) {
  const ph::disc hollow({0, 1}, 1, ph::filling::hollow);
  const ph::point<2> sensed(0, -1e-3), now(0.01, -1e-3);
  const auto c = ph::sense(ph::scene(ph::wall(hollow)), sensed)[0];
  const ph::point<2> moved = now - sensed;
  const double depth = c.depth - moved.dot(c.normal + 0.5 * (c.curvature * moved));
  EXPECT_NEAR(depth, -hollow.distance(now), 1e-7);
  EXPECT_LE((ph::point<2>(c.normal + c.curvature * moved).normalized() - hollow.gradient(now)).norm(), 1e-5);
  EXPECT_GT(std::abs(c.depth - moved.dot(c.normal) + hollow.distance(now)), 4e-5)
      << "to first order it is off";
}

// Along a circle it takes v^2 / R to stay at one depth.
TEST(velocity_direct_control, brakes_for_the_curvature_of_a_wall) {
  for (const auto side : {ph::filling::hollow, ph::filling::solid}) {
    const bool concave = side == ph::filling::hollow;
    const ph::disc round({0, concave ? 0.5 : -0.5}, 0.5, side);
    const auto touched = ph::sense(ph::scene(ph::wall(round)), {0, -1e-3});
    ASSERT_EQ(touched.size(), 1);
    ph::step_memory<law> memory;
    const auto result = ph::step(table(), without_lag(), touched, law(),
                                 state_of<table>({0, -1e-3}, {0.2, 0}, {0, -2}), memory);
    const double curving = (concave ? 1 : -1) * 0.2 * 0.2 / (concave ? 0.501 : 0.499);
    EXPECT_NEAR(result.capacity[1], 2 + slide_mass() * curving, 1e-9);
  }
}

TEST(velocity_direct_control, refuses_constants_that_make_no_sense) {
  constants p;
  p.velocity_lag = 0;
  try {
    const law control(p);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("velocity_lag [s] = 0, expected a finite number > 0"),
              std::string::npos)
        << error.what();
  }
}

// A handle pressed into a corner of two walls touches both and stays; each wall has a depth of its own.
TEST(velocity_direct_control, holds_in_the_corner_of_two_walls) {
  using M = ph::tendon_two_link<double>;
  const M arm;
  constants p;
  p.margin = 0.006;
  const ph::half_space<2> ceiling({0, 0.2}, {0, -1}), side({0.1, 0}, {-1, 0});
  ph::controller control(
      arm, ph::brakes_of<M>(),
      ph::scene(ph::wall(ph::offset(ceiling, p.margin)), ph::wall(ph::offset(side, p.margin))), law(p));
  const pair q = arm.inverse({0.095, 0.192}, ph::elbow::left).q;
  ph::simulated_device device(arm, ph::brakes_of<M>(), 0.5, q);
  ph::first_order_lag<double, 2> sensor(pair::Constant(ph::low_pass_time_constant(200.0)));
  pair capacity = pair::Zero();
  double deepest = -1, shallowest = 1;
  for (int k = 0; k < 20'000; ++k) {
    if (k % 10 == 0)
      capacity = control(ph::device_state<M>{k * 1e-4, device.q(), device.qd(), sensor.output()}).capacity;
    const pair v = device.velocity();
    device.advance(1e-4, capacity, pair(2, 2) - 20 * v);
    sensor.advance(1e-4, device.sensed_force());
    if (k < 10'000) continue;
    for (const double depth : {-ceiling.distance(device.position()), -side.distance(device.position())}) {
      deepest = std::max(deepest, depth);
      shallowest = std::min(shallowest, depth);
    }
  }
  EXPECT_GT(shallowest, 1e-4);
  EXPECT_LT(deepest, 2e-3);
}

// Back along the wall the cone leaves brake 1 alone, 51 deg from the wall's normal, while brake 2 comes to
// rest: told more it does nothing. A law that does not know that lets the handle slide into the wall along
// the path of brake 2.
TEST(velocity_direct_control, knows_that_a_brake_at_rest_only_holds) {
  using M = ph::tendon_two_link<double>;
  const M arm;
  constants p;
  p.margin = 0.006;
  const ph::half_space<2> ceiling({0, 0.225}, {0, -1});
  for (const double x : {0.08, 0.11, 0.14, 0.165}) {
    ph::controller control(arm, ph::brakes_of<M>(), ph::scene(ph::wall(ph::offset(ceiling, p.margin))),
                           law(p));
    const pair q = arm.inverse({x, 0.221}, ph::elbow::left).q;
    ph::simulated_device device(arm, ph::brakes_of<M>(), 0.5, q);
    ph::first_order_lag<double, 2> sensor(pair::Constant(ph::low_pass_time_constant(200.0)));
    pair capacity = pair::Zero();
    double deepest = -1;
    for (int k = 0; k < 20'000; ++k) {
      if (k % 10 == 0)
        capacity = control(ph::device_state<M>{k * 1e-4, device.q(), device.qd(), sensor.output()}).capacity;
      const pair v = device.velocity();
      device.advance(1e-4, capacity, pair(-1, 2) - 20 * v);
      sensor.advance(1e-4, device.sensed_force());
      deepest = std::max(deepest, -ceiling.distance(device.position()));
    }
    EXPECT_LT(deepest, 1.5e-3) << "from x = " << x;
  }
}

// The map of a device with a brake held is that with the torque which holds it.
TEST(acceleration_map, of_a_held_brake_is_that_under_its_holding_torque) {
  constexpr unsigned seed = 8;
  ph::testing::random_source random(seed);
  for (int k = 0; k < 100; ++k) {
    ph::acceleration_map<double, 2, 3> map;
    const ph::matrix<double, 3, 3> root =
        ph::matrix<double, 3, 3>::NullaryExpr([&] { return random.uniform(-1.0, 1.0); });
    map.A = root * root.transpose() + 0.1 * ph::matrix<double, 3, 3>::Identity();
    map.brakes_free = random.normal_vector<double, 3>();
    map.free = random.normal_vector<double, 2>();
    for (int j = 0; j < 3; ++j) map.G.col(j) = random.normal_vector<double, 2>();
    ph::vector<double, 3> t = random.normal_vector<double, 3>();
    const auto held = map.held(1);
    t[1] = map.holding_torque(1, t);
    EXPECT_NEAR((map.brakes_free + map.A * t)[1], 0, 1e-12) << "seed " << seed;
    EXPECT_LE((map.free + map.G * t - held.free - held.G * t).norm(), 1e-12 * (1 + t.norm() * map.G.norm()));
    EXPECT_LE((map.brakes_free + map.A * t - held.brakes_free - held.A * t).norm(), 1e-11 * (1 + t.norm()));
  }
}

TEST(brake_lag_model, follows_a_first_order_lag_and_inverts_it) {
  constexpr unsigned seed = 5;
  ph::testing::random_source random(seed);
  const pair lag(0.02, 0.005);
  ph::brake_lag_model model;
  ph::first_order_lag<double, 2> brake(lag);
  const double period = 1e-3, horizon = 5e-3;
  for (int k = 0; k < 1000; ++k) {
    model.advance(k * period, lag);
    pair u;
    for (int i = 0; i < 2; ++i) u[i] = model.command(i, random.uniform(0.0, 1.0), lag[i], 1.0, horizon);
    ASSERT_TRUE((u.array() >= 0).all() && (u.array() <= 1).all());
    brake.advance(period, u);
  }
  // From rest and unlimited, the brake has the wanted torque a horizon later
  ph::brake_lag_model fresh;
  fresh.advance(0, lag);
  const double u = fresh.command(0, 0.3, lag[0], 100.0, horizon);
  ph::first_order_lag<double, 1> one(ph::vector<double, 1>::Constant(lag[0]));
  EXPECT_NEAR(one.advance(horizon, ph::vector<double, 1>::Constant(u))[0], 0.3, 1e-14);
  // The model knows: asked for the same a horizon later, it commands just that
  fresh.advance(horizon, lag);
  EXPECT_NEAR(fresh.command(0, 0.3, lag[0], 100.0, horizon), 0.3, 1e-14);
  EXPECT_EQ(fresh.command(1, 0.3, 0.0, 100.0, horizon), 0.3) << "no lag, nothing to invert";
}

TEST(contact_memory, is_a_walls_own_while_it_is_touched) {
  ph::contact_memory<int, 2> memory;
  memory.begin_cycle();
  memory.of(7) = 70;
  memory.of(9) = 90;
  memory.begin_cycle();
  EXPECT_EQ(memory.of(9), 90);
  memory.begin_cycle();
  EXPECT_EQ(memory.of(7), 0) << "it was not touched in between";
  EXPECT_EQ(memory.of(9), 90);
  memory.clear();
  EXPECT_EQ(memory.of(9), 0);
}

}  // namespace
