// expect: passive_haptics: settled.mechanism., inertial.mechanism. and kinetostatic.mechanism. are for
#include <passive_haptics/passive_haptics.hpp>

#include "arm.hpp"

namespace ph = passive_haptics;
using device = arm<2>;

int main() {
  ph::controller control(ph::inertial(device()), ph::brakes_of<device>(),
                         ph::scene(ph::wall(ph::half_space<2>({0, 1}, {0, -1}))), ph::direct_control());
}
