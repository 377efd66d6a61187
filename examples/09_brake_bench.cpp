// Identifies a brake by three tests on a bench: steps of the current, a slow ramp, a sweep of the rate. The
// bench is simulated behind the port and torque sensor of a real one, so that the results can be compared.
#include <brakes_section.hpp>
#include <command_line.hpp>
#include <output.hpp>
#include <simulated_bench.hpp>

#include <passive_haptics/bench/bench_run.hpp>
#include <passive_haptics/bench/magnetorheological_loop.hpp>
#include <passive_haptics/bench/measured_brake.hpp>
#include <passive_haptics/bench/rate_sweep.hpp>
#include <passive_haptics/core/parameter_text.hpp>
#include <passive_haptics/driver/rate_estimator.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/plant/brakes/coulomb_brake.hpp>
#include <passive_haptics/plant/brakes/delayed_brake.hpp>
#include <passive_haptics/plant/brakes/eddy_current_brake.hpp>
#include <passive_haptics/plant/brakes/magnetorheological_brake.hpp>
#include <passive_haptics/plant/brakes/stribeck_brake.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

namespace ph = passive_haptics;

namespace {

using device = ph::tendon_two_link<double>;  // with two such brakes

constexpr example::simulated_bench_parameters how;

constexpr double current = 0.5, steady_rate = 2, pause = 0.5, ramp_time = 10;  // [A, rad/s, s, s]
constexpr double min_rate = 0.02, max_rate = 20, sweep_time = 40;              // [rad/s, rad/s, s]

// Currents [A] at a time [s] of each test; the axis rotates steadily except in the sweep.
double step_up(double t) { return t < pause ? 0 : current; }
double step_down(double t) { return t < pause ? current : 0; }
double ramp(double t) {
  return current / ramp_time * std::clamp(std::min(t - pause, 2 * (pause + ramp_time) - t), 0.0, ramp_time);
}
double hold(double) { return current; }

double steady(double) { return steady_rate; }
double sweep(double t) { return min_rate * std::pow(max_rate / min_rate, t / sweep_time); }

void print(const char* name, const ph::estimate& found, const char* unit) {
  std::printf("  %-18s %10.5g +- %.2g %s\n", name, found.value, found.standard_error, unit);
}

void print(const char* what, const ph::step_response& found) {
  std::printf("\nstep %s\n", what);
  print("change", found.change, "N m");
  print("time_constant", found.time_constant, "s");
  print("dead_time", found.dead_time, "s");
  std::printf("  deviation          %10.2g N m\n", found.deviation);
}

std::string table(const std::vector<ph::bench_sample>& samples) {
  std::ostringstream csv;
  csv << "time,current,position,torque\n";
  for (const auto& s : samples)
    csv << s.time << "," << s.current << "," << s.position << "," << s.torque << "\n";
  return csv.str();
}

using function_of_time = double (*)(double);
// Samples of a test with this current [A] and rate [rad/s], also written to a file of this name.
using bench_test = std::function<std::vector<ph::bench_sample>(const char* name, function_of_time current_at,
                                                               function_of_time rate, double duration)>;

// torque_at: torque of a current according to the driver [N m]
template <class Model>
bench_test test_of(const Model& brake, const std::function<double(double)>& torque_at,
                   const std::filesystem::path& directory) {
  std::printf("In the simulation:\n%s", ph::to_text(brake).c_str());
  return [=](const char* name, function_of_time current_at, function_of_time rate, double duration) {
    example::simulated_bench<Model> bench(brake, torque_at, rate, how);
    example::simulated_bench_port<example::simulated_bench<Model>> port{&bench};
    example::simulated_torque_sensor<example::simulated_bench<Model>> sensor{&bench};
    ph::bench_parameters p;
    p.radians_per_count = how.resolution;
    p.current_limit = current;
    const auto wait = [&] { return bench.wait(); };  // a real bench sleeps until the next period
    const auto samples = ph::record_on_bench(port, sensor, p, duration, current_at, wait);
    example::write_file(directory / (std::string(name) + ".csv"), table(samples));
    return samples;
  };
}

void identify(const bench_test& record, const std::filesystem::path& directory) {
  // 1. Steps
  const auto step_up_samples = record("step_up", step_up, steady, 3 * pause);
  const auto step_down_samples = record("step_down", step_down, steady, 3 * pause);
  const auto up = ph::fit_step_response(step_up_samples), down = ph::fit_step_response(step_down_samples);
  print("up", up);
  print("down", down);

  // 2. A ramp
  const auto ramp_samples = record("ramp", ramp, steady, 2 * (pause + ramp_time) + pause);
  const ph::ramp_delay delay{up.time_constant.value + up.dead_time.value,
                             down.time_constant.value + down.dead_time.value};
  const auto loop = ph::fit_current_ramp(ramp_samples, delay);
  std::printf("\nramp\n");
  print("residual_torque", loop.residual_torque, "N m");
  print("hysteresis", loop.hysteresis, "N m");
  for (std::size_t i = 0; i < loop.rising.size(); ++i)
    std::printf("  %6.3f A: up %8.5f, down %8.5f N m\n", 0.1 * static_cast<double>(i) * loop.max_current,
                loop.rising[i].value, loop.falling[i].value);
  if (const std::string error = validate(loop.curve()); !error.empty()) std::printf("  %s\n", error.c_str());

  const auto magnetic = ph::fit_magnetorheological_brake(step_up_samples, step_down_samples, ramp_samples);
  std::printf("\nsteps and ramp, as of a magnetorheological brake: deviation %.2g and %.2g N m\n",
              magnetic.rising.deviation, magnetic.loop.deviation);
  print("torque_limit", magnetic.loop.torque_limit, "N m");
  print("saturation", magnetic.loop.saturation, "");
  print("coercive_current", magnetic.loop.coercive_current, "");
  print("time_constant", magnetic.rising.time_constant, "s");
  print("dead_time", magnetic.rising.dead_time, "s");

  // 3. A sweep
  const auto means = ph::mean_over_windows(record("sweep", hold, sweep, sweep_time), 0.5);
  const auto viscous = ph::fit_viscous_friction(means);
  const auto stribeck = ph::fit_stribeck_friction(means);
  const auto eddy = ph::fit_eddy_current_torque(means);
  std::printf("\nsweep, as friction and drag: deviation %.2g N m\n", viscous.deviation);
  print("strength", viscous.strength, "N m");
  print("drag", viscous.drag, "N m s");
  std::printf("sweep, as Stribeck friction: deviation %.2g N m\n", stribeck.deviation);
  print("strength", stribeck.strength, "N m");
  print("static_ratio", stribeck.static_ratio, "");
  print("stribeck_rate", stribeck.stribeck_rate, "rad/s");
  print("drag", stribeck.drag, "N m s");
  std::printf("sweep, as eddy currents: deviation %.2g N m\n", eddy.deviation);
  print("strength", eddy.strength, "N m");
  print("drag", eddy.drag, "N m s");
  print("critical_rate", eddy.critical_rate, "rad/s");
  print("peak_torque", eddy.peak_torque, "N m");

  // Parameters of a controller and brake_driver for two such brakes
  if (eddy.deviation < 0.5 * std::min(viscous.deviation, stribeck.deviation)) {
    std::printf("\nno brakes.toml: the torque depends on the rate, see rate_limited_brakes\n");
    return;
  }
  const double dead_band = ph::rate_dead_band(how.resolution, 16, how.period);
  const bool has_loop = loop.hysteresis.value > 10 * loop.hysteresis.standard_error;
  const ph::measured_brake measured = has_loop ? ph::measured_brake_of(magnetic, dead_band)
                                               : ph::measured_brake_of(up, down, loop, dead_band);
  const ph::brakes_of<device> brakes = ph::measured_brakes<device>({measured, measured});
  std::printf("\nbrakes.toml, and brakes of a controller:\n%s", ph::to_text(brakes).c_str());
  example::write_file(directory / "brakes.toml", example::brakes_section<device>({measured, measured}));
}

}  // namespace

int main(int argc, char** argv) try {
  std::string which = "magnetorheological";
  std::filesystem::path directory;
  example::command_line line("brake_bench",
                             "Constants of a brake from three tests on a bench, the samples as CSV, and "
                             "brakes.toml for brake_driver.");
  line.choice("--brake", which, {"coulomb", "magnetorheological", "stribeck", "eddy_current"},
              "on the bench");
  line.output(directory);
  line.parse(argc, argv);

  const ph::brake_resistance<double> residual{.strength = 0.02, .drag = 0.001};
  const auto believed = [](double I) { return 1.6 * I; };
  if (which == "coulomb") {
    ph::delayed_brake<ph::coulomb_brake<double>> brake;
    brake.model = {.fall_ratio = 2.5, .residual = residual};
    identify(test_of(brake, believed, directory), directory);
  } else if (which == "magnetorheological") {
    ph::magnetorheological_brake<double> brake;
    brake.residual = residual;
    const auto inverse = [brake](double I) { return brake.torque_of(I / current); };
    identify(test_of(brake, inverse, directory), directory);
  } else if (which == "stribeck") {
    ph::stribeck_brake<double> brake;
    brake.coulomb.residual = residual;
    identify(test_of(brake, believed, directory), directory);
  } else {
    ph::eddy_current_brake<double> brake;
    brake.critical_rate = 10;
    brake.residual.strength = residual.strength;
    identify(test_of(brake, believed, directory), directory);
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
