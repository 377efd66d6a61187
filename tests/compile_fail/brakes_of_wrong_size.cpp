// expect: passive_haptics: torque_limit of the brakes must be a vector<scalar, brake_count> exactly
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using table = ph::xy_table<double>;

struct three_brakes {
  ph::vector<double, 3> torque_limit;
};

int main() {
  ph::controller control(table(), three_brakes(), ph::scene(ph::wall(ph::disc({0, 0}, 1))),
                         ph::no_direct_control());
  control(ph::sensorless_device_state<table>());
}
