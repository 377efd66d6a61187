// The passive constraint (3) and the sign rule, case by case, zeros included.
#include "../support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace {

template <class T>
struct brakes : ::testing::Test {};
TYPED_TEST_SUITE(brakes, scalars);

// What one brake makes of td; any rate but 0 is slip, any hand torque counts.
template <class T>
T torque_of_one(T td, T w, T th) {
  using V = ph::vector<T, 1>;
  ph::brake_parameters<T, 1> p;
  p.rate_dead_band.setZero();
  p.torque_dead_band.setZero();
  return ph::passive_torque(V(td), V(w), V(th), p)[0];
}

// (3a): rows are sgn(w) = -1, 0, 1, columns sgn(td) = -1, 0, 1; entries the sign of the torque.
constexpr int slip_table[3][3] = {{0, 0, 1}, {0, 0, 0}, {-1, 0, 0}};

TYPED_TEST(brakes, slipping_brake_follows_3a_for_all_signs) {
  using T = TypeParam;
  for (int w = -1; w <= 1; ++w) {
    for (int td = -1; td <= 1; ++td) {
      for (const T rate : {T(0.01), T(1), T(300)}) {
        for (const T size : {T(0.2), T(7)}) {
          const T expected = static_cast<T>(slip_table[w + 1][td + 1]) * size;
          EXPECT_EQ(torque_of_one(static_cast<T>(td) * size, static_cast<T>(w) * rate, T(0)), expected)
              << "w = " << w << " * " << rate << ", td = " << td << " * " << size;
        }
      }
    }
  }
}

// (3b) with the brake's strength |td| over and under the hand's |th|.
TYPED_TEST(brakes, resting_brake_follows_3b_for_all_signs) {
  using T = TypeParam;
  for (int th = -1; th <= 1; ++th) {
    for (int td = -1; td <= 1; ++td) {
      for (const auto& [hand, strength] : {std::pair{T(0.2), T(7)}, {T(7), T(0.2)}, {T(3), T(3)}}) {
        const bool holds = th * td < 0;
        const T expected = holds ? -static_cast<T>(th) * std::min(hand, strength) : T(0);
        EXPECT_EQ(torque_of_one(static_cast<T>(td) * strength, T(0), static_cast<T>(th) * hand), expected)
            << "th = " << th << " * " << hand << ", td = " << td << " * " << strength;
        // As printed, where the brake is strong enough
        EXPECT_TRUE(!holds || strength < hand || expected == -static_cast<T>(th) * hand);
      }
    }
  }
}

TYPED_TEST(brakes, sign_is_that_of_the_rate_over_the_dead_band_else_that_of_the_hand) {
  using T = TypeParam;
  const T band = T(0.5), floor = T(0.25);
  struct row {
    T w, th, sign;
  };
  for (const row& r : {row{1, 0, 1},
                       {-1, 0, -1},
                       {1, -9, 1},
                       {-1, 9, -1},  // slips: the hand has no say
                       {0, 0, 0},
                       {0, 9, 1},
                       {0, -9, -1},  // at rest
                       {T(0.5), 0, 0},
                       {T(0.5), -9, -1},
                       {T(-0.5), 9, 1},  // on the dead band is at rest
                       {T(0.5001), -9, 1},
                       {T(-0.5001), 9, -1},  // just over it is not
                       {0, T(0.25), 0},
                       {0, T(-0.25), 0},
                       {0, T(0.2501), 1},
                       {0, T(-0.2501), -1}}) {
    EXPECT_EQ(ph::brake_sign(r.w, r.th, band, floor), r.sign) << "w = " << r.w << ", th = " << r.th;
  }
  for (const T least : {std::numeric_limits<T>::denorm_min(), -std::numeric_limits<T>::denorm_min()})
    EXPECT_TRUE(ph::slips(least, T(0))) << "without a dead band any motion is slip";
  EXPECT_FALSE(ph::slips(T(0), T(0)));
}

// Three brakes: one slips, one is pushed at rest, one is left alone.
TYPED_TEST(brakes, each_brake_has_its_own_dead_bands_and_mode) {
  using T = TypeParam;
  using V = ph::vector<T, 3>;
  ph::brake_parameters<T, 3> p;
  p.rate_dead_band = V(T(0.1), T(2), T(2));
  p.torque_dead_band = V(T(0.1), T(0.1), T(5));
  const V w(T(1), T(-1), T(1)), th(T(-3), T(3), T(3));
  EXPECT_EQ(ph::brake_signs(w, th, p), V(1, 1, 0));
  EXPECT_TRUE(ph::any_sticks(w, p));
  EXPECT_FALSE(ph::any_sticks(V(1, -3, 3), p));
  EXPECT_TRUE(ph::any_sticks(V(1, -3, 2), p));
  EXPECT_EQ(ph::passive_torque(V(-7, -7, -7), w, th, p), V(-7, -3, 0));
  EXPECT_EQ(ph::passive_torque(V(7, 7, 7), w, th, p), V(0, 0, 0));
  EXPECT_EQ(ph::passive_torque(V(-2, -2, -2), w, th, p), V(-2, -2, 0));
}

TYPED_TEST(brakes, without_a_member_have_no_limit_and_no_dead_band) {
  using T = TypeParam;
  using V = ph::vector<T, 2>;
  const T unbounded = std::numeric_limits<T>::infinity();
  const ph::unlimited_brakes bare;
  EXPECT_EQ(ph::torque_limit_of<T>(bare, 1), unbounded);
  EXPECT_EQ((ph::torque_limits_of<T, 2>(bare)), V(unbounded, unbounded));
  EXPECT_EQ(ph::rate_dead_band_of<T>(bare, 1), T(0));
  EXPECT_EQ((ph::torque_dead_bands_of<T, 2>(bare)), V(0, 0));
  EXPECT_EQ(ph::brake_signs(V(T(-0.001), 0), V(5, 5), bare), V(-1, 0));
  EXPECT_FALSE(ph::any_sticks(V(0, 0), bare));
  EXPECT_EQ(ph::passive_torque(V(-7, -7), V(1, 0), V(9, 9), bare), V(-7, 0));
  ph::brake_parameters<T, 2> p;
  p.torque_limit = V(2, 3);
  p.rate_dead_band = V(4, 5);
  p.torque_dead_band = V(6, 7);
  EXPECT_EQ(ph::torque_limit_of<T>(p, 1), T(3));
  EXPECT_EQ((ph::torque_limits_of<T, 2>(p)), V(2, 3));
  EXPECT_EQ(ph::rate_dead_band_of<T>(p, 1), T(5));
  EXPECT_EQ((ph::torque_dead_bands_of<T, 2>(p)), V(6, 7));
}

// The text of each member that is wrong, the first of them if several are.
TYPED_TEST(brakes, say_what_is_wrong_with_them) {
  using T = TypeParam;
  ph::brake_parameters<T, 2> p;
  EXPECT_EQ(ph::check_brakes(p), "");
  p.time_constant[1] = T(-1);
  EXPECT_EQ(ph::check_brakes(p), "time_constant[1] [s] = -1: expected a finite number >= 0");
  p.torque_dead_band[0] = T(-2);
  EXPECT_EQ(ph::check_brakes(p), "torque_dead_band[0] [N m] = -2: expected a finite number >= 0");
  p.rate_dead_band[1] = T(-3);
  EXPECT_EQ(ph::check_brakes(p), "rate_dead_band[1] [rad/s] = -3: expected a finite number >= 0");
  p.torque_limit[0] = T(-4);
  EXPECT_EQ(ph::check_brakes(p), "torque_limit[0] [N m] = -4: expected a finite number >= 0");
}

}  // namespace
