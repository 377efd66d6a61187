#include "chain_cases.hpp"

#include <passive_haptics/testing/dynamics_laws.hpp>
#include <passive_haptics/testing/mechanism_laws.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(planar_chains, mechanism_laws, chains::planar<float>);
INSTANTIATE_TYPED_TEST_SUITE_P(planar_chains, dynamics_laws, chains::planar<float>);
