// Pictures of the experiments. Each function writes NAME.csv, NAME.gp and, if gnuplot is installed, NAME.svg.
#pragma once

#include "../planar.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace experiments {

// A run and the name of its law.
struct named_run {
  std::string law;
  run_result run;
};

// The layout of Figs. 8 to 10: path, depth, hand force, rate of brake 2, torques of both brakes and alpha
// along the wall.
void draw_figure(const std::filesystem::path& directory, const std::string& name, const std::string& title,
                 const test_wall& wall, const std::vector<named_run>& runs);

// Fig. 5 (b), without and with direct control: pull_back.svg. The force of the tendon device is simulated.
void draw_pull_back(const std::filesystem::path& directory);

// Depth of the first contact (section 5.2).
struct penetration_row {
  std::string law;
  double lag, approach, max_depth;  // of the brakes [s], speed into the wall [m/s], [m]
};
// Over the lag at the most frequent approach, and over the approach at the most frequent lag:
// penetration.svg.
void draw_penetration(const std::filesystem::path& directory, const std::vector<penetration_row>& rows);

// Conclusion 1: force approximation and delay, separately and together.
struct slant_row {
  double slant_degrees;
  std::string cell, law;  // cell: the delays
  ph::contact_metrics figures;
};
void draw_slants(const std::filesystem::path& directory, const std::vector<slant_row>& rows);  // slants.svg

// Runs of one law over random plants.
struct batch_row {
  std::string law, setting;
  std::vector<ph::contact_metrics> figures;
};
void draw_batch(const std::filesystem::path& directory, const std::vector<batch_row>& rows);  // batch.svg

// A spatial run: distance along the path [m], depth in each wall [m].
struct space_row {
  std::string device, wall, law;
  std::vector<std::pair<double, std::vector<double>>> trace;
};
void draw_in_space(const std::filesystem::path& directory,
                   const std::vector<space_row>& rows);  // in_space.svg

}  // namespace experiments
