#include "devices.hpp"
#include "edge_suite.hpp"

namespace stress {

using edges_in_the_plane =
    ::testing::Types<device_case<ph::tendon_two_link<double>>, chains::irregular_chain<double, 4, 2>>;
INSTANTIATE_TYPED_TEST_SUITE_P(edges_in_the_plane, edges, edges_in_the_plane);

}  // namespace stress
