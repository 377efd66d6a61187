// slow
// Pictures of the experiments: axes with units, a legend, a curve for each law. From runs that are made up.
#include "picture_style.hpp"
#include "pictures.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace {

using namespace experiments;

const std::array laws{law::none, law::direct, law::velocity};

std::string file(const std::filesystem::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct picture : testing::Test {
  const std::filesystem::path directory =
      std::filesystem::temp_directory_path() / ("passive_haptics_pictures_" + std::to_string(getpid()));

  picture() { std::filesystem::create_directories(directory); }
  ~picture() override { std::filesystem::remove_all(directory); }
  void SetUp() override {
    if (std::system("command -v gnuplot >/dev/null 2>&1") != 0) GTEST_SKIP() << "gnuplot is not installed";
  }
  std::string svg(const std::string& name) const { return file(directory / (name + ".svg")); }
};

void expect_texts(const std::string& svg, const std::vector<std::string>& texts) {
  for (const std::string& text : texts)
    EXPECT_NE(svg.find(">" + text + "<"), std::string::npos) << text << " is missing";
}

// Plots with a path in this colour; a legend is none.
int curves(const std::string& svg, const std::string& colour) {
  unsigned r = 0, g = 0, b = 0;
  EXPECT_EQ(std::sscanf(colour.c_str(), "#%2x%2x%2x", &r, &g, &b), 3);
  char stroke[60];
  std::snprintf(stroke, sizeof stroke, "<path stroke='rgb(%3u, %3u, %3u)'", r, g, b);
  int count = 0;
  const std::string start = "<g id=\"gnuplot_plot_";
  for (auto at = svg.find(start); at != std::string::npos; at = svg.find(start, at + 1)) {
    const std::string plot = svg.substr(at, svg.find("</g>\n\t</g>", at) - at);
    const auto path = plot.find(stroke);
    count += path != std::string::npos && plot.find(" L", path) < plot.find("/>", path);
  }
  return count;
}
int curves(const std::string& svg, law which) {
  return curves(svg, style::colour_of(std::string(name_of(which))));
}

void expect_legend(const std::string& svg) {
  for (const law l : laws) expect_texts(svg, {std::string(name_of(l))});
}

// Made up: along the wall and a little in and out of it; alpha is below 1 under direct control.
std::vector<named_run> short_runs() {
  std::vector<named_run> runs;
  for (const law l : laws) {
    run_result run;
    run.min_alpha = l == law::direct ? 0.5 : 1;
    for (int k = 0; k <= 100; ++k) {
      const double t = 0.02 * k, depth = 1e-3 * std::sin(9 * t);
      run.trace.push_back({t,
                           depth,
                           run.min_alpha,
                           {0.05 + 0.05 * t, 0.225 + depth},
                           {1, depth},
                           {1, 1},
                           {100 * depth, 50 * depth},
                           {0.5, 2},
                           {0.5, -2}});
    }
    runs.push_back({std::string(name_of(l)), run});
  }
  return runs;
}

ph::contact_metrics metrics(double depth, int separations) {
  ph::contact_metrics m;
  m.depth_std = m.depth_range = depth;
  m.separations = separations;
  return m;
}

TEST_F(picture, figure_has_its_panels) {
  draw_figure(directory, "figure_9", "a title with an_underscore and 'quotes'", planar_wall(), short_runs());
  const std::string drawn = svg("figure_9");
  expect_texts(drawn, {"a title with an_underscore and 'quotes'", "x [m]", "y [mm]", "depth [mm]",
                       "rate of brake 2 [rad/s]", "Fh into the wall [N]", "Fh along the wall [N]",
                       "torque of brake 1 [N m]", "torque of brake 2 [N m]", "alpha [1], mean of 40 ms",
                       "inside the wall"});
  for (const law l : laws)  // with what came out
    EXPECT_NE(drawn.find(">" + std::string(name_of(l)) + ": "), std::string::npos);
  EXPECT_EQ(curves(drawn, law::none), 7);
  EXPECT_EQ(curves(drawn, law::direct), 8);  // alpha, too
  EXPECT_EQ(curves(drawn, law::velocity), 7);
}

TEST_F(picture, pull_back_has_two_triangles) {
  draw_pull_back(directory);
  const std::string drawn = svg("pull_back");
  expect_texts(drawn, {"x [m]", "y [m]", "hand force Fh", "brake force Fc", "resultant Fr",
                       "desired force Fd", "producible", "wall", "Fr out of the wall = 0: no pull-back"});
  EXPECT_NE(drawn.find(" N: pull-back<"), std::string::npos);
  for (const char* colour : {"#0072b2", "#d55e00", "#000000"}) EXPECT_EQ(curves(drawn, colour), 2) << colour;
}

TEST_F(picture, penetration_over_lag_and_speed) {
  std::vector<penetration_row> rows;
  double depth = 1e-3;
  for (const law l : laws) {
    for (const double lag : {0.02, 0.005, 0.05})
      rows.push_back({std::string(name_of(l)), lag, 0.1, depth *= 1.1});
    for (const double v : {0.05, 0.2}) rows.push_back({std::string(name_of(l)), 0.02, v, depth *= 1.1});
  }
  draw_penetration(directory, rows);
  const std::string drawn = svg("penetration");
  expect_texts(drawn, {"response time of the brakes [ms]", "speed into the wall [m/s]", "largest depth [mm]",
                       "approach at 0.1 m/s", "response time 20 ms"});
  expect_legend(drawn);
  for (const law l : laws) EXPECT_EQ(curves(drawn, l), 2);
}

TEST_F(picture, slants_have_a_panel_for_each_cell) {
  std::vector<slant_row> rows;
  for (const law l : laws) {
    for (const char* cell : {"no delay", "brake lag", "slow environment", "both"})
      for (const double slant : {0.0, 10.0, 20.0, 30.0})
        rows.push_back({slant, cell, std::string(name_of(l)), metrics(1e-5 * slant, 0)});
  }
  draw_slants(directory, rows);
  const std::string drawn = svg("slants");
  expect_texts(drawn, {"slant of the wall [deg]", "depth range [mm]", "no delay", "brake lag",
                       "slow environment", "both"});
  expect_legend(drawn);
  for (const law l : laws) EXPECT_EQ(curves(drawn, l), 4);
}

TEST_F(picture, batch_counts_separations) {
  std::vector<batch_row> rows;
  for (const law l : laws) {
    for (const char* setting : {"1 kHz", "20 Hz"})
      rows.push_back({std::string(name_of(l)),
                      setting,
                      {metrics(1e-3, 2), metrics(1e-4, 0), metrics(0, 0), metrics(2e-3, 1)}});
  }
  draw_batch(directory, rows);
  const std::string drawn = svg("batch");
  expect_texts(drawn, {"standard deviation of depth [mm]", "share of plants below [1]", "1 kHz", "20 Hz"});
  for (const law l : laws) {
    EXPECT_NE(drawn.find(std::string(name_of(l)) + ": separations in 50 % of the runs"), std::string::npos);
    EXPECT_EQ(curves(drawn, l), 2);
  }
}

TEST_F(picture, in_space_draws_both_walls_of_an_edge) {
  std::vector<space_row> rows;
  for (const law l : laws) {  // an arm at an edge is missing
    for (const char* device : {"delta", "arm"})
      rows.push_back({device, "plane", std::string(name_of(l)), {{0, {0}}, {0.1, {1e-3}}}});
    rows.push_back({"delta", "edge", std::string(name_of(l)), {{0, {0, 1e-3}}, {0.1, {1e-3, 0}}}});
  }
  draw_in_space(directory, rows);
  const std::string drawn = svg("in_space");
  expect_texts(drawn, {"path length [mm]", "depth [mm]", "delta, plane", "delta, edge", "arm, plane",
                       "second wall of an edge"});
  expect_legend(drawn);
  for (const law l : laws) EXPECT_EQ(curves(drawn, l), 4);
}

TEST_F(picture, nothing_to_draw_is_refused) {
  EXPECT_THROW(draw_batch(directory, {}), std::invalid_argument);
  EXPECT_THROW(draw_figure(directory, "none", "", planar_wall(), {{"a law", {}}}), std::invalid_argument);
  EXPECT_TRUE(std::filesystem::is_empty(directory));
}

TEST_F(picture, without_gnuplot_data_and_script_are_there) {
  ASSERT_EQ(setenv("PATH", "/nowhere", 1), 0);
  draw_pull_back(directory);
  EXPECT_FALSE(file(directory / "pull_back.csv").empty());
  EXPECT_FALSE(file(directory / "pull_back.gp").empty());
  EXPECT_FALSE(std::filesystem::exists(directory / "pull_back.svg"));
}

}  // namespace
