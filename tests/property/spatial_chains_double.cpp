#include "chain_cases.hpp"

#include <passive_haptics/testing/dynamics_laws.hpp>
#include <passive_haptics/testing/mechanism_laws.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(spatial_chains, mechanism_laws, chains::spatial<double>);
INSTANTIATE_TYPED_TEST_SUITE_P(spatial_chains, dynamics_laws, chains::spatial<double>);
