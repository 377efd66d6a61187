/// Detection of a hand that pulls away from a wall or an effect, without a force sensor.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/shape.hpp>

namespace passive_haptics {

/// Constants of a release_probe.
struct release_probe_parameters {
  double probe_period = 0.3;  ///< Brakes are probed after resting for this long [s].
  double probe_time = 0.12;   ///< Maximum duration of a probe without motion [s]; several brake lags.
  /// Minimum motion of the handle that counts [m]; above the encoder resolution.
  double motion_threshold = 20e-6;

  static constexpr auto members() {
    using p = release_probe_parameters;
    return member_table(member("probe_period", &p::probe_period, "s", range::not_negative),
                        member("probe_time", &p::probe_time, "s", range::positive),
                        member("motion_threshold", &p::motion_threshold, "m", range::positive));
  }
};

/// Maximum time [s] from a reversal of the hand until the brakes are released: a probe or stop in progress,
/// the wait for the next probe, and that probe. Holds if the pull overcomes the remaining brake torques,
/// limit exp(-probe_time / T_b), in time to move the handle by motion_threshold during the probe.
inline double max_release_time(const release_probe_parameters& p) {
  return p.probe_period + 2 * p.probe_time;
}

/// Probes brakes at rest, because without a force sensor a push cannot be distinguished from a pull. While
/// the handle touches a wall or is held by an effect, brakes that have been at rest for probe_period are
/// released (their lag is the ramp) until the handle moves:
///
///     watching --rest of probe_period--> probing --moved in, or probe_time--> watching
///                                          \--moved out--> released --moved in again, or no wall--> watching
///
/// Each probe lets a pressing hand sink by about its motion during one brake lag. This is only the state
/// machine, independent of a mechanism; sensorless_controller uses it. Does not allocate.
template <int D>
class release_probe {
 public:
  /// Phase of a probe.
  enum class phase {
    watching,  ///< The law commands the brakes.
    probing,   ///< Brakes that held are released.
    released,  ///< All brakes are released.
  };

  release_probe() = default;  ///< Default parameters.
  /// Throws std::invalid_argument if validate(p) returns an error.
  explicit release_probe(const release_probe_parameters& p) : p_(require_valid(p)) {}

  /// One cycle in contact: time [s], handle x [m], direction n of the holding force, time at rest [s].
  phase update(double time, const point<D>& x, const point<D>& n, double rest) noexcept {
    const double moved = n.dot(x - origin_);  // outwards
    if (phase_ == phase::watching) {
      if (rest >= p_.probe_period) begin(phase::probing, time, x);
    } else if (phase_ == phase::probing) {
      if (moved > p_.motion_threshold) begin(phase::released, time, x);
      else if (moved < -p_.motion_threshold || time - since_ >= p_.probe_time)
        begin(phase::watching, time, x);
    } else {
      if (moved > 0) origin_ = x;
      else if (moved < -p_.motion_threshold) begin(phase::watching, time, x);
    }
    return phase_;
  }

  void clear() { phase_ = phase::watching; }  ///< Call in a cycle without a wall, or with a fault.

  phase now() const { return phase_; }  ///< Phase of the last update.

 private:
  void begin(phase next, double time, const point<D>& x) {
    phase_ = next;
    since_ = time;
    origin_ = x;
  }

  release_probe_parameters p_;
  phase phase_ = phase::watching;
  double since_ = 0;                    // start of the phase [s]
  point<D> origin_ = point<D>::Zero();  // its position; if released, the farthest point out
};

}  // namespace passive_haptics
