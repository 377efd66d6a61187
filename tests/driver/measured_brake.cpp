// slow, optimised, together
// From a bench to the law: what the tests of a brake found makes a controller whose hand glides along a wall.
#include "bench_samples.hpp"

#include <passive_haptics/bench/measured_brake.hpp>
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/recommended_law.hpp>
#include <passive_haptics/driver/rate_estimator.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/plant/brakes/delayed_brake.hpp>
#include <passive_haptics/plant/brakes/magnetorheological_brake.hpp>
#include <passive_haptics/plant/wall_following.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <functional>
#include <string>

namespace measured_brake_tests {

using namespace bench_samples;
using device = ph::tendon_two_link<double>;

constexpr double greatest = 0.5, pause = 0.5, ramp_time = 5;  // [A, s, s]
const double count = ph::encoder_parameters().resolution, dead_band = ph::rate_dead_band(count, 16, 1e-3);
const ph::half_space<2> wall({0, 0.225}, {0, -1});

double steady(double) { return 2; }                    // [rad/s]
double line(double current) { return 1.6 * current; }  // [N m]
double step_up(double t) { return t < pause ? 0 : greatest; }
double step_down(double t) { return t < pause ? greatest : 0; }
double ramp(double t) {
  return greatest / ramp_time * std::clamp(std::min(t - pause, 2 * (pause + ramp_time) - t), 0.0, ramp_time);
}

// The three records of a brake.
struct records {
  samples up, down, ramp;
};
template <class Model>
records record_all(const Model& brake, const function& torque_of) {
  const auto of = [&](const function& current_at, double duration) {
    return record(brake, torque_of, steady, current_at, duration, {.resolution = count});
  };
  return {of(step_up, 3 * pause), of(step_down, 3 * pause), of(ramp, 2 * (pause + ramp_time) + pause)};
}
ph::measured_brake measured(const records& all) {
  const auto up = ph::fit_step_response(all.up), down = ph::fit_step_response(all.down);
  const ph::ramp_delay delay{up.time_constant.value + up.dead_time.value,
                             down.time_constant.value + down.dead_time.value};
  return ph::measured_brake_of(up, down, ph::fit_current_ramp(all.ramp, delay), dead_band);
}

// A hand along the wall, at a device with two such brakes behind currents and their calibration.
template <class Model>
ph::contact_metrics along_the_wall(const Model& brake, const function& torque_of,
                                   const ph::measured_brake& found, bool by_default = false) {
  const auto brakes = by_default ? ph::brakes_of<device>() : ph::measured_brakes<device>({found, found});
  const device arm;
  const auto start = arm.inverse({0.045, 0.221}, ph::elbow::left).q;
  const ph::following_hand<double, 2> hand({1, 0}, arm.position(start));
  ph::simulated_device<device, Model> plant(arm, ph::brake_models_of<device, Model>{brake, brake},
                                            hand.parameters().mass, start);
  plant.set_motion(start, arm.jacobian(start).inverse() * ph::vector<double, 2>(0.05, 0.1));
  ph::controller control(arm, brakes, ph::scene(ph::wall(wall)), ph::recommended_law(arm, brakes));
  ph::brake_calibration<2> calibration({found.ramp.curve(), found.ramp.curve()});
  const auto loop = [&](const ph::device_state<device>& state) {
    auto result = control(state);
    const auto currents = calibration.currents(result.capacity);
    result.capacity = {torque_of(currents[0]), torque_of(currents[1])};
    return result;
  };
  return ph::follow_wall(plant, loop, wall, hand, {});
}

void expect_gliding(const ph::contact_metrics& figures) {
  EXPECT_EQ(figures.separations, 0);
  EXPECT_TRUE(figures.arrived);
  EXPECT_GT(figures.depth_mean, 0.5e-3) << "it is in contact";
  EXPECT_LT(figures.max_depth, 3e-3) << "and held";
}

ph::coulomb_brake<double> slow_brake() {
  return {.time_constant = 0.060, .fall_ratio = 1.5, .residual = {.strength = 0.02}};
}

TEST(a_bench, fills_what_a_controller_a_driver_and_a_simulation_take) {
  const ph::coulomb_brake<double> brake = slow_brake();
  const auto found = measured(record_all(brake, line));
  const auto brakes = ph::measured_brakes<device>({found, found});
  const auto curves = ph::measured_curves(ph::measured_brakes_of<device>{found, found});
  const ph::coulomb_brake<double> simulated = ph::simulated_brake(found);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(brakes.torque_limit[i], 0.82, 0.005);
    EXPECT_NEAR(brakes.time_constant[i], 0.060, 0.001) << "that of the rise";
    EXPECT_EQ(brakes.rate_dead_band[i], dead_band);
    const ph::brake_curve& curve = curves[static_cast<std::size_t>(i)];
    EXPECT_EQ(brakes.torque_limit[i], torque_of_current(curve, curve.current_limit))
        << "as brake_driver computes it from its configuration";
  }
  EXPECT_EQ(brakes.torque_dead_band, ph::brakes_of<device>().torque_dead_band);
  EXPECT_NEAR(simulated.torque_limit, 0.8, 0.005);
  EXPECT_NEAR(simulated.time_constant, brake.time_constant, 0.001);
  EXPECT_NEAR(simulated.fall_ratio, brake.fall_ratio, 0.03);
  EXPECT_NEAR(simulated.residual.strength, brake.residual.strength, 0.001);
  EXPECT_EQ(simulated.gain, 1);
  EXPECT_EQ(validate(simulated), "");
}

TEST(a_bench, leads_to_a_hand_that_glides_along_a_wall) {
  ph::delayed_brake<ph::coulomb_brake<double>> late;
  late.model = {.fall_ratio = 2.5, .residual = {.strength = 0.02, .drag = 0.001}};
  expect_gliding(along_the_wall(late, line, measured(record_all(late, line))));
}

TEST(a_bench, leads_to_a_hand_that_glides_with_a_brake_that_has_hysteresis) {
  ph::magnetorheological_brake<double> brake;
  brake.residual.strength = 0.02;
  const auto torque_of = [&](double current) { return brake.torque_of(current / greatest); };
  const auto all = record_all(brake, torque_of);
  const auto found =
      ph::measured_brake_of(ph::fit_magnetorheological_brake(all.up, all.down, all.ramp), dead_band);
  EXPECT_NEAR(found.time_constant.value, brake.time_constant, 0.001) << "of the coil, not of the torque";
  expect_gliding(along_the_wall(brake, torque_of, found));
}

// A weak and quick brake, of which the defaults say five times the limit and four times the lag: the law
// learns what it needs, so that the hand glides with the bench's values and with the defaults.
TEST(a_bench, leads_to_a_hand_that_glides_with_a_weak_and_quick_brake) {
  ph::delayed_brake<ph::coulomb_brake<double>> brake{.dead_time = 0};
  brake.model = {.time_constant = 0.005, .residual = {.strength = 0.02}};
  const auto torque_of = [](double current) { return 0.2 * current; };
  const ph::measured_brake found = measured(record_all(brake, torque_of));
  for (const bool by_default : {false, true})
    expect_gliding(along_the_wall(brake, torque_of, found, by_default));
}

// ---- what is refused

std::string error_of(const std::function<void(ph::measured_brake&)>& spoil) {
  const ph::measured_brake good{{0.02, 1e-4}, {0.03, 1e-4}, measured_ramp(), 0.05};
  ph::measured_brakes_of<device> found{good, good};
  spoil(found[1]);
  const std::string error = thrown_by([&] { ph::measured_brakes<device>(found); });
  if (error == "nothing") return error;
  EXPECT_THROW(ph::measured_curves(found), std::invalid_argument);
  EXPECT_THROW(ph::simulated_brake(found[1]), std::invalid_argument);
  EXPECT_TRUE(error.starts_with("brakes[1].")) << error;
  return error.substr(10);
}

TEST(a_bench, whose_results_are_missing_or_cannot_be_is_refused_with_what_to_do) {
  using results = ph::measured_brake;
  EXPECT_EQ(error_of([](results&) {}), "nothing");
  EXPECT_EQ(error_of([](results& r) { r = {}; }),
            "time_constant [s] = 0: expected a finite number > 0: record a larger step up, and pass its "
            "fit_step_response");
  EXPECT_EQ(error_of([](results& r) { r.time_constant.standard_error = INFINITY; }),
            "time_constant [s].standard_error = inf: expected less than the value: record a larger step up, "
            "and pass its fit_step_response");
  EXPECT_EQ(error_of([](results& r) { r.fall_time_constant.value = NAN; }),
            "fall_time_constant [s] = nan: expected a finite number > 0: record a larger step down, and pass "
            "its fit_step_response");
  EXPECT_EQ(error_of([](results& r) { r.fall_time_constant.value = 30; }),
            "fall_time_constant [s] = 30: expected at most 5: pass the times of the samples in seconds, not "
            "milliseconds");
  EXPECT_EQ(error_of([](results& r) { r.ramp.residual_torque.value = -0.1; }),
            "ramp.residual_torque [N m] = -0.1: expected >= 0: set torque_at_zero of the bench while no load "
            "acts");
  EXPECT_EQ(error_of([](results& r) { r.rate_dead_band = results().rate_dead_band; }),
            "rate_dead_band [rad/s] = nan: expected a finite number > 0: pass "
            "rate_dead_band(resolution, window, period) of its encoder");
}

TEST(a_bench, whose_steps_are_mixed_up_is_refused) {
  ph::step_response up, down;
  up.change = {0.8, 1e-3};
  up.time_constant = {0.02, 1e-4};
  down = up;
  down.change.value = -0.8;
  const auto error = [](const auto& first, const auto& second) {
    return thrown_by([&] { ph::measured_brake_of(first, second, measured_ramp(), 0.05); });
  };
  EXPECT_EQ(error(up, down), "nothing");
  EXPECT_EQ(error(down, up),
            "up.change [N m] = -0.8: expected > 0: pass the step up first, then the step down");
  EXPECT_EQ(error(up, up),
            "down.change [N m] = 0.8: expected < 0: pass the step up first, then the step down");
}

}  // namespace measured_brake_tests
