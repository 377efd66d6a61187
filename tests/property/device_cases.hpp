// The library's own mechanisms as cases of the property suites.
#pragma once

#include <gtest/gtest.h>

#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>

template <class Mechanism>
struct device_case {
  using mechanism = Mechanism;
  using joints = passive_haptics::joint_vector<mechanism>;
  static mechanism make() { return mechanism(); }
  static joints lower() { return joints::Constant(-3); }
  static joints upper() { return joints::Constant(3); }
};

template <template <class> class... Mechanisms>
struct in_float_and_double {
  using types = ::testing::Types<device_case<Mechanisms<float>>..., device_case<Mechanisms<double>>...>;
};

using device_cases = in_float_and_double<passive_haptics::two_link, passive_haptics::tendon_two_link,
                                         passive_haptics::xy_table>::types;
