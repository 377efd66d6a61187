// The library's own mechanisms as cases of the property suites.
#pragma once

#include "../tested_types.hpp"

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

// A transmission, none, a diagonal.
using tested_devices = tested_types<device_case<passive_haptics::tendon_two_link<double>>,
                                    device_case<passive_haptics::two_link<float>>,
                                    device_case<passive_haptics::xy_table<double>>>;
