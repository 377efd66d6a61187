// Forces by their power and by each brake. Their words: core/enumerations.cpp.
#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/force/classification.hpp>

#include <gtest/gtest.h>

namespace ph = passive_haptics;

namespace {

using torques = ph::vector<double, 3>;

TEST(classification, asks_for_total_power_first) {
  using ph::power_class;
  for (const bool producible : {false, true})
    EXPECT_EQ(ph::classify_power(1e-300, producible), power_class::active);
  for (const double power : {0.0, -2.0}) {
    EXPECT_EQ(ph::classify_power(power, true), power_class::passive_1);
    EXPECT_EQ(ph::classify_power(power, false), power_class::passive_2);
  }
}

TEST(classification, a_force_is_producible_if_no_brake_has_to_drive) {
  for (int s = -1; s <= 1; ++s) {
    for (int t = -1; t <= 1; ++t) {
      EXPECT_EQ(ph::producible(torques(s, 1, 0), torques(t, -1, 5)), s * t <= 0) << s << t;
      EXPECT_FALSE(ph::producible(torques(s, 1, 0), torques(t, 1e-300, 0))) << s << t;
    }
  }
}

TEST(classification, power_of_torques_is_that_of_their_force) {
  EXPECT_EQ(ph::mechanical_power(torques(1, 2, 3), torques(4, -5, 6)), 12);
  const ph::matrix<double, 2, 2> E{{1, 2}, {-3, 0.5}};
  const ph::vector<double, 2> F(0.25, -4), w(2, -1);
  EXPECT_EQ(ph::mechanical_power(ph::brake_torque(E, F), w), F.dot(E * w));
}

TEST(classification, none_is_not_displayed) {
  EXPECT_TRUE(is_displayed(ph::display_class::exact) && is_displayed(ph::display_class::approximate));
  EXPECT_FALSE(is_displayed(ph::display_class::none));
}

}  // namespace
