// Pictures of the experiments. Each function writes NAME.csv, NAME.gp and, where gnuplot is installed,
// NAME.svg.
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

// Fig. 5 (b), without and with direct control: pull_back.svg. The force that the tendon device makes is
// simulated.
void draw_pull_back(const std::filesystem::path& directory);

// The tendon device along the wall: a row a law, time from left to right.
void draw_filmstrip(const std::filesystem::path& directory, const std::string& name, const std::string& title,
                    const test_wall& wall, const std::vector<named_run>& runs);

// How deep the first contact goes (section 5.2).
struct penetration_row {
  std::string law;
  double lag, approach, max_depth;  // of the brakes [s], speed into the wall [m/s], [m]
};
// Against the lag at the approach that most rows have, and against the approach at the lag that most rows
// have: penetration.svg.
void draw_penetration(const std::filesystem::path& directory, const std::vector<penetration_row>& rows);

// Conclusion 1: force approximation and delay, alone and together.
struct slant_row {
  double slant_degrees;
  std::string cell, law;  // cell: which delays there are
  ph::contact_metrics figures;
};
void draw_slants(const std::filesystem::path& directory, const std::vector<slant_row>& rows);  // slants.svg

// Runs of one law over random plants.
struct batch_row {
  std::string law, setting;
  std::vector<ph::contact_metrics> figures;
};
void draw_batch(const std::filesystem::path& directory, const std::vector<batch_row>& rows);  // batch.svg

// A run in space: way made [m], depth in each wall [m].
struct space_row {
  std::string device, wall, law;
  std::vector<std::pair<double, std::vector<double>>> trace;
};
void draw_in_space(const std::filesystem::path& directory,
                   const std::vector<space_row>& rows);  // in_space.svg

}  // namespace experiments
