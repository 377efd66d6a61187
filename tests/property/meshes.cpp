// A mesh_solid keeps the laws of shapes.
#include <passive_haptics/scene/complement.hpp>
#include <passive_haptics/scene/mesh_solid.hpp>
#include <passive_haptics/testing/shape_laws.hpp>

#include "sample_meshes.hpp"

namespace ph = passive_haptics;
using namespace passive_haptics::testing;

namespace {

template <int D>
struct star_case {
  using shape = ph::mesh_solid<D>;
  static shape make() {
    random_source random(1985);
    return shape(ph::mesh<D>(sample_meshes::star<D>(random, 12)));
  }
  static ph::point<D> lower() { return ph::point<D>::Constant(-1.2); }
  static ph::point<D> upper() { return ph::point<D>::Constant(1.2); }
};

struct room_case : star_case<3> {
  using shape = ph::complement<ph::mesh_solid<3>>;
  static shape make() { return shape(star_case<3>::make()); }
};

}  // namespace

using meshes = ::testing::Types<star_case<2>, star_case<3>, room_case>;
INSTANTIATE_TYPED_TEST_SUITE_P(scene, shape_laws, meshes);
