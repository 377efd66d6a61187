// Torques of least power: against a grid, beside brakes that are held, and at several walls.
#include <passive_haptics/control/laws/velocity/min_power.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace {

namespace ph = passive_haptics;
using pair = ph::vector<double, 2>;

// Against all ways to make the same on a grid.
TEST(min_power_torques, make_what_is_wanted_with_the_least_power) {
  constexpr unsigned seed = 9;
  using V = ph::vector<double, 3>;
  ph::testing::random_source random(seed);
  for (int k = 0; k < 200; ++k) {
    const V g = random.normal_vector<double, 3>(), w = random.normal_vector<double, 3>();
    ph::torque_range<double, 3> range;
    for (int i = 0; i < 3; ++i) {
      range.sign[i] = random.uniform(-1.0, 1.0) > 0 ? 1 : -1;
      range.lower[i] = random.uniform(0.0, 0.2);
      range.upper[i] = range.lower[i] + random.uniform(0.0, 1.0);
      range.sign_is_lasting[i] = true;
    }
    const V gain = range.sign.cwiseProduct(g);
    const double wanted = random.uniform(-0.5, 2.0);
    const V t = ph::min_power_torques<double, 3>(g, wanted, range, w);
    double most = 0, min_power = 1e9;
    for (int i = 0; i < 3; ++i) {
      EXPECT_GE(t[i], range.lower[i]);
      EXPECT_LE(t[i], range.upper[i]);
      most += gain[i] * (gain[i] > 0 ? range.upper[i] : range.lower[i]);
    }
    const double floor = gain.dot(range.lower);
    EXPECT_NEAR(gain.dot(t), std::max(floor, std::min(wanted, most)), 1e-12)
        << "seed " << seed << ", trial " << k;
    constexpr int steps = 20;
    for (int a = 0; a <= steps; ++a)
      for (int b = 0; b <= steps; ++b)
        for (int c = 0; c <= steps; ++c) {
          const V share(double(a) / steps, double(b) / steps, double(c) / steps);
          const V other = range.lower + share.cwiseProduct(range.upper - range.lower);
          if (gain.dot(other) >= std::min(wanted, most) - 1e-12)
            min_power = std::min(min_power, w.cwiseAbs().dot(other));
        }
    EXPECT_LE(w.cwiseAbs().dot(t), min_power + 1e-9) << "seed " << seed << ", trial " << k;
  }
}

// Beside brake i that is held, brake j gives the handle g_j - g_i A_ij / A_ii for each N m.
TEST(min_power_torques, ask_a_brake_that_turns_for_what_it_does_beside_one_that_is_held) {
  using V = ph::vector<double, 2>;
  for (const int held : {0, 1}) {
    for (const double sign : {-1.0, 1.0}) {
      const int turns = 1 - held;
      V g;
      g[held] = 1;
      g[turns] = -0.2 * sign;
      ph::torque_range<double, 2> range;
      range.sign[held] = 1;
      range.sign[turns] = sign;
      range.lower.setConstant(0.1);
      range.upper[held] = 3;
      range.upper[turns] = 1;
      range.A.diagonal().setConstant(2);
      range.A(held, turns) = range.A(turns, held) = -sign;
      range.any_at_rest = range.at_rest[held] = range.held[held] = true;
      range.sign_is_lasting.setConstant(true);
      const double alone = 3 - 0.2 * 0.1, beside = 0.5 - 0.2;
      for (const auto& [wanted, torque] : {std::pair(alone, 0.1), std::pair(alone + 0.5 * beside, 0.6),
                                           std::pair(alone + 2 * beside, 1.0)}) {
        const V t = ph::min_power_torques<double, 2>(g, wanted, range, V(0, 0));
        EXPECT_NEAR(t[held], 3, 1e-12) << wanted;
        EXPECT_NEAR(t[turns], torque, 1e-12) << wanted;
      }
    }
  }
}

// A brake at rest that pushes in, or makes nothing, is not held: no other is asked for more beside it.
TEST(min_power_torques, ask_nobody_beside_a_brake_that_is_not_held) {
  using V = ph::vector<double, 2>;
  const auto torques = [](double sign, double most) {
    ph::torque_range<double, 2> range;
    range.sign = V(sign, 1);
    range.lower = V(std::min(0.1, most), 0.2);
    range.upper = V(most, 5);
    range.A << 2, -1, -1, 2;
    range.any_at_rest = range.at_rest[0] = range.held[0] = true;
    range.sign_is_lasting.setConstant(true);
    return ph::min_power_torques<double, 2>(V(1, -0.2), 10, range, V(0, 0));
  };
  EXPECT_EQ(torques(1, 0.5), V(0.5, 5)) << "it is held, and the other helps";
  EXPECT_EQ(torques(1, 0), V(0, 0.2)) << "it makes nothing";
  EXPECT_EQ(torques(-1, 3), V(0.1, 0.2)) << "it pushes in";
}

// Brakes that turn in their order, each up to its most; one that is at rest is not asked.
TEST(min_power_torques, ask_brakes_beside_one_that_is_held_in_turn) {
  using V = ph::vector<double, 4>;
  ph::torque_range<double, 4> range;
  range.sign.setOnes();
  range.lower.setZero();
  range.upper = V(0.5, 5, 1, 5);
  range.A.setConstant(-1);
  range.A.diagonal().setConstant(2);  // 0.3 for each N m of the others
  range.any_at_rest = range.at_rest[0] = range.at_rest[1] = range.held[0] = true;
  range.sign_is_lasting.setConstant(true);
  const auto expect = [&](double wanted, const V& torques) {
    const V t = ph::min_power_torques<double, 4>(V(1, -0.2, -0.2, -0.2), wanted, range, V::Zero());
    EXPECT_LE((t - torques).norm(), 1e-12) << wanted;
  };
  expect(0.5 + 0.3 * 0.4, V(0.5, 0, 0.4, 0));
  expect(0.5 + 0.3 * 1.5, V(0.5, 0, 1, 0.5));
  expect(100, V(0.5, 0, 1, 5));
  range.A(0, 3) = range.A(3, 0) = 1;  // the last would pull in
  expect(100, V(0.5, 0, 1, 0));
}

// Two walls that the brakes can serve both: each gets what it wants, also where that is less than nothing.
TEST(min_power_torques, serve_several_walls_together) {
  ph::torque_range<double, 3> range;
  range.sign = {1, -1, 1};
  range.lower.setConstant(0.05);
  range.upper.setConstant(10);
  const ph::matrix<double, 2, 3> rows{{1, 0.5, -1}, {0.2, 1, 0.3}};
  const ph::vector<double, 3> w(1, 1, 1);
  for (const ph::vector<double, 2>& wanted : {ph::vector<double, 2>(2, 1), ph::vector<double, 2>(-1, 2)}) {
    const auto t = ph::min_power_torques<double, 3, 2>(rows, wanted, range, w);
    EXPECT_LE((rows * range.sign.cwiseProduct(t) - wanted).norm(), 1e-9);
    EXPECT_GE(t.minCoeff(), 0.05 - 1e-12);
  }
}

// Of two brakes that push alike the faster costs more power: shares as 1 / p^2, p = |w| and a thousandth of
// the fastest, which tells resting ones apart from none.
TEST(min_power_torques, of_several_walls_are_those_of_least_power) {
  ph::torque_range<double, 2> range;
  range.sign = {1, -1};
  range.lower = {0, 0};
  range.upper = {10, 10};
  const ph::matrix<double, 2, 2> rows = ph::matrix_of<2, 2>(1.0, -1.0, 0.0, 0.0);
  for (const pair& w : {pair(1, 3), pair(-3, 1), pair(2, 0), pair(0, 0)}) {
    const pair t = ph::min_power_torques<double, 2, 2>(rows, pair(4, 0), range, w);
    const double most = w.cwiseAbs().maxCoeff();
    const pair power = w.cwiseAbs().array() + 1e-3 * most;
    const double share = most > 0 ? power[1] * power[1] / power.squaredNorm() : 0.5;
    EXPECT_NEAR(t[0], 4 * share, 1e-8) << w.transpose();
    EXPECT_NEAR(t[1], 4 * (1 - share), 1e-8) << w.transpose();
  }
}

}  // namespace
