#include <passive_haptics/passive_haptics.hpp>

#include <iostream>

namespace ph = passive_haptics;

int main() {
  using three_links = ph::serial_chain<double, 3, 2>;
  using arm = ph::braked_joints<three_links, 0, 1>;  // the last of its three joints has no brake
  const arm device(three_links(ph::planar_arm<double>(std::array{0.15, 0.15, 0.1})));
  const ph::vector<double, 3> q(0.3, 0.9, -0.6), qd(0.3, 0.1, 0.2);
  const ph::point<2> x = device.position(q);
  const auto scene = ph::scene(ph::wall(ph::half_space<2>(x + ph::point<2>(1e-4, 0), {1, 0})));
  ph::controller control(device, ph::brakes_of<arm>(), scene, ph::no_direct_control());
  const auto result = control(ph::device_state<arm>{.time = 0, .q = q, .qd = qd, .hand_force = {-2, 0.5}});
  std::cout << display_text(result) << " at " << ph::degrees(result.approximation_angle())
            << " deg, brakes may hold " << result.capacity.transpose() << " N m\n";
}
