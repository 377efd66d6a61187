// Figs. 8 to 10: eight panels over the path along the wall, one colour per law.
#include "picture_style.hpp"
#include "pictures.hpp"

#include <output.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace experiments {

namespace {

constexpr int surface_points = 101;
constexpr std::size_t alpha_mean = 8;  // samples of the trace: 40 ms, two time constants of the brakes

struct extent {
  style::range x, y, depth, normal, tangential, torque;
};

std::string figure_table(const test_wall& wall, const std::vector<named_run>& runs, extent& e) {
  style::table csv;
  for (const auto& [law, run] : runs) {
    csv.start_block(law,
                    "time [s], x [m], y [m], depth [mm], w1 [rad/s], w2 [rad/s], Fh into the wall [N], "
                    "Fh along the wall [N], alpha [1], capacity1 [N m], capacity2 [N m], torque1 [N m], "
                    "torque2 [N m], mean alpha of 40 ms [1]");
    double alpha_sum = 0;
    for (std::size_t k = 0; const instant& i : run.trace) {
      const plane_vector n = wall.gradient(i.position), along(-n[1], n[0]);
      const double depth = 1e3 * i.depth, normal = -i.hand_force.dot(n), tangential = i.hand_force.dot(along);
      alpha_sum += i.alpha - (k < alpha_mean ? 0 : run.trace[k - alpha_mean].alpha);
      csv.add({i.time, i.position[0], i.position[1], depth, i.rates[0], i.rates[1], normal, tangential,
               i.alpha, i.capacity[0], i.capacity[1], std::abs(i.brake_torque[0]),
               std::abs(i.brake_torque[1]), alpha_sum / static_cast<double>(std::min(++k, alpha_mean))});
      e.x.add(i.position[0]);
      e.y.add(1e3 * i.position[1]);
      e.depth.add(depth);
      e.normal.add(normal);
      e.tangential.add(tangential);
      e.torque.add(i.brake_torque.cwiseAbs().maxCoeff());
    }
  }
  csv.start_block("surface", "x [m], y [m]");
  for (int k = 0; k < surface_points; ++k) {
    const double x = e.x.low() + (e.x.high() - e.x.low()) * k / (surface_points - 1);
    csv.add({x, height_before(wall, x)});
    e.y.add(1e3 * height_before(wall, x));
  }
  return csv.str();
}

// Legend: a law and its figures.
std::vector<style::entry> entries_of(const std::vector<named_run>& runs) {
  std::vector<style::entry> entries;
  for (const auto& [law, run] : runs) {
    const int n = run.figures.separations;
    entries.push_back(
        {law + ": " + std::to_string(n) + (n == 1 ? " separation" : " separations"), style::colour_of(law)});
  }
  return entries;
}

}  // namespace

void draw_figure(const std::filesystem::path& directory, const std::string& name, const std::string& title,
                 const test_wall& wall, const std::vector<named_run>& runs) {
  style::require_traces(name, runs);
  extent e;
  example::write_file(directory / (name + ".csv"), figure_table(wall, runs, e));

  std::ostringstream script;
  const auto curves = [&](const std::string& columns) {
    std::ostringstream text;
    for (std::size_t k = 0; k < runs.size(); ++k) {
      text << (k == 0 ? "" : ", \\\n     ") << "data index " << k << " using " << columns << " with lines lw "
           << (k + 1 == runs.size() ? 1.8 : 1.2) << " lc rgb '" << style::colour_of(runs[k].law) << "'";
    }
    return text.str() + "\n";
  };
  // A fixed position next to each panel, independent of the width of its numbers
  const auto label = [](const std::string& text) {
    return "set label 1 " + style::quoted(text) + " at graph -0.145,0.5 center rotate\n";
  };
  const auto panel = [&](const std::string& text, const std::string& columns, const std::string& before = "",
                         const std::string& under = "") {
    script << before << label(text) << "plot " << under << curves(columns);
  };
  const auto yrange = [](const style::range& r) { return "set yrange " + r.str() + "\n"; };
  const std::string surface = "data index " + std::to_string(runs.size()) + " using 1:(1e3*$2)";
  const std::string last_row = "set xlabel 'x [m]' offset 0,0.4\nset format x '%.2f'\n",
                    other_rows = "unset xlabel\nset format x ''\n";
  const auto entries = entries_of(runs);
  std::ostringstream depth;  // downwards, as depth into the wall
  depth << "set yrange [" << e.depth.high() << ":" << e.depth.low()
        << "]\nset label 2 'inside the wall' at graph "
        << "0.98,0.08 right front textcolor rgb '#555555'\n";

  script << style::terminal(1200, 1000) << "data = '" << name << ".csv'\n"
         << "set multiplot layout 4,2 columnsfirst margins 0.08,0.985,0.06,0.895 spacing 0.09,0.025 title "
         << style::quoted(title) << " font ',16'\n"
         << "unset key\nset xrange " << e.x.str() << "\n"
         << other_rows << style::legend(entries, 0.935, 0.02);
  panel(
      "y [mm]", "2:(1e3*$3)",
      yrange(e.y) + "set label 2 'inside the wall' at graph 0.98,0.92 right front textcolor rgb '#555555'\n",
      surface + ":(" + std::to_string(e.y.high()) + ") with filledcurves fc rgb '" + style::wall_colour +
          "', \\\n     " + surface + " with lines lc rgb '#999999', \\\n     ");
  script << style::no_legend(entries.size());
  panel("depth [mm]", "2:4", depth.str(),
        "data index " + std::to_string(runs.size()) + " using 1:(0):(1e3) with filledcurves fc rgb '" +
            style::wall_colour + "', \\\n     ");
  panel("Fh into the wall [N]", "2:7", "unset label 2\n" + yrange(e.normal));
  panel("Fh along the wall [N]", "2:8", yrange(e.tangential) + last_row);
  panel("rate of brake 2 [rad/s]", "2:6", other_rows + "set yrange [*:*]\nset offsets 0,0,graph 0.05,0\n");
  panel("torque of brake 1 [N m]", "2:12", "unset offsets\n" + yrange(e.torque));
  panel("torque of brake 2 [N m]", "2:13");
  script << last_row
         << "set yrange [-0.05:1.3]\nset label 2 'a law that is not drawn has alpha = 1, or none' at "
         << "graph 0.98,0.9 right front textcolor rgb '#555555'\n"
         << label("alpha [1], mean of 40 ms") << "plot NaN";
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (runs[k].run.min_alpha < 1)
      script << ", \\\n     data index " << k << " using 2:14 with lines lw 1.2 lc rgb '"
             << style::colour_of(runs[k].law) << "'";
  }
  script << "\n";
  script << "unset multiplot\n";
  example::draw(directory, name, script.str());
}

}  // namespace experiments
