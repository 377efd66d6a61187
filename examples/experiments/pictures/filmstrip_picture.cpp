// The tendon device along a wall in frames.
#include "../surface.hpp"
#include "picture_style.hpp"
#include "pictures.hpp"

#include <output.hpp>

namespace experiments {

namespace {

constexpr std::size_t frames = 7;
constexpr double exaggeration = 10;                                        // of the distance from the wall
constexpr double left = -0.085, right = 0.205, bottom = -0.02, top = 0.3;  // of a frame [m]

std::size_t last_of_frame(const run_result& run, std::size_t frame) {
  return (run.trace.size() - 1) * (frame + 1) / frames;
}

// Two blocks per frame: links, trace so far.
void add_frame(style::table& csv, const test_wall& wall, const named_run& r, std::size_t frame) {
  const ph::tendon_two_link<double> arm;
  const std::size_t last = last_of_frame(r.run, frame);
  const plane_vector handle = r.run.trace[last].position;
  const plane_vector elbow = arm.pose(arm.inverse(handle, ph::elbow::left).q).link_1;
  csv.start_block(r.law + ", links", "x [m], y [m]");
  for (const plane_vector& joint : {plane_vector(0, 0), elbow, handle}) csv.add({joint[0], joint[1]});
  csv.start_block(r.law + ", trace, ten times as far from the wall", "x [m], y [m]");
  for (std::size_t k = 0; k <= last; ++k) {
    const instant& i = r.run.trace[k];
    const plane_vector x = i.position - (exaggeration - 1) * i.depth * wall.gradient(i.position);
    csv.add({x[0], x[1]});
  }
}

}  // namespace

void draw_filmstrip(const std::filesystem::path& directory, const std::string& name, const std::string& title,
                    const test_wall& wall, const std::vector<named_run>& runs) {
  style::require_traces(name, runs);
  style::table csv;
  csv.start_block("surface", "x [m], y [m]");
  constexpr int surface_points = 61;
  for (int k = 0; k < surface_points; ++k) {
    const double x = left + (right - left) * k / (surface_points - 1);
    csv.add({x, surface_height(wall, x)});
  }
  for (const named_run& r : runs)
    for (std::size_t k = 0; k < frames; ++k) add_frame(csv, wall, r, k);
  example::write_file(directory / (name + ".csv"), csv.str());

  const std::size_t rows = runs.size();
  const double height = 70 + 235 * static_cast<double>(rows);
  std::ostringstream script;
  script << style::terminal(1240, static_cast<int>(height)) << "data = '" << name
         << ".csv'\nset multiplot layout " << rows << "," << frames << " margins 0.055,0.995," << 45 / height
         << "," << 1 - 60 / height << " spacing 0.006," << 30 / height << " title "
         << style::quoted(title + "; trace: distance from the wall 10 times as large") << " font ',16'\n"
         << "set size ratio -1\nset xrange [" << left << ":" << right << "]\nset yrange [" << bottom << ":"
         << top << "]\nset xtics 0,0.1\nset ytics 0,0.1\nunset key\n";
  std::size_t block = 1;
  for (std::size_t row = 0; row < rows; ++row) {
    const std::string colour = style::colour_of(runs[row].law);
    const auto& trace = runs[row].run.trace;
    for (std::size_t k = 0; k < frames; ++k, block += 2) {
      script << (k == 0 ? "set ylabel 'y [m]' offset 1.5,0\nset format y '%.1f'\n"
                        : "unset ylabel\nset format y ''\n")
             << (row + 1 == rows ? "set xlabel 'x [m]' offset 0,0.5\nset format x '%.1f'\n"
                                 : "set format x ''\n")
             << "set label 1 " << style::quoted(k == 0 ? runs[row].law : "")
             << " at graph 0,1.06 left front textcolor rgb '" << colour << "'\nset label 2 sprintf('%.1f s', "
             << trace[last_of_frame(runs[row].run, k)].time
             << ") at graph 0.96,0.93 right front\nplot data index 0 using 1:2:(" << top
             << ") with filledcurves fc rgb '" << style::wall_colour
             << "', \\\n     data index 0 using 1:2 with lines lc rgb '#999999', \\\n     data index "
             << block << " using 1:2 with lines lw 5 lc rgb '#b0b0b0', \\\n     data index " << block
             << " using 1:2 with points pt 7 ps 0.8 lc rgb '#555555', \\\n     data index " << block + 1
             << " using 1:2 with lines lw 2 lc rgb '" << colour << "'\n";
    }
  }
  script << "unset multiplot\n";
  example::draw(directory, name, script.str());
}

}  // namespace experiments
