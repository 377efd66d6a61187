#include "../device_cases.hpp"

#include <passive_haptics/testing/dynamics_properties.hpp>
#include <passive_haptics/testing/fault_properties.hpp>
#include <passive_haptics/testing/mechanism_properties.hpp>
#include <passive_haptics/testing/projection_properties.hpp>
#include <passive_haptics/testing/step_properties.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(other_devices, mechanism_properties, other_devices);
INSTANTIATE_TYPED_TEST_SUITE_P(other_devices, dynamics_properties, other_devices);
INSTANTIATE_TYPED_TEST_SUITE_P(other_devices, step_properties, other_devices);
INSTANTIATE_TYPED_TEST_SUITE_P(other_devices, projection_properties, other_devices);
INSTANTIATE_TYPED_TEST_SUITE_P(other_devices, fault_properties, other_devices);
