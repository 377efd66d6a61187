// expect: passive_haptics: this law needs the brakes' lag: give the brakes a time_constant
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using table = ph::xy_table<double>;

int main() {
  ph::controller control(table(), ph::unlimited_brakes(), ph::scene(ph::wall(ph::disc({0, 0}, 1))),
                         ph::velocity_direct_control());
  control(ph::device_state<table>());
}
