// expect: passive_haptics: unsupported sizes; .* brake_count == dof >= task_dimension or, with a
#include <passive_haptics/passive_haptics.hpp>

#include "arm.hpp"

namespace ph = passive_haptics;
using device = arm<2, 3>;

int main() {
  ph::controller control(device(), ph::brakes_of<device>(),
                         ph::scene(ph::wall(ph::half_space<2>({0, 1}, {0, -1}))), ph::direct_control());
}
