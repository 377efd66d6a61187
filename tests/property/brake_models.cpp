// Every brake model under the suite; and models that are wrong, which must not pass it.
#include "../tested_types.hpp"

#include <passive_haptics/plant/brakes/any_brake.hpp>
#include <passive_haptics/plant/brakes/compensated_brake.hpp>
#include <passive_haptics/plant/brakes/coulomb_brake.hpp>
#include <passive_haptics/plant/brakes/delayed_brake.hpp>
#include <passive_haptics/plant/brakes/eddy_current_brake.hpp>
#include <passive_haptics/plant/brakes/magnetorheological_brake.hpp>
#include <passive_haptics/plant/brakes/presliding_brake.hpp>
#include <passive_haptics/plant/brakes/stribeck_brake.hpp>
#include <passive_haptics/testing/brake_model_properties.hpp>

using namespace passive_haptics::testing;
namespace ph = passive_haptics;

namespace {

// Exact but for rounding, as their headers say.
template <class Model>
struct case_of {
  using model = Model;
  static constexpr double inverse_error = 0;
  static Model make() { return {}; }
};

template <class T>
struct wrong_and_slow : case_of<ph::coulomb_brake<T>> {
  static ph::coulomb_brake<T> make() {
    return {.torque_limit = T(2), .fall_ratio = T(3), .gain = T(1.3), .residual = {T(0.1), T(0.01)}};
  }
};

template <class T>
struct without_lag : case_of<ph::magnetorheological_brake<T>> {
  static ph::magnetorheological_brake<T> make() { return {.saturation = T(3), .time_constant = T(0)}; }
};

// A whole number of time steps.
template <class Model>
struct late : case_of<ph::delayed_brake<Model>> {
  static ph::delayed_brake<Model> make() {
    ph::delayed_brake<Model> brake;
    brake.dead_time = typename Model::scalar(1) / 512;
    return brake;
  }
};

using some_brake =
    ph::any_brake<ph::stribeck_brake<double>, ph::coulomb_brake<double>, ph::eddy_current_brake<double>>;
template <class Model>
struct chosen : case_of<some_brake> {
  static some_brake make() { return Model(); }
};

template <class T>
using compensated = ph::compensated_brake<ph::magnetorheological_brake<T>>;

using models =
    tested_types<case_of<ph::coulomb_brake<double>>, wrong_and_slow<float>,
                 case_of<ph::stribeck_brake<double>>, case_of<ph::eddy_current_brake<double>>,
                 case_of<ph::magnetorheological_brake<double>>, without_lag<double>,
                 late<ph::eddy_current_brake<double>>,
                 case_of<ph::presliding_brake<ph::coulomb_brake<double>>>, case_of<compensated<double>>,
                 late<compensated<double>>, chosen<ph::eddy_current_brake<double>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(models, brake_model_properties, models);

// ---- what the suite must find

// A brake that is right, but for what a test changes in it.
struct right {
  using scalar = double;
  struct state {
    double strength = 0;
  };
  ph::brake_resistance<double> advance(double dt, double command, double, state& now) const noexcept {
    now.strength = ph::lagged(now.strength, ph::valid_command(command, 1.0), ph::valid_time_step(dt), 0.02);
    return {now.strength, 0};
  }
  double torque_limit_at(double) const noexcept { return 1; }
  double command_for(double torque, double, const state&) const noexcept { return torque; }
};

// A motor at heart: it pushes on while its strength falls.
struct driving : right {
  ph::brake_resistance<double> advance(double dt, double command, double, state& now) const noexcept {
    const double before = now.strength;
    right::advance(dt, command, 0, now);
    return {now.strength - 0.5 * std::max(before - now.strength, 0.0) - 1e-6, 0};
  }
};
struct over_its_limit : right {
  double torque_limit_at(double rate) const noexcept { return std::abs(rate) > 50 ? 0.9 : 1; }
};
struct trusting : right {
  ph::brake_resistance<double> advance(double dt, double command, double, state& now) const noexcept {
    now.strength = ph::lagged(now.strength, std::min(command, 1.0), dt, 0.02);
    return {std::clamp(now.strength, 0.0, 1.0), 0};
  }
};
struct by_the_step : right {
  ph::brake_resistance<double> advance(double, double command, double, state& now) const noexcept {
    now.strength += 0.01 * (ph::valid_command(command, 1.0) - now.strength);
    return {now.strength, 0};
  }
};
struct trusting_rates : right {
  ph::brake_resistance<double> advance(double dt, double command, double rate, state& now) const noexcept {
    return {right::advance(dt, command, 0, now).strength / (1 + rate * rate), 0};
  }
};
struct badly_inverted : right {
  double command_for(double torque, double, const state&) const noexcept { return 0.99 * torque; }
};

template <class B>
std::string broken_law(const B& brake) {
  for (const std::string& text : {broken_energy_law(brake, 1, 100000), broken_input_law(brake, 1),
                                  broken_time_step_law(brake, 1), broken_inverse_law(brake, 1, 0)})
    if (!text.empty()) return text.substr(0, text.find(':'));
  return "none";
}

TEST(brake_model_suite, finds_what_is_wrong) {
  EXPECT_EQ(broken_law(right()), "none");
  EXPECT_EQ(broken_law(driving()), "not passive");
  EXPECT_EQ(broken_law(over_its_limit()), "not bounded");
  EXPECT_EQ(broken_law(trusting()), "not passive");
  EXPECT_EQ(broken_law(by_the_step()), "not of first order");
  EXPECT_EQ(broken_law(trusting_rates()), "rate");
  EXPECT_EQ(broken_law(badly_inverted()), "inverse");
}

}  // namespace
