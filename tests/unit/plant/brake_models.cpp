// optimised
// A simulated device with brakes of each model: first order, passive, and a wall to follow.
#include "../support.hpp"

#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/brakes/any_brake.hpp>
#include <passive_haptics/plant/brakes/compensated_brake.hpp>
#include <passive_haptics/plant/brakes/delayed_brake.hpp>
#include <passive_haptics/plant/brakes/eddy_current_brake.hpp>
#include <passive_haptics/plant/brakes/presliding_brake.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace {

using M = ph::xy_table<double>;
using pair = ph::vector<double, 2>;

// That of the model, or of the one inside.
template <class Model>
ph::brake_resistance<double>& residual_in(Model& model) {
  if constexpr (requires { model.model; }) return model.model.residual;
  else return model.residual;
}

template <class Model>
struct simulated_model : ::testing::Test {
  // Where the handle is after 0.5 s under a push that swings and commands that change in steps
  static ph::simulated_device<M, Model> run(double dt) {
    Model strong;
    residual_in(strong) = {0.05, 0.1};
    ph::simulated_device device(M(), ph::brake_models_of<M, Model>{strong, strong}, 0.3, {0, 0});
    const long steps = std::lround(0.5 / dt);
    for (long k = 0; k < steps; ++k) {
      const double t = static_cast<double>(k) * dt, phase = std::floor(t / 0.02);
      const pair capacity = pair::Constant(0.25 + 0.2 * std::sin(3 * phase));
      device.advance(dt, capacity, {1.2 * std::sin(9 * t), 0.5 + 0.4 * std::cos(14 * t)});
    }
    return device;
  }
};

using models = tested_types<ph::coulomb_brake<double>, ph::eddy_current_brake<double>,
                            ph::delayed_brake<ph::coulomb_brake<double>>>;
TYPED_TEST_SUITE(simulated_model, models);

TYPED_TEST(simulated_model, is_of_first_order_in_the_time_step) {
  const pair whole = this->run(1e-4).position(), half = this->run(5e-5).position(),
             exact = this->run(1e-4 / 32).position();
  const double error = (whole - exact).norm(), half_error = (half - exact).norm();
  EXPECT_LE(half_error, 0.55 * error);
  EXPECT_LE(error, 1e-3 * exact.norm());
}

TYPED_TEST(simulated_model, only_takes_energy) {
  const auto device = this->run(1e-4);
  const ph::energy_balance& energy = device.energy();
  EXPECT_LE(energy.max_brake_power, 1e-15);
  EXPECT_GT(energy.brakes, 1e-4);
  EXPECT_GT(energy.residual_friction, 0);
  EXPECT_GT(energy.drag, 0);
  EXPECT_LE(std::abs(energy.imbalance()), 1e-12) << "its mass matrix is constant";
}

// A spring in series with friction: it turns by compliance times torque, swings there without loss, slips at
// its strength and keeps the rest of its twist.
TEST(simulated_presliding, is_a_spring_that_slips_at_its_strength) {
  using model = ph::presliding_brake<ph::coulomb_brake<double>>;
  model brake;
  brake.model = {.torque_limit = 10, .time_constant = 0};
  brake.presliding = 2e-3;
  EXPECT_DOUBLE_EQ(brake.compliance(), 2e-4);
  ph::simulated_device device(M(), ph::brake_models_of<M, model>{brake, brake}, 0.5, {0, 0});
  const auto run = [&](double force, double time, double dt) {
    double most = 0, sum = 0;
    const long steps = std::lround(time / dt);
    for (long k = 0; k < steps; ++k) {
      device.advance(dt, {10, 10}, {force, 0});
      most = std::max(most, device.q()[0]);
      sum += device.q()[0];
    }
    return std::pair(most, sum / static_cast<double>(steps));
  };
  const double dt = 1e-6;
  const auto [most, mean] = run(4, 0.1777, dt);  // two periods
  EXPECT_NEAR(mean, 4 * brake.compliance(), 0.05 * mean) << "about where it balances the hand";
  EXPECT_NEAR(most, 8 * brake.compliance(), 0.02 * most) << "twice as far, as an undamped spring";
  EXPECT_LE(std::abs(device.energy().imbalance()), 1e-12);
  EXPECT_GT(device.energy().max_brake_power, 0) << "it gives back";

  device.set_motion({0, 0}, {0, 0});
  run(20, 0.05, dt);
  const double slipped = device.q()[0];
  EXPECT_GT(slipped, 5 * brake.presliding) << "it slips";
  EXPECT_NEAR(device.brake_torque()[0], -10, 1e-9);
  device.set_motion({0, 0}, {0, 0});
  device.advance(dt, {10, 10}, {0, 0});
  EXPECT_EQ(device.brake_torque()[0], 0) << "a new motion begins without twist";
}

TEST(simulated_presliding, of_nothing_is_the_brake_itself) {
  using model = ph::presliding_brake<ph::coulomb_brake<double>>;
  const ph::coulomb_brake<double> plain{.residual = {0.05, 0.1}};
  model stiff;
  stiff.model = plain;
  stiff.presliding = 0;
  ph::simulated_device one(M(), ph::brake_models_of<M>{plain, plain}, 0.3, {0, 0});
  ph::simulated_device other(M(), ph::brake_models_of<M, model>{stiff, stiff}, 0.3, {0, 0});
  for (int k = 0; k < 1000; ++k) {
    const pair capacity = pair::Constant(0.5 + 0.4 * std::sin(1e-2 * k)), force(std::sin(3e-3 * k), 0.7);
    one.advance(1e-4, capacity, force);
    other.advance(1e-4, capacity, force);
    ASSERT_EQ(one.q(), other.q()) << k;
  }
  stiff.model.torque_limit = 0;
  stiff.presliding = 0.01;
  EXPECT_EQ(stiff.compliance(), 0);
}

TEST(simulated_presliding, is_kept_by_what_holds_a_model) {
  using model = ph::presliding_brake<ph::coulomb_brake<double>>;
  const model brake;
  EXPECT_GT(brake.compliance(), 0);
  EXPECT_EQ(ph::compliance_of(ph::coulomb_brake<double>()), 0);
  ph::delayed_brake<model> late;
  EXPECT_EQ(ph::compliance_of(late), brake.compliance());
  ph::compensated_brake<model> inverted;
  EXPECT_EQ(ph::compliance_of(inverted), brake.compliance());
  const ph::any_brake<ph::coulomb_brake<double>, model> any = brake;
  EXPECT_EQ(ph::compliance_of(any), brake.compliance());
  const ph::presliding_brake<model> two_springs{brake, brake.presliding};
  EXPECT_EQ(ph::compliance_of(two_springs), 2 * brake.compliance());
}

// m dv/dt = -c v with c of the command: commanded drag is the brakes' work and their torque.
TEST(simulated_eddy_currents, slow_down_as_drag_does_and_hold_nothing) {
  using model = ph::eddy_current_brake<double>;
  const model brake{.peak_torque = 10, .critical_rate = 1e6, .time_constant = 0};
  ph::simulated_device device(M(), ph::brake_models_of<M, model>{brake, brake}, 0.0, {0, 0});
  device.set_motion({0, 0}, {1, 0});
  const double drag = 2 * 10 / 1e6, dt = 1e-3;
  for (int k = 1; k <= 1000; ++k) {
    device.advance(dt, {10, 10}, {0, 0});
    ASSERT_NEAR(device.qd()[0], std::pow(1 + drag / 0.5 * dt, -k), 1e-12);
    ASSERT_NEAR(device.brake_torque()[0], -drag * device.qd()[0], 1e-15);
  }
  EXPECT_NEAR(device.energy().brakes, (1 - device.qd()[0] * device.qd()[0]) / 4, 1e-12);
  EXPECT_EQ(device.energy().drag, 0);
  EXPECT_TRUE(device.brake_strength().isZero(0));
  device.set_motion({0, 0}, {0, 0});
  device.advance(dt, {10, 10}, {0.001, 0});
  EXPECT_GT(device.qd()[0], 0) << "nothing sticks";
}

}  // namespace
