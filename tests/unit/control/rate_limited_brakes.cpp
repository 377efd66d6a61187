// A cycle whose brakes give less at some rates.
#include "../support.hpp"

#include <passive_haptics/brake/models/rate_limited_brakes.hpp>
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/brakes/eddy_current_brake.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/testing/support/random.hpp>

namespace {

template <class M>
using eddy_brakes = ph::rate_limited_brakes<M, ph::eddy_current_brake<double>>;

// The same cycle as with brakes that have these limits.
TEST(rate_limited_cycle, is_that_of_the_limits_of_the_moment) {
  using M = ph::tendon_two_link<double>;
  const M arm;
  const eddy_brakes<M> brakes;
  const auto wall = ph::scene(ph::wall(ph::half_space<2>({0, 10}, {0.6, 0.8})));
  ph::testing::random_source random(20040627);
  int working = 0;
  for (int k = 0; k < 200; ++k) {
    auto state = state_of<M>(random.direction<double, 2>(), 0.5 * random.direction<double, 2>(), {1, -2});
    if (k % 5 == 0) state.qd[k % 2] = 0;
    const ph::vector<double, 2> w = ph::brake_rates(arm, state.q, state.qd);
    ph::controller limited(arm, brakes, wall, ph::velocity_direct_control()), commands = limited;
    ph::controller by_hand(arm, brakes.at(w), wall, ph::velocity_direct_control());
    const auto result = limited(state), same = by_hand(state);
    ASSERT_EQ(result.outcome, same.outcome);
    ASSERT_EQ(result.capacity, same.capacity);
    ASSERT_EQ(result.torque, same.torque);
    ASSERT_EQ(commands.command(state).capacity, same.capacity);
    working += !result.capacity.isZero(0);
    for (int i = 0; i < 2; ++i)
      ASSERT_LE(result.capacity[i], brakes.models[0].torque_limit_at(w[i])) << "brake " << i;
  }
  EXPECT_GT(working, 20);
}

TEST(rate_limited, limits_are_those_of_the_models_and_of_the_brakes) {
  eddy_brakes<ph::xy_table<double>> brakes;
  brakes.torque_limit.setConstant(1);
  const auto now = brakes.at({0, 100}), slow = brakes.at({-1, 1});
  EXPECT_EQ(now.torque_limit[0], 0) << "eddy currents do not hold at rest";
  EXPECT_EQ(now.torque_limit[1], 1);
  EXPECT_EQ(slow.torque_limit[0], slow.torque_limit[1]);
  EXPECT_EQ(now.time_constant, brakes.time_constant);
}

}  // namespace
