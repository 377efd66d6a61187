#include "../chain_cases.hpp"

#include <passive_haptics/testing/dynamics_properties.hpp>
#include <passive_haptics/testing/mechanism_properties.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(spatial_chains_in_double, mechanism_properties, chains::spatial<double>);
INSTANTIATE_TYPED_TEST_SUITE_P(spatial_chains_in_double, dynamics_properties, chains::spatial<double>);
