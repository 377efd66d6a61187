#include "mesh_cases.hpp"

using namespace passive_haptics::testing;

using solid = ::testing::Types<meshes::solid_star<3>>;
INSTANTIATE_TYPED_TEST_SUITE_P(meshes, shape_properties, solid);
using surface = ::testing::Types<meshes::surface_of_a_star<3>>;
INSTANTIATE_TYPED_TEST_SUITE_P(meshes, tracked_shape_properties, surface);
