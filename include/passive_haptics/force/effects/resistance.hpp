/// @file
/// Dry resistance with a limit: what a brake feels like, in slip and at rest.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <limits>

namespace passive_haptics {

/// Speed under which a handle counts as at rest [m/s]: the brakes' rate dead band, 0.02 rad/s
/// (brake_parameters.hpp), at the paper's link length of 0.15 m (section 5).
template <class T>
inline constexpr T default_velocity_dead_band = T(0.003);

/// Force of size `limit` against the velocity v; inside the dead band, limit v / dead_band plus what holds
/// against the push, together no more than limit.
///
/// So a push under the limit brings the handle to rest and holds it. Without a push the force is continuous,
/// zero at rest, and F . v <= 0. With one, F . v <= limit dead_band, and F jumps at the edge of the band if
/// the push is not along v. Units: limit and push [N], v and dead_band [m/s], or [N m] and [rad/s]; limit >=
/// 0, dead_band > 0. The slope is a damping: a simulation that applies the force without the passive
/// constraint (3), which lets no brake reverse a motion, needs limit step < 2 dead_band mass. Reference: D.
/// Karnopp, Computer simulation of stick-slip friction in mechanical dynamic systems, ASME J. Dynamic
/// Systems, Measurement, and Control 107(1), 1985, pp. 100-103.
template <class T, int D>
vector<T, D> resistance(T limit, const vector<T, D>& v, T dead_band, const vector<T, D>& push) {
  const T speed = length_of(v);
  if (speed > dead_band) return -limit / speed * v;
  const vector<T, D> wanted = limit / dead_band * v + push;
  const T size = length_of(wanted);
  return size > limit ? vector<T, D>(-limit / size * wanted) : vector<T, D>(-wanted);
}

/// Size of a resisting force along one direction, against motion that way only, 0 <= size <= limit. Motion
/// the other way is free. `speed` and `push` are components along the direction.
template <class T>
T one_way_resistance(T limit, T speed, T dead_band, T push) {
  if (speed > dead_band) return limit;
  if (speed < -dead_band) return T(0) * limit;  // a NaN stays one
  const T wanted = limit * (speed / dead_band) + push;
  if (wanted <= T(0)) return T(0);
  return wanted > limit ? limit : wanted;
}

}  // namespace passive_haptics
