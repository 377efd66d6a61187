// slow
#include "control_law_cases.hpp"

using namespace passive_haptics::testing;
namespace ph = passive_haptics;

INSTANTIATE_TYPED_TEST_SUITE_P(coercive, control_law_properties,
                               on_tendon_device<ph::coercive_force_approximation>);
INSTANTIATE_TYPED_TEST_SUITE_P(single_dof, control_law_properties,
                               on_tendon_device<ph::single_degree_of_freedom_control>);
INSTANTIATE_TYPED_TEST_SUITE_P(velocity_ratio, control_law_properties,
                               on_tendon_device<ph::velocity_ratio_control>);
INSTANTIATE_TYPED_TEST_SUITE_P(on_off, control_law_properties, on_tendon_device<ph::on_off_control>);
INSTANTIATE_TYPED_TEST_SUITE_P(bang_bang, control_law_properties, on_tendon_device<ph::bang_bang_control>);

INSTANTIATE_TYPED_TEST_SUITE_P(coercive, fault_properties,
                               on_tendon_device<ph::coercive_force_approximation>);
INSTANTIATE_TYPED_TEST_SUITE_P(single_dof, fault_properties,
                               on_tendon_device<ph::single_degree_of_freedom_control>);
INSTANTIATE_TYPED_TEST_SUITE_P(velocity_ratio, fault_properties,
                               on_tendon_device<ph::velocity_ratio_control>);
INSTANTIATE_TYPED_TEST_SUITE_P(on_off, fault_properties, on_tendon_device<ph::on_off_control>);
INSTANTIATE_TYPED_TEST_SUITE_P(bang_bang, fault_properties, on_tendon_device<ph::bang_bang_control>);
