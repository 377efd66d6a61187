#include "devices.hpp"
#include "edge_suite.hpp"

namespace stress {

using edges_in_space = ::testing::Types<closed_chains::desktop_delta<double>>;
INSTANTIATE_TYPED_TEST_SUITE_P(edges_in_space, edges, edges_in_space);

}  // namespace stress
