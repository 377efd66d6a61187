// The main job: a hand moves the paper's device along a virtual wall (section 5), with and without direct
// control, the environment updated at 1 kHz and at 20 Hz; beside it the XY table of Fig. 4. Prints a table,
// leaves CSV and plots.
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/wall_following.hpp>

#include <output.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <string>

namespace ph = passive_haptics;
using plane_vector = ph::vector<double, 2>;

namespace {

// The wall of section 5.2, free below, and the way along it.
const ph::half_space<2> surface({0, 0.225}, {0, -1});
constexpr double start_x = 0.045;              // [m]
constexpr double start_gap = 0.004;            // off the wall [m]
const plane_vector start_velocity(0.05, 0.1);  // along the wall and into it [m/s]
constexpr int kept_every = 50;                 // time steps between two lines of the CSV
double most_power = 0;                         // that any brake gave to its device in any run [W]

template <class M>
std::string csv_line(const ph::wall_following_sample<M>& s) {
  std::ostringstream line;
  line << s.time << ", " << s.position[0] << ", " << s.position[1] << ", " << s.depth << ", " << s.rates[0]
       << ", " << s.rates[1] << ", " << s.hand_force[0] << ", " << s.hand_force[1] << ", " << s.control->alpha
       << ", " << s.control->capacity[0] << ", " << s.control->capacity[1] << ", " << s.brake_torque[0]
       << ", " << s.brake_torque[1] << "\n";
  return line.str();
}
constexpr const char* csv_header =
    "time [s], x [m], y [m], depth [m], w1 [rad/s], w2 [rad/s], Fh_x [N], Fh_y [N], alpha [1], capacity1 [N "
    "m], "
    "capacity2 [N m], t1 [N m], t2 [N m]\n";

// One run: returns the CSV, prints a line of the table.
template <class M, class Law>
std::string follow(const char* device_name, const M& arm, const ph::joint_vector<M>& q,
                   const ph::brakes_of<M>& brakes, const char* law_name, Law law, double environment_rate,
                   const ph::wall_following_parameters& experiment = {}) {
  ph::controller control(arm, brakes, ph::held_scene(ph::scene(ph::wall(surface)), 1 / environment_rate),
                         law);
  const ph::following_hand<double, 2> hand({1, 0}, arm.position(q));
  ph::simulated_device device(arm, brakes, hand.parameters().mass, q);
  const ph::matrix<double, 2, 2> J(ph::jacobian(arm, q));
  device.set_motion(q, J.partialPivLu().solve(start_velocity));

  std::string csv = csv_header;
  int step = 0;
  const auto figures = ph::follow_wall(device, control, surface, hand, experiment, [&](const auto& sample) {
    if (step++ % kept_every == 0) csv += csv_line<M>(sample);
  });
  std::printf("%-10s %5.0f Hz  %-18s %11d %11.3f %11.3f %9.0f %% %11.2f %9.1f%s\n", device_name,
              environment_rate, law_name, figures.separations, 1e3 * figures.depth_std,
              1e3 * figures.depth_range, 100 * figures.stick_share, figures.retarding_force,
              1e3 * figures.brake_energy, figures.arrived ? "" : "   (did not arrive)");
  most_power = std::max(most_power, figures.largest_brake_power);
  std::fflush(stdout);
  return csv;
}

std::string plot_script(const std::string& name, double environment_rate) {
  std::ostringstream script;
  script << "set terminal svg size 900,1150 font 'sans,12' background 'white'\nset output output\n"
         << "set datafile separator ','\n"
         << "without = '" << name << "_no_direct_control.csv'\nwith = '" << name << "_direct_control.csv'\n"
         << "set multiplot layout 5,1 title 'Tendon device along the wall y = 0.225 m, environment at "
         << environment_rate << " Hz'\n"
         << R"(set lmargin at screen 0.09
set rmargin at screen 0.74
set grid lc rgb '#dddddd'
set xrange [0.04:0.175]
set xlabel 'x [m]'
set style data lines
set style line 1 lw 1.5 lc rgb '#d55e00'
set style line 2 lw 1.5 lc rgb '#0072b2'
set key outside right
set ytics nomirror
set ylabel 'y [m]'
plot 0.225 lc rgb '#999999' dt 2 title 'wall (free below)', \
     without every ::1 using 2:3 ls 1 title 'no direct control', with every ::1 using 2:3 ls 2 title 'direct control'
set ylabel 'depth [mm]'
plot 0 lc rgb '#999999' dt 2 title 'surface', without every ::1 using 2:(1e3*$4) ls 1 title 'no direct control', \
     with every ::1 using 2:(1e3*$4) ls 2 title 'direct control'
set ylabel 'brake rate [rad/s]'
plot without every ::1 using 2:6 ls 1 title 'w2, no direct control', with every ::1 using 2:6 ls 2 title 'w2, direct control', \
     with every ::1 using 2:5 lc rgb '#009e73' title 'w1, direct control'
set ylabel 'hand force [N]'
plot without every ::1 using 2:8 ls 1 title 'Fh y, no direct control', with every ::1 using 2:8 ls 2 title 'Fh y, direct control', \
     with every ::1 using 2:7 lc rgb '#009e73' title 'Fh x, direct control'
set ylabel 'alpha [1]'
set logscale y
set format y '10^{%T}'
set yrange [1e-6:2]
plot with every ::1 using 2:($9 > 0 ? $9 : 1e-6) ls 2 title 'direct control'
unset multiplot
)";
  return script.str();
}

}  // namespace

int main(int argc, char** argv) try {
  const auto directory = example::output_directory(
      argc, argv,
      "03_wall_following: two devices along a virtual wall, as a table, CSV files and wall_following_*.svg");

  const ph::tendon_two_link<double> arm;
  const ph::brakes_of<ph::tendon_two_link<double>> brakes;  // 1 N m, lag 20 ms, dead band 0.02 rad/s
  const plane_vector start(start_x, 0.225 - start_gap);
  const auto q = arm.inverse(start, ph::elbow::left).q;

  const ph::xy_table<double> table;
  ph::brakes_of<ph::xy_table<double>> slide_brakes;  // the same, felt at 0.1 m from the axis
  slide_brakes.torque_limit.setConstant(10);         // [N]
  slide_brakes.rate_dead_band.setConstant(0.002);    // [m/s]
  ph::wall_following_parameters linear;
  linear.encoder_resolution *= 0.1;  // 8192 counts a turn, 0.1 m from the axis [m]

  std::printf("%-10s %8s  %-18s %11s %11s %11s %11s %11s %9s\n", "device", "environ.", "law", "separations",
              "depth std", "depth range", "brake 2", "retarding", "brakes");
  std::printf("%-10s %8s  %-18s %11s %11s %11s %11s %11s %9s\n", "", "", "", "", "[mm]", "[mm]", "sticks",
              "force [N]", "take [mJ]");
  for (const double rate : {1000.0, 20.0}) {
    const std::string name = "wall_following_" + std::to_string(static_cast<int>(rate)) + "Hz";
    example::write_file(directory / (name + "_no_direct_control.csv"),
                        follow("tendon", arm, q, brakes, "no direct control", ph::no_direct_control(), rate));
    example::write_file(directory / (name + "_direct_control.csv"),
                        follow("tendon", arm, q, brakes, "direct control", ph::direct_control(), rate));
  }
  for (const double rate : {1000.0, 20.0}) {
    follow("XY table", table, start, slide_brakes, "no direct control", ph::no_direct_control(), rate,
           linear);
    follow("XY table", table, start, slide_brakes, "direct control", ph::direct_control(), rate, linear);
  }
  std::puts(
      "\nCounted from the first contact; depth figures after the first 10 % of the path. A separation is a "
      "contact\n"
      "followed by a gap of more than 10 um. Sensors: encoders of 8192 counts a turn, rates low-passed at 50 "
      "Hz, "
      "force at\n"
      "200 Hz. Bouncing is chaotic: read bands, not digits.");
  std::printf("The most power that a brake gave to its device in any time step: %.0e W.\n\n", most_power);

  for (const double rate : {1000.0, 20.0}) {
    const std::string name = "wall_following_" + std::to_string(static_cast<int>(rate)) + "Hz";
    example::draw(directory, name, plot_script(name, rate));
    std::printf("data:    %s\n", std::filesystem::weakly_canonical(directory / (name + "_*.csv")).c_str());
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
