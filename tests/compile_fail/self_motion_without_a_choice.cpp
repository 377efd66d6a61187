// expect: passive_haptics: this mechanism has more joints than task dimensions and no inertia. Give it
// mass_matrix, .*kinetostatic.mechanism.
#include <passive_haptics/passive_haptics.hpp>

#include "arm.hpp"

namespace ph = passive_haptics;
using device = arm<3>;

int main() {
  ph::controller control(device(), ph::brakes_of<device>(),
                         ph::scene(ph::wall(ph::half_space<2>({0, 1}, {0, -1}))), ph::direct_control());
}
