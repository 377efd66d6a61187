/// @file
/// The Effect concept: a force that resists motion, and so one that brakes can do.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <type_traits>

namespace passive_haptics {

/// A desired force beside that of the walls.
///
/// Minimal complete definition:
///   - `scalar` and `static constexpr int dimension` (d);
///   - `vector<scalar, d> force(x, v, hand_force) const`: force on the handle [N] at position x [m], velocity
///   v [m/s]
///     and hand force [N] (zero where none is known), all in the base frame.
///
/// Laws: with hand_force = 0, F . v <= 0 for all x and v, and F = 0 for v = 0: an effect returns no energy.
/// With a hand force the same outside the dead bands that the effect states; inside one it may hold against
/// the hand, with a power of at most |F| times the dead band. The sum of two effects is an effect.
template <class E>
concept Effect = requires(const E effect, const vector<typename E::scalar, E::dimension> u) {
  { effect.force(u, u, u) } -> ExactVector<typename E::scalar, E::dimension>;
};

/// Sum of the forces of several effects [N]; at least one. Arguments as Effect::force.
template <Effect First, Effect... Rest>
vector<typename First::scalar, First::dimension> total_force(
    const std::type_identity_t<vector<typename First::scalar, First::dimension>>& x,
    const std::type_identity_t<vector<typename First::scalar, First::dimension>>& v,
    const std::type_identity_t<vector<typename First::scalar, First::dimension>>& hand_force,
    const First& first, const Rest&... rest) {
  vector<typename First::scalar, First::dimension> sum = first.force(x, v, hand_force);
  ((sum += rest.force(x, v, hand_force)), ...);
  return sum;
}

}  // namespace passive_haptics
