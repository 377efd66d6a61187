// slow
// A mesh_solid keeps the laws of shapes, a mesh_surface those of tracked shapes.
#include <passive_haptics/scene/mesh/height_field.hpp>
#include <passive_haptics/scene/mesh/mesh_solid.hpp>
#include <passive_haptics/scene/mesh/mesh_surface.hpp>
#include <passive_haptics/testing/shape_properties.hpp>
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
struct solid_star : about_a_star<ph::mesh_solid<D>> {
  static ph::mesh_solid<D> make() { return ph::mesh_solid<D>(star<D>()); }
};

template <int D>
struct surface_of_a_star : about_a_star<ph::mesh_surface<D>> {
  static ph::mesh_surface<D> make() { return ph::mesh_surface<D>(star<D>()); }
};
struct hills : about_a_star<ph::mesh_surface<3>> {
  static shape make() {
    ph::testing::random_source random(1985);
    ph::height_field_parameters p{11, 11, 0.2, 0.2, {}, {-1, -1, 0}};
    for (int k = 0; k < 121; ++k) p.heights.push_back(random.uniform(-0.3, 0.3));
    return shape(ph::triangle_mesh(ph::height_field(p)));
  }
};

}  // namespace meshes

using namespace passive_haptics::testing;

using mesh_solids = ::testing::Types<meshes::solid_star<2>, meshes::solid_star<3>>;
INSTANTIATE_TYPED_TEST_SUITE_P(meshes, shape_properties, mesh_solids);
using mesh_surfaces =
    ::testing::Types<meshes::surface_of_a_star<2>, meshes::surface_of_a_star<3>, meshes::hills>;
INSTANTIATE_TYPED_TEST_SUITE_P(meshes, tracked_shape_properties, mesh_surfaces);
