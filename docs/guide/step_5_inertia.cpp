#include "scara.hpp"

#include <passive_haptics/mechanism/chains/serial_chain_with_inertia.hpp>
#include <passive_haptics/plant/simulated_device.hpp>

#include <array>
#include <iostream>

// The same arm as a chain: links of any mass and centre, on joints that turn or slide
class scara_chain : public ph::serial_chain_with_inertia<double, 2, 2> {
 public:
  scara_chain() : serial_chain_with_inertia(ph::planar_arm<double>(std::array{0.2, 0.1}), inertia()) {}
  ph::matrix<double, 2, 2> transmission() const { return ph::matrix<double, 2, 2>{{1, 0}, {3, 3}}; }

 private:
  static ph::serial_chain_inertia<double, 2, 2> inertia() {
    ph::serial_chain_inertia<double, 2, 2> i;
    i.links[0] = {.mass = 0.5, .centre = {0.2, 0}};  // [kg], [m] with both links along x
    i.links[1] = {.mass = 0.3, .centre = {0.3, 0}};
    i.handle_mass = 0;
    i.rotor_inertia = {0, 0};  // [kg m^2]
    return i;
  }
};

int main() {
  const scara arm;
  const ph::brakes_of<scara> brakes;
  ph::simulated_device<scara> device(arm, brakes, 0.5, {0.3, 1.2});  // a hand of 0.5 kg, at q
  for (int k = 0; k < 1000; ++k)
    device.advance(1e-4, {0, 1}, {2, 1});  // brake 1 open, brake 2 at 1 N m, the hand pulls with (2, 1) N
  std::cout << "after 0.1 s the brakes rotate at " << (arm.transmission() * device.qd()).transpose()
            << " rad/s\n";

  const ph::vector<double, 2> q(0.3, 1.2), qd(0.5, -2);
  const scara_chain chain;
  const bool equal = chain.mass_matrix(q).isApprox(arm.mass_matrix(q)) &&
                     chain.bias_torque(q, qd).isApprox(arm.bias_torque(q, qd)) &&
                     chain.bias_acceleration(q, qd).isApprox(arm.bias_acceleration(q, qd));
  return equal && std::abs(device.qd().sum()) < 1e-12 ? 0 : 1;
}
