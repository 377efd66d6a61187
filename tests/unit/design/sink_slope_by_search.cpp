// slow, optimised
// Sink slopes against what can be displayed at each slope of a fine grid, for devices of all forms.
#include <passive_haptics/design/sink_slope.hpp>

#include <passive_haptics/design/displayable.hpp>
#include <passive_haptics/mechanism/adaptors/braked_joints.hpp>
#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>
#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/five_bar.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include "../../property/chain_cases.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
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
constexpr int grid = 360;
double grid_slope(int k) { return std::tan(std::numbers::pi / 2 * k / grid); }

struct found_slopes {
  int all = 0, held = 0, sinking = 0, lost = 0, lost_again = 0;  // lost_again: not held at some steeper slope
};

template <class M>
found_slopes search(const M& mechanism, const ph::joint_vector<M>& lower, const ph::joint_vector<M>& upper,
                    int hands, std::uint64_t seed) {
  ph::testing::random_source random(seed);
  found_slopes seen;
  for (int k = 0; k < hands; ++k) {
    SCOPED_TRACE(::testing::Message() << "seed " << seed << ", hand " << k);
    const auto hand = draw_hand(mechanism, lower, upper, random);
    const auto found = ph::sink_slope(mechanism, hand.q, hand.along, hand.normal, hand.brakes, hand.push);
    if (found.outcome != ph::status::ok) continue;  // a pose without a position
    ++seen.all;
    seen.held += found.slope == 0;
    seen.lost += !std::isfinite(found.slope);
    seen.sinking += found.slope > 0 && std::isfinite(found.slope);
    const double more = hand.push * (1 + 1e-9), less = hand.push * (1 - 1e-9);
    if (std::isfinite(found.slope)) {
      EXPECT_GE(hand.max_force_at(mechanism, found.slope), less);
    }
    bool again = false;
    for (int j = 0; j < grid; ++j) {
      const double slope = grid_slope(j), force = hand.max_force_at(mechanism, slope);
      if (slope < found.slope * (1 - 1e-9)) {
        EXPECT_LT(force, more) << "at " << slope << ", less than " << found.slope;
      }
      again |= slope > found.slope * (1 + 1e-9) && force < less;
    }
    seen.lost_again += again;
    if (::testing::Test::HasFailure()) return seen;
  }
  return seen;
}

template <class M>
void expect_least(const M& mechanism, const ph::joint_vector<M>& lower, const ph::joint_vector<M>& upper,
                  int hands) {
  for (const std::uint64_t seed : {11u, 4711u}) {
    const found_slopes seen = search(mechanism, lower, upper, hands, seed);
    EXPECT_GT(seen.all, hands / 2);
    EXPECT_GT(seen.sinking, seen.all / 20);
    EXPECT_GT(seen.held, seen.all / 20);
    EXPECT_GT(seen.lost, seen.all / 20);
    EXPECT_EQ(seen.lost_again, 0);
    std::printf("%d hands: %d held, %d sinking, %d lost, %d lost again at a steeper slope\n", seen.all,
                seen.held, seen.sinking, seen.lost, seen.lost_again);
  }
}

template <int N>
ph::vector<double, N> all(double x) {
  return ph::vector<double, N>::Constant(x);
}

TEST(sink_slope, is_the_least_of_a_grid_where_forces_add_up) {
  using planar = ph::vector<double, 2>;
  const planar low(1.7, 0.2), high(2.9, 1.4);
  expect_least(ph::tendon_two_link<double>(), planar(-3, 0.2), planar(3, 2.9), 500);
  expect_least(ph::xy_table<double>(), planar(-1, -1), planar(1, 1), 250);
  expect_least(ph::five_bar<double>(), low, high, 500);
  expect_least(ph::five_bar<double, 4>(), low, high, 500);
  expect_least(ph::delta<double>(), all<3>(-0.3), all<3>(1.1), 500);
  expect_least(chains::irregular_chain<double, 3, 3>::make(), all<3>(-2), all<3>(2), 500);
}

template <int N>
auto planar_chain() {
  std::array<double, N> lengths;
  lengths.fill(0.2);
  return ph::serial_chain<double, N, 2>(ph::planar_arm<double>(lengths));
}

TEST(sink_slope, is_the_least_of_a_grid_where_a_self_motion_settles) {
  expect_least(planar_chain<3>(), all<3>(-2), all<3>(2), 300);
  expect_least(planar_chain<4>(), all<4>(-2), all<4>(2), 150);
  expect_least(chains::irregular_chain<double, 5, 3>::make(), all<5>(-2), all<5>(2), 50);
  expect_least(ph::braked_joints<ph::serial_chain<double, 4, 2>, 0, 1, 3>(planar_chain<4>()), all<4>(-2),
               all<4>(2), 150);
}

}  // namespace
