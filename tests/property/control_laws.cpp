#include "device_cases.hpp"

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/testing/control_law_properties.hpp>

namespace {

struct nulling_early : passive_haptics::direct_control {
  nulling_early() { velocity_dead_band = 0.05; }
};
using tendon_device = device_case<passive_haptics::tendon_two_link<double>>;
using direct_control_case = passive_haptics::testing::law_case<tendon_device, nulling_early>;

}  // namespace

namespace passive_haptics::testing {
INSTANTIATE_TYPED_TEST_SUITE_P(direct_control, control_law_properties, direct_control_case);
}
