// slow
#include "chain_cases.hpp"

#include <passive_haptics/testing/dynamics_properties.hpp>
#include <passive_haptics/testing/mechanism_properties.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(chains, mechanism_properties, chains::lengths);
INSTANTIATE_TYPED_TEST_SUITE_P(chains, dynamics_properties, chains::lengths);
