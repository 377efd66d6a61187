#include "device_cases.hpp"

#include <passive_haptics/testing/fault_laws.hpp>
#include <passive_haptics/testing/projection_laws.hpp>
#include <passive_haptics/testing/step_laws.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(devices, step_laws, device_cases);
INSTANTIATE_TYPED_TEST_SUITE_P(devices, projection_laws, device_cases);
INSTANTIATE_TYPED_TEST_SUITE_P(devices, fault_laws, device_cases);
