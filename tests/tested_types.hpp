// The types that a suite of tests is repeated for; in the light tests the first of them alone.
#pragma once

#include <gtest/gtest.h>

#ifdef PASSIVE_HAPTICS_LIGHT_TESTS
template <class First, class...>
using tested_types = ::testing::Types<First>;
#else
template <class... Each>
using tested_types = ::testing::Types<Each...>;
#endif
