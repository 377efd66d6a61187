#include "control_law_cases.hpp"

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(direct_control, control_law_properties, on_tendon_device<nulling_early>);
INSTANTIATE_TYPED_TEST_SUITE_P(direct_control, fault_properties, on_tendon_device<nulling_early>);
