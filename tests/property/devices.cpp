#include "device_cases.hpp"

#include <passive_haptics/testing/dynamics_properties.hpp>
#include <passive_haptics/testing/fault_properties.hpp>
#include <passive_haptics/testing/mechanism_properties.hpp>
#include <passive_haptics/testing/projection_properties.hpp>
#include <passive_haptics/testing/step_properties.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(devices, mechanism_properties, tested_devices);
INSTANTIATE_TYPED_TEST_SUITE_P(devices, dynamics_properties, tested_devices);
INSTANTIATE_TYPED_TEST_SUITE_P(devices, step_properties, tested_devices);
// The projection takes a diagonal E as a dense one, and single precision is that of custom_mechanisms.cpp.
using tendons = device_case<passive_haptics::tendon_two_link<double>>;
INSTANTIATE_TYPED_TEST_SUITE_P(devices, projection_properties, tendons);
using limits_in_float = tested_types<tendons, device_case<passive_haptics::two_link<float>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(devices, fault_properties, limits_in_float);
