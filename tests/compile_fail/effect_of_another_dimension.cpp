// expect: passive_haptics: an effect's dimension must be the scene's
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

int main() {
  const ph::viscous_field<double, 3> honey({.viscosity = ph::matrix<double, 3, 3>::Identity()});
  ph::with_effects(ph::scene(ph::wall(ph::disc({0, 0}, 1))), honey);
}
