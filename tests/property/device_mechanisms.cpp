#include "device_cases.hpp"

#include <passive_haptics/testing/dynamics_properties.hpp>
#include <passive_haptics/testing/mechanism_properties.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(devices, mechanism_properties, device_cases);
INSTANTIATE_TYPED_TEST_SUITE_P(devices, dynamics_properties, device_cases);
