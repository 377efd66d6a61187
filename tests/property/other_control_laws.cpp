// slow
#include "custom_cases.hpp"
#include "device_cases.hpp"

#include <passive_haptics/control/laws/on_off_control.hpp>
#include <passive_haptics/testing/control_law_properties.hpp>
#include <passive_haptics/testing/fault_properties.hpp>

namespace passive_haptics::testing {
namespace {

using tendons = device_case<tendon_two_link<double>>;
using spatial = custom_case<custom::spatial_arm<double>>;
using spatial_relay = law_case<spatial, on_off_control>;
using relay = law_case<tendons, on_off_control>;

}  // namespace

INSTANTIATE_TYPED_TEST_SUITE_P(laws, control_law_properties, spatial_relay);
INSTANTIATE_TYPED_TEST_SUITE_P(laws, fault_properties, relay);

}  // namespace passive_haptics::testing
