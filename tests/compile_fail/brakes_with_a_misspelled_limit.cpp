// expect: passive_haptics: the brakes need a torque_limit, or static constexpr bool unlimited = true.
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using table = ph::xy_table<double>;

struct misspelled {
  ph::vector<double, 2> torque_limits;
};

int main() {
  ph::controller control(table(), misspelled(), ph::scene(ph::wall(ph::disc({0, 0}, 1))),
                         ph::no_direct_control());
  control(ph::sensorless_device_state<table>());
}
