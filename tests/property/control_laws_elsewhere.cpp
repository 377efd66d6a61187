// slow
#include "control_law_cases.hpp"

using namespace passive_haptics::testing;
namespace ph = passive_haptics;

INSTANTIATE_TYPED_TEST_SUITE_P(direct_control_elsewhere, control_law_properties,
                               on_other_devices<nulling_early>);
INSTANTIATE_TYPED_TEST_SUITE_P(on_off_elsewhere, control_law_properties,
                               on_other_devices<ph::on_off_control>);

INSTANTIATE_TYPED_TEST_SUITE_P(direct_control_elsewhere, fault_properties, on_other_devices<nulling_early>);
INSTANTIATE_TYPED_TEST_SUITE_P(on_off_elsewhere, fault_properties, on_other_devices<ph::on_off_control>);
