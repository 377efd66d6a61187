// slow
#include "control_law_cases.hpp"

using namespace passive_haptics::testing;
namespace ph = passive_haptics;

INSTANTIATE_TYPED_TEST_SUITE_P(on_off, control_law_properties, on_tendon_device<ph::on_off_control>);
INSTANTIATE_TYPED_TEST_SUITE_P(on_off, fault_properties, on_tendon_device<ph::on_off_control>);
