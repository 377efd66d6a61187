#include "../closed_chain_cases.hpp"

#include <passive_haptics/testing/dynamics_properties.hpp>
#include <passive_haptics/testing/fault_properties.hpp>
#include <passive_haptics/testing/mechanism_properties.hpp>
#include <passive_haptics/testing/step_properties.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains, mechanism_properties, closed_chains::all);
INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains, dynamics_properties, closed_chains::all);
// Control cycles of closed chains obey the same laws as those of the first devices.
using closed_chains_in_cycles =
    ::testing::Types<closed_chains::pantograph<double>, closed_chains::desktop_delta<float>>;
INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains, step_properties, closed_chains_in_cycles);
INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains, fault_properties, closed_chains_in_cycles);
