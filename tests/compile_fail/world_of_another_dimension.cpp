// expect: passive_haptics: all walls of a world need the world's dimension.
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

int main() {
  ph::world_walls<3> walls;
  walls.add(ph::wall(ph::disc({0, 0}, 1)));
}
