#include "custom_cases.hpp"

#include <passive_haptics/testing/dynamics_laws.hpp>
#include <passive_haptics/testing/mechanism_laws.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(custom, mechanism_laws, custom_cases);
INSTANTIATE_TYPED_TEST_SUITE_P(custom, dynamics_laws, lever_case);
