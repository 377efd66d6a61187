// What parts are expected to render: by hand on an XY table, by brute force on arms, and what is refused.
#include "../../../property/chain_cases.hpp"
#include "../../../property/closed_chain_cases.hpp"
#include "../../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/core/parameter_text.hpp>
#include <passive_haptics/design/expected_rendering.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/wall_following.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

constexpr double no_end = std::numeric_limits<double>::infinity();

// Drums of 50 mm on the shafts of small brakes.
template <class M>
ph::data_sheet<M> small_parts(double gear = 20) {
  ph::data_sheet<M> parts;
  for (ph::brake_data& brake : parts.brakes)
    brake = {.torque_limit = 1, .residual_torque = 0.02, .fall_time_constant = 0.03, .gear_ratio = gear};
  for (ph::encoder_data& encoder : parts.encoders) encoder = {.counts_per_turn = 4096, .gear_ratio = gear};
  return parts;
}

template <int Joints>
std::vector<double> values_of(const ph::rendering<Joints>& r) {
  std::vector<double> all;
  for_each_figure(r, [&](const std::string&, const char*, const ph::banded& b) {
    all.insert(all.end(), {b.value, b.low, b.high});
  });
  return all;
}

template <int Joints>
void expect_equal(const ph::rendering<Joints>& a, const ph::rendering<Joints>& b, double tolerance) {
  const auto x = values_of(a), y = values_of(b);
  for (std::size_t i = 0; i < x.size(); ++i)
    EXPECT_TRUE(x[i] == y[i] || std::abs(x[i] - y[i]) <= tolerance * std::abs(y[i]))
        << i << ": " << x[i] << " instead of " << y[i];
  EXPECT_EQ(a.holds_push, b.holds_push);
}

template <class T>
class expected_rendering_of : public testing::Test {};
TYPED_TEST_SUITE(expected_rendering_of, scalars);

TYPED_TEST(expected_rendering_of, a_table_is_that_by_hand) {
  using T = TypeParam;
  using table = ph::xy_table<T>;
  using V = ph::vector<T, 2>;
  auto parts = small_parts<table>();
  parts.brakes[1].rotor_inertia = 1e-4;  // 0.04 kg on the drum
  parts.brakes[1].time_constant = 0.010;
  parts.control_rate = 500;
  parts.scene_rate = 100;
  parts.hand.stiffness = 60;
  parts.hand.damping = 12;
  const ph::rendering<2> r = ph::expected_rendering(table(), parts, V(0, 0), V(T(0.05), T(-0.12)), V(0, 3));
  const double count = 2 * std::numbers::pi / 4096 / 20, lag = ph::low_pass_time_constant(50.0);
  const double eps = 100 * static_cast<double>(std::numeric_limits<T>::epsilon());

  EXPECT_NEAR(r.free_drag.value, 0.4 * (0.05 + 0.12) / 0.13, eps);
  EXPECT_NEAR(r.wall_drag.value, 0.4, eps) << "the brake of y holds the push without drag";
  EXPECT_NEAR(r.strongest_force.value, 20, 20 * eps);
  EXPECT_TRUE(r.holds_push);
  EXPECT_NEAR(r.release_time.value, 0.001 + 0.004 + 0.03 * std::log(10), eps);
  EXPECT_NEAR(r.velocity_noise.value, ph::rate_noise(0.12, count, 2 * lag), eps * count / lag);
  EXPECT_NEAR(r.rate_noise[0].value, ph::rate_noise(0.05, count, 2 * lag), eps * count / lag);
  EXPECT_EQ(r.rate_noise[1].value, r.velocity_noise.value);

  ph::braked_wall wall;
  wall.force = wall.approximated_force = 20;
  wall.residual_force = 0.4;
  wall.inertia = static_cast<double>(table().mass_matrix(V(0, 0))(1, 1)) + 0.5 + 0.04;
  wall.depth_resolution = count;
  wall.approach_speed = 0.12;
  wall.time_constant = 0.020;  // of the slower brake
  wall.control_period = 0.002;
  wall.scene_period = 0.010;
  wall.hand_stiffness = 60;
  wall.hand_damping = 12;
  const ph::wall_limits limits = limits_of(wall);
  EXPECT_NEAR(r.depth.value, limits.depth, 10 * eps * limits.depth);
  EXPECT_NEAR(r.stiffness.value, limits.stiffness, 100 * eps * limits.stiffness);
  EXPECT_NEAR(r.depth.low, limits.depth / 2 - count, eps);
  EXPECT_NEAR(r.depth.high, 2 * limits.depth + count, eps);
}

// Torques grow with the gear, counts shrink: the figures are those of parts without one.
TEST(expected_rendering, a_gear_multiplies_torques_counts_and_inertia) {
  using M = ph::tendon_two_link<double>;
  using V = ph::vector<double, 2>;
  const M arm;
  const V q = arm.inverse({0.1, 0.2}, ph::elbow::left).q, v(0.08, 0.1), n(0.3, -1);
  ph::data_sheet<M> geared = small_parts<M>(), direct = small_parts<M>(1);
  for (std::size_t i = 0; i < 2; ++i) {
    geared.brakes[i].rotor_inertia = 1e-6;
    geared.brakes[i].torque_limit = 0.05;
    geared.brakes[i].residual_torque = 0.001;
    direct.brakes[i].rotor_inertia = 4e-4;
    direct.brakes[i].residual_torque = 0.02;
    direct.encoders[i].counts_per_turn = 20 * 4096;
  }
  expect_equal(ph::expected_rendering(arm, geared, q, v, n), ph::expected_rendering(arm, direct, q, v, n),
               1e-12);
}

template <class M, class V, class W>
void expect_rotors_of_the_parts(const M& bare, const M& with, const ph::data_sheet<M>& parts, const V& q,
                                const W& v, const W& n, const ph::brake_vector<M>& rotors) {
  ph::data_sheet<M> sheet = parts;
  for (std::size_t i = 0; i < sheet.brakes.size(); ++i)
    sheet.brakes[i].rotor_inertia = rotors[static_cast<int>(i)];
  const auto expected = ph::expected_rendering(with, parts, q, v, n);
  expect_equal(ph::expected_rendering(bare, sheet, q, v, n), expected, 1e-9);
  EXPECT_NE(ph::expected_rendering(bare, parts, q, v, n).depth.value, expected.depth.value);
}

// A mechanism whose rotors are among its own parameters against one that gets them of the data sheet.
TEST(expected_rendering, counts_the_rotors_of_the_parts) {
  using V = ph::vector<double, 2>;
  using M = ph::tendon_two_link<double>;
  ph::tendon_two_link_parameters<double> p;
  const V rotors(3e-4, 2e-4);
  const auto tendons = [&](const V& rotor) {
    p.arm.rotor_inertia_1 = rotor[0];
    p.arm.rotor_inertia_2 = rotor[1];
    return M(p);
  };
  const V q = M().inverse({0.1, 0.2}, ph::elbow::left).q, v(0.08, 0.3), n(0, -1);
  expect_rotors_of_the_parts(tendons(V::Zero()), tendons(rotors), small_parts<M>(1), q, v, n, rotors);

  using shape = chains::irregular_chain<double, 4, 2>;
  using chain = shape::mechanism;
  auto inertia = shape::inertia();
  const ph::vector<double, 4> on_joints(3e-4, 2e-4, 1e-4, 4e-4);
  inertia.rotor_inertia = on_joints;
  const chain with(shape::geometry(), inertia);
  inertia.rotor_inertia.setZero();
  const chain bare(shape::geometry(), inertia);
  expect_rotors_of_the_parts(bare, with, small_parts<chain>(1), ph::vector<double, 4>(0.4, 0.7, -0.6, 0.9),
                             V(0.1, 0.3), V(0.2, -1), on_joints);
}

// Forces of a slide by those of single brakes: the strongest, and the least drag that holds the push.
TEST(expected_rendering, its_forces_in_a_slide_are_those_of_the_brakes) {
  using M = ph::tendon_two_link<double>;
  using V = ph::vector<double, 2>;
  const M arm;
  constexpr unsigned seed = 3107;
  SCOPED_TRACE("seed " + std::to_string(seed));
  ph::testing::random_source random(seed);
  int held = 0;
  for (int k = 0; k < 500; ++k) {
    const V q(random.uniform(-3.1, 3.1), random.uniform(-2.5, -0.6)), n = random.direction<double, 2>();
    const V t(n[1], -n[0]);
    ph::data_sheet<M> parts = small_parts<M>(1);
    parts.hand.push = random.uniform(0.5, 6.0);
    parts.hand.stiffness = random.uniform(0.0, 300.0);
    for (ph::brake_data& brake : parts.brakes) brake.residual_torque = random.uniform(0.0, 0.05);
    const ph::rendering<2> r = ph::expected_rendering(arm, parts, q, V(0.1 * t), n);
    const ph::matrix<double, 2, 2> G = ph::force_generators(arm, q);  // a column for 1 N m of each brake
    const V against = -(G.transpose() * t).cwiseSign();
    V free = V::Zero();
    for (int i = 0; i < 2; ++i) free += parts.brakes[std::size_t(i)].residual_torque * against[i] * G.col(i);
    EXPECT_NEAR(r.free_drag.value, -free.dot(t), 1e-10);
    const double softened = r.depth.value < no_end ? parts.hand.stiffness * r.depth.value : 0.0;
    const double demanded = std::max(parts.hand.push - softened - free.dot(n), 0.0);
    double least = no_end, strongest = free.dot(n);
    for (int i = 0; i < 2; ++i) {
      const V F = against[i] * G.col(i);
      strongest += std::max(F.dot(n), 0.0);
      if (F.dot(n) > 0 && demanded / F.dot(n) <= 1) least = std::min(least, -F.dot(t) * demanded / F.dot(n));
    }
    EXPECT_NEAR(r.strongest_force.value, strongest, 1e-9 * std::abs(strongest)) << k;
    if (least == no_end) continue;  // it takes both, or is too much
    ++held;
    EXPECT_TRUE(r.holds_push);
    const bool approximated = r.wall_drag.value <= -free.dot(t) + least + 1e-9;
    EXPECT_TRUE(approximated) << k << ": " << r.wall_drag.value << " N instead of " << least - free.dot(t);
    if (r.wall_drag.value < -free.dot(t) + least - 1e-9) {
      EXPECT_LT(
          ph::displayable(arm, q, V(0.1 * t), n, ph::axis_brakes_of(parts).torque_limit).strongest_nearest,
          demanded);
    }
  }
  EXPECT_GE(held, 200);
}

// With self-motion the handle moves in the easiest way: no joint rates that move it so take less.
TEST(expected_rendering, the_drag_of_an_arm_with_self_motion_is_the_least) {
  using shape = chains::irregular_chain<double, 4, 2>;
  using M = shape::mechanism;
  using V = ph::vector<double, 2>;
  const M arm = shape::make();
  constexpr unsigned seed = 411;
  SCOPED_TRACE("seed " + std::to_string(seed));
  ph::testing::random_source random(seed);
  for (int k = 0; k < 50; ++k) {
    const auto q = random.between<double, 4>(shape::lower(), shape::upper());
    const V v = random.direction<double, 2>();
    ph::data_sheet<M> parts = small_parts<M>(1);
    const ph::rendering<4> r = ph::expected_rendering(arm, parts, q, v, V(0, 1));
    const ph::matrix<double, 2, 4> J(ph::jacobian(arm, q));
    const ph::matrix<double, 4, 2> inverse = J.transpose() * (J * J.transpose()).inverse();
    double found = no_end;
    for (int trial = 0; trial < 2000; ++trial) {
      const ph::vector<double, 4> any = random.wide(0.01, 30.0) * random.normal_vector<double, 4>();
      const ph::vector<double, 4> qd = inverse * v + any - inverse * (J * any);
      found = std::min(found, 0.02 * qd.lpNorm<1>());
    }
    EXPECT_LE(r.free_drag.value, found * (1 + 1e-9)) << k;
    EXPECT_GE(r.free_drag.value, 0.5 * found) << k;
  }
}

TEST(expected_rendering, of_redundant_brakes_is_that_of_their_sum) {
  using M = ph::five_bar<double, 4>;
  using V = ph::vector<double, 2>;
  const M device = closed_chains::lopsided_five_bar<double, 4>::make();
  const V q(2.4, 0.6), v(0.1, -0.05);
  const auto parts = small_parts<M>(1);
  const ph::rendering<2> r = ph::expected_rendering(device, parts, q, v, V(0, 1));
  const V qd = ph::matrix<double, 2, 2>(ph::jacobian(device, q)).inverse() * v;
  EXPECT_NEAR(r.free_drag.value, 0.02 * ph::brake_rates(device, q, qd).lpNorm<1>() / v.norm(), 1e-12);
  EXPECT_GT(r.strongest_force.value, 0);
}

TEST(expected_rendering, without_residual_torques_and_counts_there_is_neither_drag_nor_noise) {
  using M = ph::tendon_two_link<double>;
  using V = ph::vector<double, 2>;
  ph::data_sheet<M> parts = small_parts<M>(1);
  for (ph::brake_data& brake : parts.brakes) brake.residual_torque = 0;
  for (ph::encoder_data& encoder : parts.encoders) encoder.counts_per_turn = no_end;
  const M arm;
  const V q = arm.inverse({0.1, 0.2}, ph::elbow::left).q;
  const ph::rendering<2> r = ph::expected_rendering(arm, parts, q, V(0.1, 0.1), V(0, -1));
  EXPECT_EQ(r.free_drag.value, 0);
  EXPECT_EQ(r.velocity_noise.value, 0);
  EXPECT_EQ(r.rate_noise[0].value, 0);
  EXPECT_EQ(r.rate_noise[1].value, 0);
  EXPECT_GT(r.depth.value, 0);
}

TEST(expected_rendering, of_a_handle_at_rest_has_neither_drag_nor_noise) {
  using M = ph::tendon_two_link<double>;
  using V = ph::vector<double, 2>;
  const M arm;
  const V q = arm.inverse({0.1, 0.2}, ph::elbow::left).q;
  const ph::rendering<2> r = ph::expected_rendering(arm, small_parts<M>(1), q, V(0, 0), V(0, -1));
  EXPECT_EQ(r.free_drag.value, 0);
  EXPECT_EQ(r.velocity_noise.value, 0);
  EXPECT_GT(r.strongest_force.value, 0);
}

// A velocity along an oblique normal has a part along the wall by rounding alone.
TEST(expected_rendering, of_a_handle_that_comes_straight_has_no_drag_along_the_wall) {
  using M = ph::tendon_two_link<double>;
  using V = ph::vector<double, 2>;
  const M arm;
  const V q = arm.inverse({0.1, 0.2}, ph::elbow::left).q;
  for (int k = 0; k < 100; ++k) {
    const V n(std::cos(0.1 * k), std::sin(0.1 * k));
    const ph::rendering<2> r = ph::expected_rendering(arm, small_parts<M>(1), q, V(-0.1 * n), n);
    EXPECT_EQ(r.wall_drag.value, 0) << k;
    EXPECT_GT(r.free_drag.value, 0) << k;
    EXPECT_EQ(ph::sliding_residual(arm, q, V(-0.1 * n), n, V(0.1, 0.1)), 0) << k;
  }
}

// Drag is power by speed, whatever the speed.
TEST(expected_rendering, the_drag_is_that_of_the_direction) {
  using M = ph::tendon_two_link<double>;
  using V = ph::vector<double, 2>;
  const M arm;
  const V q = arm.inverse({0.1, 0.2}, ph::elbow::left).q, v(0.1, 0.03), n(0.2, -1);
  const ph::rendering<2> expected = ph::expected_rendering(arm, small_parts<M>(1), q, v, n);
  for (const double size : {1e-300, 1e-9, 10.0}) {
    const ph::rendering<2> r = ph::expected_rendering(arm, small_parts<M>(1), q, V(size * v), n);
    EXPECT_NEAR(r.free_drag.value, expected.free_drag.value, 1e-12) << size;
    if (size < 10) {  // a faster hand comes deeper, and pushes less
      EXPECT_NEAR(r.wall_drag.value, expected.wall_drag.value, 1e-12) << size;
    }
  }
}

// Next to a singular pose all that can be stated is huge or small, but a number.
TEST(expected_rendering, next_to_a_singular_pose_has_figures) {
  using M = ph::tendon_two_link<double>;
  using V = ph::vector<double, 2>;
  for (const double bend : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const ph::rendering<2> r =
        ph::expected_rendering(M(), small_parts<M>(1), V(0.3, bend), V(0.1, 0.1), V(0, -1));
    for (const double value : values_of(r)) EXPECT_FALSE(std::isnan(value)) << bend;
    EXPECT_GT(r.free_drag.value, 0);
  }
}

TEST(expected_rendering, brakes_without_torque_hold_nothing) {
  using M = ph::tendon_two_link<double>;
  using V = ph::vector<double, 2>;
  ph::data_sheet<M> parts = small_parts<M>(1);
  for (ph::brake_data& brake : parts.brakes) brake.torque_limit = brake.residual_torque = 0;
  const M arm;
  const V q = arm.inverse({0.1, 0.2}, ph::elbow::left).q;
  const ph::rendering<2> r = ph::expected_rendering(arm, parts, q, V(0.1, 0.1), V(0, -1));
  EXPECT_EQ(r.strongest_force.value, 0);
  EXPECT_EQ(r.stiffness.value, 0);
  EXPECT_EQ(r.depth.value, no_end);
  EXPECT_EQ(r.depth.high, no_end);
  EXPECT_FALSE(r.depth.contains(0.009));
  EXPECT_TRUE(r.depth.contains(0.04));
  EXPECT_FALSE(r.holds_push);
  EXPECT_EQ(r.wall_drag.value, 0);
  EXPECT_EQ(r.wall_drag.high, no_end) << "it sinks, and slides nowhere";
}

// Of negative figures, too: residual torques may pull the handle in.
TEST(expected_rendering, the_lower_end_of_a_band_is_the_lower_one) {
  using M = ph::tendon_two_link<double>;
  using V = ph::vector<double, 2>;
  const M arm;
  ph::data_sheet<M> parts = small_parts<M>(1);
  for (ph::brake_data& brake : parts.brakes) brake = {.torque_limit = 0, .residual_torque = 0.1};
  int negative = 0;
  for (const double x : {-0.05, 0.02, 0.1, 0.15, 0.18}) {
    const V q = arm.inverse({x, 0.2}, ph::elbow::left).q;
    const ph::rendering<2> r = ph::expected_rendering(arm, parts, q, V(0.05, 0.1), V(0, -1));
    negative += r.strongest_force.value < 0;
    EXPECT_TRUE(r.strongest_force.contains(r.strongest_force.value));
    EXPECT_FALSE(r.strongest_force.contains(1.2 * r.strongest_force.value));
    EXPECT_FALSE(r.strongest_force.contains(0.8 * r.strongest_force.value));
  }
  EXPECT_GE(negative, 1);
}

// Each member in turn, of each part.
TEST(expected_rendering, a_bad_part_is_refused_by_name) {
  using M = ph::tendon_two_link<double>;
  using V = ph::vector<double, 2>;
  const M arm;
  const V q = arm.inverse({0.1, 0.2}, ph::elbow::left).q;
  ph::data_sheet<M> parts = small_parts<M>(1);
  const auto expect_refused = [&](const std::string& name, double& member, double value) {
    const double good = std::exchange(member, value);
    const std::string text = thrown_by([&] { ph::expected_rendering(arm, parts, q, V(0.1, 0.1), V(0, -1)); });
    EXPECT_NE(text.find(name + " "), std::string::npos) << name << " = " << value << ": " << text;
    member = good;
  };
  const auto expect_all_refused = [&](const std::string& part, auto& members) {
    ph::for_each_member(members, [&](const ph::member_description& about, double& member) {
      const std::string name =
          part + about.name + " of " + std::remove_reference_t<decltype(members)>::type_name;
      for (const double bad : {std::nan(""), -no_end}) expect_refused(name, member, bad);
      if (std::string(about.name) != "counts_per_turn") expect_refused(name, member, no_end);
      if (std::string(about.name) != "push") expect_refused(name, member, -1);
    });
  };
  for (const char* i : {"0", "1"}) {
    const auto k = static_cast<std::size_t>(*i - '0');
    expect_all_refused(std::string("brakes[") + i + "].", parts.brakes[k]);
    expect_all_refused(std::string("encoders[") + i + "].", parts.encoders[k]);
    for (double* ratio : {&parts.brakes[k].gear_ratio, &parts.encoders[k].gear_ratio})
      expect_refused("gear_ratio", *ratio, 0);
  }
  expect_all_refused("hand.", parts.hand);
  for (const double bad : {0.0, -1.0, no_end, std::nan("")}) {
    expect_refused("control_rate of a data sheet [Hz]", parts.control_rate, bad);
    expect_refused("scene_rate of a data sheet [Hz]", parts.scene_rate, bad);
    expect_refused("rate_corner of a data sheet [Hz]", parts.rate_corner, bad);
  }
}

TEST(expected_rendering, an_axis_without_an_encoder_is_refused) {
  using M = ph::tendon_two_link<double>;
  using V = ph::vector<double, 2>;
  ph::data_sheet<M> parts = small_parts<M>(1);
  parts.encoders[1].counts_per_turn = 0;
  EXPECT_EQ(
      thrown_by([&] { ph::expected_rendering(M(), parts, V(0.5, -1), V(0.1, 0.1), V(0, -1)); }),
      "passive_haptics: encoders[1].counts_per_turn of an encoder [1] = 0, expected a number > 0, or inf "
      "for an ideal encoder; a controller needs one on each axis");
}

TEST(expected_rendering, a_place_that_is_none_is_refused_by_name) {
  using M = ph::tendon_two_link<double>;
  using V = ph::vector<double, 2>;
  const M arm;
  const V q = arm.inverse({0.1, 0.2}, ph::elbow::left).q, v(0.1, 0.1), n(0, -1);
  const auto parts = small_parts<M>(1);
  const auto text = [&](const V& at, const V& moving, const V& out) {
    return thrown_by([&] { ph::expected_rendering(arm, parts, at, moving, out); });
  };
  for (const double bad : {std::nan(""), no_end}) {
    EXPECT_NE(text(V(0, bad), v, n).find("q[1] [rad or m] = "), std::string::npos);
    EXPECT_NE(text(q, V(bad, 0), n).find("velocity[0] [m/s] = "), std::string::npos);
    EXPECT_NE(text(q, v, V(bad, 0)).find("|normal| = "), std::string::npos);
  }
  EXPECT_NE(text(q, v, V(0, 0)).find("|normal| = 0, expected a direction"), std::string::npos);
  EXPECT_EQ(text(V(0.3, 0), v, n),
            "passive_haptics: rank of the Jacobian at q = 1, expected 2: choose a pose that is not singular");
}

// The brake of docs/guide/data_sheet.md, ten times slower than those that the bands were measured with.
TEST(expected_rendering, of_a_slow_brake_is_that_of_its_simulation) {
  using M = ph::tendon_two_link<double>;
  using V = ph::vector<double, 2>;
  const ph::coulomb_brake<double> real = ph::magnetic_particle_brake<double>();
  ph::tendon_two_link_parameters<double> p;
  p.arm.rotor_inertia_1 = p.arm.rotor_inertia_2 = 0;
  ph::data_sheet<M> parts;
  for (ph::brake_data& brake : parts.brakes)
    brake = {.torque_limit = real.torque_limit,
             .residual_torque = real.residual.strength,
             .time_constant = real.time_constant,
             .fall_time_constant = real.time_constant,
             .rotor_inertia = 0.00055};
  const V q = M().inverse({0.12, 0.225}, ph::elbow::left).q, n(0, -1), v(0.1, 0.1);
  const ph::rendering<2> expected = ph::expected_rendering(M(p), parts, q, v, n);

  p.arm.rotor_inertia_1 = p.arm.rotor_inertia_2 = 0.00055;
  const M arm(p);
  ph::simulated_device<M> plant(arm, ph::brake_models_of<M>{real, real}, parts.hand.mass, q);
  plant.set_motion(q, ph::matrix<double, 2, 2>(ph::jacobian(arm, q)).inverse() * v);
  const ph::half_space<2> wall(plant.position(), n);
  ph::controller control(arm, ph::axis_brakes_of(parts), ph::scene(ph::wall(wall, 1e7)),
                         ph::velocity_direct_control({.approach_speed = 0}));
  ph::following_hand_parameters<double> hand{.speed = 0.1, .push = parts.hand.push, .mass = parts.hand.mass};
  ph::wall_following_parameters run{.path_end = 1, .longest = 0.2};
  double deepest = 0, turned = 0, release = no_end;
  const auto follow = [&](auto&& observe) {
    ph::follow_wall(
        plant,
        [&](ph::device_state<M> state) {
          state.time += turned;
          return control(state);
        },
        wall, ph::following_hand<double, 2>(V(1, 0), plant.position(), hand), run, observe);
  };
  follow([&](const auto& now) { deepest = std::max(deepest, now.depth); });
  EXPECT_TRUE(expected.depth.contains(deepest)) << deepest;
  const double tenth = plant.brake_strength().maxCoeff() / 10;
  turned = run.longest;
  run.longest = 2;
  hand.push = -hand.push;
  follow([&](const auto& now) {
    if (plant.brake_strength().maxCoeff() <= tenth) release = std::min(release, now.time);
  });
  EXPECT_TRUE(expected.release_time.contains(release)) << release;
}

TEST(expected_rendering, is_printed_as_a_table) {
  using M = ph::tendon_two_link<double>;
  using V = ph::vector<double, 2>;
  const M arm;
  const V q = arm.inverse({0.1, 0.2}, ph::elbow::left).q;
  ph::data_sheet<M> parts = small_parts<M>(1);
  const std::string text = to_text(ph::expected_rendering(arm, parts, q, V(0.1, 0.1), V(0, -1)));
  for (const char* name : {"free_drag [N] ", "wall_drag [N] ", "strongest_force [N] ", "stiffness [N/m] ",
                           "depth [m] ", "release_time [s] ", "velocity_noise [m/s] ",
                           "rate_noise[0] [rad/s or m/s] ", "rate_noise[1] [rad/s or m/s] "})
    EXPECT_NE(text.find(name), std::string::npos) << name << text;
  EXPECT_EQ(text.find("sinks"), std::string::npos) << text;
  EXPECT_NE(to_text(parts).find("brakes[1].residual_torque of a brake [N m] = 0.02\n"), std::string::npos);
  parts.hand.push = 100;
  EXPECT_NE(to_text(ph::expected_rendering(arm, parts, q, V(0.1, 0.1), V(0, -1))).find("it sinks"),
            std::string::npos);
}

}  // namespace
