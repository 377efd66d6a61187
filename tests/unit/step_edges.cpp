// One control cycle at its edges: singular poses, stiff walls, coincident walls, large angles.
#include "support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/mechanism/tendon_two_link.hpp>
#include <passive_haptics/mechanism/xy_table.hpp>
#include <passive_haptics/scene/half_space.hpp>

#include <cmath>
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

TYPED_TEST(step_edges, coincident_walls_act_as_one) {
  using M = typename TestFixture::arm_type;
  const ph::half_space<2> plane({0, 0.3}, {0.3, 1});
  const M arm;
  const auto state = state_of<M>({TypeParam(0.2), TypeParam(0.4)}, {-1, 2}, {0, -1});
  const double soft = 1;  // [N/m], so that no torque limit is reached
  ph::controller one(arm, {}, ph::scene(ph::wall(plane, soft)), ph::direct_control{});
  ph::controller two(arm, {}, ph::scene(ph::wall(plane, soft), ph::wall(plane, soft)), ph::direct_control{});
  const auto a = one(state), b = two(state);
  EXPECT_EQ(a.wall, 0);
  EXPECT_EQ(b.wall, 0);
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

}  // namespace
