// The example experiments with its options for parts only. Its runs are made up: those of the example take
// the compiler far longer.
#include <experiments/numbered_options.hpp>
#include <experiments/planar.hpp>

#include <cstdio>
#include <exception>
#include <filesystem>

namespace experiments {

// Figures that differ from experiment to experiment.
run_result follow_with_arm(law which, const test_wall& wall, const setup& how) {
  run_result run;
  run.figures.separations = static_cast<int>(which);
  run.figures.depth_std = how.gain / how.environment_rate;
  run.figures.depth_mean = wall.distance({0, 0});
  return run;
}

}  // namespace experiments

int main(int argc, char** argv) try {
  std::filesystem::path directory = ".";
  experiments::numbered_options numbered;
  example::command_line line("experiments", "Parts of the experiments.");
  numbered.add_to(line);
  line.output(directory);
  line.parse(argc, argv);
  numbered.carry_out(directory);
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
