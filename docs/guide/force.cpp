#include <passive_haptics/passive_haptics.hpp>

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

  // An effect joins the walls of a step as a contact.
  const ph::viscous_field<double, 2> honey(
      {.viscosity = 5 * ph::matrix<double, 2, 2>::Identity()});  // [N s/m]
  ph::contacts<2, 1> touched;
  touched.push_back(ph::contact_asking_for(honey.force({0, 1}, {0.1, 0}, {0, 0})));
  return touched[0].depth == 0.5 ? 0 : 1;
}
