#include "../closed_chain_cases.hpp"

#include <passive_haptics/testing/dynamics_properties.hpp>
#include <passive_haptics/testing/mechanism_properties.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains_in_float, mechanism_properties, closed_chains::all<float>);
INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains_in_float, dynamics_properties, closed_chains::all<float>);
INSTANTIATE_TYPED_TEST_SUITE_P(other_closed_chains, mechanism_properties, closed_chains::others_in_double);
INSTANTIATE_TYPED_TEST_SUITE_P(other_closed_chains, dynamics_properties, closed_chains::others_in_double);
// Four brakes on two joints.
using redundant =
    ::testing::Types<closed_chains::lopsided_five_bar<float, 4>, closed_chains::lopsided_five_bar<double, 4>>;
INSTANTIATE_TYPED_TEST_SUITE_P(redundant, mechanism_properties, redundant);
INSTANTIATE_TYPED_TEST_SUITE_P(redundant, dynamics_properties, redundant);
