/// @file
/// Self-motion, n > d: J qd = v leaves n - d directions of motion, N = ker J, that nobody holds. A light arm
/// gives way until n - d of its brakes are at rest, and moves on so. The force that brakes display is the one
/// that a hand feels from then on (brake/at_rest/settled_rates.hpp). It needs no inertia.
#pragma once

#include <passive_haptics/mechanism/mechanism.hpp>

namespace passive_haptics {

/// A device whose self-motion settles while it displays a force.
template <class M>
concept Settles = (M::dof > M::task_dimension);

}  // namespace passive_haptics
