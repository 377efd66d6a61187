// expect: passive_haptics: the scene has no wall of this number
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

int main() {
  auto walls = ph::scene(ph::wall(ph::disc({0, 0}, 1)));
  walls.get<1>();
}
