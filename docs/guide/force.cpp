#include <passive_haptics/passive_haptics.hpp>

#include <cmath>
#include <iostream>

namespace ph = passive_haptics;
using device = ph::two_link<double>;

int main() {
  const device arm({.length_1 = 1, .length_2 = 1});
  const auto E = ph::brake_jacobian(arm, {ph::radians(45.0), ph::radians(90.0)});
  const ph::vector<double, 2> s(-1, 1);  // the handle moves along -y
  const ph::vector<double, 2> Fd(0.5, 1);

  const auto Fp = ph::nearest_force(E, s, Fd).force;  // (0, 1), the projection on the cone
  std::cout << "nearest force " << Fp.transpose() << " N, gamma "
            << ph::degrees(std::acos(Fp.norm() / Fd.norm())) << " deg\n";
  return std::abs(Fp.y() - 1) < 1e-12 ? 0 : 1;
}
