// slow
// One set of torques for several contacts, and for effects beside them: by hand.
#include <passive_haptics/force/desired_force.hpp>
#include <passive_haptics/force/torques/torques_beside.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ph = passive_haptics;

namespace {

using pair = ph::vector<double, 2>;
using three = ph::vector<double, 3>;
const ph::force_map<double, 2, 2> axes{ph::identity_matrix<double, 2>()};

TEST(desired_force, of_a_wall_grows_with_depth_along_its_normal) {
  const auto Fd = ph::desired_force_of<double>(
      ph::contact<2>{.normal = {0.6, 0.8}, .depth = 0.5, .stiffness = 6, .wall_velocity = {1, 2}});
  EXPECT_EQ(Fd.direction, pair(0.6, 0.8));
  EXPECT_EQ(Fd.magnitude, 3);
  EXPECT_EQ(Fd.wall_velocity, pair(1, 2));
  EXPECT_NEAR(ph::outward<double>(Fd, pair(4, 7)), 0.6 * 3 + 0.8 * 5, 1e-15);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double magnitude : {0.0, -1.0, nan, 1e-300})
    EXPECT_EQ(ph::is_nonzero(ph::desired_force<double, 2>{{1, 0}, magnitude, {0, 0}}), magnitude > 0);
}

TEST(governing_contact, asks_for_the_largest_force_or_for_none_that_is_finite) {
  const auto governing = [](std::initializer_list<double> depths) {
    ph::contacts<2, 4> touched;
    double stiffness = 8;
    for (const double depth : depths) {
      touched.push_back({.normal = {1, 0}, .depth = depth, .stiffness = stiffness});
      stiffness /= 2;
    }
    return ph::governing_contact(touched);
  };
  EXPECT_EQ(governing({}), -1);
  EXPECT_EQ(governing({0, 0}), 0);
  EXPECT_EQ(governing({1, 3, 5}), 1);
  EXPECT_EQ(governing({1, 2, 4}), 0) << "the first of equals";
  EXPECT_EQ(governing({9, std::numeric_limits<double>::infinity(), 5}), 1);
  EXPECT_EQ(governing({9, 3, std::numeric_limits<double>::quiet_NaN()}), 2);
  ph::contacts<2, 1> one;
  EXPECT_EQ(ph::governing_contact(one), -1);
  one.push_back({.normal = {1, 0}, .depth = 1, .stiffness = 1});
  EXPECT_EQ(ph::governing_contact(one), 0);
}

TEST(check_contacts, finds_what_is_not_finite_in_each) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ph::contact<2> good{.normal = {1, 0}, .depth = 1, .stiffness = 1e30};
  for (int bad = -1; bad < 4; ++bad) {
    for (int at = 0; at < 2; ++at) {
      ph::contacts<2, 2> touched;
      for (int j = 0; j < 2; ++j) {
        ph::contact<2> c = good;
        if (j == at && bad == 0) c.normal[1] = nan;
        if (j == at && bad == 1) c.depth = nan;
        if (j == at && bad == 2) c.wall_velocity[0] = nan;
        if (j == at && bad == 3) c.depth = 1e10;  // no float
        touched.push_back(c);
      }
      const auto outcome = bad < 0 ? ph::status::ok : ph::status::contact_invalid;
      EXPECT_EQ(ph::check_contacts<float>(touched), outcome) << bad << " of contact " << at;
      EXPECT_EQ(ph::check_contacts<double>(touched), bad == 3 ? ph::status::ok : outcome);
    }
  }
}

TEST(force_map, inverts_what_has_an_inverse) {
  const auto two = ph::invert_brake_jacobian(ph::matrix<double, 2, 2>{{2, 1}, {3, 4}});
  EXPECT_TRUE(two.G.isApprox(ph::matrix<double, 2, 2>{{0.8, -0.6}, {-0.2, 0.4}}, 1e-15)) << two.G;
  const auto map =
      ph::invert_brake_jacobian(ph::matrix<double, 3, 3>{{2, 1, 0.3}, {-1, 3, 0.7}, {0.1, 0.2, 1}});
  EXPECT_TRUE(two.P.isZero(0) && map.P.isZero(0)) << map.P;
  const double hair = 0x1p-30;
  const auto flat = ph::invert_brake_jacobian(ph::matrix<double, 2, 2>{{1 + hair, 1}, {1, 1 - hair}});
  EXPECT_FALSE(flat.P.isZero(0)) << "singular to rounding";
  for (const double h : {0x1p-20, 0x1p-24}) {  // det E = -h
    const auto map = ph::invert_brake_jacobian(ph::matrix<double, 2, 2>{{1, 1}, {1 + h, 1}});
    EXPECT_EQ(map.G, (ph::matrix<double, 2, 2>{{-1, 1 + h}, {1, -1}} / h)) << h;
  }
}

TEST(force_map, of_what_has_no_inverse_is_the_least_norm_and_the_rest) {
  const auto tall = ph::invert_brake_jacobian(ph::matrix<double, 2, 3>{{1, 0, 1}, {0, 1, 1}});
  EXPECT_TRUE((3 * tall.G).isApprox(ph::matrix<double, 2, 3>{{2, -1, 1}, {-1, 2, 1}}, 1e-14)) << tall.G;
  EXPECT_TRUE((3 * tall.P).isApprox(three(1, 1, -1) * three(1, 1, -1).transpose(), 1e-14)) << tall.P;
  const auto singular = ph::invert_brake_jacobian(ph::matrix<double, 2, 2>{{1, 2}, {0, 0}});
  EXPECT_TRUE(singular.G.isApprox(ph::matrix<double, 2, 2>{{0.2, 0.4}, {0, 0}}, 1e-14)) << singular.G;
  EXPECT_TRUE(singular.P.isApprox(ph::matrix<double, 2, 2>{{0.8, -0.4}, {-0.4, 0.2}}, 1e-14)) << singular.P;
}

TEST(contact_forces, take_the_least_drag) {
  const auto box = ph::torques_within<double, 2>({0, 0}, {9, 9});
  const std::array<ph::contact_demand<double, 2>, 1> wall{{{{0.6, 0.8}, 5, false}}};
  const auto least = ph::contact_forces<double, 2, 2, 1>(axes, box, wall, 1);
  EXPECT_TRUE(least.torque.isApprox(pair(3, 4), 1e-14)) << least.torque.transpose();
  const ph::matrix<double, 2, 2> drag{{1, 0}, {0, 2}};  // t_0^2 + 4 t_1^2
  const auto other = ph::contact_forces<double, 2, 2, 1>(axes, box, wall, 1, drag);
  EXPECT_TRUE(other.torque.isApprox(pair(0.6, 0.2) * (5 / (0.36 + 0.16)), 1e-14)) << other.torque.transpose();
}

TEST(contact_forces, tell_what_each_contact_gets) {
  const auto result = ph::contact_forces<double, 2, 2, 3>(
      axes, ph::torques_within<double, 2>({-1, -1}, {5, 5}), {{{{1, 0}, 2, true}, {{0, 1}, 9, false}}}, 2);
  EXPECT_EQ(result.torque, pair(2, 5));
  EXPECT_EQ(result.force, pair(2, 5));
  EXPECT_EQ(result.displayed, (std::array<double, 3>{2, 5, 0}));
}

// Priorities hold whatever is asked for: the torques for 1e245 N would be infinite. The brakes 1 and 2, which
// push different ways, may only have the same torque: none.
TEST(contact_forces, keep_to_what_comes_first_where_a_demand_is_beyond_all_torques) {
  const ph::force_map<double, 2, 3> tied{1e-100 * ph::matrix<double, 2, 3>{{1, 1, 1}, {1, -1, -1}},
                                         ph::matrix<double, 3, 3>{{0, 0, 0}, {0, 0.5, -0.5}, {0, -0.5, 0.5}}};
  const auto made = [&](const three& s, double limit) {
    return ph::contact_forces<double, 2, 3, 2>(tied, ph::torques_within<double, 3>(s, {limit, limit, limit}),
                                               {{{{1, 0}, 0, true}, {{0, 1}, 1e245, false}}}, 2)
        .torque;
  };
  EXPECT_EQ(made({-1, -1, 1}, 1), three(0, 0, 0));
  EXPECT_EQ(made({0, 0, 0}, 1), three(1, -0.5, -0.5));
  const three free = made({0, 0, 0}, std::numeric_limits<double>::infinity());
  EXPECT_TRUE(free.isApprox(free[0] * three(1, -0.5, -0.5), 1e-14)) << free.transpose();
  EXPECT_GT(free[0], 1e30);
}

// What effects want of the force, and nothing of single joints.
template <int Brakes>
ph::effect_demand<double, 2, Brakes, 2> wanting(const pair& Fe) {
  return {Fe, ph::matrix<double, 2, Brakes>::Zero(), pair::Zero()};
}

TEST(torques_beside, leave_to_a_wall_what_it_has_and_take_the_rest) {
  const auto box = ph::torques_within<double, 2>({0, 0}, {9, 9});
  const ph::matrix<double, 1, 2> normal(0, 1);
  EXPECT_EQ(ph::torques_beside(axes, box, pair(1, 2), normal, wanting<2>({-3, 7})), pair(-3, 2));
}

TEST(torques_beside, are_the_least_that_make_the_force) {
  const ph::force_map<double, 2, 3> redundant{ph::matrix<double, 2, 3>{{1, 1, 0}, {0, 0, 1}}};
  const auto box = ph::torques_within<double, 3>({0, 0, 0}, {9, 9, 9});
  const ph::matrix<double, 1, 2> no_wall(0, 0);
  const three t = ph::torques_beside(redundant, box, three(1, 0, 2), no_wall, wanting<3>({1, 0}));
  EXPECT_TRUE(t.isApprox(three(0.5, 0.5, 0), 1e-15)) << t.transpose();
}

// A joint may have a torque of its own, before the force of an effect; not against the box.
TEST(torques_beside, give_a_joint_its_torque_first) {
  const auto box = ph::torques_within<double, 2>({0, 0}, {9, 9});
  const ph::matrix<double, 1, 2> no_wall(0, 0), wall(1, 0);
  ph::effect_demand<double, 2, 2, 2> wanted = wanting<2>({-3, 7});
  wanted.joint_rows.row(1) = pair(1, 1);
  wanted.joint_torque[1] = 2;  // more than 1 + 4
  EXPECT_TRUE(ph::torques_beside(axes, box, pair(1, 4), no_wall, wanted).isApprox(pair(-1.5, 8.5), 1e-14));
  EXPECT_TRUE(ph::torques_beside(axes, box, pair(1, 4), wall, wanted).isApprox(pair(1, 6), 1e-14));
}

// -0.1 + (0.3 - -0.1) is more than 0.3.
TEST(torques_beside, stay_within_limits_to_the_last_bit) {
  const auto box = ph::torques_within<double, 2>({0, 0}, {0.3, 0.3});
  const ph::matrix<double, 1, 2> no_wall(0, 0);
  EXPECT_EQ(ph::torques_beside(axes, box, pair(-0.1, 0.1), no_wall, wanting<2>({9, -9})), pair(0.3, -0.3));
}

}  // namespace
