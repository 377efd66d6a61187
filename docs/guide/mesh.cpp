#include <passive_haptics/passive_haptics.hpp>

#include <iostream>

namespace ph = passive_haptics;

int main() {
  // A hill of 20 mm in a field of 0.2 m x 0.2 m, a height every 5 mm.
  ph::height_field_parameters field{41, 41, 5e-3, 5e-3, {}, {-0.1, -0.1, 0}};
  for (int j = 0; j < field.rows; ++j) {
    for (int i = 0; i < field.columns; ++i)
      field.heights.push_back(0.02 * std::exp(-(std::pow(i - 20, 2) + std::pow(j - 20, 2)) / 50));
  }
  const ph::mesh_surface<3> hill(ph::triangle_mesh(ph::height_field(field)));

  ph::mesh_surface<3>::tracker memory;  // one for each handle
  ph::point<3> before(0.05, 0, 0.05);
  int touched = 0;
  for (int k = 0; k <= 4; ++k) {  // through the hill, 10 mm over the ground
    const ph::point<3> x(0.05 - 0.015 * k, 0, 0.01);
    const double may_go = hill.follow(before, x, memory, [&](const ph::point<3>& normal, double depth) {
      std::cout << "depth " << depth << " m, normal " << normal.transpose() << "\n";
      ++touched;
    });
    std::cout << "need not be measured again for " << may_go << " m\n";
    before = x;
  }

  // A solid is a shape like any other: this one by its four corners and four faces, counterclockwise from
  // outside.
  const ph::mesh_solid<3> solid(ph::triangle_mesh(
      {{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, {0, 0, 0.1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}}));
  const auto walls = ph::scene(ph::wall(solid, 1e5));
  return touched > 0 && ph::sense(walls, {0.01, 0.02, 0.02}).size() == 1 ? 0 : 1;
}
