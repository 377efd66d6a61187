#include <passive_haptics/passive_haptics.hpp>

#include <iostream>

namespace ph = passive_haptics;

int main() {
  // A closed part, by its four corners and four faces, counterclockwise from outside
  const ph::mesh_solid<3> part(ph::triangle_mesh(
      {{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}}));
  const auto scene = ph::scene(ph::wall(part, 1e5));

  // A terrain: a hill of 20 mm in a field of 0.2 m x 0.2 m, a height every 5 mm
  ph::height_field_parameters field{41, 41, 5e-3, 5e-3, {}, {-0.1, -0.1, 0}};
  for (int j = 0; j < field.rows; ++j) {
    for (int i = 0; i < field.columns; ++i)
      field.heights.push_back(0.02 * std::exp(-(std::pow(i - 20, 2) + std::pow(j - 20, 2)) / 50));
  }
  ph::world_walls<3> walls;
  walls.add(ph::wall(ph::mesh_surface<3>(ph::triangle_mesh(ph::height_field(field))), 1e5));
  ph::world<3> world(walls);

  bool held = false;
  for (const double x : {0.05, 0.035, 0.02, 0.005}) {  // into the hill, 10 mm over the ground
    const auto touched = ph::sense(world, ph::point<3>(x, 0, 0.01));
    for (const auto& c : touched)
      std::cout << "depth " << c.depth << " m, normal " << c.normal.transpose() << "\n";
    held = touched.size() == 1;
  }
  return held && ph::sense(scene, {0.01, 0.02, 0.02}).size() == 1 ? 0 : 1;
}
