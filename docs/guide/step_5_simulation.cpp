#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

namespace ph = passive_haptics;

using scara = ph::two_link<double>;  // has mass_matrix, bias_torque and bias_acceleration
static_assert(ph::Dynamics<scara>);
static_assert(ph::describe<scara>().has("mass_matrix"));
static_assert(ph::describe<scara>().has("bias_torque"));
static_assert(ph::describe<scara>().has("bias_acceleration"));

int main() {
  const scara arm({.length_1 = 0.2, .length_2 = 0.1});
  const ph::brakes_of<scara> brakes;
  const double hand_mass = 0.5;
  ph::simulated_device<scara> device(arm, brakes, hand_mass, {0.3, 1.2});
  for (int k = 0; k < 1000; ++k) {
    device.advance(1e-4, {0, 1},
                   {2, 1});  // 0.1 s: brake 1 open, brake 2 held with 1 N m, the hand pulls with (2, 1) N
  }
  return device.qd()[0] != 0 && std::abs(device.qd()[1]) < 1e-12 ? 0 : 1;
}
