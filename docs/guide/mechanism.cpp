#include <passive_haptics/passive_haptics.hpp>

#include <iostream>

namespace ph = passive_haptics;

int main() {
  const ph::tendon_two_link<double> arm;  // the paper's dimensions
  const auto pose = arm.inverse({0.12, 0.225}, ph::elbow::left);
  if (pose.outcome != ph::status::ok) return 1;  // out_of_reach, or a point that is not finite
  const auto J = ph::jacobian(arm, pose.q);
  const auto w = ph::brake_rates(arm, pose.q, {0.1, -0.2});
  std::cout << "x = " << arm.position(pose.q).transpose() << " m\nJ =\n"
            << J << "\nw = " << w.transpose() << " rad/s\n";
}
