// expect: passive_haptics: a law that saturates before scaling takes one wall at a time
#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/laws/saturated_direct_control.hpp>
#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/scene/scene.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>

namespace ph = passive_haptics;
using table = ph::xy_table<double>;

int main() {
  const ph::wall wall(ph::half_space<2>({0, 0}, {0, 1}));
  ph::controller control(table(), ph::brakes_of<table>(), ph::scene(wall, wall),
                         ph::saturated_direct_control{});
  control(ph::device_state<table>());
}
