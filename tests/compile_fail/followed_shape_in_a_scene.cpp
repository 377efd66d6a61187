// expect: passive_haptics: a shape that is followed .TrackedShape. needs a world
#include <passive_haptics/passive_haptics.hpp>

namespace ph = passive_haptics;

int main() {
  const ph::mesh_surface<2> line(ph::polyline({{{0, 0}, {1, 0}}, {{0, 1}}}));
  const ph::wall sheet(line);
  const auto scene = ph::scene(sheet);
}
