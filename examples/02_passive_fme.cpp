// The passive FMEs of Fig. 2 and the force approximation of Fig. 3: l1 = l2 = 1, joint angles (45, 90) deg,
// the handle moves along -y. Calls the stages one by one; a control loop would call step() or a controller.
#include <passive_haptics/passive_haptics.hpp>

#include <command_line.hpp>
#include <output.hpp>

#include <Eigen/LU>

#include <cstdio>
#include <sstream>

namespace ph = passive_haptics;
using device = ph::two_link<double>;
using force = ph::vector<double, 2>;

int main(int argc, char** argv) try {
  const auto directory =
      example::output_directory(argc, argv, "passive_fme",
                                "Forces that two brakes can display: a table, passive_fme.svg and its data.");
  const device arm({.length_1 = 1, .length_2 = 1});
  const ph::joint_vector<device> q(ph::radians(45.0), ph::radians(90.0));
  const ph::brakes_of<device> brakes;

  const auto E = ph::brake_jacobian(arm, q);
  const auto G = ph::reference_forces(arm, q).G;
  std::puts("Reference forces for 1 N m of one brake (4)-(6) [N]:");
  for (int i = 0; i < 2; ++i) {
    const force R = (1e4 * G.col(i)).array().round() / 1e4 + 0.0;  // no "-0.0000"
    std::printf("  R%d+ = (%7.4f, %7.4f)   R%d- = (%7.4f, %7.4f)\n", i + 1, R[0], R[1], i + 1, 0 - R[0],
                0 - R[1]);
  }

  // The handle moves along -y, so brake 1 rotates backwards and brake 2 forwards.
  const force v(0, -1);
  const ph::brake_vector<device> w = ph::matrix<double, 2, 2>(E).partialPivLu().solve(v);
  const auto s = ph::brake_signs<double, 2>(w, ph::brake_vector<device>::Zero(), brakes);
  const auto available = ph::producible_signs(s);

  std::puts("\nPassive FMEs (Fig. 2), by the signs of the brake torques:");
  std::ostringstream outlines;
  outlines << "# region, Fx [N], Fy [N]\n";
  int number = 0;
  for (const auto& region : ph::passive_fme_regions<2>()) {
    ++number;
    std::printf("  FME %d: t1 %c 0, t2 %c 0%s\n", number, region[0] > 0 ? '>' : '<',
                region[1] > 0 ? '>' : '<',
                region == available ? "   <- what the brakes can do while the handle moves along -y" : "");
    for (const force& F : ph::passive_fme_outline(G, region))
      outlines << number << ", " << F[0] << ", " << F[1] << "\n";
    outlines << "\n\n";
  }

  std::puts("\nForce approximation (Fig. 3), v = (0, -1) m/s:");
  std::puts("  Fd [N]             power       display       Fc [N]              gamma [deg]");
  std::ostringstream arrows;
  arrows << "# Fd x [N], Fd y [N], Fc x [N], Fc y [N], name of Fd, name of Fc where it is not Fd\n";
  const double min_cosine = ph::step_options<double>().min_cosine;
  int arrow = 0;
  for (const force& Fd : {force(-0.5, 1), force(0.5, 1), force(0.5, -1), force(-0.5, -0.05)}) {
    const force n = Fd.normalized();
    const ph::brake_vector<device> t = ph::brake_torque(E, n);
    const auto shown = ph::approximate(E, s, n, min_cosine);
    const force Fc = Fd.norm() * shown.force;
    const bool displayed = shown.display != ph::display_class::none;
    std::printf("  (%5.2f, %5.2f)   %-10s  %-12s  ", Fd[0], Fd[1],
                to_string(ph::classify_power(n.dot(v), ph::producible(s, t))).data(),
                to_string(shown.display).data());
    if (displayed)
      std::printf("(%6.3f, %6.3f)  %8.2f\n", Fc[0], Fc[1],
                  ph::degrees(std::acos(std::min(1.0, shown.cosine()))));
    else std::printf("%-16s  %8s\n", "-", "-");
    arrows << Fd[0] << ", " << Fd[1] << ", " << Fc[0] << ", " << Fc[1] << ", Fd" << ++arrow << ", ";
    if (shown.display == ph::display_class::approximate) arrows << "Fc" << arrow;
    arrows << "\n";
  }
  std::puts(
      "\nThe paper says of Fd3 that it \"cannot be displayed at all since it belongs to the active region of "
      "F.v > 0\".\n"
      "What decides is its direction: it makes an angle of more than 90 deg with every force of the passive "
      "FME, so the\n"
      "nearest producible force is 0. The last row is active too, F.v = 0.05 W, yet it lies within 90 deg of "
      "R1+ and is\n"
      "displayed approximately. So power and display are two questions; direct control lives where the first "
      "says\n"
      "'active' and the second 'approximate': a handle that moves out of a wall which the hand still presses "
      "on.");

  example::write_file(directory / "passive_fme_outlines.csv", outlines.str());
  example::write_file(directory / "passive_fme_forces.csv", arrows.str());
  example::draw(directory, "passive_fme",
                R"gnuplot(
set terminal svg size 900,460 font 'sans,13' background 'white'
set output output
set datafile separator ','
set multiplot layout 1,2
set size ratio -1
set border 3
set tics nomirror
set xlabel 'Fx [N]'
set ylabel 'Fy [N]'
unset key
set xrange [-1.8:1.8]
set yrange [-1.8:1.8]
beyond(coordinate, x, y) = coordinate * (1 + 0.22 / sqrt(x*x + y*y + 1e-9))  # the head of an arrow
color(k) = word('#cc79a7 #009e73 #56b4e9 #e69f00', k)
set title "All forces that two brakes of 1 N m can make,\nby the directions in which the brakes turn"
set label 1 'FME 1' at -1.1, -0.9 tc rgb '#a04a7c'
set label 2 'FME 2' at -1.25, 1.2 tc rgb '#00694d'
set label 3 'FME 3' at 0.75, -1.2 tc rgb '#1f6f9f'
set label 4 'FME 4' at 0.65, 0.9 tc rgb '#8a5f00'
plot for [k=1:4] 'passive_fme_outlines.csv' index k-1 using 2:3 with filledcurves closed fs solid 0.4 lc rgb color(k), \
     for [k=1:4] 'passive_fme_outlines.csv' index k-1 using 2:3 with lines lc rgb '#555555'
unset label
set title "The handle moves down (v): FME 2 is left.\nDesired forces (black) and what is displayed (orange)"
set label 5 'FME 2' at -1.05, 1.55 tc rgb '#00694d'
set label 6 'v' at 0.1, -0.45 tc rgb '#1f6f9f'
plot 'passive_fme_outlines.csv' index 1 using 2:3 with filledcurves closed fs solid 0.4 lc rgb '#009e73', \
     'passive_fme_forces.csv' using (0):(0):3:4 with vectors filled head size 0.12,20 lw 5 lc rgb '#d55e00', \
     'passive_fme_forces.csv' using (0):(0):1:2 with vectors filled head size 0.1,20 lw 1.5 lc rgb '#222222', \
     'passive_fme_forces.csv' using (beyond($1, $1, $2)):(beyond($2, $1, $2)):5 with labels tc rgb '#222222', \
     'passive_fme_forces.csv' using (beyond($3, $3, $4)):(beyond($4, $3, $4)):6 with labels offset 0,0.6 tc rgb '#b04400', \
     '+' using (0):(0):(0):(-0.6) every ::0::0 with vectors filled head size 0.12,20 lw 4 lc rgb '#56b4e9'
unset multiplot
)gnuplot");
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
