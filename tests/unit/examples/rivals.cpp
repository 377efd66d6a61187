// slow
// The laws that the experiments compare with: their torques oppose the motion of the brakes, within the
// limits.
#include "../../property/device_cases.hpp"

#include <experiments/rivals/bang_bang_control.hpp>
#include <experiments/rivals/coercive_force_approximation.hpp>
#include <experiments/rivals/single_degree_of_freedom_control.hpp>
#include <experiments/rivals/velocity_ratio_control.hpp>
#include <passive_haptics/testing/control_law_properties.hpp>

namespace {

using namespace passive_haptics::testing;

template <class... Law>
using on_tendon_device =
    ::testing::Types<law_case<device_case<passive_haptics::tendon_two_link<double>>, Law>...>;
using rivals =
    on_tendon_device<experiments::bang_bang_control, experiments::coercive_force_approximation,
                     experiments::single_degree_of_freedom_control, experiments::velocity_ratio_control>;
INSTANTIATE_TYPED_TEST_SUITE_P(rivals, control_law_properties, rivals);

}  // namespace
