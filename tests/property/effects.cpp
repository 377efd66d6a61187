// optimised
#include "device_cases.hpp"
#include "effect_suite.hpp"

namespace {

using tendons = device_case<ph::tendon_two_link<double>>;
INSTANTIATE_TYPED_TEST_SUITE_P(effects, effects_without_a_sensor, tendons);

}  // namespace
