// expect: passive_haptics: a scene is made of walls: .*`scene.wall.shape, stiffness..`
#include <passive_haptics/passive_haptics.hpp>

#include "arm.hpp"

namespace ph = passive_haptics;
using device = arm<2>;

int main() {
  ph::controller control(device(), ph::brakes_of<device>(), ph::scene(ph::half_space<2>({0, 1}, {0, -1})),
                         ph::direct_control());
}
