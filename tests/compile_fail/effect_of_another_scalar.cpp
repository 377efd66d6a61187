// expect: passive_haptics: an effect's scalar must be the mechanism's
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using table = ph::xy_table<double>;

int main() {
  const ph::viscous_field<float, 2> honey({.viscosity = ph::matrix<float, 2, 2>::Identity()});
  ph::controller control(table(), ph::brakes_of<table>(), ph::with_effects(ph::no_walls<2>(), honey),
                         ph::direct_control());
  control(ph::device_state<table>());
}
