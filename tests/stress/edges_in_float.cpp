#include "devices.hpp"
#include "edge_suite.hpp"

namespace stress {

using edges_in_float = ::testing::Types<four_brakes<float>>;
INSTANTIATE_TYPED_TEST_SUITE_P(edges_in_float, edges, edges_in_float);

}  // namespace stress
