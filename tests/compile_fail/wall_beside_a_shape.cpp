// expect: passive_haptics: a scene is made of walls: .*`scene.wall.shape, stiffness..`
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

int main() {
  const ph::half_space<2> floor({0, 1}, {0, -1});
  ph::scene(ph::wall(floor), floor);
}
