// Figs. 8 to 10: ten panels over the path along the wall, one colour a law.
#include "../surface.hpp"
#include "picture_style.hpp"
#include "pictures.hpp"

#include <output.hpp>

#include <algorithm>
#include <iomanip>
#include <vector>

namespace experiments {

namespace {

constexpr int surface_points = 101;
constexpr double zoomed_out = 0.1;  // share of the depths in contact above the zoom, and below it

struct extent {
  style::range x, y, depth, normal, tangential;
  style::range zoom;  // depth of the law that keeps it best [mm]
};

style::range middle_of(std::vector<double> values) {
  style::range middle;
  std::sort(values.begin(), values.end());
  const auto out = static_cast<std::size_t>(zoomed_out * static_cast<double>(values.size()));
  for (std::size_t k = out; k + out < values.size(); ++k) middle.add(values[k]);
  return middle;
}

std::string figure_table(const test_wall& wall, const std::vector<named_run>& runs, extent& e) {
  style::table csv;
  for (const auto& [law, run] : runs) {
    csv.start_block(law,
                    "time [s], x [m], y [m], depth [mm], w1 [rad/s], w2 [rad/s], Fh into the wall [N], "
                    "Fh along the wall [N], alpha [1], capacity1 [N m], capacity2 [N m]");
    std::vector<double> in_contact;
    for (const instant& i : run.trace) {
      const plane_vector n = wall.gradient(i.position), along(-n[1], n[0]);
      const double depth = 1e3 * i.depth, normal = -i.hand_force.dot(n), tangential = i.hand_force.dot(along);
      csv.add({i.time, i.position[0], i.position[1], depth, i.rates[0], i.rates[1], normal, tangential,
               i.alpha, i.capacity[0], i.capacity[1]});
      e.x.add(i.position[0]);
      e.y.add(1e3 * i.position[1]);
      e.depth.add(depth);
      e.normal.add(normal);
      e.tangential.add(tangential);
      if (depth > 0) in_contact.push_back(depth);
    }
    const style::range most = middle_of(std::move(in_contact));
    if (e.zoom.empty() || most.width() < e.zoom.width()) e.zoom = most;
  }
  csv.start_block("surface", "x [m], y [m]");
  for (int k = 0; k < surface_points; ++k) {
    const double x = e.x.low() + (e.x.high() - e.x.low()) * k / (surface_points - 1);
    csv.add({x, surface_height(wall, x)});
    e.y.add(1e3 * surface_height(wall, x));
  }
  return csv.str();
}

// Beyond this x [m] the force approximation takes brake 2 alone: the nearest force lies on its edge.
double last_use_of_brake_1(const run_result& run) {
  double last = run.trace.front().position[0];
  for (const instant& i : run.trace)
    if (i.capacity[0] > 0) last = i.position[0];
  return last;
}

std::string legend_of(const std::vector<named_run>& runs) {
  std::vector<style::entry> entries;
  for (const named_run& r : runs) entries.push_back({r.law, style::colour_of(r.law)});
  entries.push_back({"inside the wall", style::wall_colour, "solid", style::area_width});
  return style::legend(entries, 0.948);
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
  // At the same place beside each panel, however wide its numbers are
  const auto label = [](const std::string& text) {
    return "set label 1 " + style::quoted(text) + " at graph -0.145,0.5 center rotate\n";
  };
  const std::string inside = "data index " + std::to_string(runs.size()) +
                             " using 1:(0):(1e3) with filledcurves fc rgb '" + style::wall_colour +
                             "', \\\n     ";
  const std::string last_row = "set xlabel 'x [m]' offset 0,0.4\nset format x '%.2f'\n";

  const auto panel = [&](const std::string& text, const std::string& columns, const std::string& before = "",
                         const std::string& under = "") {
    script << before << label(text) << "plot " << under << curves(columns);
  };
  const auto yrange = [](const std::string& r) { return "set yrange " + r + "\n"; };
  const std::string surface = "data index " + std::to_string(runs.size()) + " using 1:(1e3*$2)";

  script << style::terminal(1200, 1180) << "data = '" << name << ".csv'\n"
         << "set multiplot layout 5,2 columnsfirst margins 0.08,0.985,0.05,0.925 spacing 0.09,0.022 title "
         << style::quoted(title) << " font ',16'\n"
         << "unset key\nset xrange " << e.x.str() << "\nset format x ''\n"
         << legend_of(runs);
  panel("y [mm]", "2:(1e3*$3)", yrange(e.y.str()),
        surface + ":(" + std::to_string(e.y.high()) + ") with filledcurves fc rgb '" + style::wall_colour +
            "', \\\n     " + surface + " with lines lc rgb '#999999', \\\n     ");
  script << style::no_legend(runs.size() + 1);
  panel("depth [mm]", "2:4", yrange(e.depth.str()), inside);
  panel("depth, zoomed [mm]", "2:4", yrange(e.zoom.str()), inside);
  panel("Fh into the wall [N]", "2:7", yrange(e.normal.str()));
  panel("Fh along the wall [N]", "2:8", yrange(e.tangential.str()) + last_row);
  panel("w1 [rad/s]", "2:5",
        "unset xlabel\nset format x ''\nset yrange [*:*]\nset offsets 0,0,graph 0.05,0\n");
  panel("w2 [rad/s]", "2:6");
  std::ostringstream why;
  why << "set label 2 'beyond x = " << std::setprecision(2) << last_use_of_brake_1(runs.front().run)
      << " m the nearest force is that of brake 2 alone' at graph 0.98,0.9 right front\n";
  panel("capacity of brake 1 [N m]", "2:10", why.str());
  script << "unset label 2\n";
  panel("capacity of brake 2 [N m]", "2:11");
  script << "unset offsets\nset logscale y\nset yrange [1e-5:2]\nset format y '%g'\n"
         << "set label 2 'a law that is not drawn has alpha = 1, or none' at graph 0.02,0.07 left front\n"
         << last_row << label("alpha [1]") << "plot NaN";
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (runs[k].run.least_alpha >= 1) continue;
    script << ", \\\n     data index " << k << " using 2:($9 > 1e-5 ? $9 : 1e-5) with lines lw 1.2 lc rgb '"
           << style::colour_of(runs[k].law) << "'";
  }
  script << "\nunset multiplot\n";
  example::draw(directory, name, script.str());
}

}  // namespace experiments
