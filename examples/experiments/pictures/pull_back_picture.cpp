// Fig. 5 (b): the tendon device with brake 2 locked inside a wall, and the effect of direct control.
#include "picture_style.hpp"
#include "pictures.hpp"

#include <output.hpp>

#include <Eigen/LU>

#include <cstdio>
#include <sstream>

namespace experiments {

namespace {

using arm_type = ph::tendon_two_link<double>;

constexpr double handle_x = 0.155, depth = 0.5e-3;  // [m]
constexpr double speed = 0.05;                      // with brake 2 locked [m/s]
constexpr double hand_mass = 0.5;                   // as in the runs [kg]
constexpr double scale = 0.045;                     // of the picture [m/N]
constexpr double cone_radius = 0.075;               // in the picture [m]
const plane_vector hand_force(2.0, 2.0);            // along the wall and into it [N]
constexpr double wall_y = 0.225;                    // [m]
const ph::half_space<2> surface({0, wall_y}, {0, -1});

struct still {
  plane_vector handle, elbow, normal;
  plane_vector brake_force;  // of the brakes [N]
  std::vector<plane_vector> cone;
  ph::step_result<arm_type> control;
};

std::vector<plane_vector> cone_outline(const plane_vector& apex, const ph::matrix<double, 2, 2>& G,
                                       const plane_vector& signs) {
  const plane_vector a = -signs[0] * G.col(0).normalized(), b = -signs[1] * G.col(1).normalized();
  constexpr int chords = 24;
  std::vector<plane_vector> outline{apex};
  for (int k = 0; k <= chords; ++k) {
    const double share = static_cast<double>(k) / chords;
    outline.push_back(apex + cone_radius * ((1 - share) * a + share * b).normalized());
  }
  outline.push_back(apex);
  return outline;
}

still press(bool under_direct_control) {
  const arm_type arm;
  ph::brakes_of<arm_type> brakes;
  brakes.time_constant.setZero();  // a still picture: the lag is over
  const plane_vector x(handle_x, wall_y + depth);
  const auto q = arm.inverse(x, ph::elbow::left).q;

  // With brake 2 locked, the handle only moves along the first column of E
  plane_vector v = ph::brake_jacobian(arm, q).col(0);
  v *= (v[0] > 0 ? speed : -speed) / v.norm();
  const ph::matrix<double, 2, 2> J(ph::jacobian(arm, q));
  const plane_vector qd = J.partialPivLu().solve(v);

  const auto touched = ph::sense(ph::scene(ph::wall(surface)), ph::point<2>(x));
  const auto step = [&]<class Law>(const Law& law) {
    ph::step_memory<Law> memory;
    return ph::step(arm, brakes, touched, law, ph::device_state<arm_type>{0, q, qd, hand_force}, memory);
  };
  still s;
  s.control = under_direct_control ? step(ph::direct_control()) : step(ph::no_direct_control());
  ph::simulated_device device(arm, brakes, hand_mass, q);
  device.set_motion(q, qd);
  device.advance(1e-4, s.control.capacity, hand_force);
  s.brake_force = device.brake_force();
  s.handle = x;
  s.elbow = arm.pose(q).link_1;
  s.normal = touched[0].normal;
  s.cone = cone_outline(x, ph::reference_forces(arm, q).G, s.control.signs);
  return s;
}

void add_arrow(style::table& csv, const char* name, const plane_vector& from, const plane_vector& length) {
  csv.start_block(name, "x [m], y [m], dx [m], dy [m]");
  csv.add({from[0], from[1], length[0], length[1]});
}

constexpr int blocks_of_still = 6;
void add_still(style::table& csv, const still& s) {
  const plane_vector resultant = hand_force + s.brake_force;
  csv.start_block("links", "x [m], y [m]");
  for (const plane_vector& joint : {plane_vector(0, 0), s.elbow, s.handle}) csv.add({joint[0], joint[1]});
  csv.start_block("cone of producible forces", "x [m], y [m]");
  for (const plane_vector& corner : s.cone) csv.add({corner[0], corner[1]});
  add_arrow(csv, "Fd, its direction only", s.handle, cone_radius * s.normal);
  add_arrow(csv, "Fh", s.handle, scale * hand_force);
  add_arrow(csv, "Fc", s.handle + scale * hand_force, scale * s.brake_force);
  add_arrow(csv, "Fr", s.handle, scale * resultant);
}

std::string text(const char* format, double value) {
  char line[100];
  std::snprintf(line, sizeof line, format, value);
  return line;
}

// Names are next to the middle of their arrows; a number states the result.
std::string labels(const still& s) {
  std::ostringstream script;
  int number = 0;
  const auto put = [&](const std::string& what, const plane_vector& at, const char* place,
                       const std::string& colour) {
    script << "set label " << ++number << " " << style::quoted(what) << " at " << at[0] << "," << at[1] << " "
           << place << " front textcolor rgb '" << colour << "'\n";
  };
  const plane_vector tip = s.handle + scale * hand_force, Fr = hand_force + s.brake_force;
  const double outward = Fr.dot(s.normal);
  put("Fh", s.handle + 0.5 * scale * hand_force + plane_vector(-0.004, 0.003), "right", "#0072b2");
  put("Fc", tip + 0.5 * scale * s.brake_force + plane_vector(0.007, 0.003), "left", "#d55e00");
  put("Fr", s.handle + scale * Fr + plane_vector(0.004, -0.001), "left", "#000000");
  put("Fd", s.handle + cone_radius * s.normal + plane_vector(0.003, -0.004), "left", "#777777");
  const plane_vector corner(0.085, 0.072);
  put(text("Fd = %.0f N, not to scale", s.control.desired_force.norm()), corner, "left", "#000000");
  put(text("approximation angle = %.0f deg", ph::degrees(s.control.approximation_angle())),
      corner - plane_vector(0, 0.018), "left", "#000000");
  put(text("alpha = %.2g", s.control.alpha) + text(", Fc made by brake 2 = %.2f N", s.brake_force.norm()),
      corner - plane_vector(0, 0.036), "left", "#000000");
  put(std::abs(outward) < 5e-3 ? "Fr out of the wall = 0: no pull-back"
                               : text("Fr out of the wall = %.2f N: pull-back", outward),
      corner - plane_vector(0, 0.054), "left", "#000000");
  return script.str();
}

}  // namespace

void draw_pull_back(const std::filesystem::path& directory) {
  const std::array stills{press(false), press(true)};
  style::table csv;
  for (const still& s : stills) add_still(csv, s);
  example::write_file(directory / "pull_back.csv", csv.str());

  std::ostringstream script;
  script << style::terminal(1200, 760) << R"(data = 'pull_back.csv'
set multiplot layout 1,2 margins 0.07,0.985,0.085,0.87 spacing 0.07,0 title 'A hand presses the tendon device on a wall while brake 2 is locked (Fig. 5)' font ',16'
set size ratio -1
set xrange [-0.02:0.29]
set yrange [-0.01:0.335]
set xlabel 'x [m]'
set ylabel 'y [m]'
unset key
)"
         << style::legend({{"hand force Fh", "#0072b2"},
                           {"brake force Fc", "#d55e00"},
                           {"resultant Fr", "#000000"},
                           {"desired force Fd", "#999999", "(8,5)"},
                           {"producible", "#c6e6da", "solid", style::area_width},
                           {"wall", style::wall_colour, "solid", style::area_width}},
                          0.925, 0.06);
  const char* titles[] = {"(a) no_direct_control: brake 2 stays locked, Fr = Fh + Fc points out of the wall",
                          "(b) direct_control: brake 2 gives way, Fr lies along the wall"};
  for (std::size_t k = 0; k < stills.size(); ++k) {
    const auto block = [&](int i) {
      return "data index " + std::to_string(blocks_of_still * static_cast<int>(k) + i) + " using ";
    };
    const auto arrow = [&](int i, const char* colour, const char* more = "") {
      return block(i) + "1:2:3:4 with vectors head filled size 0.008,20 lw 3 lc rgb '" + colour + "' " + more;
    };
    script << "set title '" << titles[k] << "' offset 0,-0.5\n"
           << labels(stills[k]) << "plot '+' using ($0 == 0 ? -0.02 : 0.29):(0.225):(0.335) every 98 "
           << "with filledcurves fc rgb '" << style::wall_colour << "', \\\n     " << block(1)
           << "1:2 with filledcurves closed fc rgb '#c6e6da', \\\n     " << block(0)
           << "1:2 with lines lw 7 lc rgb '#b0b0b0', \\\n     " << block(0)
           << "1:2 with points pt 7 ps 1.2 lc rgb '#555555', \\\n     " << arrow(2, "#999999", "dt (8,5)")
           << ", \\\n     " << arrow(3, "#0072b2") << ", \\\n     " << arrow(4, "#d55e00") << ", \\\n     "
           << arrow(5, "#000000") << "\n"
           << style::no_legend(k == 0 ? 6 : 0);
  }
  script << "unset multiplot\n";
  example::draw(directory, "pull_back", script.str());
}

}  // namespace experiments
