// expect: passive_haptics: torque_dead_band of the brakes must be .* exactly, in addition to a rate_dead_band
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using table = ph::xy_table<double>;

struct brakes {
  ph::vector<double, 2> torque_limit, torque_dead_band;
};

int main() {
  ph::controller control(table(), brakes(), ph::scene(ph::wall(ph::disc({0, 0}, 1))),
                         ph::no_direct_control());
  control(ph::sensorless_device_state<table>());
}
