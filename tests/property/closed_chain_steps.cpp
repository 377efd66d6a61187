// Control cycles of closed chains obey the same laws as those of the first devices.
#include "closed_chain_cases.hpp"

#include <passive_haptics/testing/fault_laws.hpp>
#include <passive_haptics/testing/step_laws.hpp>

using namespace passive_haptics::testing;

using cases = ::testing::Types<closed_chains::pantograph<float>, closed_chains::pantograph<double>,
                               closed_chains::desktop_delta<float>, closed_chains::desktop_delta<double>>;
INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains, step_laws, cases);
INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains, fault_laws, cases);
