// Runs a log of a device's motion through a control law and writes what would have been commanded: a
// log of brake_driver, of a simulation, or of your own program.
#include <log/replay_program.hpp>

#include <Eigen/LU>

#include <cmath>

namespace ph = passive_haptics;

namespace {

// Half a second along the wall and a little in and out of it.
std::string made_up_log() {
  const ph::tendon_two_link<double> arm;
  example::log_row row;
  std::string log;
  for (int k = 0; k < 500; ++k) {
    const double t = 1e-3 * k, speed = 0.1, depth = 2e-4 * std::sin(20 * t);
    const auto q = arm.inverse({0.06 + speed * t, 0.225 + depth}, ph::elbow::left).q;
    const ph::vector<double, 2> v(speed, 4e-3 * std::cos(20 * t));
    row.start();
    put_motion(row, {},
               ph::device_state<ph::tendon_two_link<double>>{
                   t, q, arm.jacobian(q).partialPivLu().solve(v), {0.5, 2}});
    if (k == 0) log = row.header();
    log += row.csv();
  }
  return log;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace ph;
  using example::replay_of;
  return example::replay_program(
      argc, argv,
      {{"tendon_two_link", replay_of<tendon_two_link<double>, tendon_two_link_parameters<double>>()},
       {"two_link", replay_of<two_link<double>, two_link_parameters<double>>()},
       {"xy_table", replay_of<xy_table<double>, xy_table_parameters<double>>()},
       {"five_bar", replay_of<five_bar<double>, five_bar_parameters<double>>()},
       {"five_bar_4", replay_of<five_bar<double, 4>, five_bar_parameters<double, 4>>()},
       {"delta", replay_of<delta<double>, delta_parameters<double>>()}},
      made_up_log());
}
