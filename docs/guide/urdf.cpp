#include <passive_haptics/interop/urdf.hpp>
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/simulated_device.hpp>
#include <passive_haptics/scene/files/stl.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <string>

namespace ph = passive_haptics;
using device = ph::serial_chain_with_inertia<double, 7, 3>;

int main(int argc, char** argv) {
  const std::string folder = argc > 1 ? argv[1] : "docs/guide";
  try {
    const std::string file = folder + "/seven_joint_arm.urdf";
    const ph::urdf_chain found = ph::read_urdf(file, "base", "handle");
    for (const ph::urdf_joint& joint : found.joints)
      std::cout << joint.name << ": " << joint.link.mass << " kg, effort " << joint.effort << "\n";
    std::cout << found.remarks;  // what of the file is not in the chain as it is there

    const ph::vector<double, 7> q(0.2, 0.7, 0.1, 1.2, -0.3, 0.5, 0);  // [rad]
    const ph::point<3> start = ph::chain_of<7>(found).position(q);

    // A part, in millimetres and in its own frame: one of its faces to 5 mm from the handle
    ph::mesh_parameters<3> part = ph::read_stl(folder + "/mesh_file.stl", 1e-3).mesh;
    const ph::point<3> outward = ph::point<3>(1, 1, 1).normalized(), middle(0.1 / 3, 0.1 / 3, 0.1 / 3);
    for (ph::point<3>& vertex : part.vertices) vertex += start - middle - 0.005 * outward;
    const ph::mesh_solid<3> solid{ph::triangle_mesh(part)};

    const device arm = ph::chain_from_urdf<7>(file, "base", "handle");
    const ph::brakes_of<device> brakes{.torque_limit = ph::vector<double, 7>::Constant(2)};  // [N m]
    ph::controller control(arm, brakes, ph::scene(ph::wall(solid, 1e5)), ph::recommended_law(arm, brakes));

    ph::simulated_device<device> simulated(arm, brakes, 0.3, q);  // with a hand of 0.3 kg
    ph::device_state<device> state;
    double max_depth = 0;
    for (int k = 0; k < 500; ++k) {  // each millisecond
      state.time = 1e-3 * k;
      state.q = simulated.q();
      state.qd = simulated.qd();
      state.hand_force = simulated.sensed_force();
      const auto result = control(state);
      if (result.outcome != ph::status::ok) return 1;
      for (int i = 0; i < 10; ++i) simulated.advance(1e-4, result.capacity, -2 * outward);  // a push [N]
      max_depth = std::max(max_depth, -solid.distance(simulated.position()));
    }
    std::cout << 1e3 * max_depth << " mm deep at most\n";
    return max_depth > 0 && max_depth < 0.005 ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
