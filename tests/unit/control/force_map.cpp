// slow
// The forces that torques make, without assembling the map by hand; the nearest one within limits.
#include "../../property/custom_mechanisms.hpp"

#include <passive_haptics/force/forms/form_of.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>

#include <gtest/gtest.h>

#include <random>

namespace ph = passive_haptics;

namespace {

const custom::planar_arm<double> three_joints;
const ph::vector<double, 3> pose(0.4, 0.9, -0.7);

}  // namespace

TEST(force_map, gives_the_nearest_force_within_limits) {
  const auto E = ph::brake_jacobian(three_joints, pose);
  const auto map = ph::force_map_of(three_joints, pose);
  const ph::vector<double, 2> Fd(0.6, -0.8);
  const ph::vector<double, 3> limit(0.05, 0.04, 0.03), none(0, 0, 0);
  const auto found = ph::nearest_torque(map, ph::torques_within(none, limit), Fd);
  EXPECT_TRUE((found.torque.array().abs() <= limit.array()).all());
  EXPECT_LT((found.torque - ph::brake_torque(E, found.force)).norm(), 1e-12);
  // No other force within the limits comes nearer
  std::mt19937_64 engine(20040627);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int k = 0; k < 20000; ++k) {
    const ph::vector<double, 2> F(number(engine), number(engine));
    if ((ph::brake_torque(E, F).array().abs() > limit.array()).any()) continue;
    ASSERT_GE((F - Fd).norm(), (found.force - Fd).norm() - 1e-12);
  }
}

TEST(velocity, is_that_of_the_brakes_through_E) {
  const ph::vector<double, 3> qd(0.3, -0.2, 0.5);
  EXPECT_EQ(ph::velocity(three_joints, pose, qd), ph::jacobian(three_joints, pose) * qd);
  EXPECT_EQ(ph::velocity(ph::xy_table<double>(), {0, 0}, {0.1, 0.2}), (ph::vector<double, 2>(0.1, 0.2)));
}
