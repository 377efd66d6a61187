// Each brake model against its closed form. What all models owe: tests/property/brake_models.cpp.
#include "../support.hpp"

#include <passive_haptics/plant/brakes/any_brake.hpp>
#include <passive_haptics/plant/brakes/compensated_brake.hpp>
#include <passive_haptics/plant/brakes/coulomb_brake.hpp>
#include <passive_haptics/plant/brakes/delayed_brake.hpp>
#include <passive_haptics/plant/brakes/eddy_current_brake.hpp>
#include <passive_haptics/plant/brakes/magnetorheological_brake.hpp>
#include <passive_haptics/plant/brakes/presliding_brake.hpp>
#include <passive_haptics/plant/brakes/stribeck_brake.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace {

constexpr double long_enough = 10;  // [s]

// What a brake resists with at this rate once the command has been held.
template <class B>
double settled(const B& brake, double command, double rate, typename B::state& state) {
  const auto r = brake.advance(long_enough, command, rate, state);
  return r.strength + r.drag * std::abs(rate);
}
template <class B>
double settled(const B& brake, double command, double rate) {
  typename B::state fresh;
  return settled(brake, command, rate, fresh);
}

// The figures of its data sheet.
TEST(magnetic_particle_brake, rises_to_its_rated_torque) {
  const auto brake = ph::magnetic_particle_brake<double>();
  ph::coulomb_brake<double>::state state;
  EXPECT_NEAR(brake.advance(0.22, 99, 0, state).strength, 7.5 * (1 - 1 / std::numbers::e), 1e-14);
  EXPECT_NEAR(settled(brake, 99, 0, state), 7.5, 1e-14);
  EXPECT_EQ(brake.residual.strength, 0.09);
}

TEST(coulomb_brake, rises_and_falls_with_lags_of_its_own) {
  const ph::coulomb_brake<double> brake{
      .torque_limit = 2, .time_constant = 0.1, .fall_ratio = 3, .gain = 0.8};
  ph::coulomb_brake<double>::state state;
  EXPECT_NEAR(brake.advance(0.05, 1.5, 9, state).strength, 1.2 * (1 - std::exp(-0.5)), 1e-15);
  const double before = state.strength;
  const auto falling = brake.advance(0.06, 0.25, -9, state);
  EXPECT_NEAR(falling.strength, 0.2 + (before - 0.2) * std::exp(-0.2), 1e-15);
  EXPECT_EQ(falling.drag, 0);
  EXPECT_NEAR(settled(brake, 99, 0, state), 2, 1e-14);
  EXPECT_EQ(brake.torque_limit_at(5), 2);
  EXPECT_EQ(brake.command_for(1, 5, {}), 1.25);
  EXPECT_EQ(brake.command_for(99, 5, {}), 2.5);
  EXPECT_EQ(brake.command_for(-1, 5, {}), 0);
  for (const double none : {-1.0, -HUGE_VAL, std::nan("")})
    EXPECT_NEAR(settled(brake, none, 0, state), 0, 1e-14);
}

TEST(stribeck_brake, is_strongest_at_rest) {
  const ph::stribeck_brake<double> brake;
  EXPECT_NEAR(settled(brake, 0.4, 0), 0.6, 1e-15);
  EXPECT_NEAR(settled(brake, 0.4, -0.05), 0.4 * (1 + 0.5 / std::numbers::e), 1e-15);
  EXPECT_NEAR(settled(brake, 0.4, 1), 0.4, 1e-15);
  EXPECT_NEAR(settled(brake, 99, 0), 1.5, 1e-15);
  EXPECT_NEAR(settled(brake, brake.command_for(0.6, 0.03, {}), 0.03), 0.6, 1e-15);
}

// Their curve at a gap of 3 mm: rpm and N m.
TEST(eddy_current_brake, follows_lubin_and_rezzoug_to_twice_the_critical_rate) {
  constexpr double curve[][2] = {{15, 0.88590},   {150, 8.6346},   {300, 16.0419},
                                 {600, 25.0508},  {975, 27.7643},  {1200, 27.2209},
                                 {1500, 25.6667}, {1800, 23.9115}, {1950, 23.0681}};
  const ph::eddy_current_brake<double> brake;
  for (const auto& [rpm, torque] : curve) {
    const double rate = rpm * std::numbers::pi / 30;
    EXPECT_NEAR(settled(brake, 1e9, rate), torque, 0.04 * torque) << rpm;
    EXPECT_NEAR(brake.torque_limit_at(-rate), settled(brake, 1e9, rate), 1e-13 * torque);
  }
}

TEST(eddy_current_brake, is_drag_at_low_rates_and_nothing_at_rest) {
  const ph::eddy_current_brake<double> brake{.peak_torque = 2, .critical_rate = 100};
  ph::eddy_current_brake<double>::state state;
  const auto r = brake.advance(long_enough, 1.0, 0, state);
  EXPECT_EQ(r.strength, 0);
  EXPECT_NEAR(r.drag, 2.0 / 100, 1e-17);
  EXPECT_EQ(brake.torque_limit_at(0), 0);
  EXPECT_NEAR(brake.torque_limit_at(0.1) / brake.torque_limit_at(0.05), 2, 1e-5);
  EXPECT_NEAR(settled(brake, 1.0, 100), 1, 1e-15) << "a command is the torque at the critical rate";
  EXPECT_NEAR(settled(brake, 1.0, 1e4), 2 / (100 + 0.01), 1e-15) << "the field is weakened";
  EXPECT_NEAR(settled(brake, brake.command_for(0.03, 1, {}), 1), 0.03, 1e-16);
}

TEST(eddy_current_brake, keeps_its_limit_at_rates_that_are_barely_numbers) {
  using real = std::numeric_limits<double>;
  for (const double critical_rate : {1e-3, 102.1, 1e6}) {
    const ph::eddy_current_brake<double> brake{.critical_rate = critical_rate};
    for (const double rate : {real::denorm_min(), real::min(), 1e-300, 1e-154, 1e154, 1e300, real::max()}) {
      const double torque = settled(brake, 1e9, rate);
      EXPECT_LE(torque, brake.torque_limit_at(rate)) << critical_rate << ' ' << rate;
      EXPECT_TRUE(std::isfinite(torque)) << critical_rate << ' ' << rate;
    }
  }
}

TEST(brake_models, whose_torque_overflows_are_refused) {
  EXPECT_EQ(validate(ph::eddy_current_brake<double>{.peak_torque = 1e300, .critical_rate = 1e-20}),
            "2 peak_torque / critical_rate [N m s] = inf: expected a finite number");
  ph::compensated_brake<ph::stribeck_brake<double>> brake;
  brake.model.coulomb.torque_limit = 1e300;
  brake.model.static_ratio = 1e10;
  EXPECT_EQ(validate(brake), "model.static_ratio torque_limit [N m] = inf: expected a finite number");
}

TEST(magnetorheological_brake, goes_around_a_loop) {
  const ph::magnetorheological_brake<double> brake{
      .torque_limit = 2, .saturation = 1.2, .coercive_current = 0.1};
  const auto f = [&](double m) { return 2 * std::tanh(1.2 * m) / std::tanh(1.2); };
  ph::magnetorheological_brake<double>::state state;
  EXPECT_NEAR(settled(brake, f(0.05), 0, state), 0, 1e-15) << "never energised";
  auto rising = state;
  EXPECT_NEAR(brake.advance(brake.time_constant, 99, 0, rising).strength, f(0.9 - 0.95 / std::numbers::e),
              1e-14);
  EXPECT_NEAR(settled(brake, f(0.5), 0, state), f(0.4), 1e-14) << "on the way up";
  EXPECT_NEAR(settled(brake, f(0.45), 0, state), f(0.4), 1e-14) << "the play";
  EXPECT_NEAR(settled(brake, 99, 0, state), f(0.9), 1e-14);
  EXPECT_NEAR(settled(brake, f(0.5), 0, state), f(0.6), 1e-14) << "on the way down";
  EXPECT_NEAR(settled(brake, 0, 0, state), f(0.1), 1e-14) << "remanence";
  EXPECT_NEAR(settled(brake, f(0.15), 0, state), f(0.1), 1e-14);
  EXPECT_NEAR(settled(brake, f(0.5), 0, state), f(0.4), 1e-14) << "the loop closes";
}

TEST(magnetorheological_brake, is_made_to_follow_by_a_driver_that_knows_it) {
  const ph::compensated_brake<ph::magnetorheological_brake<double>> known;
  const ph::magnetorheological_brake<double> unknown;
  ph::magnetorheological_brake<double>::state state, other;
  for (const double wanted : {0.3, 0.8, 0.9, 0.5, 0.2, 0.6, 0.1}) {
    EXPECT_NEAR(settled(known, wanted, 0, state), wanted, 1e-14);
    EXPECT_GT(std::abs(settled(unknown, wanted, 0, other) - wanted), 0.01);
  }
  EXPECT_NEAR(settled(known, 0, 0, state), unknown.torque_of(0.02), 1e-14)
      << "no current takes away what remanence keeps";
  EXPECT_EQ(unknown.command_for(99, 0, {}), unknown.torque_limit);
  EXPECT_EQ(unknown.command_for(0, 0, {.current = 0.5, .magnetisation = 0.5}), 0);
}

// tanh(k) rounds to 1, the curve has no inverse there.
TEST(magnetorheological_brake, that_saturates_at_once_still_lets_go) {
  const ph::magnetorheological_brake<double> brake{
      .torque_limit = 2, .saturation = 20, .coercive_current = 0.1};
  ph::magnetorheological_brake<double>::state state;
  EXPECT_NEAR(settled(brake, 99, 0, state), 2, 1e-14);
  EXPECT_NEAR(settled(brake, 0, 0, state), 2 * std::tanh(2.0), 1e-14);
  EXPECT_EQ(brake.magnetisation_of(2), 1);
  const ph::magnetorheological_brake<double> none{.torque_limit = 0};
  EXPECT_EQ(none.magnetisation_of(1), 0);
}

TEST(any_brake, resists_as_the_model_that_was_chosen) {
  using any = ph::any_brake<ph::stribeck_brake<double>, ph::eddy_current_brake<double>>;
  const ph::stribeck_brake<double> friction;
  const ph::eddy_current_brake<double> drag;
  for (const double rate : {0.01, 3.0}) {
    EXPECT_EQ(settled(any(friction), 0.5, rate), settled(friction, 0.5, rate));
    EXPECT_EQ(settled(any(drag), 0.5, rate), settled(drag, 0.5, rate));
    EXPECT_EQ(any(friction).torque_limit_at(rate), friction.torque_limit_at(rate));
    EXPECT_EQ(any(drag).torque_limit_at(rate), drag.torque_limit_at(rate));
  }
}

// One model after the other, each as any_brake
TEST(any_brake, refuses_an_invalid_model_and_finds_the_command_of_a_valid_one) {
  using any = ph::any_brake<ph::stribeck_brake<double>, ph::coulomb_brake<double>>;
  EXPECT_THROW(any(ph::coulomb_brake<double>{.torque_limit = -1}), std::invalid_argument);
  const ph::coulomb_brake<double> half{.gain = 0.5};
  EXPECT_EQ(settled(ph::compensated_brake<any>{any(half)}, 0.3, 0), 0.3);
}

// What a brake without lag gets of the commands told(0), told(1), ..., 1 ms each.
template <int Changes = 64>
void expect_delayed(double dead_time, const auto& told, const auto& acting, int steps) {
  ph::delayed_brake<ph::coulomb_brake<double>, Changes> brake;
  brake.model.time_constant = 0;
  brake.dead_time = dead_time;
  typename decltype(brake)::state state;
  for (int k = 0; k < steps; ++k)
    ASSERT_EQ(brake.advance(1e-3, told(k), 0, state).strength, acting(k)) << "step " << k;
}

// Changes alone wait: a command that is kept up, and what is no command, fills no queue.
TEST(delayed_brake, keeps_its_dead_time_however_long_a_command_lasts) {
  EXPECT_EQ(ph::delayed_brake<ph::coulomb_brake<double>>().dead_time, 0.002);
  for (const double after : {0.5, 0.0, -1.0, -HUGE_VAL, std::nan("")}) {
    SCOPED_TRACE(after);
    expect_delayed<4>(
        0.01, [&](int k) { return k == 0 ? 0.5 : after; },
        [&](int k) { return k < 10    ? 0.0
                            : k == 10 ? 0.5
                                      : std::fmax(after, 0.0); }, 30);
  }
}

TEST(delayed_brake, acts_in_the_nearest_time_step) {
  for (const auto& [dead_time, steps] : {std::pair{0.0024, 2}, {0.0026, 3}, {0.0004, 0}}) {
    SCOPED_TRACE(dead_time);
    expect_delayed(
        dead_time, [](int) { return 0.5; }, [late = steps](int k) { return k < late ? 0 : 0.5; }, 6);
  }
}

TEST(delayed_brake, with_a_full_queue_lets_the_oldest_command_act_early) {
  const auto told = [](int k) { return k < 0 ? 0.0 : (k + 1) / 1000.0; };
  expect_delayed<4>(0.01, told, [&](int k) { return told(k - 4); }, 500);
}

TEST(brake_models, name_their_own_parameters_and_those_of_the_model_inside) {
  ph::delayed_brake<ph::stribeck_brake<double>> brake;
  EXPECT_EQ(validate(brake), "");
  brake.model.static_ratio = 0.9;
  EXPECT_EQ(validate(brake), "model.static_ratio [1] = 0.9: expected a finite number >= 1");
  brake.model.static_ratio = 1;
  brake.dead_time = -1;
  EXPECT_EQ(validate(brake), "dead_time [s] = -1: expected a finite number >= 0");
  brake.model.coulomb.torque_limit = -1;
  EXPECT_EQ(validate(brake), "model.coulomb.torque_limit [N m] = -1: expected a finite number >= 0");
}

// A model of a user, without a table
struct without_parameters {
  using scalar = double;
  struct state {};
  ph::brake_resistance<double> advance(double, double, double, state&) const noexcept { return {}; }
  double torque_limit_at(double) const noexcept { return 1; }
};
TEST(brake_models, check_their_own_parameters_around_a_model_without_any) {
  EXPECT_EQ(validate(ph::delayed_brake<without_parameters>{.dead_time = -1}),
            "dead_time [s] = -1: expected a finite number >= 0");
  EXPECT_EQ(validate(ph::presliding_brake<without_parameters>{.presliding = -1}),
            "presliding [rad] = -1: expected a finite number >= 0");
}

static_assert(ph::InvertibleBrakeModel<ph::coulomb_brake<float>>);
static_assert(ph::InvertibleBrakeModel<ph::delayed_brake<ph::eddy_current_brake<double>>>);
static_assert(!ph::BrakeModel<ph::brake_parameters<double, 2>>);

}  // namespace
