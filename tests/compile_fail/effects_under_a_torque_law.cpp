// expect: passive_haptics: with_effects needs a ScalingLaw
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using table = ph::xy_table<double>;

int main() {
  const ph::viscous_field<double, 2> honey({.viscosity = ph::matrix<double, 2, 2>::Identity()});
  ph::controller control(table(), ph::brakes_of<table>(),
                         ph::with_effects(ph::scene(ph::wall(ph::disc({0, 0}, 1))), honey),
                         ph::velocity_direct_control());
  control(ph::device_state<table>());
}
