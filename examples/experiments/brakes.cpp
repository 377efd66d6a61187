#include "brakes.hpp"

#include "batch.hpp"
#include "planar_run.hpp"

#include <passive_haptics/plant/brakes/any_brake.hpp>
#include <passive_haptics/plant/brakes/compensated_brake.hpp>
#include <passive_haptics/plant/brakes/delayed_brake.hpp>
#include <passive_haptics/plant/brakes/eddy_current_brake.hpp>
#include <passive_haptics/plant/brakes/magnetorheological_brake.hpp>
#include <passive_haptics/plant/brakes/stribeck_brake.hpp>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace experiments {

namespace {

using arm = ph::tendon_two_link<double>;
using coulomb = ph::coulomb_brake<double>;
using stribeck = ph::stribeck_brake<double>;
using magnetorheological = ph::magnetorheological_brake<double>;
using eddy_current = ph::eddy_current_brake<double>;
template <class Model>
using inverted = ph::compensated_brake<Model>;
using some_brake =
    ph::any_brake<coulomb, stribeck, inverted<stribeck>, magnetorheological, inverted<magnetorheological>,
                  inverted<eddy_current>, ph::delayed_brake<coulomb>>;
using known_brakes = ph::rate_limited_brakes<arm, some_brake>;

// A brake, and its parameters in the controller.
struct brake_case {
  std::string name;
  some_brake real;
  double lag = 0.020;                                          // known [s]
  double limit = 1;                                            // known [N m],
  some_brake limit_at = coulomb{.torque_limit = 1000};         // known limit at the current rate
  double push = ph::following_hand_parameters<double>().push;  // of the hand [N]
};

ph::delayed_brake<coulomb> late(double dead_time) {
  ph::delayed_brake<coulomb> brake;
  brake.dead_time = dead_time;
  return brake;
}
const coulomb slow_fall{.fall_ratio = 3}, particle = ph::magnetic_particle_brake<double>();
const inverted<eddy_current> eddy{};

std::vector<brake_case> kinds() {
  return {{"lag of 20 ms", coulomb()},
          {"falls in 60 ms", slow_fall},
          {"dead time of 5 ms", late(0.005)},
          {"residual 0.05 N m", coulomb{.residual = {.strength = 0.05}}},
          {"particle, hand of 6 N", particle, particle.time_constant, particle.torque_limit,
           coulomb{.torque_limit = 1000}, 6},
          {"Stribeck", stribeck()},
          {"MR", magnetorheological()},
          {"eddy", eddy, 0.020, 1, eddy}};
}

std::vector<brake_case> beliefs() {
  return {{"lag of 20 ms: known", coulomb()},
          {"falls in 60 ms: taken for 20 ms", slow_fall},
          {"falls in 60 ms: taken for 60 ms", slow_fall, 0.060},
          {"dead time of 5 ms: not known", late(0.005)},
          {"dead time of 5 ms: taken for a lag of 25 ms", late(0.005), 0.025},
          {"Stribeck: not known", stribeck()},
          {"Stribeck: inverted", inverted<stribeck>()},
          {"MR: not known", magnetorheological()},
          {"MR: inverted", inverted<magnetorheological>()},
          {"eddy: inverted", eddy},
          {"eddy: inverted, limit known", eddy, 0.020, 1, eddy}};
}

run_result follow_with(const brake_case& what, law which, double time_step = setup().time_step) {
  const test_wall wall = planar_wall();
  setup how;
  how.time_step = time_step;
  how.hand.push = what.push;
  device<arm, known_brakes, some_brake> d{arm(),
                                          arm(),
                                          known_brakes({}, {what.limit_at, what.limit_at}),
                                          {what.real, what.real},
                                          ph::encoder_parameters().resolution,
                                          {}};
  d.brakes.torque_limit.setConstant(what.limit);
  d.brakes.time_constant.setConstant(what.lag);
  d.start = d.real.inverse(start_beside(wall, how.gap), ph::elbow::left).q;
  return follow(d, which, wall, how);
}

std::string known_of(const std::vector<brake_case>& cases) {
  const auto runs = on_all_cores("known of brakes", cases.size(),
                                 [&](std::size_t k) { return follow_with(cases[k], law::velocity).figures; });
  std::string table = markdown_head(
      {"brake: what is known of it", "separations", "standard deviation [mm]", "deepest [mm]", "drag [N]"});
  for (std::size_t k = 0; k < cases.size(); ++k)
    table += markdown_row({cases[k].name, written("%d", runs[k].separations),
                           written("%.2f", 1e3 * runs[k].depth_std), written("%.1f", 1e3 * runs[k].max_depth),
                           written("%.2f", runs[k].retarding_force)});
  return table;
}

}  // namespace

bool holds_with_every_brake(double time_step) {
  const std::vector<brake_case> brakes = kinds();
  const auto runs = on_all_cores("every brake", brakes.size(), [&](std::size_t k) {
    return follow_with(brakes[k], law::velocity, time_step).figures;
  });
  return std::all_of(runs.begin(), runs.end(),
                     [](const ph::contact_metrics& f) { return f.separations == 0 && f.arrived; });
}

void laws_and_brakes(page_tables& page) {
  const std::vector<brake_case> brakes = kinds();
  const auto runs = on_all_cores("laws and brakes", all_laws.size() * brakes.size(), [&](std::size_t k) {
    return follow_with(brakes[k % brakes.size()], all_laws[k / brakes.size()]).figures;
  });
  std::vector<std::string> titles{"law"};
  for (const brake_case& b : brakes) titles.push_back(b.name);
  std::string &hold = page["laws_and_brakes_hold"], feel = markdown_head(titles);
  hold = feel;
  for (std::size_t i = 0; i < all_laws.size(); ++i) {
    std::vector<std::string> holds{std::string(name_of(all_laws[i]))}, feels = holds;
    for (std::size_t j = 0; j < brakes.size(); ++j) {
      const ph::contact_metrics& f = runs[i * brakes.size() + j];
      holds.push_back(written("%d / %.2f", f.separations, 1e3 * f.depth_std));
      feels.push_back(written("%.1f / %.2f", 1e3 * f.max_depth, f.retarding_force));
    }
    hold += markdown_row(holds);
    feel += markdown_row(feels);
  }
  std::printf(
      "\nLaws and brakes: separations / standard deviation [mm]\n\n%s\nDeepest [mm] / drag [N]\n\n%s"
      "\nvelocity_direct_control, by what is known of its brakes\n\n%s",
      hold.c_str(), feel.c_str(), known_of(beliefs()).c_str());
  std::fflush(stdout);
}

}  // namespace experiments
