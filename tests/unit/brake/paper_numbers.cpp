// The numbers that the paper prints, or that follow from its figures.
#include "../support.hpp"

#include <passive_haptics/brake/passive_fme.hpp>
#include <passive_haptics/brake/reference_forces.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/two_link.hpp>

#include <Eigen/LU>

#include <cmath>
#include <utility>

namespace {

// Figs. 2 and 3: l1 = l2 = 1 m, q = (45, 90) deg, the handle moves along -y.
template <class T>
struct figure_3 : ::testing::Test {
  using V = ph::vector<T, 2>;
  const ph::two_link<T> arm{ph::two_link_parameters<T>{.length_1 = 1, .length_2 = 1}};
  const V q{ph::radians(T(45)), ph::radians(T(90))};
  const V qd = ph::jacobian(arm, q).inverse() * V(0, -1);

  ph::step_result<ph::two_link<T>> display(double x, double y) const {
    ph::brakes_of<ph::two_link<T>> strong;
    strong.torque_limit.setConstant(100);
    return step_once<ph::no_direct_control>(arm, strong, state_of<ph::two_link<T>>(q, qd),
                                            asking_for<2>({x, y}));
  }
};
TYPED_TEST_SUITE(figure_3, scalars);

TYPED_TEST(figure_3, moving_down_turns_joint_1_back_and_joint_2_forth) {
  using W = ph::vector<TypeParam, 2>;
  expect_near(this->qd, W(-std::sqrt(TypeParam(0.5)), std::sqrt(TypeParam(2))), 1);
  const auto result = this->display(-0.5, 1);
  EXPECT_EQ(result.signs, W(-1, 1));
  EXPECT_EQ(ph::producible_signs(result.signs), (ph::torque_signs<2>{1, -1}))
      << "passive FME 2: R_1+ and R_2-";
}

TYPED_TEST(figure_3, reference_forces_are_formula_5) {
  using T = TypeParam;
  for (const T l1 : {T(1), T(0.3)}) {
    const ph::two_link<T> other(ph::two_link_parameters<T>{.length_1 = l1, .length_2 = T(0.8)});
    const T l2 = T(0.8), q1 = T(0.4), q2 = T(-1.1);
    const T c1 = std::cos(q1), s1 = std::sin(q1), s2 = std::sin(q2), c12 = std::cos(q1 + q2),
            s12 = std::sin(q1 + q2);
    const ph::matrix<T, 2, 2> formula{{l2 * c12, -l1 * c1 - l2 * c12}, {l2 * s12, -l1 * s1 - l2 * s12}};
    const auto reference = ph::reference_forces(other, ph::vector<T, 2>(q1, q2));
    ASSERT_EQ(reference.outcome, ph::status::ok);
    expect_near(reference.G, ph::matrix<T, 2, 2>(formula / (l1 * l2 * s2)), 10);
    EXPECT_EQ(reference.G, other.inverse_transposed_jacobian({q1, q2})) << "to the bit: where there is one";
  }
}

TYPED_TEST(figure_3, desired_force_1_is_displayed_exactly) {
  const auto result = this->display(-0.5, 1);
  EXPECT_EQ(result.display, ph::display_class::exact);
  EXPECT_EQ(result.power, ph::power_class::passive_1);
  expect_near(result.control_force, ph::vector<TypeParam, 2>(-0.5, 1), 1);
  EXPECT_EQ(result.approximation_angle(), TypeParam(0));
  EXPECT_GT(result.torque[0], 0);  // along R_1+
  EXPECT_LT(result.torque[1], 0);  // along R_2-
}

TYPED_TEST(figure_3, desired_force_2_is_approximated_by_reference_force_2) {
  using T = TypeParam;
  const auto result = this->display(0.5, 1);
  EXPECT_EQ(result.display, ph::display_class::approximate);
  EXPECT_EQ(result.power, ph::power_class::passive_2);
  expect_near(result.control_force, ph::vector<T, 2>(0, T(1.25)), 1);
  EXPECT_NEAR(ph::degrees(result.approximation_angle()), T(26.565051177078), T(1e-4));
  EXPECT_EQ(result.torque[0], T(0));  // brake 1 is released
  EXPECT_NEAR(result.torque[1], -T(1.25) / std::sqrt(T(2)), T(1e-6));
}

TYPED_TEST(figure_3, desired_force_3_is_not_displayed) {
  using T = TypeParam;
  const auto result = this->display(0.5, -1);
  EXPECT_EQ(result.display, ph::display_class::none);
  EXPECT_EQ(result.power, ph::power_class::active);
  EXPECT_EQ(result.capacity, (ph::vector<T, 2>::Zero()));
  EXPECT_NEAR(ph::degrees(result.approximation_angle()), T(90), T(1e-5));
}

TYPED_TEST(figure_3, an_active_force_may_yet_be_approximated) {
  using T = TypeParam;
  const auto result = this->display(-1, -0.1);
  EXPECT_EQ(result.power, ph::power_class::active);
  EXPECT_EQ(result.display, ph::display_class::approximate);
  // Fd . R_1+ = 0.9 / sqrt(2), so Fc = (1.01 / 0.9) (-1, 1)
  expect_near(result.control_force, ph::vector<T, 2>(-T(1.01) / T(0.9), T(1.01) / T(0.9)), 1);
  EXPECT_GT(result.torque[0], 0);
  EXPECT_EQ(result.torque[1], T(0));
}

// Section 5: the tendon device beside the wall y = 0.225 m.
template <class T>
struct tendon_device : ::testing::Test {
  using M = ph::tendon_two_link<T>;
  using V = ph::vector<T, 2>;
  const M arm;

  // Moving along +x with the hand, against a wall that is touched from below.
  ph::step_result<M> slide(T x, double stiffness, double depth, T outward, const V& hand) const {
    const auto pose = arm.inverse({x, T(0.225)}, ph::elbow::left);
    EXPECT_EQ(pose.outcome, ph::status::ok);
    const V qd = ph::jacobian(arm, pose.q).inverse() * V(T(0.5), -outward);
    ph::brakes_of<M> strong;
    strong.torque_limit.setConstant(T(1e9));
    return step_once<ph::direct_control>(
        arm, strong, state_of<M>(pose.q, qd, hand),
        ph::contact<2>{.normal = {0, -1}, .depth = depth, .stiffness = stiffness});
  }
};
TYPED_TEST_SUITE(tendon_device, scalars);

TYPED_TEST(tendon_device, elbow_left_pose_is_the_papers) {
  const auto pose = this->arm.inverse({TypeParam(0.06), TypeParam(0.225)}, ph::elbow::left);
  EXPECT_NEAR(ph::degrees(pose.q[0]), TypeParam(114.2), TypeParam(0.05));
  EXPECT_NEAR(ph::degrees(pose.q[1]), TypeParam(-78.2), TypeParam(0.05));
}

TYPED_TEST(tendon_device, brake_2_turns_with_both_joints) {
  const ph::vector<TypeParam, 2> w =
      ph::brake_rates(this->arm, ph::vector<TypeParam, 2>(0, 0), ph::vector<TypeParam, 2>(2, 3));
  expect_near(w, ph::vector<TypeParam, 2>(2, 2 + 3 / TypeParam(0.4)), 10);
}

TYPED_TEST(tendon_device, approximation_angles_on_the_wall_are_the_papers) {
  for (const auto& [x, angle] : {std::pair{0.06, 3.5}, {0.17, 31.9}}) {
    const auto result = this->slide(static_cast<TypeParam>(x), 1e7, 1e-3, TypeParam(-1e-3), {0, 0});
    EXPECT_EQ(result.display, ph::display_class::approximate);
    EXPECT_NEAR(static_cast<double>(ph::degrees(result.approximation_angle())), angle, 0.05) << "x = " << x;
    EXPECT_EQ(result.torque[0], TypeParam(0)) << "only brake 2 is activated";
    EXPECT_LT(result.torque[1], TypeParam(0)) << "R_2-";
  }
}

TYPED_TEST(tendon_device, two_newton_against_a_stiff_wall_need_a_scale_near_zero) {
  using T = TypeParam;
  const auto result = this->slide(T(0.1), 1e7, 5e-3, T(1e-3), {T(0.5), T(2)});
  EXPECT_NEAR(result.desired_force.norm(), T(5e4), T(0.1));
  EXPECT_NEAR(result.alpha, T(4e-5), T(1e-9));
}

TYPED_TEST(tendon_device, an_inward_motion_is_not_scaled) {
  EXPECT_EQ(this->slide(TypeParam(0.1), 1e7, 5e-3, TypeParam(-1e-3), {0, 2}).alpha, TypeParam(1));
}

TYPED_TEST(tendon_device, a_hand_that_pulls_off_the_wall_is_let_go) {
  const auto result = this->slide(TypeParam(0.1), 1e7, 5e-3, TypeParam(1e-3), {0, -1});
  EXPECT_EQ(result.alpha, TypeParam(0));
  EXPECT_EQ(result.capacity, (ph::vector<TypeParam, 2>::Zero()));
}

TYPED_TEST(tendon_device, a_hand_that_presses_harder_than_the_wall_is_scaled_by_no_more_than_one) {
  EXPECT_EQ(this->slide(TypeParam(0.1), 1e3, 1e-3, TypeParam(1e-3), {0, 2}).alpha, TypeParam(1));
}

}  // namespace
