// slow, optimised
// What a stiff hand feels 50 to 100 ms after brakes began to display 1 N.
#include <experiments/felt_force.hpp>
#include <experiments/rods.hpp>

#include <gtest/gtest.h>

namespace {

TEST(felt_force, of_settled_brakes_is_what_was_wanted) {
  const auto row = experiments::feel(experiments::planar_rods<3>({0.15, 0.15, 0.1}), 50);
  EXPECT_NEAR(row.median, 1, 0.02);
  EXPECT_GE(row.within_share(), 0.85);
  EXPECT_GE(row.displayed_share(), 0.85);
  EXPECT_EQ(row.unknown_sign + row.not_at_rest + row.pose, row.displayed - row.within);
}

}  // namespace
