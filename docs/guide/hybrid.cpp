#include <passive_haptics/passive_haptics.hpp>

#include <iostream>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;

int main() {
  // The paper's device back along its wall y = 0.225 m, with brakes of 0.3 N m, against a push of 2 N
  const device arm;
  const auto back = [&](double u) {
    const auto pose = arm.inverse({0.17 - 0.125 * u, 0.225}, ph::elbow::left);
    return ph::path_point<device>{pose.q, {-1, 0}, {0, -1}};
  };
  auto brakes = ph::hybrid_brakes<device>::with_limits({0.3, 0.3});
  std::cout << "without motors the hand sinks " << 1e3 * ph::sink_depth(arm, back, brakes, 2.0) << " mm\n";

  const double share = ph::min_motor_share(arm, back, brakes.brakes, 2.0);
  brakes.motor_limit = share * brakes.brakes.torque_limit;
  const double depth = ph::sink_depth(arm, back, brakes, 2.0);
  std::cout << "motors of " << 100 * share << " % hold it: " << 1e3 * depth << " mm\n";
  return share > 0.2 && share < 0.3 && depth < 1e-3 ? 0 : 1;
}
