// expect: passive_haptics: there is no effect of this number
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

int main() {
  const ph::viscous_field<double, 2> honey({.viscosity = ph::matrix<double, 2, 2>::Identity()});
  auto scene = ph::with_effects(ph::scene(ph::wall(ph::disc({0, 0}, 1))), honey);
  scene.effect<-1>();
}
