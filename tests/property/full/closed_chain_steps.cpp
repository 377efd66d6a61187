// Control cycles of closed chains obey the same laws as those of the first devices.
#include "../closed_chain_cases.hpp"

#include <passive_haptics/testing/fault_properties.hpp>
#include <passive_haptics/testing/step_properties.hpp>

using namespace passive_haptics::testing;

using cases = ::testing::Types<closed_chains::pantograph<float>, closed_chains::pantograph<double>,
                               closed_chains::desktop_delta<float>, closed_chains::desktop_delta<double>>;
INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains, step_properties, cases);
INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains, fault_properties, cases);
