// expect: passive_haptics: this law needs a hand force: give the state a hand_force
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using table = ph::xy_table<double>;

int main() {
  ph::controller control(table(), ph::brakes_of<table>(), ph::scene(ph::wall(ph::disc({0, 0}, 1))),
                         ph::direct_control{});
  control(ph::sensorless_device_state<table>());
}
