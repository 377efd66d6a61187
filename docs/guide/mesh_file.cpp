#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/scene/files/stl.hpp>

#include <exception>
#include <iostream>

namespace ph = passive_haptics;

int main(int argc, char** argv) {
  try {
    const ph::mesh_file file = ph::read_stl(argc > 1 ? argv[1] : "docs/guide/mesh_file.stl", 1e-3);  // in mm
    const ph::triangle_mesh mesh(file.mesh);
    constexpr double reach = 0.4;                                // of the device [m]
    std::cerr << file.remarks << ph::plausibility(mesh, reach);  // nothing, if all is well

    const auto walls = ph::scene(ph::wall(ph::mesh_solid<3>(mesh), 1e5));
    return ph::sense(walls, {0.01, 0.02, 0.02}).size() == 1 ? 0 : 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
