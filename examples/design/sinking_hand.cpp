#include "sinking_hand.hpp"

#include <passive_haptics/passive_haptics.hpp>

#include <output.hpp>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>

namespace design {

namespace {

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;
using V = ph::vector<double, 2>;

constexpr double torque_limit = 0.3;       // each brake [N m]
constexpr double pushes[] = {1, 2, 4, 8};  // of the hand into the wall [N]
const V out_of_wall(0, -1);                // the normal of the paper's wall
constexpr int forth = 1, back = -1;        // along the wall, +x and -x

const auto brakes = ph::hybrid_brakes<device>::with_limits({torque_limit, torque_limit});

// Colours of a slope, on one scale for all pictures.
constexpr const char* slope_colours =
    "set palette defined (0 '#ffffff', 0.001 '#deebf7', 0.5 '#9ecae1', 1 '#4292c6', 2 '#08519c', 3 "
    "'#08306b')\n"
    "set cbrange [0:3]\n";

}  // namespace

void draw_sink_slopes(const std::filesystem::path& directory) {
  const device arm;
  constexpr double step = 0.003;  // [m]
  constexpr int cells = 100;      // on each side of the base
  std::ostringstream table;
  table << "# x [m], y [m], sink slope along -x [1], along +x [1]; -1: held at no slope\n";
  for (int j = -cells; j <= cells; ++j) {
    for (int i = -cells; i <= cells; ++i) {
      const auto pose = arm.inverse({step * i, step * j}, ph::elbow::left);
      table << step * i << ", " << step * j;
      for (const int way : {back, forth}) {
        const auto found = ph::sink_slope(arm, pose.q, {way, 0}, out_of_wall, brakes, 2.0);
        if (pose.outcome != ph::status::ok || found.outcome != ph::status::ok) table << ", NaN";
        else table << ", " << (std::isfinite(found.slope) ? found.slope : -1);
      }
      table << "\n";
    }
    table << "\n";
  }
  example::write_file(directory / "sink_slopes.csv", table.str());
  example::draw(directory, "sink_slopes", std::string(R"gnuplot(
set encoding utf8
set terminal svg noenhanced size 1100,560 font 'sans,13' background 'white'
set output output
set datafile separator ','
set multiplot layout 1,2 title "How steeply a hand of 2 N sinks into a wall (y = const, the hand below it): the paper's device, brakes of 0.3 N m" font ',15'
set size ratio -1
set xrange [-0.31:0.31]
set yrange [-0.31:0.31]
set xlabel 'x [m]'
set ylabel 'y [m]'
set cblabel 'sink slope [m into the wall for each m along it]'
set border lc rgb '#666666'
set tics nomirror
unset key
set label 1 'wall of the paper' at 0.11,0.25 center front tc rgb '#b04400'
set arrow 1 from 0.045,0.225 to 0.17,0.225 nohead lw 3 lc rgb '#d55e00' front
set object 1 circle at 0,0 size 0.006 fc rgb '#333333' fs solid front
set object 2 rectangle from graph 0,0 to graph 1,1 fc rgb '#e0e0e0' fs solid noborder behind
)gnuplot") + slope_colours + R"gnuplot(
do for [k=0:1] {
  set title (k == 0 ? 'led back, along -x' : 'led forth, along +x')." (white: held; black: at no slope; grey: out of reach)"
  plot 'sink_slopes.csv' using 1:2:(column(3+k) < 0 ? NaN : column(3+k)) with image, \
       '' using (column(3+k) == -1 ? $1 : NaN):2 with points pt 5 ps 0.24 lc rgb '#111111'
}
unset multiplot
)gnuplot");
}

void compare_motors(const std::filesystem::path& directory) {
  const device arm;
  constexpr double from = 0.045, to = 0.17, height = 0.225;  // [m], section 5.1
  const auto along = [&](int way) {
    return [=, &arm](double u) {
      const double x = way == forth ? from + (to - from) * u : to - (to - from) * u;
      return ph::path_point<device>{arm.inverse(V(x, height), ph::elbow::left).q, {way, 0}, out_of_wall};
    };
  };
  std::puts("\nAlong the paper's wall, brakes of 0.3 N m:\n");
  std::puts("  way     push [N]   sinks [mm]   motors that hold it [% of the brakes' limit]");
  for (const int way : {forth, back})
    for (const double push : pushes) {
      const double depth = ph::sink_depth(arm, along(way), brakes, push);
      std::printf("  %-6s %9.0f ", way == forth ? "forth" : "back", push);
      if (std::isfinite(depth)) std::printf("%12.2f", 1e3 * depth);
      else std::printf("%12s", "not held");
      std::printf(" %12.1f\n", 100 * ph::min_motor_share(arm, along(way), brakes.brakes, push));
    }

  constexpr int places = 200;
  std::ostringstream table;
  for (const double push : pushes) {
    table << "# x [m], sink slope [1], least motor share [%]: led back, push " << push << " N\n";
    for (int k = 0; k < places; ++k) {
      const auto at = along(back)((k + 0.5) / places);
      const double slope = ph::sink_slope(arm, at.q, at.direction, at.normal, brakes, push).slope;
      const double share = ph::min_motor_share(arm, at.q, at.direction, at.normal, brakes.brakes, push).share;
      table << arm.position(at.q)[0] << ", " << slope << ", " << 100 * share << "\n";
    }
    table << "\n\n";
  }
  example::write_file(directory / "min_motors.csv", table.str());
  example::draw(directory, "min_motors", R"gnuplot(
set encoding utf8
set terminal svg noenhanced size 1100,460 font 'sans,13' background 'white'
set output output
set datafile separator ','
set multiplot layout 1,2 title "Back along the paper's wall, brakes of 0.3 N m" font ',15'
set grid lc rgb '#dddddd' lt 1
set border lc rgb '#666666'
set xlabel 'x [m], led from right to left'
set xrange [0.04:0.175]
set yrange [0:2.7]
set key left top
color(k) = word('#0072b2 #009e73 #e69f00 #d55e00', k)
push(k) = word('1 2 4 8', k)
set title 'without motors: how steeply the hand sinks'
set ylabel 'sink slope [m/m]'
plot for [k=1:4] 'min_motors.csv' index k-1 using 1:2 with lines lw 11-2*k lc rgb color(k) title push(k).' N'.(k == 4 ? ', left of 0.1 m at no slope' : '')
set title 'with motors: how much holds it'
set yrange [0:160]
set ylabel "motor beside each brake [% of the brake's limit]"
plot for [k=1:4] 'min_motors.csv' index k-1 using 1:3 with lines lw 3 lc rgb color(k) title push(k).' N'
unset multiplot
)gnuplot");
}

}  // namespace design
