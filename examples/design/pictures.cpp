#include "pictures.hpp"

#include <output.hpp>

#include <sstream>

namespace design {

namespace {

// One figure of a planar device with `joints` joints over the workspace; figure: its column after `display`
// in to_csv. Points with `never` true get the last colour of the palette.
struct panel {
  std::string file, title;
  int joints, figure;
  double highest;  // of the colours
  std::string never;
};

std::string script_of(const panel& p) {
  std::ostringstream script;
  const int outcome = 2 + p.joints + 1, display = outcome + 1, column = display + p.figure;
  script << "set title '" << p.title << "'\nset cbrange [0:" << p.highest << "]\nplot '" << p.file
         << "' using 1:2:(strcol(" << outcome << ") ne 'ok' ? NaN : " << p.never << " ? 1e9 : least($"
         << column << ", " << 0.95 * p.highest << ")) with image\n";
  return script.str();
}

std::string display_is_none(int joints) {
  std::ostringstream condition;
  condition << "strcol(" << 2 + joints + 2 << ") eq 'none'";
  return condition.str();
}
std::string is_never_held(int joints) {
  std::ostringstream condition;
  condition << "$" << 2 + joints + 6 << " > 1e9";
  return condition.str();
}

// The grey background marks points without figures
std::string four_maps(const std::string& title) {
  return picture_of(1000, 660) + "set multiplot layout 2,2 title '" + title +
         "'\nunset key\nleast(a, b) = a < b ? a : b\nset size ratio -1\nset autoscale noextend\n"
         "set xlabel 'x [m]'\nset ylabel 'y [m]'\nset xtics 0.1\nset ytics 0.1\n"
         "set object 1 rectangle from graph 0, graph 0 to graph 1, graph 1 fc rgb '#bbbbbb' fs solid "
         "noborder behind\n"
         "set palette defined (0 '#f7fbff', 0.3 '#9ecae1', 0.6 '#4292c6', 0.95 '#08306b', 0.951 '#d55e00', 1 "
         "'#d55e00')\n";
}

}  // namespace

std::string picture_of(int width, int height) {
  std::ostringstream script;
  script << "set encoding utf8\nset terminal svg noenhanced size " << width << "," << height
         << " font 'sans,13' background 'white'\nset output output\nset datafile separator ','\n"
            "set key autotitle columnhead\nset border lc rgb '#666666'\n"
            "set tics textcolor rgb 'black' nomirror\n";
  return script.str();
}

void draw_map(const std::filesystem::path& directory, const std::string& name, const std::string& title,
              const std::string& csv) {
  const std::string file = name + ".csv";
  example::write_file(directory / file, csv);
  const std::string none = display_is_none(2);
  std::string script = four_maps(title);
  for (const panel& p : {panel{file, "Drag for each newton of the wall [N]", 2, 2, 3, none},
                         panel{file, "Strongest normal force of brakes of 1 N m [N]", 2, 3, 20, none},
                         panel{file, "Sink slope under a push of 2 N", 2, 4, 1.5, is_never_held(2)},
                         panel{file, "Isotropy", 2, 5, 1.06, "0"}})
    script += script_of(p);
  example::draw(directory, name, script + "unset multiplot\n");
}

void draw_devices(const std::filesystem::path& directory, const std::string& name, const std::string& title,
                  const std::vector<std::pair<std::string, std::string>>& maps) {
  std::string script = four_maps(title);
  int number = 0;
  for (const auto& [device, csv] : maps) {
    const std::string file = name + "_" + std::to_string(++number) + ".csv";
    example::write_file(directory / file, csv);
    const int joints = csv.find(",q3,") != std::string::npos ? 3 : 2;
    if (device.rfind("Five-bar", 0) == 0) script += "set xtics 0.04\nset ytics 0.04\n";
    script += script_of({file, device, joints, 4, 1.5, is_never_held(joints)});
    script += "set xtics 0.1\nset ytics 0.1\n";
  }
  example::draw(directory, name, script + "unset multiplot\n");
}

void draw_reductions(const std::filesystem::path& directory, const std::string& name,
                     const std::vector<std::pair<double, task_figures>>& by_reduction) {
  std::ostringstream csv;
  csv << "k2,displayed,held,drag,max_force\n";
  for (const auto& [k2, f] : by_reduction)
    csv << k2 << "," << 100 * (f.exact + f.approximate) << "," << 100 * f.held << "," << f.drag << ","
        << f.max_force << "\n";
  example::write_file(directory / (name + ".csv"), csv.str());
  const std::string file = name + ".csv";
  std::ostringstream script;
  script << picture_of(1000, 380)
         << "set multiplot layout 1,2 title 'The paper chose k2 = 0.4 (dashed): the reduction of brake 2, "
            "over all "
            "directions along walls'\n"
         << "set logscale x\nset xrange [0.2:2.5]\nset xlabel 'k2'\nset xtics (0.2,0.4,0.6,1,1.6,2.5)\nset "
            "grid lc rgb '#dddddd'\n"
         << "set arrow 1 from 0.4, graph 0 to 0.4, graph 1 nohead dt 2 lc rgb '#444444'\n"
         << "set ylabel 'share of places and directions [%]'\nset yrange [50:90]\nset key bottom left Left "
            "reverse samplen 2\n"
         << "plot '" << file
         << "' using 1:2 with lines lw 3 lc rgb '#0072b2' title 'a wall can be displayed', '" << file
         << "' using 1:3 with lines lw 3 lc rgb '#d55e00' title 'a push of 2 N is held by brakes of 1 N m'\n"
         << "set ylabel 'strongest normal force, mean [N]'\nset yrange [0:25]\nset key top right\n"
         << "plot '" << file
         << "' using 1:5 with lines lw 3 lc rgb '#009e73' title 'brakes of 1 N m'\nunset multiplot\n";
  example::draw(directory, name, script.str());
}

}  // namespace design
