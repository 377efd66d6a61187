// The whole idea: a device, a wall, a law; once a cycle the state goes in and the brakes' capacities come
// out.
#include <passive_haptics/passive_haptics.hpp>

#include <Eigen/LU>

#include <iostream>

namespace ph = passive_haptics;
using device = ph::tendon_two_link<double>;

int main() {
  const device arm;  // the paper's device: two links of 0.15 m, both brakes at the base
  const ph::half_space<2> plane({0, 0.225}, {0, -1});  // a point of the surface, the way out of the wall
  ph::controller control(arm, ph::brakes_of<device>(), ph::scene(ph::wall(plane)), ph::direct_control());

  ph::device_state<device> state;                            // from the sensors:
  state.time = 0;                                            // of any clock [s]
  state.q = arm.inverse({0.12, 0.2251}, ph::elbow::left).q;  // 0.1 mm inside the wall [rad]
  state.hand_force = {0.8, 1.5};                             // pushing along the wall and into it [N]
  for (const double outward : {-0.01, 0.01}) {               // moving deeper, then moving out [m/s]
    state.qd = arm.jacobian(state.q).partialPivLu().solve(ph::vector<double, 2>(0.05, -outward));
    const auto result = control(state);
    std::cout << "moving " << (outward < 0 ? "inward: " : "outward:") << "  desired force "
              << result.desired_force.transpose() << " N"
              << ", displayed: " << display_text(result) << ", gamma "
              << ph::degrees(result.approximation_angle()) << " deg"
              << ", alpha " << result.alpha << ", brakes may hold " << result.capacity.transpose()
              << " N m\n";
  }
}
