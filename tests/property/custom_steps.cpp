#include "custom_cases.hpp"

#include <passive_haptics/testing/fault_laws.hpp>
#include <passive_haptics/testing/projection_laws.hpp>
#include <passive_haptics/testing/step_laws.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(custom, step_laws, custom_cases);
INSTANTIATE_TYPED_TEST_SUITE_P(custom, projection_laws, custom_cases);
INSTANTIATE_TYPED_TEST_SUITE_P(custom, fault_laws, custom_cases);
