// Compares devices for a task before any is built: the paper's with other reductions, five-bars with two and
// four brakes, an arm of three joints.
#include "design/devices.hpp"
#include "design/pictures.hpp"
#include "design/sinking_hand.hpp"

#include <command_line.hpp>
#include <output.hpp>

#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace ph = passive_haptics;

namespace {

void print_row(const std::string& name, const design::task_figures& f) {
  std::printf("%-26s %9.0f %5.2f %9.1f %6.0f %6.0f %10.2f %9.2f\n", name.c_str(),
              100 * (f.exact + f.approximate), f.drag, f.max_force, 100 * f.held, 100 * f.sinking,
              f.sink_slope, f.isotropy);
}

// The handle moves along x, the wall is above
template <class Candidate>
std::string map_of(const Candidate& device) {
  const auto points = device.points({1, 0});
  return ph::to_csv(
      points, ph::design_map(device.mechanism, points, ph::switchable_brakes<decltype(device.mechanism)>(),
                             design::push));
}

}  // namespace

int main(int argc, char** argv) try {
  const auto directory = example::output_directory(
      argc, argv, "design",
      "Compares devices for a task, also with motors: tables, maps over the workspace as CSV, pictures.");

  std::printf(
      "Along walls in 16 directions, everywhere in the workspace; brakes of 1 N m, a push of %g N:\n\n",
      design::push);
  std::printf("%-26s %9s %5s %9s %6s %6s %10s %9s\n%-26s %9s %5s %9s %6s %6s %10s %9s\n", "", "displayed",
              "drag", "strongest", "held", "sinks", "sink slope", "isotropy", "device", "[%]", "[1]", "[N]",
              "[%]", "[%]", "[1]", "[1]");
  for (const double k2 : {0.2, 0.4, 0.6, 1.0, 1.6, 2.5}) {
    std::ostringstream name;
    name << "paper's device, k2 = " << k2;
    print_row(name.str(), design::over_task(design::paper_device(k2)));
  }
  print_row("five-bar, 2 brakes", design::over_task(design::five_bar_device<2>()));
  print_row("five-bar, 4 brakes", design::over_task(design::five_bar_device<4>()));
  print_row("arm of 3 joints", design::over_task(design::three_joint_arm()));
  std::puts(
      "\ndisplayed: some force out of the wall; drag: median, for each newton of it; strongest: mean;\n"
      "held: the push does not sink; sink slope: median where it sinks.");

  std::vector<std::pair<double, design::task_figures>> by_reduction;
  for (int k = 0; k <= 24; ++k) {
    const double k2 = 0.2 * std::pow(2.5 / 0.2, k / 24.0);
    by_reduction.emplace_back(k2, design::over_task(design::paper_device(k2, 41, 21)));
  }
  design::draw_reductions(directory, "design_reductions", by_reduction);
  design::draw_map(directory, "design_map",
                   "The paper''s device: the handle moves to the right, the wall is above (grey: out of "
                   "reach, orange: no wall)",
                   map_of(design::paper_device(0.4, 161, 81)));
  design::draw_devices(
      directory, "design_devices",
      "Sink slope under a push of 2 N, brakes of 1 N m: the handle moves to the right, the wall is "
      "above",
      {{"Paper''s device", map_of(design::paper_device())},
       {"Five-bar, 2 brakes", map_of(design::five_bar_device<2>())},
       {"Arm of 3 joints", map_of(design::three_joint_arm())},
       {"Five-bar, 4 brakes", map_of(design::five_bar_device<4>())}});
  design::draw_sink_slopes(directory);
  design::compare_motors(directory);
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
