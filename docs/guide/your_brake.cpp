#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/wall_following.hpp>
#include <passive_haptics/testing/brake_model_properties.hpp>

#include <algorithm>

namespace ph = passive_haptics;

// A disc pressed by air: the pressure changes at most so fast, the friction follows it.
struct air_brake {
  using scalar = double;
  double torque_limit = 2;  // at full pressure [N m]
  double filling = 50;      // of an open valve [N m/s]

  struct state {
    double torque = 0;  // [N m]
  };

  ph::brake_resistance<double> advance(double dt, double command, double, state& now) const noexcept {
    const double desired = ph::valid_command(command, torque_limit);
    const double step = filling * ph::valid_time_step(dt);
    now.torque = std::clamp(desired, now.torque - step, now.torque + step);
    return {.strength = now.torque};
  }
  double torque_limit_at(double) const noexcept { return torque_limit; }
};

// Its simulation
struct air_brake_case {
  using model = air_brake;
  static air_brake make() { return {}; }
};

namespace passive_haptics::testing {
INSTANTIATE_TYPED_TEST_SUITE_P(air, brake_model_properties, air_brake_case);
}

// A device with two of them, along a wall
TEST(air_brakes, hold_a_hand_at_a_wall) {
  using device = ph::tendon_two_link<double>;
  const device arm;
  const ph::half_space<2> wall({0, 0.225}, {0, -1});
  const auto q = arm.inverse({0.06, 0.224}, ph::elbow::left).q;
  const ph::following_hand<double, 2> hand({1, 0}, arm.position(q));
  ph::simulated_device simulated(arm, ph::brake_models_of<device, air_brake>{}, hand.parameters().mass, q);

  ph::brakes_of<device> brakes;  // the data sheet for the controller
  brakes.torque_limit.setConstant(air_brake().torque_limit);
  brakes.time_constant.setConstant(0.01);
  ph::controller control(arm, brakes, ph::scene(ph::wall(wall)), ph::velocity_direct_control());
  const auto figures = ph::follow_wall(simulated, control, wall, hand, {.path_end = 0.1});
  EXPECT_TRUE(figures.arrived);
  EXPECT_LT(figures.max_depth, 0.003);
}
