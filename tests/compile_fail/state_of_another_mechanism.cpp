// expect: passive_haptics: the state needs members q and qd, each a vector<scalar, dof> exactly
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;
using table = ph::xy_table<double>;

int main() {
  ph::controller control(table(), ph::brakes_of<table>(), ph::scene(ph::wall(ph::disc({0, 0}, 1))),
                         ph::no_direct_control{});
  control(ph::device_state<ph::xy_table<float>>());
}
