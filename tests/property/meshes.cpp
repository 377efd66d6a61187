// slow
#include "mesh_cases.hpp"

using namespace passive_haptics::testing;

using mesh_solids = ::testing::Types<meshes::solid_star<2>, meshes::solid_star<3>, meshes::room_in_a_star>;
INSTANTIATE_TYPED_TEST_SUITE_P(meshes, shape_properties, mesh_solids);
using mesh_surfaces =
    ::testing::Types<meshes::surface_of_a_star<2>, meshes::surface_of_a_star<3>, meshes::hills>;
INSTANTIATE_TYPED_TEST_SUITE_P(meshes, tracked_shape_properties, mesh_surfaces);
