// The mechanisms of custom_mechanisms.hpp as cases of the property suites.
#pragma once

#include "custom_mechanisms.hpp"

#include <gtest/gtest.h>

template <class Mechanism>
struct custom_case {
  using mechanism = Mechanism;
  using joints = passive_haptics::joint_vector<mechanism>;
  static mechanism make() { return mechanism(); }
  static joints lower() { return joints::Constant(-2); }
  static joints upper() { return joints::Constant(2); }
};

struct archetype_case : custom_case<custom::archetype> {
  static mechanism make() { return mechanism(mechanism::key()); }
};

struct lever_case : custom_case<custom::lever<double>> {
  static constexpr bool has_gravity = true;
};
