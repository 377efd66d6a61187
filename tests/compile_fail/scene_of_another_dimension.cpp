// expect: passive_haptics: the scene's dimension must be the mechanism's task_dimension
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using table = ph::xy_table<double>;

int main() {
  ph::controller control(table(), ph::brakes_of<table>(), ph::scene(ph::wall(ph::ball<3>({0, 0, 0}, 1))),
                         ph::no_direct_control{});
  control(ph::device_state<table>());
}
