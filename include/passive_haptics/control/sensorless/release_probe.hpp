/// @file
/// Detects that a hand pulls away from a wall or an effect, for a device without a force sensor.
#pragma once

#include <passive_haptics/core/parameters.hpp>
#include <passive_haptics/scene/shape.hpp>

namespace passive_haptics {

/// Constants of a release_probe.
struct release_probe_parameters {
  double probe_period = 0.3;  ///< Brakes that have been at rest for this long are probed [s].
  double probe_time = 0.12;   ///< A probe that nothing moves ends after this [s]; several lags of the brakes.
  /// Least motion of the handle that counts [m]; over the encoders' resolution.
  double motion_threshold = 20e-6;

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = release_probe_parameters;
    return member_table(member("probe_period", &p::probe_period, "s", range::not_negative),
                        member("probe_time", &p::probe_time, "s", range::positive),
                        member("motion_threshold", &p::motion_threshold, "m", range::positive));
  }
};

/// The longest time [s] from a hand's reversal until the brakes are released for good: a probe or a stop that
/// is under way, the rest before the next, and that. It holds for a pull that overcomes what the brakes still
/// hold at the end of a probe, limit exp(-probe_time / T_b), soon enough to move the handle by
/// motion_threshold within it. After it the handle moves out as the hand pulls it.
inline double max_release_time(const release_probe_parameters& p) {
  return p.probe_period + 2 * p.probe_time;
}

/// Without a force sensor a brake at rest cannot distinguish a push from a pull. So, while the handle touches
/// a wall or is held by an effect, brakes that have been at rest for probe_period are released (their own lag
/// is the ramp) until the handle moves:
///
///     watching --rest of probe_period--> probing --moved in, or probe_time--> watching
///                                          \--moved out--> released --moved in again, or no wall--> watching
///
/// Each probe costs a hand that presses some depth, about that which it moves in a lag of the brakes. The
/// state machine alone, of no mechanism; sensorless_controller runs it. Never allocates.
template <int D>
class release_probe {
 public:
  /// Phase of a probe, by what is commanded.
  enum class phase {
    watching,  ///< What the law commands.
    probing,   ///< Brakes that held are released.
    released,  ///< All brakes are released.
  };

  release_probe() = default;  ///< With the default parameters.
  /// Throws std::invalid_argument with the text of validate(p).
  explicit release_probe(const release_probe_parameters& p) : p_(require_valid(p)) {}

  /// One cycle in contact: time [s], handle x [m], the direction n of the force that holds (the wall's
  /// normal), and for how long some brake has been at rest [s].
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

  /// A cycle without a wall, or a fault.
  void clear() { phase_ = phase::watching; }

  /// As of the last update.
  phase now() const { return phase_; }

 private:
  void begin(phase next, double time, const point<D>& x) {
    phase_ = next;
    since_ = time;
    origin_ = x;
  }

  release_probe_parameters p_;
  phase phase_ = phase::watching;
  double since_ = 0;                    // when the phase began [s]
  point<D> origin_ = point<D>::Zero();  // and where; when released, the farthest point out
};

}  // namespace passive_haptics
