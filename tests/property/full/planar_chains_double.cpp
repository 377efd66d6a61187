#include "../chain_cases.hpp"

#include <passive_haptics/testing/dynamics_properties.hpp>
#include <passive_haptics/testing/mechanism_properties.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(planar_chains_in_double, mechanism_properties, chains::planar<double>);
INSTANTIATE_TYPED_TEST_SUITE_P(planar_chains_in_double, dynamics_properties, chains::planar<double>);
