// Combined results of many runs: penetration, conclusion 1, random plants, spatial runs.
#include "panels.hpp"
#include "picture_style.hpp"
#include "pictures.hpp"

#include <cstdio>
#include <map>

namespace experiments {

namespace {

constexpr double min_shown = 1e-7;  // on a logarithmic scale [m]

double in_mm(double metres) { return 1e3 * std::max(metres, min_shown); }

// The most frequent value; the minimum of several.
template <class Rows, class Value>
double commonest(const Rows& rows, Value value) {
  std::map<double, int> count;
  for (const auto& row : rows) ++count[value(row)];
  const auto more = [](const auto& a, const auto& b) { return a.second < b.second; };
  return count.empty() ? 0 : std::max_element(count.begin(), count.end(), more)->first;
}

std::string text(const char* format, double value) {
  char line[100];
  std::snprintf(line, sizeof line, format, value);
  return line;
}

const auto law_of = [](const auto& row) { return row.law; };

}  // namespace

void draw_penetration(const std::filesystem::path& directory, const std::vector<penetration_row>& rows) {
  const auto lag_of = [](const penetration_row& r) { return r.lag; };
  const auto approach_of = [](const penetration_row& r) { return r.approach; };
  const double lag = commonest(rows, lag_of), approach = commonest(rows, approach_of);

  panel by_lag{
      text("approach at %g m/s", approach), "response time of the brakes [ms]", "largest depth [mm]", {}};
  panel by_approach{
      text("response time %g ms", 1e3 * lag), "speed into the wall [m/s]", "largest depth [mm]", {}};
  for (const std::string& law : style::distinct(rows, law_of)) {
    curve over_lag{law, {}}, over_approach{law, {}};
    for (const penetration_row& r : rows) {
      if (r.law != law) continue;
      if (r.approach == approach) over_lag.points.emplace_back(1e3 * r.lag, 1e3 * r.max_depth);
      if (r.lag == lag) over_approach.points.emplace_back(r.approach, 1e3 * r.max_depth);
    }
    for (curve* c : {&over_lag, &over_approach}) std::sort(c->points.begin(), c->points.end());
    by_lag.curves.push_back(over_lag);
    by_approach.curves.push_back(over_approach);
  }
  draw_panels(
      directory,
      {.name = "penetration",
       .title = "The first contact (section 5.2): without direct control the depth grows with lag and speed",
       .columns = 2,
       .width = 1000,
       .style = line_style::points_on_lines,
       .settings = "set yrange [0:*]\nset xrange [0:*]\nset offsets 0,graph 0.04,graph 0.06,0\n",
       .all = {by_lag, by_approach}});
}

void draw_slants(const std::filesystem::path& directory, const std::vector<slant_row>& rows) {
  panels p{
      .name = "slants",
      .title = "Conclusion 1: along a slanted wall an XY table bounces, most with delay (0.0001 mm: or less)",
      .columns = 4,
      .style = line_style::points_on_lines,
      .log_y = true,
      .common_y = true,
      .settings = "set xtics 10\nset xrange [-4:34]\n"};
  for (const std::string& cell : style::distinct(rows, [](const slant_row& r) { return r.cell; })) {
    panel one{cell, "slant of the wall [deg]", "depth range [mm]", {}};
    for (const std::string& law : style::distinct(rows, law_of)) {
      curve c{law, {}};
      for (const slant_row& r : rows) {
        if (r.cell == cell && r.law == law)
          c.points.emplace_back(r.slant_degrees, in_mm(r.figures.depth_range));
      }
      std::sort(c.points.begin(), c.points.end());
      if (!c.points.empty()) one.curves.push_back(c);
    }
    p.all.push_back(one);
  }
  p.columns = static_cast<int>(std::max<std::size_t>(1, std::min<std::size_t>(4, p.all.size())));
  draw_panels(directory, p);
}

void draw_batch(const std::filesystem::path& directory, const std::vector<batch_row>& rows) {
  panels p{
      .name = "batch",
      .title = "Random devices: the further to the left a curve is, the smoother the law follows the wall",
      .row_height = 360,
      .style = line_style::steps,
      .log_x = true,
      .common_x = true,
      .settings = "set yrange [0:1]\n"};
  for (const std::string& setting : style::distinct(rows, [](const batch_row& r) { return r.setting; })) {
    panel one{setting, "standard deviation of depth [mm]", "share of plants below [1]", {}};
    for (const batch_row& r : rows) {
      if (r.setting != setting || r.figures.empty()) continue;
      const double runs = static_cast<double>(r.figures.size());
      std::vector<double> depths;
      int separated = 0;
      for (const ph::contact_metrics& m : r.figures) {
        depths.push_back(in_mm(m.depth_std));
        separated += m.separations > 0;
      }
      std::sort(depths.begin(), depths.end());
      curve c{.law = r.law, .points = {{depths.front(), 0}}};
      for (std::size_t k = 0; k < depths.size(); ++k)
        c.points.emplace_back(depths[k], static_cast<double>(k + 1) / runs);
      c.name = r.law + text(": separations in %.0f %% of the runs", 100 * separated / runs);
      one.curves.push_back(c);
    }
    p.all.push_back(one);
  }
  p.columns = static_cast<int>(std::max<std::size_t>(1, std::min<std::size_t>(3, p.all.size())));
  p.width = 80 + 500 * p.columns;
  draw_panels(directory, p);
}

void draw_in_space(const std::filesystem::path& directory, const std::vector<space_row>& rows) {
  const auto walls = style::distinct(rows, [](const space_row& r) { return r.wall; });
  panels p{
      .name = "in_space",
      .title =
          "Three degrees of freedom: how deep the hand is in the wall. A level line glides, a zigzag bounces",
      .columns = static_cast<int>(std::max<std::size_t>(1, walls.size())),
      .width = 100 + 290 * static_cast<int>(std::max<std::size_t>(2, walls.size())),
      .row_height = 240,
      .settings =
          "set yrange [*:*] reverse\nset offsets 0,0,graph 0.05,graph 0.05\n"
          "set object 1 rectangle from graph 0, first 0 to graph 1, graph 0 behind fc rgb '#eeeeee' "
          "fs noborder\n"};
  for (const std::string& device : style::distinct(rows, [](const space_row& r) { return r.device; })) {
    for (const std::string& wall : walls) {
      panel one{device + ", " + wall, "path length [mm]", "depth [mm]", {}};
      for (const space_row& r : rows) {
        if (r.device != device || r.wall != wall || r.trace.empty()) continue;
        for (std::size_t k = 0; k < r.trace.front().second.size(); ++k) {
          curve c{.law = r.law, .points = {}, .dashed = k > 0};
          for (const auto& [way, depths] : r.trace) c.points.emplace_back(1e3 * way, 1e3 * depths[k]);
          one.curves.push_back(c);
          if (k > 0) p.dashed_means = "second wall of an edge";
        }
      }
      p.all.push_back(one);
    }
  }
  draw_panels(directory, p);
}

}  // namespace experiments
