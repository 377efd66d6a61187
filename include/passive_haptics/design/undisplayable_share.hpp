/// Share of a path on which no law can hold a hand.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/design/displayable.hpp>
#include <passive_haptics/design/path_point.hpp>

namespace passive_haptics {

/// Returns the share [1] of a path on which these brakes, including motors, cannot display `push` [N] against
/// the wall, or anything for push = 0. Poses without a result count. path(u): path_point<M> at u in (0, 1).
/// Throws std::invalid_argument for less than 1 sample.
template <class M, class Path>
double undisplayable_share(const M& mechanism, Path&& path, const hybrid_brakes<M>& brakes,
                           typename M::scalar push = 0, int samples = 200) {
  detail::refuse_unless(samples >= 1, "samples of an undisplayable_share", samples, "1 or more");
  int weak = 0;
  for (int k = 0; k < samples; ++k) {
    const path_point<M> at = path((k + 0.5) / samples);
    weak += !(displayable(mechanism, at.q, at.direction, at.normal, brakes).max_force > push);
  }
  return static_cast<double>(weak) / samples;
}

/// Overload for brakes with these torque limits [N m].
template <class M, class Path>
double undisplayable_share(const M& mechanism, Path&& path,
                           const brake_vector<M>& torque_limit =
                               brake_vector<M>::Constant(std::numeric_limits<typename M::scalar>::infinity()),
                           typename M::scalar push = 0, int samples = 200) {
  return passive_haptics::undisplayable_share(mechanism, path, hybrid_brakes<M>::with_limits(torque_limit),
                                              push, samples);
}

}  // namespace passive_haptics
