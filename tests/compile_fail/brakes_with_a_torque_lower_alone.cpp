// expect: passive_haptics: torque_lower and torque_upper of the brakes must both be a vector<scalar,
// brake_count>
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using table = ph::xy_table<double>;

struct brakes {
  ph::vector<double, 2> torque_limit, torque_lower;
};

int main() {
  ph::controller control(table(), brakes(), ph::scene(ph::wall(ph::disc({0, 0}, 1))),
                         ph::no_direct_control());
  control(ph::sensorless_device_state<table>());
}
