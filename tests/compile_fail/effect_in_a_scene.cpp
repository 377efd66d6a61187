// expect: passive_haptics: a scene is made of walls: .*`with_effects.scene, effect.`
#include <passive_haptics/passive_haptics.hpp>

#include "arm.hpp"

namespace ph = passive_haptics;
using device = arm<2>;

int main() {
  ph::controller control(device(), ph::brakes_of<device>(), ph::scene(ph::viscous_field<double, 2>({})),
                         ph::direct_control());
}
