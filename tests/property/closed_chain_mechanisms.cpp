#include "closed_chain_cases.hpp"

#include <passive_haptics/testing/dynamics_properties.hpp>
#include <passive_haptics/testing/mechanism_properties.hpp>

using namespace passive_haptics::testing;

INSTANTIATE_TYPED_TEST_SUITE_P(float_closed, mechanism_properties, closed_chains::all<float>);
INSTANTIATE_TYPED_TEST_SUITE_P(double_closed, mechanism_properties, closed_chains::all<double>);
INSTANTIATE_TYPED_TEST_SUITE_P(float_closed, dynamics_properties, closed_chains::all<float>);
INSTANTIATE_TYPED_TEST_SUITE_P(double_closed, dynamics_properties, closed_chains::all<double>);
// Four brakes on two joints.
using redundant =
    ::testing::Types<closed_chains::lopsided_five_bar<float, 4>, closed_chains::lopsided_five_bar<double, 4>>;
INSTANTIATE_TYPED_TEST_SUITE_P(redundant, mechanism_properties, redundant);
INSTANTIATE_TYPED_TEST_SUITE_P(redundant, dynamics_properties, redundant);
