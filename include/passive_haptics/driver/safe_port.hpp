/// @file
/// A port that no bad sample, command or device can hurt a hand through.
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

/// A port and a force sensor, watched: the last good samples in, currents that may flow out. To be called
/// once a cycle, read(), then write(), with the time of the cycle [s] on the clock of the samples.
///
///   open -> ready -> activate -> active <-> degraded -> (fault) -> released -> rearm -> ready
///
/// Hold-over: for `hold_over` seconds the last good sample is used instead of bad or older ones, then the
/// brakes are released; also if a quarter of the samples were rejected (rejected_samples). They are released
/// at once if the device is lost or restarted, an encoder froze, a counter may have wrapped unseen, a command
/// is not valid, or no cycle came for `hold_over`. If it is unknown how far the encoders went, the program
/// must start again, with homing. After open() nothing here allocates, throws, locks or reads a clock.
template <class Port, class Sensor = no_force_sensor>
class safe_port {
 public:
  static_assert(is_port<Port, explain>() && is_force_sensor<Sensor, explain>());
  static constexpr int encoder_count = Port::encoder_count;              ///< Encoders.
  static constexpr int brake_count = Port::brake_count;                  ///< Brakes.
  static constexpr int channel_count = Sensor::channel_count;            ///< Channels of the force sensor.
  using currents = brake_currents<brake_count>;                          ///< [A]
  using parameters = safe_port_parameters<brake_count, channel_count>;   ///< What it allows.
  using encoder_counts = typename encoder_check<encoder_count>::counts;  ///< [counts]
  using force_reading = std::array<double, std::size_t(channel_count)>;  ///< As the sensor reports it.

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

  /// Opens device and sensor, once; empty if both are there, else what is missing.
  std::string open() {
    if (state_ != port_state::closed) return "open() was called before: the device is open";
    std::string error = port_.open();
    if (error.empty() && !release_.is_at_once() && !(watchdog(port_) > 0))
      error = "at_release.policy, expected zero: a device without a watchdog keeps currents for ever";
    if (error.empty()) error = sensor_.open();
    encoders_.set_counter_bits(counter_bits(port_));
    if (error.empty()) error = period_.error(encoders_.wrap_time(), counter_bits(port_));
    if (error.empty()) state_ = port_state::ready;
    else port_.release();
    return error;
  }

  /// Takes this cycle's samples.
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

  /// Gives the brakes their currents [A], or what the state allows of them; see applied().
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

  /// From ready to active; false, and nothing happens, unless ready, the samples are good and not
  /// needs_homing(). If the parameters have no `period`, it is the median of the first 20 spacings of read():
  /// if a counter can wrap unseen within it, the position is lost.
  bool activate() noexcept {
    if (state_ != port_state::ready || !is_fit()) return false;
    if (period_.value() >= encoders_.wrap_time()) fail({fault::counter_wrapped, fault_source::encoders});
    else state_ = port_state::active;
    return holds();
  }

  /// Releases the brakes. What is released stays so, with the first reason. `begun`: the release of another
  /// process (supervisor::began()), which goes on here.
  void release(const fault_record& why = {fault::user},
               const std::optional<release_start<brake_count>>& begun = {}) noexcept {
    if (state_ == port_state::closed) return;
    fail(why);
    if (begun) release_.take_over(*begun);
  }

  /// Releases the brakes, and gives 0 A at once, whatever the release policy.
  void release_immediately(const fault_record& why = {fault::user}) noexcept {
    release(why);
    release_.begin({});
    give_none();
  }

  /// From released to ready; false, and nothing happens, unless released, the last transfers are good and the
  /// encoders have not lost their way (needs_homing()).
  bool rearm() noexcept {
    if (state_ != port_state::released || !is_fit()) return false;
    reason_ = {};
    limiter_.release();
    state_ = port_state::ready;
    return true;
  }

  /// The state.
  port_state state() const noexcept { return state_; }
  /// Why the brakes are released; none where they are not.
  const fault_record& reason() const noexcept { return reason_; }
  /// What is wrong with the last samples, or with the last write; none where they are good.
  const fault_record& pending_fault() const noexcept {
    const auto& samples = encoder_samples_.result().what != fault::none ? encoder_samples_ : force_samples_;
    return samples.result().what != fault::none ? samples.result() : writes_.result();
  }
  /// Whether it is unknown how far the encoders went: then the program must start again.
  bool needs_homing() const noexcept { return !homed_; }
  /// Where the encoders are, past every wrap of their counters: the last good reading [counts].
  const encoder_counts& position() const noexcept { return encoders_.position(); }
  /// When that was [s].
  double position_time() const noexcept { return encoders_.time(); }
  /// Whether the times of the encoders look like those of their arrival, which makes rates wrong.
  const arrival_check& arrivals() const noexcept { return encoders_.arrivals(); }
  /// The encoders' samples that arrived and that were rejected.
  const rejected_samples& encoder_rejections() const noexcept { return encoder_samples_.rejections(); }
  /// The force sensor's samples that arrived and that were rejected.
  const rejected_samples& force_rejections() const noexcept { return force_samples_.rejections(); }
  /// The last good reading of the force sensor.
  const force_reading& force() const noexcept { return forces_.reading(); }
  /// What the device last took [A]; a release counts as 0 A unless it is lost or refuses what is written. If
  /// the brakes are released and nothing was taken for hold_over seconds, NaN: what flows is unknown, and a
  /// supervisor that gets NaN as its heartbeat acts (supervisor::beat()).
  currents applied() const noexcept {
    const bool known = state_ != port_state::released || now_ - writes_.last_good() <= hold_over_;
    return known ? applied_ : same_for_each<brake_count>(std::numeric_limits<double>::quiet_NaN());
  }
  /// Whether the brakes have these currents, as far as the device reports: false while it is lost or refuses.
  bool applied_is_known() const noexcept { return !lost_ && writes_.result().what == fault::none; }
  /// Whether the device is lost: nothing can be read or written any more, and no call tries to.
  bool is_lost() const noexcept { return lost_; }
  /// The port, for members that only the port has.
  const Port& port() const noexcept { return port_; }

 private:
  bool holds() const noexcept { return state_ == port_state::active || state_ == port_state::degraded; }
  bool is_positioned() const noexcept { return std::isfinite(encoder_samples_.last_good()); }
  bool is_fit() const noexcept {
    return homed_ && is_positioned() && encoder_samples_.is_good() && force_samples_.is_good() &&
           writes_.is_good();
  }
  bool flows() const noexcept { return applied_ != currents{}; }

  // Nothing is to flow without being watched, also where the device refuses to end it
  void act_on(const transfer_watch& transfers) noexcept {
    const fault_record& found = transfers.result();
    const bool of_position = found.source == fault_source::encoders && invalidates_position(found.what);
    const bool matters = holds() || flows() || (of_position && is_positioned());
    if (releases_immediately(found) || (matters && transfers.fails())) fail(found);
  }

  // since: when a cycle last came [s]
  void fail(const fault_record& why) noexcept { fail(why, now_); }
  void fail(const fault_record& why, double since) noexcept {
    const bool begins = state_ != port_state::released;  // a fault that stays sends no release each cycle
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
  bool lost_ = false;  // nothing can be read or written any more
  bool homed_ = true;
  fault_record reason_;
  currents applied_{};
  double now_ = -std::numeric_limits<double>::infinity(), dt_ = 0;  // [s]
};

}  // namespace passive_haptics
