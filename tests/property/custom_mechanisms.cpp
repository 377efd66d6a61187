// slow
#include "custom_cases.hpp"

#include <passive_haptics/testing/dynamics_properties.hpp>
#include <passive_haptics/testing/fault_properties.hpp>
#include <passive_haptics/testing/mechanism_properties.hpp>
#include <passive_haptics/testing/projection_properties.hpp>
#include <passive_haptics/testing/step_properties.hpp>

using namespace passive_haptics::testing;

// Each to one way of the concept.
using custom_cases =
    ::testing::Types<archetype_case, custom_case<custom::planar_arm<double>>,
                     custom_case<custom::spatial_arm<float>>, custom_case<custom::geared_slides<double>>,
                     custom_case<custom::skew_table<double>>, custom_case<custom::coupled_arm<double>>,
                     lever_case>;
INSTANTIATE_TYPED_TEST_SUITE_P(custom, mechanism_properties, custom_cases);
INSTANTIATE_TYPED_TEST_SUITE_P(custom, dynamics_properties, lever_case);
// One of each size: with self-motion, in space, on a line. There the projection has a closed form.
using sizes = ::testing::Types<custom_case<custom::planar_arm<double>>,
                               custom_case<custom::spatial_arm<float>>, lever_case>;
INSTANTIATE_TYPED_TEST_SUITE_P(custom, step_properties, sizes);
using others =
    ::testing::Types<custom_case<custom::planar_arm<double>>, custom_case<custom::spatial_arm<float>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(custom, projection_properties, others);
using self_motion = custom_case<custom::planar_arm<double>>;
INSTANTIATE_TYPED_TEST_SUITE_P(custom, fault_properties, self_motion);
