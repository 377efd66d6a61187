/// A port that protects the hand from bad samples, commands and devices.
#pragma once

#include <passive_haptics/driver/checks/believed_samples.hpp>
#include <passive_haptics/driver/checks/loop_period.hpp>
#include <passive_haptics/driver/checks/transfer_watch.hpp>
#include <passive_haptics/driver/safe_port_parameters.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace passive_haptics {

/// A supervised port and force sensor: provides the last good samples and limits the currents. Call read(),
/// then write(), once per cycle, with the time of the cycle [s] on the clock of the samples.
///
///   open -> ready -> activate -> active <-> degraded -> (fault) -> released -> rearm -> ready
///
/// Hold-over: bad or old samples are replaced by the last good one for `hold_over` seconds, then the brakes
/// are released; also if a quarter of the samples were rejected (rejected_samples). They are released
/// immediately if the device is lost or restarted, an encoder froze, a counter may have wrapped undetected, a
/// command is not valid, or no cycle came for `hold_over`. If the encoder positions are lost, the program
/// must restart with homing. After open() it neither allocates, throws, locks nor reads a clock.
template <class Port, class Sensor = no_force_sensor>
class safe_port {
 public:
  static_assert(is_port<Port, explain>() && is_force_sensor<Sensor, explain>());
  static constexpr int encoder_count = Port::encoder_count;              ///< Number of encoders.
  static constexpr int brake_count = Port::brake_count;                  ///< Number of brakes.
  static constexpr int channel_count = Sensor::channel_count;            ///< Number of force channels.
  using currents = brake_currents<brake_count>;                          ///< [A]
  using parameters = safe_port_parameters<brake_count, channel_count>;   ///< Parameters.
  using encoder_counts = typename encoder_check<encoder_count>::counts;  ///< [counts]
  using force_reading = std::array<double, std::size_t(channel_count)>;  ///< As reported by the sensor.

  /// Throws std::invalid_argument with the text of validate(p).
  explicit safe_port(Port port, Sensor sensor = {}, const parameters& p = {})
      : port_(std::move(port)),
        sensor_(std::move(sensor)),
        hold_over_(require_valid(p).hold_over),
        period_(p.period),
        encoders_(hold_over_, p.encoders),
        forces_(hold_over_, p.sensor),
        encoder_samples_(hold_over_),
        force_samples_(hold_over_),
        writes_(hold_over_),
        limiter_(p.currents),
        release_(p.at_release) {}
  safe_port(const safe_port&) = delete;
  safe_port& operator=(const safe_port&) = delete;
  ~safe_port() { port_.release(); }

  /// Opens device and sensor. Returns an error or an empty string.
  std::string open() {
    if (state_ != port_state::closed) return "open() was called twice: the device is open; call it once";
    std::string error = port_.open();
    if (error.empty() && !release_.is_at_once() && !(watchdog(port_) > 0))
      error = std::string("at_release.policy = ")
                  .append(release_.policy() == release_policy::ramp ? "ramp" : "hold")
                  .append(
                      ": expected zero: a device without a watchdog keeps its currents; set zero, or use a "
                      "device with a watchdog");
    if (error.empty()) error = sensor_.open();
    encoders_.set_counter_bits(counter_bits(port_));
    if (error.empty()) error = period_.error(encoders_.wrap_time(), counter_bits(port_));
    if (error.empty()) state_ = port_state::ready;
    else port_.release();
    return error;
  }

  /// Reads and checks this cycle's samples.
  port_state read(double now) noexcept {
    if (state_ == port_state::closed) return state_;
    const double before = std::exchange(now_, now);
    dt_ = now > before && std::isfinite(before) ? now - before : 0;
    if (dt_ > 0) period_.add(dt_);
    if (!(now > before && std::isfinite(now))) fail({fault::clock_jump});
    else if (holds() && now - before > hold_over_) fail({fault::cycle_late}, before);
    if (lost_) return state_;

    encoder_samples_.add(encoders_.read(port_, now_, !flows() && applied_is_known()), now_);
    force_samples_.add(forces_.read(sensor_, now_), now_);
    act_on(encoder_samples_);
    act_on(force_samples_);
    settle();
    return state_;
  }

  /// Applies currents [A] as far as the state allows; see applied().
  port_state write(const currents& wanted) noexcept {
    if (state_ == port_state::closed) return state_;
    const auto invalid =
        std::find_if_not(wanted.begin(), wanted.end(), [](double x) { return std::isfinite(x) && x >= 0; });
    if (holds() && invalid != wanted.end())
      fail({fault::current_not_valid, fault_source::brakes, static_cast<int>(invalid - wanted.begin())});
    currents asked{};
    if (holds()) asked = wanted;
    if (lost_) return state_;
    if (state_ == port_state::released) {
      asked = release_(now_);
      release_.attend(now_);
    }
    const currents flowing = limiter_(asked, dt_);

    const port_status written = port_.write(flowing);
    const fault bad = written == port_status::failed ? fault::device_lost : fault::write_refused;
    if (written == port_status::ok) applied_ = flowing;
    writes_.add(written == port_status::ok ? fault_record() : fault_record{bad, fault_source::brakes}, now_);
    act_on(writes_);
    settle();
    return state_;
  }

  /// Ready to active; false unless ready, with good samples and not needs_homing(). If a counter can wrap
  /// undetected within the period (given, or the median of 20 spacings of read()), the position is lost.
  bool activate() noexcept {
    if (state_ != port_state::ready || !is_fit()) return false;
    if (period_.value() >= encoders_.wrap_time()) fail({fault::counter_wrapped, fault_source::encoders});
    else state_ = port_state::active;
    return holds();
  }

  /// Releases the brakes, for the first reason. `begun`: another process's release (supervisor::began()).
  void release(const fault_record& why = {fault::user},
               const std::optional<release_start<brake_count>>& begun = {}) noexcept {
    if (state_ == port_state::closed) return;
    fail(why);
    if (begun) release_.take_over(*begun);
  }

  /// Releases the brakes with 0 A immediately, for any release policy.
  void release_immediately(const fault_record& why = {fault::user}) noexcept {
    release(why);
    release_.begin({});
    give_none();
  }

  /// Released to ready; false unless released, with good last transfers and not needs_homing().
  bool rearm() noexcept {
    if (state_ != port_state::released || !is_fit()) return false;
    reason_ = {};
    limiter_.release();
    state_ = port_state::ready;
    return true;
  }

  port_state state() const noexcept { return state_; }  ///< The state.
  /// Reason for the release; none if not released.
  const fault_record& reason() const noexcept { return reason_; }
  /// Fault of the last samples or write; none if they are good.
  const fault_record& pending_fault() const noexcept {
    const auto& samples = encoder_samples_.result().what != fault::none ? encoder_samples_ : force_samples_;
    return samples.result().what != fault::none ? samples.result() : writes_.result();
  }
  /// True if the encoder positions are lost: the program must restart.
  bool needs_homing() const noexcept { return !homed_; }
  /// Encoder positions beyond counter wraps, by the last good reading [counts].
  const encoder_counts& position() const noexcept { return encoders_.position(); }
  double position_time() const noexcept { return encoders_.time(); }  ///< Time of that reading [s].
  /// Check for times of arrival, which make rates wrong.
  const arrival_check& arrivals() const noexcept { return encoders_.arrivals(); }
  /// Counts of the encoders' samples.
  const rejected_samples& encoder_rejections() const noexcept { return encoder_samples_.rejections(); }
  /// Counts of the force sensor's samples.
  const rejected_samples& force_rejections() const noexcept { return force_samples_.rejections(); }
  /// Last good reading of the force sensor.
  const force_reading& force() const noexcept { return forces_.reading(); }
  /// Currents that the device last accepted [A]; NaN (unknown) if the brakes are released and nothing was
  /// accepted for hold_over seconds: then a supervisor acts (supervisor::beat()).
  currents applied() const noexcept {
    const bool known = state_ != port_state::released || now_ - writes_.last_good() <= hold_over_;
    return known ? applied_ : same_for_each<brake_count>(std::numeric_limits<double>::quiet_NaN());
  }
  /// True if the device has these currents, as far as it reports: false while it is lost or rejects writes.
  bool applied_is_known() const noexcept { return !lost_ && writes_.result().what == fault::none; }
  /// True if the device is lost; no further transfers are attempted.
  bool is_lost() const noexcept { return lost_; }
  const Port& port() const noexcept { return port_; }  ///< The port.

 private:
  bool holds() const noexcept { return state_ == port_state::active || state_ == port_state::degraded; }
  bool is_positioned() const noexcept { return std::isfinite(encoder_samples_.last_good()); }
  bool is_fit() const noexcept {
    return homed_ && is_positioned() && encoder_samples_.is_good() && force_samples_.is_good() &&
           writes_.is_good();
  }
  bool flows() const noexcept { return applied_ != currents{}; }

  // Currents must not flow unsupervised, even if the device rejects their end
  void act_on(const transfer_watch& transfers) noexcept {
    const fault_record& found = transfers.result();
    const bool of_position = found.source == fault_source::encoders && invalidates_position(found.what);
    const bool matters = holds() || flows() || (of_position && is_positioned());
    if (releases_immediately(found) || (matters && transfers.fails())) fail(found);
  }

  // since: time of the last cycle [s]
  void fail(const fault_record& why) noexcept { fail(why, now_); }
  void fail(const fault_record& why, double since) noexcept {
    const bool begins = state_ != port_state::released;  // a persistent fault sends only one release
    if (why.what == fault::device_lost && why.source != fault_source::force_sensor) lost_ = true;
    if (lost_ || (why.source != fault_source::force_sensor && invalidates_position(why.what))) homed_ = false;
    if (begins) {
      reason_ = why;
      release_.begin({since, applied_});
    }
    state_ = port_state::released;
    if (lost_ || (release_.is_at_once() && (begins || flows()))) give_none();
  }

  void give_none() noexcept {
    limiter_.release();
    port_.release();
    if (applied_is_known()) applied_ = {};
  }

  void settle() noexcept {
    if (!holds()) return;
    const bool well = pending_fault().what == fault::none && !limiter_.lowered_by_heat();
    state_ = well ? port_state::active : port_state::degraded;
  }

  Port port_;
  [[no_unique_address]] Sensor sensor_;
  double hold_over_;
  loop_period period_;
  believed_encoders<encoder_count> encoders_;
  believed_forces<channel_count> forces_;
  transfer_watch encoder_samples_, force_samples_, writes_;
  current_limiter<brake_count> limiter_;
  release_profile<brake_count> release_;

  port_state state_ = port_state::closed;
  bool lost_ = false;  // no further transfers
  bool homed_ = true;
  fault_record reason_;
  currents applied_{};
  double now_ = -std::numeric_limits<double>::infinity(), dt_ = 0;  // [s]
};

}  // namespace passive_haptics
