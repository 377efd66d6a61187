// slow
// A mesh_surface keeps the laws of tracked shapes. A mesh_solid is in composed_shapes.cpp.
#include <passive_haptics/scene/mesh/mesh_surface.hpp>
#include <passive_haptics/testing/tracked_shape_properties.hpp>

#include "sample_meshes.hpp"

namespace meshes {

namespace ph = passive_haptics;

template <int D>
ph::mesh<D> star() {
  ph::testing::random_source random(1985);
  return ph::mesh<D>(sample_meshes::star<D>(random, 12));
}

template <class Shape>
struct about_a_star {
  using shape = Shape;
  using point = ph::point<Shape::dimension>;
  static point lower() { return point::Constant(-1.2); }
  static point upper() { return point::Constant(1.2); }
};

template <int D>
struct surface_of_a_star : about_a_star<ph::mesh_surface<D>> {
  static ph::mesh_surface<D> make() { return ph::mesh_surface<D>(star<D>()); }
};
}  // namespace meshes

using namespace passive_haptics::testing;

using mesh_surfaces = ::testing::Types<meshes::surface_of_a_star<2>, meshes::surface_of_a_star<3>>;
INSTANTIATE_TYPED_TEST_SUITE_P(meshes, tracked_shape_properties, mesh_surfaces);
