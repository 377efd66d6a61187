// slow, optimised
// What a stiff hand feels 50 to 100 ms after brakes began to display 1 N.
#include <experiments/felt_force.hpp>
#include <experiments/rods.hpp>

#include <gtest/gtest.h>

namespace {

namespace felt_forces {

namespace ph = passive_haptics;
using experiments::feel;
using experiments::felt_row;
constexpr std::size_t states = 50;

const auto three = experiments::planar_rods<3>({0.15, 0.15, 0.1});
const auto lower = experiments::with_brakes<0, 1>(three);
const auto four = experiments::planar_rods<4>({0.12, 0.12, 0.1, 0.08});

TEST(felt_force, of_settled_brakes_is_what_was_wanted) {
  const felt_row of_three = feel(three, states), of_lower = feel(lower, states), of_four = feel(four, states);
  for (const felt_row& row : {of_three, of_lower, of_four}) {
    EXPECT_NEAR(row.median, 1, 0.02);
    EXPECT_GE(row.within_share(), 0.85);
    EXPECT_EQ(row.unknown_sign + row.not_at_rest + row.pose, row.displayed - row.within);
  }
  EXPECT_GE(of_three.displayed_share(), 0.85);
  EXPECT_GE(of_lower.displayed_share(), 0.55);
  EXPECT_GE(of_four.displayed_share(), 0.85);
}

}  // namespace felt_forces

}  // namespace
