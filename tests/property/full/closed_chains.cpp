#include "../closed_chain_cases.hpp"

#include <passive_haptics/testing/dynamics_properties.hpp>
#include <passive_haptics/testing/mechanism_properties.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains, mechanism_properties, closed_chains::some);
INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains, dynamics_properties, closed_chains::some);
