// slow
// Sink slopes against what can be displayed at each slope of a grid, for devices of all forms.
#include <passive_haptics/design/sink_slope.hpp>

#include <passive_haptics/design/displayable.hpp>
#include <passive_haptics/mechanism/adaptors/braked_joints.hpp>
#include <passive_haptics/mechanism/chains/serial_chain.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace ph = passive_haptics;

namespace {

// A hand that is led along a wall, by brakes that may be off or work one way, with or without motors.
template <class M>
struct led_hand {
  ph::joint_vector<M> q;
  ph::task_vector<M> along, normal;
  ph::hybrid_brakes<M> brakes;
  double push;

  double max_force_at(const M& mechanism, double slope) const {
    return ph::displayable(mechanism, q, ph::task_vector<M>(along - slope * normal), normal, brakes)
        .max_force;
  }
};

template <class M>
led_hand<M> draw_hand(const M& mechanism, const ph::joint_vector<M>& lower, const ph::joint_vector<M>& upper,
                      ph::testing::random_source& random) {
  constexpr int d = M::task_dimension;
  led_hand<M> hand;
  hand.q = random.between(lower, upper);
  hand.normal = random.direction<double, d>();
  hand.along = random.direction<double, d>();
  for (int pass = 0; pass < 2; ++pass)  // once leaves rounding of what was long beside the rest
    hand.along = (hand.along - hand.normal.dot(hand.along) * hand.normal).normalized();
  const double kind = random.uniform(0.0, 1.0);
  for (int i = 0; i < M::brake_count; ++i) {
    hand.brakes.brakes.torque_limit[i] = random.uniform(0.3, 2.0);
    if (kind < 0.3) hand.brakes.motor_limit[i] = random.uniform(0.0, 0.5);
    const double way = random.uniform(0.0, 1.0);
    if (kind < 0.7 || way > 0.5) continue;
    if (way < 0.15) hand.brakes.brakes.switch_off(i);
    else if (way < 0.3) hand.brakes.brakes.make_positive(i);
    else hand.brakes.brakes.make_negative(i);
  }
  const double most =
      ph::displayable(mechanism, hand.q, ph::task_vector<M>(-hand.normal), hand.normal, hand.brakes)
          .max_force;
  hand.push = random.uniform(0.05, 1.1) * (std::isfinite(most) && most > 0 ? most : 1.0);
  return hand;
}

// Angles of descent, evenly between 0 and a right angle.
constexpr int grid = 90;
double grid_slope(int k) { return std::tan(std::numbers::pi / 2 * k / grid); }

template <class M>
void expect_least(const M& mechanism, const ph::joint_vector<M>& lower, const ph::joint_vector<M>& upper,
                  int hands = 100) {
  ph::testing::random_source random(11);
  int all = 0, held = 0, lost = 0;
  for (int k = 0; k < hands; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed 11, hand " << k);
    const auto hand = draw_hand(mechanism, lower, upper, random);
    const auto found = ph::sink_slope(mechanism, hand.q, hand.along, hand.normal, hand.brakes, hand.push);
    if (found.outcome != ph::status::ok) continue;  // a pose without a position
    ++all;
    held += found.slope == 0;
    lost += !std::isfinite(found.slope);
    const double more = hand.push * (1 + 1e-9), less = hand.push * (1 - 1e-9);
    if (std::isfinite(found.slope)) {
      ASSERT_GE(hand.max_force_at(mechanism, found.slope), less);
    }
    for (int j = 0; j < grid; ++j) {
      const double slope = grid_slope(j), force = hand.max_force_at(mechanism, slope);
      if (slope < found.slope * (1 - 1e-9)) {
        ASSERT_LT(force, more) << "at " << slope << ", less than " << found.slope;
      } else if (slope > found.slope * (1 + 1e-9)) {
        ASSERT_GE(force, less) << "lost again at the steeper " << slope;
      }
    }
  }
  EXPECT_GT(all, hands / 2);
  EXPECT_GT(held, all / 20);
  EXPECT_GT(lost, all / 20);
  EXPECT_GT(all - held - lost, all / 20);
}

template <int N>
ph::vector<double, N> all(double x) {
  return ph::vector<double, N>::Constant(x);
}

TEST(sink_slope, is_the_least_of_a_grid_if_forces_add_up) {
  expect_least(ph::tendon_two_link<double>(), {-3, 0.2}, {3, 2.9});
  expect_least(ph::five_bar<double, 4>(), {1.7, 0.2}, {2.9, 1.4});
  expect_least(ph::delta<double>(), all<3>(-0.3), all<3>(1.1));
}

TEST(sink_slope, is_the_least_of_a_grid_if_a_self_motion_settles) {
  const ph::serial_chain<double, 3, 2> chain(ph::planar_arm<double>(std::array<double, 3>{0.2, 0.2, 0.2}));
  expect_least(chain, all<3>(-2), all<3>(2), 50);
  expect_least(ph::braked_joints<ph::serial_chain<double, 3, 2>, 0, 2>(chain), all<3>(-2), all<3>(2), 50);
}

// Two slides, of which the second moves nothing, with one brake more.
struct stuck_slides {
  using scalar = double;
  static constexpr int dof = 2, task_dimension = 2, brake_count = 3;
  ph::vector<double, 2> position(const ph::vector<double, 2>& q) const { return {q[0], 0}; }
  ph::matrix<double, 2, 2> jacobian() const { return ph::matrix<double, 2, 2>{{1, 0}, {0, 0}}; }
  ph::matrix<double, 3, 2> transmission() const { return ph::matrix<double, 3, 2>{{1, 0}, {0, 1}, {1, 1}}; }
};

TEST(sink_slope, and_what_can_be_displayed_are_none_without_a_pose_or_a_force) {
  const ph::five_bar<double, 4> open_loop;
  const auto limit = ph::vector<double, 4>::Ones().eval();
  EXPECT_EQ(ph::displayable(open_loop, {3.1, 0.0}, {0, 1}, {1, 0}, limit).outcome,
            ph::status::pose_undefined);
  EXPECT_EQ(ph::sink_slope(open_loop, {3.1, 0.0}, {0, 1}, {1, 0}, limit, 1).outcome,
            ph::status::pose_undefined);
  const auto stuck = ph::displayable(stuck_slides(), {0, 0}, {1, 0}, {-1, 0}, {1, 1, 1});
  EXPECT_EQ(stuck.outcome, ph::status::singular_jacobian);
  EXPECT_EQ(stuck.display, ph::display_class::none);
  EXPECT_EQ(stuck.max_force, 0);
}

}  // namespace
