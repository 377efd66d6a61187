// One set of torques for several contacts, and for effects beside them: by hand.
#include <passive_haptics/force/torques/torques_beside.hpp>

#include <gtest/gtest.h>

namespace ph = passive_haptics;

namespace {

using pair = ph::vector<double, 2>;
using three = ph::vector<double, 3>;
const ph::force_map<double, 2, 2> axes{ph::identity_matrix<double, 2>()};

TEST(contact_forces, tell_what_each_contact_gets) {
  const auto result = ph::contact_forces<double, 2, 2, 3>(
      axes, ph::torques_within<double, 2>({-1, -1}, {5, 5}), {{{{1, 0}, 2, true}, {{0, 1}, 9, false}}}, 2);
  EXPECT_EQ(result.torque, pair(2, 5));
  EXPECT_EQ(result.force, pair(2, 5));
  EXPECT_EQ(result.displayed, (std::array<double, 3>{2, 5, 0}));
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

// -0.1 + (0.3 - -0.1) is more than 0.3.
TEST(torques_beside, stay_within_limits_to_the_last_bit) {
  const auto box = ph::torques_within<double, 2>({0, 0}, {0.3, 0.3});
  const ph::matrix<double, 1, 2> no_wall(0, 0);
  EXPECT_EQ(ph::torques_beside(axes, box, pair(-0.1, 0.1), no_wall, wanting<2>({9, -9})), pair(0.3, -0.3));
}

}  // namespace
