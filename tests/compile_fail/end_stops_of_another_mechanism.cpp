// expect: passive_haptics: an effect on joints must be of as many as the mechanism has
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using table = ph::xy_table<double>;

int main() {
  const ph::end_stops<double, 3> stops({});
  ph::controller control(table(), ph::brakes_of<table>(), ph::with_effects(ph::no_walls<2>(), stops),
                         ph::direct_control());
  control(ph::device_state<table>());
}
