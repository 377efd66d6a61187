#include "../chain_cases.hpp"

#include <passive_haptics/testing/dynamics_properties.hpp>
#include <passive_haptics/testing/mechanism_properties.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(planar_chains, mechanism_properties, chains::planar);
INSTANTIATE_TYPED_TEST_SUITE_P(planar_chains, dynamics_properties, chains::planar);
