// slow
#include "closed_chain_cases.hpp"
#include "control_law_cases.hpp"

using namespace passive_haptics::testing;
namespace ph = passive_haptics;

using single_dof_of_four_brakes =
    law_case<closed_chains::lopsided_five_bar<double, 4>, ph::single_degree_of_freedom_control>;

INSTANTIATE_TYPED_TEST_SUITE_P(direct_control_elsewhere, control_law_properties,
                               on_other_devices<nulling_early>);
INSTANTIATE_TYPED_TEST_SUITE_P(coercive_elsewhere, control_law_properties,
                               on_other_devices<ph::coercive_force_approximation>);
INSTANTIATE_TYPED_TEST_SUITE_P(single_dof_elsewhere, control_law_properties,
                               on_other_devices<ph::single_degree_of_freedom_control>);
INSTANTIATE_TYPED_TEST_SUITE_P(velocity_ratio_elsewhere, control_law_properties,
                               on_other_devices<ph::velocity_ratio_control>);
INSTANTIATE_TYPED_TEST_SUITE_P(on_off_elsewhere, control_law_properties,
                               on_other_devices<ph::on_off_control>);

INSTANTIATE_TYPED_TEST_SUITE_P(single_dof_of_four_brakes, control_law_properties,
                               ::testing::Types<single_dof_of_four_brakes>);

INSTANTIATE_TYPED_TEST_SUITE_P(direct_control_elsewhere, fault_properties, on_other_devices<nulling_early>);
INSTANTIATE_TYPED_TEST_SUITE_P(coercive_elsewhere, fault_properties,
                               on_other_devices<ph::coercive_force_approximation>);
INSTANTIATE_TYPED_TEST_SUITE_P(single_dof_elsewhere, fault_properties,
                               on_other_devices<ph::single_degree_of_freedom_control>);
INSTANTIATE_TYPED_TEST_SUITE_P(velocity_ratio_elsewhere, fault_properties,
                               on_other_devices<ph::velocity_ratio_control>);
INSTANTIATE_TYPED_TEST_SUITE_P(on_off_elsewhere, fault_properties, on_other_devices<ph::on_off_control>);
