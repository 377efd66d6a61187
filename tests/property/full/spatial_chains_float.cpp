#include "../chain_cases.hpp"

#include <passive_haptics/testing/dynamics_properties.hpp>
#include <passive_haptics/testing/mechanism_properties.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(spatial_chains_in_float, mechanism_properties, chains::spatial<float>);
INSTANTIATE_TYPED_TEST_SUITE_P(spatial_chains_in_float, dynamics_properties, chains::spatial<float>);
