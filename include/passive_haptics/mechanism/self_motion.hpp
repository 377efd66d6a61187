/// Self-motion, n > d: J qd = v leaves n - d free directions, N = ker J. A light arm moves along them until n
/// - d of its brakes are at rest. The brakes then display the settled force
/// (brake/at_rest/settled_rates.hpp). Inertia is not needed.
#pragma once

#include <passive_haptics/mechanism/mechanism.hpp>

namespace passive_haptics {

/// A device with a self-motion that settles while it displays a force.
template <class M>
concept Settles = (M::dof > M::task_dimension);

}  // namespace passive_haptics
