/// Dry resistance with a limit, like a slipping or holding brake.
#pragma once

#include <passive_haptics/core/matrix.hpp>

#include <limits>

namespace passive_haptics {

/// Default speed below which a handle is at rest [m/s]: the rate dead band of the brakes, 0.02 rad/s
/// (brake_parameters.hpp), at the paper's link length of 0.15 m (section 5).
template <class T>
inline constexpr T default_velocity_dead_band = T(0.003);

/// Force of magnitude `limit` against the velocity v; inside the dead band, limit v / dead_band plus the
/// reaction to the push, limited to `limit`.
///
/// A push below the limit therefore comes to rest and is held. Without a push the force is continuous, zero
/// at rest, and F . v <= 0. With a push, F . v <= limit dead_band, and F jumps at the edge of the band unless
/// the push is along v. Units: limit and push [N], v and dead_band [m/s], or [N m] and [rad/s]; limit >= 0,
/// dead_band > 0. A simulation without the passive constraint (3) needs limit step < 2 dead_band mass.
/// Source: D. Karnopp, Computer simulation of stick-slip friction in mechanical dynamic systems, ASME J.
/// Dynamic Systems, Measurement, and Control 107(1), 1985, pp. 100-103.
template <class T, int D>
vector<T, D> resistance(T limit, const vector<T, D>& v, T dead_band, const vector<T, D>& push) {
  const T speed = length_of(v);
  if (speed > dead_band) return -limit / speed * v;
  const vector<T, D> wanted = limit / dead_band * v + push;
  const T size = length_of(wanted);
  return size > limit ? vector<T, D>(-limit / size * wanted) : vector<T, D>(-wanted);
}

/// Magnitude of a resistance to motion one way, in [0, limit]. `speed` and `push` are components this way.
template <class T>
T one_way_resistance(T limit, T speed, T dead_band, T push) {
  if (speed > dead_band) return limit;
  if (speed < -dead_band) return T(0) * limit;  // keeps NaN
  const T wanted = limit * (speed / dead_band) + push;
  if (wanted <= T(0)) return T(0);
  return wanted > limit ? limit : wanted;
}

}  // namespace passive_haptics
