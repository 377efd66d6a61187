// A mechanism that is right in itself.
#pragma once

#include <passive_haptics/passive_haptics.hpp>

template <int Joints, int Brakes = Joints>
struct arm {
  using scalar = double;
  static constexpr int dof = Joints, task_dimension = 2, brake_count = Brakes;
  template <class S>
  passive_haptics::vector<S, 2> position(const passive_haptics::vector<S, Joints>& q) const {
    return q.template head<2>();
  }
};
