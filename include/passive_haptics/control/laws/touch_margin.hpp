/// Default margin of laws that act from the touch on.
#pragma once

namespace passive_haptics {

/// Distance from a wall at which such a law needs its contact [m], for slowly sampled scenes: the distance a
/// hand moves at 0.2 m/s between two samples at 20 Hz.
inline constexpr double touch_margin = 10e-3;

}  // namespace passive_haptics
