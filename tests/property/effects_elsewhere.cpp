// slow, optimised, no sanitizers
#include "closed_chain_cases.hpp"
#include "effect_suite.hpp"

namespace {

using loops = ::testing::Types<closed_chains::level_five_bar<4>, closed_chains::desktop_delta<double>>;
INSTANTIATE_TYPED_TEST_SUITE_P(closed_chains, effects_without_a_sensor, loops);

}  // namespace
