// The sections of docs/results.md that take minutes, and so no other run has: corners, shapes and scenes,
// wide devices of ten seeds, and the whole table of arms.
#include "arms.hpp"
#include "batch.hpp"
#include "corners.hpp"
#include "plants.hpp"
#include "results_page.hpp"
#include "scenes.hpp"
#include "wide_devices.hpp"

#include <command_line.hpp>

#include <cstdio>
#include <exception>
#include <string>

using namespace experiments;

int main(int argc, char** argv) try {
  std::filesystem::path directory = ".";
  std::string section;
  bool all_arms = false;
  example::command_line line("experiments",
                             "Sections of the experiments.");  // 07_experiments has the help text
  line.choice("section", section, {"corners", "scenes", "wide"}, "only this one");
  line.flag("--arms", all_arms, "no more than the whole table of arms");
  line.output(directory);
  line.parse(argc, argv);
  page_tables tables;
  if (section.empty()) {
    progress_bar::plan(arm_runs);
    const bool no_power = follow_with_arms(tables);
    return is_printed(tables) && no_power ? 0 : 1;
  }
  if (section == "wide") {
    progress_bar::plan(3000);
    tables["wide_seeds"] = wide_seeds(plant_seed);
    std::fputs(tables["wide_seeds"].c_str(), stdout);
    return is_printed(tables) ? 0 : 1;
  }
  int unexplained = 0;
  tables = section == "corners" ? follow_corners() : follow_scenes(unexplained);
  return is_printed(tables) && unexplained == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
