// slow
// Effects in a controller of a simulated device against closed forms. (The property suite of effects has all
// of them on all devices, without a force sensor.)
#include "../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/pipelines/with_effects.hpp>
#include <passive_haptics/force/effects/detents.hpp>
#include <passive_haptics/force/effects/end_stops.hpp>
#include <passive_haptics/force/effects/rough_walls.hpp>
#include <passive_haptics/force/effects/viscous_field.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/plant/simulated_device.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <cmath>
#include <numbers>

namespace {

using table = ph::xy_table<double>;
using vector = ph::vector<double, 2>;

constexpr double mass = 1.0;  // of each axis with the hand [kg]
constexpr double cycle_period = 1e-3, time_step = 1e-4;

ph::brakes_of<table> quick_brakes() {
  ph::brakes_of<table> brakes;
  brakes.torque_limit.setConstant(30);
  brakes.rate_dead_band.setConstant(1e-3);
  brakes.time_constant.setConstant(1e-3);
  return brakes;
}

ph::viscous_field<double, 2> honey(double viscosity) {
  return ph::viscous_field<double, 2>({.viscosity = viscosity * ph::matrix<double, 2, 2>::Identity()});
}

// A table under a scene with effects, moved by a hand.
template <class Scene>
struct experiment {
  ph::simulated_device<table> device;
  ph::controller<table, Scene, ph::direct_control> control;
  double time = 0;

  experiment(const Scene& scene, const vector& x, const vector& v = {0, 0})
      : device(table(), quick_brakes(), 0.5, x), control(table(), quick_brakes(), scene, {}) {
    device.set_motion(x, v);
  }

  // Pushes with a force [N] for a time [s].
  void push(const vector& force, double seconds) {
    const int cycles = static_cast<int>(std::lround(seconds / cycle_period));
    for (int k = 0; k < cycles; ++k) {
      const auto told = control(ph::device_state<table>{time, device.q(), device.qd(), force});
      ASSERT_EQ(told.outcome, ph::status::ok);
      for (int i = 0; i < 10; ++i) device.advance(time_step, told.capacity, force);
      time += cycle_period;
    }
    EXPECT_LE(device.energy().max_brake_power, 1e-12);
  }
};

const ph::no_walls<2> nothing;

TEST(in_honey, a_simulated_device_slows_down_as_the_field_says) {
  experiment device(ph::with_effects(nothing, honey(4)), {0, 0}, {0.3, -0.2});
  const double half_life = std::log(2.0) * mass / 4;  // of m v' = -B v
  device.push({0, 0}, half_life);
  expect_near(device.device.velocity(), vector(0.15, -0.1), 0.15, 0.01 / 2.2e-16);
}

TEST(a_detent, holds_a_simulated_device_up_to_its_strength) {
  const ph::detents<double, 2> knob({.spacing = 0.02, .strength = 4});
  const auto way = [&](double push) {
    experiment device(ph::with_effects(nothing, knob), {0, 0});
    device.push({push, 0}, 0.5);
    return device.device.position().x();
  };
  const double balance = 0.02 / (2 * std::numbers::pi) * std::asin(2.0 / 4);
  EXPECT_GE(way(2), 0.99 * balance);
  EXPECT_LE(way(2), 0.5 * 0.02) << "held before the next detent";
  EXPECT_GE(way(6), 0.1) << "from detent to detent";
}

TEST(end_stops, stop_a_simulated_device_and_let_it_back) {
  const ph::end_stops<double, 2> stops(
      {.upper = {0.05, 1}, .stiffness = {2000, 2000}, .rate_dead_band = {1e-3, 1e-3}});
  experiment device(ph::with_effects(nothing, stops), {0, 0});
  device.push({4, 0}, 1.0);
  const double held = device.device.position().x();
  // It arrives with the work of the push, which the stop takes: k way^2 / 2 = push (0.05 + way)
  const double way = (4 + std::sqrt(16 + 2 * 2000 * 4 * 0.05)) / 2000;
  EXPECT_NEAR(held, 0.05 + way, 2e-3) << "2 ms at 0.6 m/s, for lag and cycle";
  EXPECT_NEAR(device.device.velocity().x(), 0, 1e-6);
  device.push({-4, 0}, 0.1);  // free on the way back
  EXPECT_NEAR(device.device.position().x(), held - 0.5 * 4 / mass * 0.01, 1e-3);
}

TEST(wall_friction, holds_and_slows_a_simulated_device_that_the_wall_carries) {
  const auto floor = ph::scene(ph::wall(ph::half_space<2>({0, 0}, {0, 1}), 1e4));
  const ph::rough_walls<double, 2> rough({.coefficient = 0.5});
  const auto slid = [&](const auto& scene, double push) {
    experiment device(scene, {0, -1e-3});
    device.push({push, -8}, 0.5);
    EXPECT_LE(std::abs(device.device.position().y() + 1e-3), 1e-3) << "the wall holds it";
    return device.device.position().x();
  };
  EXPECT_LE(slid(ph::with_effects(floor, rough), 3), 1e-4);
  EXPECT_NEAR(slid(ph::with_effects(floor, rough), 6), 0.5 * (6 - 0.5 * 8) / mass * 0.25, 0.02 * 0.25);
  EXPECT_NEAR(slid(floor, 3), 0.5 * 3 / mass * 0.25, 1e-3) << "smooth";
}

}  // namespace
