// The model of brakes that lag, and its inverse.
#include <passive_haptics/control/laws/velocity/brake_lag.hpp>
#include <passive_haptics/core/scalar/first_order_lag.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

namespace {

namespace ph = passive_haptics;
using pair = ph::vector<double, 2>;

TEST(brake_lag_model, follows_a_first_order_lag_and_inverts_it) {
  constexpr unsigned seed = 5;
  ph::testing::random_source random(seed);
  const pair lag(0.02, 0.005);
  ph::brake_lag_model model;
  ph::first_order_lag<double, 2> brake(lag);
  const double period = 1e-3, horizon = 5e-3;
  for (int k = 0; k < 1000; ++k) {
    model.advance(k * period, lag);
    pair u;
    for (int i = 0; i < 2; ++i)
      u[i] = model.command(i, random.uniform(0.0, 1.0), 1.0, ph::lag_share(horizon, lag[i]));
    ASSERT_TRUE((u.array() >= 0).all() && (u.array() <= 1).all());
    brake.advance(period, u);
  }
  // From rest and unlimited, the brake has the wanted torque a horizon later
  ph::brake_lag_model fresh;
  const double share = ph::lag_share(horizon, lag[0]);
  fresh.advance(0, lag);
  const double u = fresh.command(0, 0.3, 100.0, share);
  ph::first_order_lag<double, 1> one(ph::vector<double, 1>::Constant(lag[0]));
  EXPECT_NEAR(one.advance(horizon, ph::vector<double, 1>::Constant(u))[0], 0.3, 1e-14);
  // The model knows: asked for the same a horizon later, it commands just that
  fresh.advance(horizon, lag);
  EXPECT_NEAR(fresh.command(0, 0.3, 100.0, share), 0.3, 1e-14);
  EXPECT_EQ(fresh.command(1, 0.3, 100.0), 0.3) << "no lag, nothing to invert";
  EXPECT_EQ(fresh.command(0, 5.0, 0.4, share), 0.4) << "its limit";
  const double before = fresh.torque(0);
  fresh.advance(0, lag);
  EXPECT_EQ(fresh.torque(0), before) << "time runs backwards";
}

}  // namespace
