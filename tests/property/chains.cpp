// slow
// Open and closed chains of irregular shape.
#include "chain_cases.hpp"
#include "closed_chain_cases.hpp"

#include <passive_haptics/testing/dynamics_properties.hpp>
#include <passive_haptics/testing/mechanism_properties.hpp>
#include <passive_haptics/testing/step_properties.hpp>

using namespace passive_haptics::testing;
using chains::irregular_chain;

// In the plane with a sliding joint, in space with gravity.
using open_chains = ::testing::Types<irregular_chain<float, 5, 2>, irregular_chain<double, 6, 3>>;
INSTANTIATE_TYPED_TEST_SUITE_P(chains, mechanism_properties, open_chains);
INSTANTIATE_TYPED_TEST_SUITE_P(chains, dynamics_properties, open_chains);

// Each assembly of a five-bar, one with four brakes on two joints, and a delta.
using loops = ::testing::Types<closed_chains::pantograph<float>, closed_chains::lopsided_five_bar<double, 4>,
                               closed_chains::upside_down_delta<double>>;
INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains, mechanism_properties, loops);
INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains, dynamics_properties, loops);
using delta = closed_chains::desktop_delta<double>;
INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains, step_properties, delta);
