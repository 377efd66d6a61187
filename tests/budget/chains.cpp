// Serial chains: a pose, and cycles of arms with self-motion, which take the compiler as long as all of
// cycles.cpp.
#include "counted.hpp"

#include <array>
#include <cstddef>

namespace {

using namespace budget;

// Position and Jacobian of a chain of six joints, roughly a human arm
row poses() {
  const auto at = [](double x) { return ph::point<3>(x, 0, 0.1); };
  const auto X = ph::point<3>::UnitX(), Y = ph::point<3>::UnitY(), Z = ph::point<3>::UnitZ();
  const ph::serial_chain<double, 6, 3> arm(ph::serial_chain_parameters<double, 6, 3>{
      .joints = {ph::revolute_joint<double>(Z, at(0)), ph::revolute_joint<double>(Y, at(0)),
                 ph::revolute_joint<double>(X, at(0)), ph::revolute_joint<double>(Y, at(0.25)),
                 ph::revolute_joint<double>(Z, at(0.5)), ph::revolute_joint<double>(Y, at(0.5))},
      .handle = ph::point<3>(0.6, 0, 0.1)});
  return [arm, states = random_states(arm)] {
    for (const auto& s : states) {
      const ph::mechanism_pose here(arm, s.q);
      use(here.position());
      use(here.jacobian());
    }
  };
}

// Seven joints in space that turn about z, y and x in turns: 35 sets of brakes may come to rest
ph::serial_chain<double, 7, 3> seven_joints() {
  ph::serial_chain_parameters<double, 7, 3> p;
  for (int i = 0; i < 7; ++i)
    p.joints[std::size_t(i)] =
        ph::revolute_joint<double>(ph::point<3>::Unit(2 - i % 3), ph::point<3>(0.1 * i, 0, 0.02 * i));
  p.handle = {0.7, 0, 0.1};
  return ph::serial_chain<double, 7, 3>(p);
}

}  // namespace

int main(int argc, char** argv) {
  rows_by_name rows;
  add(rows, "settled_3", ph::serial_chain<double, 3, 2>(ph::planar_arm<double>(std::array{0.15, 0.15, 0.1})));
  add(rows, "settled_7", seven_joints());
  rows["chain_of_6/pose_and_jacobian"] = poses;
  return run(rows, argc, argv);
}
