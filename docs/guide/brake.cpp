#include <passive_haptics/passive_haptics.hpp>

#include <iostream>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;

int main() {
  const device arm;
  const auto q = arm.inverse({0.12, 0.225}, ph::elbow::left).q;
  ph::brakes_of<device> brakes;
  brakes.torque_limit = {0.8, 0.8};  // [N m]

  const auto E = ph::brake_jacobian(arm, q);                         // v = E w, t = E^T F
  const ph::brake_vector<device> w(-0.3, 0.001);                     // brake 2 is slower than its dead band
  const auto th = ph::brake_torque(E, ph::vector<double, 2>(0, 2));  // what the hand does to the brakes
  const auto s = ph::brake_signs(w, th, brakes);                     // -1, and the sign of th[1]
  const auto t = ph::passive_torque({0.5, 0.5}, w, th, brakes);      // what they make of 0.5 N m each
  std::cout << "s = " << s.transpose() << "\nt = " << t.transpose() << " N m\n";
  return (s.array() * t.array() <= 0).all() ? 0 : 1;
}
