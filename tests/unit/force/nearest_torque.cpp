// slow
// Redundant brakes at the corners: brakes that are alike, at rest, dead or infinite, within limits or none.
#include <passive_haptics/force/forms/generator_form.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace ph = passive_haptics;

namespace {

using pair = ph::vector<double, 2>;
using three = ph::vector<double, 3>;
constexpr double inf = std::numeric_limits<double>::infinity();
const ph::vector<double, 5> five = -ph::vector<double, 5>::Ones();

TEST(nearest_torque, is_shared_by_brakes_that_are_alike) {
  const ph::matrix<double, 2, 4> G{{1, 2, 0, 0}, {0, 0, 1, 1}};
  const ph::vector<double, 4> s(-1, -1, -1, -1);
  const auto torque = [&](double x, double y) {
    return ph::nearest_torque<double, 2, 4>(G, s, {x, y}).torque;
  };
  EXPECT_TRUE(torque(1, 0).isApprox(ph::vector<double, 4>(0.2, 0.4, 0, 0), 1e-15));
  EXPECT_TRUE(torque(1, -1).isApprox(ph::vector<double, 4>(0.2, 0.4, 0, 0), 1e-15));
  EXPECT_TRUE(torque(1, 1).isApprox(ph::vector<double, 4>(0.2, 0.4, 0.5, 0.5), 1e-15));
  const ph::matrix<double, 3, 5> H{{1, 2, 0, 0, 1}, {0, 0, 1, 1, 1}, {0, 0, 0, 0, 0}};
  const auto t = ph::nearest_torque<double, 3, 5>(H, five, {1, 1, 1});  // Gram matrix {6, 1}, {1, 3}
  EXPECT_TRUE(t.force.isApprox(three(1, 1, 0), 1e-15));
  EXPECT_TRUE(t.torque.isApprox(ph::vector<double, 5>(2, 4, 5, 5, 7) / 17, 1e-14));
}

TEST(nearest_torque, of_a_brake_at_rest_goes_both_ways) {
  const ph::matrix<double, 2, 3> G{{1, 0, 1}, {0, 1, 0}};
  const three s(-1, -1, 0);
  const auto torque = [&](double x, double y) {
    return ph::nearest_torque<double, 2, 3>(G, s, {x, y}).torque;
  };
  EXPECT_TRUE(torque(1, 0).isApprox(three(0.5, 0, 0.5), 1e-15));
  EXPECT_TRUE(torque(-1, 0).isApprox(three(0, 0, -1), 1e-15));
  EXPECT_TRUE(torque(0, -1).isZero(1e-15));
}

TEST(nearest_torque, is_zero_where_nothing_can_be_made) {
  const three s(1, -1, -1);
  for (const double bad : {0.0, inf, -inf, std::numeric_limits<double>::quiet_NaN()}) {
    const auto t = ph::nearest_torque<double, 2, 3>(ph::matrix<double, 2, 3>::Constant(bad), s, {0.6, 0.8});
    EXPECT_TRUE(t.torque.isZero(0) && t.force.isZero(0)) << bad;
    const auto u =
        ph::nearest_torque<double, 3, 5>(ph::matrix<double, 3, 5>::Constant(bad), five, {0, 0.6, 0.8});
    EXPECT_TRUE(u.torque.isZero(0) && u.force.isZero(0)) << bad;
  }
}

template <class T>
void expect_the_same_in_units(const std::vector<T>& units) {
  const ph::matrix<T, 2, 4> G{{1, -2, T(0.5), 0}, {T(0.3), 1, 1, 0}};
  const ph::vector<T, 4> s(-1, -1, -1, -1);
  const ph::vector<T, 2> n(0, 1);
  const ph::vector<T, 4> t = ph::nearest_torque(G, s, n).torque;
  const T rounding = T(4.5) * std::numeric_limits<T>::epsilon();  // 1e-15 of a double
  EXPECT_TRUE((G * t).isApprox(n, rounding));
  for (const T unit : units) {
    const auto scaled = ph::nearest_torque<T, 2, 4>(unit * G, s, n);
    EXPECT_TRUE((unit * scaled.torque).isApprox(t, 10 * rounding)) << unit;
  }
}

TEST(nearest_torque, does_not_depend_on_units) {
  expect_the_same_in_units<double>({1e-300, 1e-100, 1e100, 1e300});
  expect_the_same_in_units<float>({1e-30F, 1e-12F, 1e12F, 1e30F});
}

TEST(nearest_torque, stays_within_limits_and_gets_as_near_as_they_allow) {
  const ph::matrix<double, 2, 2> G = ph::matrix<double, 2, 2>::Identity();
  const auto force = [&](const pair& s, const pair& limit, const pair& Fd) {
    return ph::nearest_torque<double, 2, 2>(G, ph::torques_within(s, limit), Fd).force;
  };
  const pair moving(-1, -1), resting(0, 0);
  EXPECT_EQ(force(moving, {1, 0.5}, {3, 0.25}), pair(1, 0.25));
  EXPECT_EQ(force(moving, {1, 0.5}, {3, -7}), pair(1, 0));
  EXPECT_EQ(force(resting, {1, 0.5}, {0.75, -7}), pair(0.75, -0.5));
  for (const pair& s : {moving, resting}) EXPECT_EQ(force(s, {0, inf}, {3, 7}), pair(0, 7)) << "one is dead";
}

TEST(nearest_torque, within_limits_is_shared_by_brakes_that_push_one_way) {
  const ph::torque_box<double, 2> box{{-1, -1}, {1, 1}};
  const auto made = ph::nearest_torque<double, 2, 2>(ph::matrix<double, 2, 2>{{1, 2}, {0, 0}}, box, {2, 1});
  EXPECT_TRUE(made.torque.isApprox(pair(0.4, 0.8), 1e-14)) << made.torque.transpose();
  EXPECT_TRUE(made.force.isApprox(pair(2, 0), 1e-14));
}

TEST(nearest_torque, of_a_box_without_limits_has_its_signs) {
  const ph::matrix<double, 2, 3> G{{1, 0, 2}, {0, 3, 0}};
  const auto torque = [&](const three& lower, const three& upper, double x, double y) {
    const auto t = ph::nearest_torque(G, ph::torque_box<double, 3>{lower, upper}, pair(x, y));
    EXPECT_TRUE(t.force.isApprox(G * t.torque, 1e-15));
    return t.torque;
  };
  const three none(0, 0, 0), up(inf, inf, 0), both(inf, inf, inf);
  EXPECT_TRUE(torque(none, up, 4, 6).isApprox(three(4, 2, 0), 1e-15));
  EXPECT_TRUE(torque(none, up, -4, 6).isApprox(three(0, 2, 0), 1e-15));
  EXPECT_TRUE(torque(none, up, 4, -6).isApprox(three(4, 0, 0), 1e-15));
  EXPECT_TRUE(torque(-up, none, -4, -6).isApprox(three(-4, -2, 0), 1e-15));
  EXPECT_TRUE(torque(-up, none, -4, 6).isApprox(three(-4, 0, 0), 1e-15));
  EXPECT_TRUE(torque(-both, both, -4, -6).isApprox(three(-0.8, -2, -1.6), 1e-15));
  EXPECT_TRUE(torque(none, both, 4, -6).isApprox(three(0.8, 0, 1.6), 1e-15));
  EXPECT_TRUE(torque(-both, none, -4, 6).isApprox(three(-0.8, 0, -1.6), 1e-15));
}

TEST(nearest_torque, of_a_diagonal_is_that_of_each_axis) {
  const ph::diagonal_matrix<double, 2> G(2, -0.5);
  const auto t = ph::nearest_torque(G, pair(-1, -1), pair(3, 4));
  EXPECT_EQ(t.torque, pair(1.5, 0));
  EXPECT_EQ(t.force, pair(3, 0));
  EXPECT_EQ(ph::nearest_torque(G, ph::torques_within<double, 2>({0, 0}, {1, 5}), pair(3, 4)).torque,
            pair(1, -5));
}

// Beyond space; the third and the fourth generator differ by little and their torques are long.
TEST(nearest_torque, in_four_dimensions_is_exact_where_torques_are_long) {
  using four = ph::vector<double, 4>;
  const ph::matrix<double, 4, 4> axes = four(1, 2, 4, 8).asDiagonal();
  const auto each = ph::nearest_torque(axes, four(-1, -1, 1, 1), four(3, -4, 4, -4));
  EXPECT_EQ(each.torque, four(3, 0, 0, -0.5));
  EXPECT_EQ(each.force, four(3, 0, 0, -4));

  ph::matrix<double, 4, 4> G = axes;
  G.col(2) << 7e7, 0.1, 0.3, 1;
  G.col(3) << -3e7, 0.2, 0.7, -1;
  const four n = (G * four(0.1, 0.1, 0.3, 0.7)).normalized();
  const auto F = ph::approximate_by_generators(G, four(-1, -1, -1, -1), n, 0.0);
  EXPECT_EQ(F.display, ph::display_class::exact) << F.force.transpose() << "\n" << n.transpose();
}

}  // namespace
