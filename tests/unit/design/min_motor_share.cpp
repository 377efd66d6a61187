// How much motor beside each brake would hold a hand: on paper.
#include <passive_haptics/design/displayable.hpp>
#include <passive_haptics/design/min_motor_share.hpp>
#include <passive_haptics/design/sink_depth.hpp>
#include <passive_haptics/design/undisplayable_share.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace ph = passive_haptics;

namespace {

using slides = ph::xy_table<double>;
using in_plane = ph::vector<double, 2>;
constexpr double beyond_all = std::numeric_limits<double>::infinity();

// A slanted wall: brake y pushes out with 0.8 * 2 N, brake x not at all, but its motor with 0.6 s.
const in_plane out_of_wall(0.6, 0.8), along_the_wall(0.8, -0.6);

ph::switchable_brakes<slides> brakes_of_1_and_2() {
  ph::switchable_brakes<slides> brakes;
  brakes.torque_limit = {1, 2};
  return brakes;
}

double share_for(double push, const ph::switchable_brakes<slides>& brakes = brakes_of_1_and_2()) {
  const auto found = ph::min_motor_share(slides(), {0, 0}, along_the_wall, out_of_wall, brakes, push);
  EXPECT_EQ(found.outcome, ph::status::ok);
  return found.share;
}

TEST(min_motor_share, is_what_brakes_leave_by_what_motors_can_make) {
  EXPECT_EQ(share_for(-1), 0);
  EXPECT_EQ(share_for(1.6), 0);
  EXPECT_NEAR(share_for(2.0), 0.4 / 0.6, 1e-15);
  EXPECT_NEAR(share_for(2.2), 1, 1e-15);
  EXPECT_NEAR(share_for(2.5), 2.5 / 2.2, 1e-15) << "motors stronger than brakes";
  EXPECT_EQ(share_for(beyond_all), beyond_all);
  auto brakes = brakes_of_1_and_2();
  brakes.switch_off(1);  // which does not switch off its motor
  EXPECT_NEAR(share_for(1.1, brakes), 0.5, 1e-15);
  brakes.torque_limit = {0, 0};
  EXPECT_EQ(share_for(1.1, brakes), beyond_all);
}

TEST(min_motor_share, along_a_path_is_the_largest) {
  const auto path = [](double u) {
    return ph::path_point<slides>{{0, 0}, u < 0.9 ? along_the_wall : in_plane(-along_the_wall), out_of_wall};
  };
  // Back along the wall brake x pushes out with 0.6 N, and the motor of brake y with 1.6 s
  EXPECT_NEAR(ph::min_motor_share(slides(), path, brakes_of_1_and_2(), 1.4), 0.8 / 1.6, 1e-15);
  EXPECT_EQ(ph::min_motor_share(slides(), path, brakes_of_1_and_2(), 0.59), 0);
  EXPECT_THROW(ph::min_motor_share(slides(), path, brakes_of_1_and_2(), 1.4, 0), std::invalid_argument);
}

TEST(min_motor_share, says_why_there_is_none) {
  auto brakes = brakes_of_1_and_2();
  const auto outcome = [&](double push, const in_plane& normal) {
    const auto found = ph::min_motor_share(slides(), {0, 0}, along_the_wall, normal, brakes, push);
    EXPECT_EQ(found.share, beyond_all);
    return found.outcome;
  };
  EXPECT_EQ(outcome(1, {0, 0}), ph::status::contact_invalid);
  EXPECT_EQ(outcome(std::numeric_limits<double>::quiet_NaN(), out_of_wall), ph::status::parameters_invalid);
  brakes.torque_limit[0] = beyond_all;
  EXPECT_EQ(outcome(1, out_of_wall), ph::status::parameters_invalid);
}

// No law drives a motor.
static_assert(ph::BrakesFor<ph::switchable_brakes<slides>, slides>);
static_assert(!ph::BrakesFor<ph::hybrid_brakes<slides>, slides>);

TEST(hybrid_brakes, add_motors_to_what_can_be_displayed) {
  const ph::hybrid_brakes<slides> none = brakes_of_1_and_2(), some(brakes_of_1_and_2(), {0.5, 0});
  const auto alone = ph::displayable(slides(), {0, 0}, along_the_wall, out_of_wall, none),
             hybrid = ph::displayable(slides(), {0, 0}, along_the_wall, out_of_wall, some);
  EXPECT_NEAR(alone.max_force, 1.6, 1e-15);
  EXPECT_NEAR(hybrid.max_force, 1.6 + 0.6 * 0.5, 1e-15);
  EXPECT_EQ(hybrid.angle, alone.angle) << "class, angle and signs are those of the brakes";
  EXPECT_EQ(hybrid.max_approximated_force, alone.max_approximated_force);
  const auto turned = ph::displayable(slides(), {0, 0}, -along_the_wall, -out_of_wall, some);
  EXPECT_NEAR(turned.max_force, hybrid.max_force, 1e-15) << "motors push and pull";
  const auto out = ph::displayable(slides(), {0, 0}, out_of_wall, out_of_wall, some);
  EXPECT_EQ(out.display, ph::display_class::none);
  EXPECT_NEAR(out.max_force, 0.3, 1e-15) << "a motor pushes out a handle that leaves";
  const auto path = [](double u) {
    return ph::path_point<slides>{in_plane(0.1 * u * along_the_wall), along_the_wall, out_of_wall};
  };
  EXPECT_EQ(ph::undisplayable_share(slides(), path, none, 1.8), 1);
  EXPECT_EQ(ph::undisplayable_share(slides(), path, some, 1.8), 0);
  EXPECT_NEAR(ph::sink_depth(slides(), path, none, 1.8), 0.1 * 4 / 3, 1e-15);
  EXPECT_EQ(ph::sink_depth(slides(), path, some, 1.8), 0);
}

}  // namespace
