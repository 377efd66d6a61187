// Every law on three devices.
#include "custom_cases.hpp"
#include "device_cases.hpp"

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/coercive_force_approximation.hpp>
#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/control/laws/single_degree_of_freedom_control.hpp>
#include <passive_haptics/control/laws/velocity_ratio_control.hpp>
#include <passive_haptics/testing/control_law_properties.hpp>
#include <passive_haptics/testing/fault_properties.hpp>

namespace {

using namespace passive_haptics::testing;
namespace ph = passive_haptics;

struct nulling_early : ph::direct_control {
  nulling_early() { velocity_dead_band = 0.05; }
};

template <class Law>
using on_devices = ::testing::Types<law_case<device_case<ph::tendon_two_link<double>>, Law>,
                                    law_case<device_case<ph::xy_table<float>>, Law>,
                                    law_case<custom_case<custom::spatial_arm<double>>, Law>>;

INSTANTIATE_TYPED_TEST_SUITE_P(direct_control, control_law_properties, on_devices<nulling_early>);
INSTANTIATE_TYPED_TEST_SUITE_P(coercive, control_law_properties,
                               on_devices<ph::coercive_force_approximation>);
INSTANTIATE_TYPED_TEST_SUITE_P(single_dof, control_law_properties,
                               on_devices<ph::single_degree_of_freedom_control>);
INSTANTIATE_TYPED_TEST_SUITE_P(velocity_ratio, control_law_properties,
                               on_devices<ph::velocity_ratio_control>);
INSTANTIATE_TYPED_TEST_SUITE_P(on_off, control_law_properties, on_devices<ph::on_off_control>);

INSTANTIATE_TYPED_TEST_SUITE_P(direct_control, fault_properties, on_devices<nulling_early>);
INSTANTIATE_TYPED_TEST_SUITE_P(coercive, fault_properties, on_devices<ph::coercive_force_approximation>);
INSTANTIATE_TYPED_TEST_SUITE_P(single_dof, fault_properties,
                               on_devices<ph::single_degree_of_freedom_control>);
INSTANTIATE_TYPED_TEST_SUITE_P(velocity_ratio, fault_properties, on_devices<ph::velocity_ratio_control>);
INSTANTIATE_TYPED_TEST_SUITE_P(on_off, fault_properties, on_devices<ph::on_off_control>);

}  // namespace
