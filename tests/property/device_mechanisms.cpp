#include "device_cases.hpp"

#include <passive_haptics/testing/dynamics_laws.hpp>
#include <passive_haptics/testing/mechanism_laws.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(devices, mechanism_laws, device_cases);
INSTANTIATE_TYPED_TEST_SUITE_P(devices, dynamics_laws, device_cases);
