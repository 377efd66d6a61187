// slow
#include "closed_chain_cases.hpp"

#include <passive_haptics/testing/dynamics_properties.hpp>
#include <passive_haptics/testing/fault_properties.hpp>
#include <passive_haptics/testing/mechanism_properties.hpp>
#include <passive_haptics/testing/step_properties.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains, mechanism_properties, closed_chains::all);
INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains, dynamics_properties, closed_chains::all);
using cycled = ::testing::Types<closed_chains::pantograph<float>, closed_chains::desktop_delta<double>>;
INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains, step_properties, cycled);
INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains, fault_properties, cycled);
