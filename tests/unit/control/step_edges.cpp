// slow
// One control cycle at its edges: singular poses, stiff walls, coincident walls, large angles.
#include "../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/held_scene.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace {

template <class T>
struct step_edges : ::testing::Test {
  using arm_type = ph::tendon_two_link<T>;
  using table_type = ph::xy_table<T>;
};
TYPED_TEST_SUITE(step_edges, scalars);

// Straight and folded: J is singular, the half-space form still answers.
TYPED_TEST(step_edges, singular_poses_are_no_fault) {
  using T = TypeParam;
  using M = typename TestFixture::arm_type;
  const M arm;
  int displayed = 0;
  for (const T q2 : {T(0), std::numbers::pi_v<T>, -std::numbers::pi_v<T>}) {
    for (int direction = 0; direction < 16; ++direction) {
      const double a = direction * std::numbers::pi / 8;
      for (const auto& qd : {ph::vector<T, 2>(1, 2), {-1, 3}, {T(0.5), -4}, {-2, -2}, {0, 0}}) {
        const ph::vector<T, 2> hand(T(0.3), T(-0.7));
        const auto result = step_once<ph::direct_control>(
            arm, {}, state_of<M>({T(0.7), q2}, qd, hand),
            ph::contact<2>{.normal = {std::cos(a), std::sin(a)}, .depth = 1e-4, .stiffness = 1e4});
        ASSERT_EQ(result.outcome, ph::status::ok) << "q2 = " << q2;
        EXPECT_TRUE((result.signs.array() * result.torque.array() <= T(0)).all());
        EXPECT_TRUE((result.capacity.array() <= T(1)).all());
        displayed += result.display == ph::display_class::none ? 0 : 1;
      }
    }
  }
  EXPECT_GT(displayed, 0);
}

TYPED_TEST(step_edges, extremely_stiff_walls_end_at_the_torque_limits) {
  using T = TypeParam;
  using M = typename TestFixture::table_type;
  for (const double stiffness : {1e12, 1e30}) {
    const auto result = step_once<ph::no_direct_control>(
        M(), {}, state_of<M>({0, 0}, {-1, -1}),
        ph::contact<2>{.normal = {0.6, 0.8}, .depth = 1e-2, .stiffness = stiffness});
    EXPECT_EQ(result.outcome, ph::status::ok);
    EXPECT_TRUE(result.saturated);
    expect_near(result.torque, ph::vector<T, 2>(T(0.75), T(1)), 1);
    EXPECT_NEAR(result.desired_force.template cast<double>().norm() / (stiffness * 1e-2), 1, 1e-6);
  }
}

TYPED_TEST(step_edges, negative_limits_and_undefined_options_release_the_brakes) {
  using T = TypeParam;
  using M = typename TestFixture::arm_type;
  const auto state = state_of<M>({T(0.2), T(0.4)}, {T(-1), T(2)}, {T(0), T(-1)});
  ph::contacts<2, 1> touched;
  touched.push_back({.normal = {0.6, 0.8}, .depth = 1e-3, .stiffness = 1e4});
  const auto outcome = [&](T limit, T min_cosine, T dead_band = T(0)) {
    ph::brakes_of<M> brakes;
    brakes.torque_limit[1] = limit;
    brakes.rate_dead_band[0] = brakes.torque_dead_band[1] = dead_band;
    ph::step_options<T> options;
    options.min_cosine = min_cosine;
    ph::step_memory<ph::direct_control> memory;
    return ph::step(M(), brakes, touched, ph::direct_control(), state, memory, options).outcome;
  };
  EXPECT_EQ(outcome(T(1), T(0.5)), ph::status::ok);
  EXPECT_EQ(outcome(T(-1), T(0.5)), ph::status::parameters_invalid);
  EXPECT_EQ(outcome(T(1), std::numeric_limits<T>::quiet_NaN()), ph::status::parameters_invalid);
  EXPECT_EQ(outcome(T(1), T(0.5), T(-1e-9)), ph::status::parameters_invalid);
}

TYPED_TEST(step_edges, coincident_walls_act_as_one) {
  using M = typename TestFixture::arm_type;
  const ph::half_space<2> plane({0, 0.3}, {0.3, 1});
  const M arm;
  const auto state = state_of<M>({TypeParam(0.2), TypeParam(0.4)}, {-1, 2}, {0, -1});
  const double soft = 1;  // [N/m], so that no torque limit is reached
  ph::controller one(arm, {}, ph::scene(ph::wall(plane, soft)), ph::direct_control{});
  ph::controller two(arm, {}, ph::scene(ph::wall(plane, soft), ph::wall(plane, soft)), ph::direct_control{});
  const auto a = one(state);
  const auto b = two(state);
  EXPECT_EQ(a.wall_number, 0);
  EXPECT_EQ(b.wall_number, 0);
  EXPECT_GT(a.capacity.norm(), TypeParam(0));
  EXPECT_FALSE(a.saturated);
  expect_near(a.capacity, b.capacity, 1);
}

TYPED_TEST(step_edges, beyond_the_largest_approximation_angle_nothing_is_displayed) {
  using T = TypeParam;
  using M = typename TestFixture::table_type;
  // Moving up along a slanted wall: only brake 1 may help, at the wall's own angle from its axis
  const auto run = [](double slant, T limit) {
    const double a = ph::radians(slant);
    ph::contacts<2, 1> touched;
    touched.push_back({.normal = {std::cos(a), std::sin(a)}, .depth = 1e-6, .stiffness = 1e7});
    ph::step_memory<ph::no_direct_control> memory;
    const ph::step_options<T> options(ph::approximation_parameters<T>{ph::radians(limit)});
    return ph::step(M(), ph::brakes_of<M>(), touched, ph::no_direct_control{}, state_of<M>({0, 0}, {-1, 1}),
                    memory, options);
  };
  EXPECT_EQ(run(29, 30).display, ph::display_class::approximate);
  EXPECT_EQ(run(31, 30).display, ph::display_class::none);
  EXPECT_EQ(run(31, 30).approximation_cosine, T(0));
  EXPECT_TRUE(run(31, 30).capacity.isZero(0));
  EXPECT_NEAR(ph::degrees(run(29, 30).approximation_angle()), T(29), T(1e-4));
  EXPECT_EQ(run(88.9, 89).display, ph::display_class::approximate) << "the default";
  EXPECT_EQ(run(89.1, 89).display, ph::display_class::none);
}

TYPED_TEST(step_edges, a_force_that_overflows_in_the_approximation_releases_the_brakes) {
  using T = TypeParam;
  using M = typename TestFixture::table_type;
  // Only brake 1 helps, at 60 deg from the wall's normal: twice the desired force
  const auto run = [](double share) {
    return step_once<ph::no_direct_control>(
        M(), {}, state_of<M>({0, 0}, {-1, 1}),
        ph::contact<2>{.normal = {0.5, std::sqrt(0.75)},
                       .depth = share * static_cast<double>(std::numeric_limits<T>::max()),
                       .stiffness = 1});
  };
  EXPECT_EQ(run(0.4).outcome, ph::status::ok);
  EXPECT_GT(run(0.4).capacity.norm(), T(0));
  EXPECT_EQ(run(0.6).outcome, ph::status::result_not_finite);
  EXPECT_TRUE(run(0.6).capacity.isZero(0) && run(0.6).torque.isZero(0));
}

// A half-space violated by less than rounding is not worth a projection, but no torque of the wrong sign is
// left.
TYPED_TEST(step_edges, torques_of_the_wrong_sign_are_exactly_zero_however_small) {
  using T = TypeParam;
  using V = ph::vector<T, 3>;
  const ph::matrix<T, 3, 3> E = ph::matrix<T, 3, 3>::Identity();
  const T hair = std::numeric_limits<T>::epsilon() / 16;
  const V n(hair, T(0.6), T(-0.8)), s(1, 1, 1);
  const auto Fc = ph::approximate(E, s, n, T(0.1));
  EXPECT_EQ(Fc.display, ph::display_class::approximate);
  EXPECT_EQ(Fc.torque[0], T(0));
  EXPECT_EQ(Fc.torque[1], T(0));
  EXPECT_NEAR(Fc.torque[2], T(-1.25), ph::rounding_tolerance<T>(4));
}

// Rounding never leaves Fp = 0 exactly; what it leaves must not be blown up to a force.
TYPED_TEST(step_edges, forces_in_the_polar_cone_are_not_displayed_whatever_the_largest_angle) {
  using T = TypeParam;
  using V = ph::vector<T, 3>;
  ph::testing::random_source random(17);
  for (int k = 0; k < 500; ++k) {
    ph::matrix<T, 3, 3> E;
    for (int j = 0; j < 3; ++j) E.col(j) = ph::vector<T, 3>::Unit(j) + T(0.3) * random.direction<T, 3>();
    const V s(1, -1, 1);
    const V share(random.uniform(T(0.1), T(1)), random.uniform(T(0.1), T(1)), random.uniform(T(0.1), T(1)));
    const V n = V(E * s.cwiseProduct(share)).normalized();
    const auto Fc = ph::approximate(E, s, n, T(0));
    EXPECT_EQ(Fc.display, ph::display_class::none) << "seed 17, trial " << k << ", cosine " << Fc.cosine();
  }
}

TYPED_TEST(step_edges, a_pose_without_position_or_jacobian_is_a_fault_that_no_scene_sees) {
  using T = TypeParam;
  using M = hyperbola<T>;
  const ph::contact<2> wall{.normal = {0, 1}, .depth = 1e-3, .stiffness = 1e3};
  const auto bare = step_once<ph::no_direct_control>(M(), {}, state_of<M>({0, 1}, {1, 1}), wall);
  EXPECT_EQ(bare.outcome, ph::status::pose_undefined);
  EXPECT_TRUE(bare.capacity.isZero(0) && bare.torque.isZero(0));

  const auto floor = ph::scene(ph::wall(ph::half_space<2>({0, 3}, {0, 1}), 1.0));
  ph::controller control(M(), ph::brakes_of<M>(), ph::held_scene(floor, 1), ph::no_direct_control{});
  const auto at = [&](double time, T q) {
    return control(ph::device_state<M>{time, {1, q}, {0, 1}, {0, 0}});
  };
  EXPECT_EQ(at(0, 1).desired_force[1], T(2));
  EXPECT_EQ(at(5, 0).outcome, ph::status::pose_undefined);
  EXPECT_EQ(at(0.5, T(0.5)).desired_force[1], T(2)) << "still held";
}

TYPED_TEST(step_edges, brake_rates_that_overflow_are_a_fault) {
  using T = TypeParam;
  using M = typename TestFixture::arm_type;
  const T most = std::numeric_limits<T>::max();  // w2 = qd1 + qd2 / 0.4
  const ph::contact<2> wall{.normal = {0, -1}, .depth = 1e-3, .stiffness = 1e3};
  const auto result = step_once<ph::no_direct_control>(M(), {}, state_of<M>({2, -1}, {0, most}), wall);
  EXPECT_NE(result.outcome, ph::status::ok);
  EXPECT_TRUE(result.capacity.isZero(0) && result.torque.isZero(0));
}

}  // namespace
