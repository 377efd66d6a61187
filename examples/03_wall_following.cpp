// A hand moves the paper's device along a virtual wall (section 5) without direct control, with it, and with
// velocity_direct_control; the environment runs at 1 kHz or 20 Hz. Prints a table, writes logs and a plot.
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/wall_following.hpp>

#include <command_line.hpp>
#include <log/decision.hpp>
#include <log/live_stream.hpp>
#include <output.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;
using plane_vector = ph::vector<double, 2>;

namespace {

// The wall of section 5.2, free below, and the start of the handle.
const ph::half_space<2> surface({0, 0.225}, {0, -1});
const plane_vector start(0.045, 0.221);        // 4 mm from the wall [m]
const plane_vector start_velocity(0.05, 0.1);  // along the wall and into it [m/s]

// A compliant hand: a target 3 mm beyond the point at which 300 N/m push with 1.75 N.
ph::following_hand_parameters<double> yielding_hand() {
  ph::following_hand_parameters<double> p;
  p.push = 1.75;
  p.normal_stiffness = 300;
  p.target_depth = 0.003;
  return p;
}

// Brakes just strong enough for it: normal to the wall they produce 1.4 to 3 times its push.
ph::brakes_of<device> weak_brakes() {
  ph::brakes_of<device> brakes;  // lag 20 ms, dead band 0.02 rad/s
  brakes.torque_limit.setConstant(0.129);
  return brakes;
}

// The log of a run: state and result of the controller, and the true motion 0.1 ms later.
class run_log {
 public:
  explicit run_log(int live_port) : stream_(live_port) {}

  void add(const ph::device_state<device>& state, const ph::wall_following_sample<device>& truth) {
    row_.start();
    put_motion(row_, {}, state);
    put_decision(row_, {}, *truth.control);
    row_.put("x", "m", truth.position[0]);
    row_.put("y", "m", truth.position[1]);
    row_.put("depth", "m", truth.depth);
    row_.put("w", "rad/s", truth.rates);
    row_.put_axes("true_Fh", "N", truth.hand_force);
    row_.put("brake_torque", "N m", truth.brake_torque);
    if (text_.empty()) text_ = row_.header();
    text_ += row_.csv();
    stream_.send(state.time, row_);
  }
  const std::string& text() const { return text_; }

 private:
  example::log_row row_;
  std::string text_;
  example::paced_stream stream_;
};

// One run under a law.
template <class Law>
ph::contact_metrics follow(Law law, double environment_rate, run_log& log) {
  const device arm;
  const auto brakes = weak_brakes();
  const auto q = arm.inverse(start, ph::elbow::left).q;
  const auto seen = ph::scene(ph::wall(surface));
  ph::controller control(arm, brakes, ph::held_scene(seen, 1 / environment_rate), law);
  const ph::following_hand<double, 2> hand({1, 0}, start, yielding_hand());
  ph::simulated_device plant(arm, brakes, hand.parameters().mass, q);
  plant.set_motion(q, arm.jacobian(q).partialPivLu().solve(start_velocity));

  std::optional<ph::device_state<device>> latest;
  const auto controller = [&](const ph::device_state<device>& state) {
    latest = state;
    return control(state);
  };
  return ph::follow_wall(plant, controller, surface, hand, {}, [&](const auto& truth) {
    if (latest) log.add(*std::exchange(latest, std::nullopt), truth);
  });
}

void print_line(double environment_rate, const char* law_name, const ph::contact_metrics& f) {
  std::printf("%5.0f Hz  %-24s %8d %8.1f %8.1f %8.2f %8.0f %% %9.2f %9.2f%s\n", environment_rate, law_name,
              f.separations, 1e3 * f.max_depth, 1e3 * f.depth_mean, 1e3 * f.depth_std, 100 * f.stick_share,
              f.hand_force_std, f.retarding_force, f.arrived ? "" : "   (did not arrive)");
  std::fflush(stdout);
}

// Script for a picture of the depths.
std::string depth_script(const std::string& name) {
  return "set terminal svg noenhanced size 900,330 font 'sans,14' background 'white'\nset output output\n"
         "set datafile separator ','\nset datafile columnheaders\n"
         "none = '" +
         name + "_no_direct_control.csv'\nglides = '" + name + R"gnuplot(_velocity_direct_control.csv'
set title 'A hand that moves along a virtual wall: how deep it is in the wall'
set xrange [40:175]
set yrange [6.5:-3]
set xlabel 'way along the wall [mm]'
set ylabel 'depth [mm]'
set ytics 2 nomirror
set xtics nomirror
set border 3
unset key
set object 1 rectangle from graph 0, first 0 to graph 1, graph 0 behind fc rgb '#eeeeee' fs noborder
set label 1 'outside of the wall' at 60, -2.3 tc rgb '#555555'
set label 2 'inside' at 60, 0.8 tc rgb '#555555'
set label 3 'without direct control: it bounces' at 110, -2.3 tc rgb '#b04400'
set label 4 'under velocity_direct_control: it glides' at 110, 3.4 tc rgb '#00694d'
plot 0 lc rgb '#555555' lw 1 notitle, \
     none every 5 using (1e3*column('x')):(1e3*column('depth')) with lines lw 1.8 lc rgb '#d55e00' notitle, \
     glides every 5 using (1e3*column('x')):(1e3*column('depth')) with lines lw 2.5 lc rgb '#009e73' notitle
)gnuplot";
}

std::string plot_script(const std::string& name, double environment_rate) {
  std::ostringstream script;
  script << "set terminal svg noenhanced size 900,1000 font 'sans,12' background 'white'\nset output output\n"
         << "set datafile separator ','\n"
         << "none = '" << name << "_no_direct_control.csv'\ndirect = '" << name
         << "_saturated_direct_control.csv'\nvelocity = '" << name << "_velocity_direct_control.csv'\n"
         << "set multiplot layout 5,1 margins 0.105,0.97,0.06,0.92 spacing 0.03 title 'Along the wall, "
            "environment at "
         << environment_rate
         << " Hz: without direct control brake 2 sticks and slips, and the hand bounces'\n"
         << R"gnuplot(set grid lc rgb '#dddddd'
set xrange [0.04:0.175]
set style data lines
set datafile columnheaders
set style line 1 lw 1.2 lc rgb '#d55e00'
set style line 2 lw 1.5 lc rgb '#cc79a7'
set style line 3 lw 1.5 lc rgb '#009e73'
set key at screen 0.48,screen 0.957 center center maxrows 1
set ytics nomirror
set format x ''
all(y) = sprintf("none every 5 using 'x':(%s) ls 1 title 'no_direct_control', \
direct every 5 using 'x':(%s) ls 2 title 'saturated_direct_control', \
velocity every 5 using 'x':(%s) ls 3 title 'velocity_direct_control'", y, y, y)
set ylabel 'depth [mm]'
set yrange [*:*] reverse
eval "plot 0 lc rgb '#999999' dt 2 notitle, ".all("1e3*column('depth')")
unset key
set yrange [*:*] noreverse
set ylabel 'rate of brake 2 [rad/s]'
eval "plot ".all("column('w2')")
set ylabel 'Fh into wall [N]'
eval "plot ".all("column('true_Fh_y')")
set ylabel 'Fh along wall [N]'
eval "plot ".all("column('true_Fh_x')")
set xlabel 'x [m]'
set format x '%.2f'
set ylabel 'torque of brake 2 [N m]'
eval "plot ".all("abs(column('brake_torque2'))")
unset multiplot
)gnuplot";
  return script.str();
}

}  // namespace

int main(int argc, char** argv) try {
  std::filesystem::path directory = ".";
  int live_port = 0;
  example::command_line line("wall_following",
                             "The paper's device along a virtual wall: a table, gliding.svg, "
                             "wall_following.svg, and a log of each run in it.");
  line.port("--live", live_port,
            "send the logged runs to this local UDP port as JSON while they run (docs/guide/log.md)");
  line.output(directory);
  line.parse(argc, argv);

  std::printf("%-8s  %-24s %8s %8s %8s %8s %10s %9s %9s\n", "environ.", "law", "separa-", "deepest", "depth",
              "depth", "brake 2", "Fh std", "retarding");
  std::printf("%-8s  %-24s %8s %8s %8s %8s %10s %9s %9s\n", "", "", "tions", "[mm]", "mean", "std", "sticks",
              "[N]", "force [N]");
  double max_power = 0;  // of any brake on the device [W]
  constexpr double drawn = 20;
  for (const double rate : {1000.0, drawn}) {
    const auto run = [&](const char* law_name, auto law) {
      run_log log(rate == drawn ? live_port : 0);
      const ph::contact_metrics figures = follow(law, rate, log);
      print_line(rate, law_name, figures);
      max_power = std::max(max_power, figures.max_brake_power);
      if (rate == drawn)
        example::write_file(directory / std::string("wall_following_").append(law_name).append(".csv"),
                            log.text());
    };
    run("no_direct_control", ph::no_direct_control());
    run("saturated_direct_control", ph::saturated_direct_control());
    run("velocity_direct_control", ph::velocity_direct_control());
  }
  std::puts(
      "\nDirect control as the paper's experiments read it: brakes just strong enough, cut to their limit "
      "before alpha,\n"
      "and a hand that yields. With stronger brakes, or alpha before the limit as printed, it bounces on: "
      "docs/results.md.");
  std::printf("The most power that a brake gave to the device in any time step: %.0e W.\n\n", max_power);
  example::draw(directory, "gliding", depth_script("wall_following"));
  example::draw(directory, "wall_following", plot_script("wall_following", drawn));
  std::printf("data:    %s\n", std::filesystem::weakly_canonical(directory / "wall_following_*.csv").c_str());
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
