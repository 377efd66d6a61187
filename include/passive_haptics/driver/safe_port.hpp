/// @file
/// A port that no bad sample, command or device can hurt a hand through.
#pragma once

#include <passive_haptics/driver/checks/believed_samples.hpp>
#include <passive_haptics/driver/checks/loop_period.hpp>
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
/// Hold-over: for `hold_over` seconds the last good sample stands in for bad ones, then the brakes are
/// released. They are also released if a quarter of the samples of the last ten `hold_over` were rejected
/// (rejected_samples). They are released at once where the device is lost or restarted, an encoder froze, a
/// counter may have wrapped unseen, a command is not valid, or no cycle came for `hold_over` seconds. An
/// older sample than that counts as bad. If it is not known any more how far the encoders went, the program
/// must start again, with homing. Nothing here allocates, throws, locks or reads a clock after open().
template <class Port, class Sensor = no_force_sensor>
class safe_port {
 public:
  static_assert(port_requirements<Port>::met && sensor_requirements<Sensor>::met);
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
    if (error.empty() && period_.value() >= encoders_.wrap_time()) error = period_error();
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

    const fault_record encoders = encoders_.read(port_, now_, !flows() && applied_is_known());
    const fault_record sensor = forces_.read(sensor_, now_);
    bad_sample_ = encoders.what != fault::none ? encoders : sensor;
    const bool too_many = encoders_.rejections().is_too_many();
    if (invalidates_position(encoders.what) && is_positioned() && lasts(encoders, encoders_good_, too_many))
      lose_position(encoders);
    watch(encoders, encoders_good_, too_many);
    watch(sensor, sensor_good_, forces_.rejections().is_too_many());
    settle();
    return state_;
  }

  /// Gives the brakes their currents [A], or what the state allows of them; see applied().
  port_state write(const currents& wanted) noexcept {
    if (state_ == port_state::closed) return state_;
    const auto bad = std::ranges::find_if_not(wanted, [](double x) { return std::isfinite(x) && x >= 0; });
    if (holds() && bad != wanted.end())
      fail({fault::current_not_valid, fault_source::brakes, static_cast<int>(bad - wanted.begin())});
    currents asked{};
    if (holds()) asked = wanted;
    if (lost_) return state_;
    if (state_ == port_state::released) {
      asked = release_(now_);
      release_.attend(now_);
    }
    const currents flowing = limiter_(asked, dt_);

    const port_status written = port_.write(flowing);
    bad_write_ = {};
    if (written == port_status::ok) applied_ = flowing;
    else
      bad_write_ = {written == port_status::failed ? fault::device_lost : fault::write_refused,
                    fault_source::brakes};
    watch(bad_write_, write_good_);
    settle();
    return state_;
  }

  /// From ready to active; false, and nothing happens, unless ready, the samples are good and the
  /// encoders have not lost their way (needs_homing()). If the parameters have no `period`, it is the median
  /// of the first 20 spacings of read(): if a counter can wrap unseen within it, the position is lost.
  bool activate() noexcept {
    if (state_ != port_state::ready || !is_fit()) return false;
    if (period_.value() >= encoders_.wrap_time()) {
      lose_position({fault::counter_wrapped, fault_source::encoders});
      return false;
    }
    state_ = port_state::active;
    return true;
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
  void let_go(const fault_record& why = {fault::user}) noexcept {
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
    return bad_sample_.what != fault::none ? bad_sample_ : bad_write_;
  }
  /// Whether it is unknown how far the encoders went: then the program must start again.
  bool needs_homing() const noexcept { return !homed_; }
  /// Where the encoders are, past every wrap of their counters: the last good reading [counts].
  const encoder_counts& position() const noexcept { return encoders_.position(); }
  /// When that was [s].
  double position_time() const noexcept { return encoders_.time(); }
  /// Whether the times of the encoders look like those of their arrival, which makes rates wrong.
  const arrival_check& arrivals() const noexcept { return encoders_.arrivals(); }
  /// How many samples of the encoders were rejected.
  const rejected_samples& encoder_rejections() const noexcept { return encoders_.rejections(); }
  /// How many samples of the force sensor were rejected.
  const rejected_samples& force_rejections() const noexcept { return forces_.rejections(); }
  /// The last good reading of the force sensor.
  const force_reading& force() const noexcept { return forces_.reading(); }
  /// What the device last took [A]; a release counts as 0 A unless it is lost or refuses what is written. If
  /// the brakes are released and nothing was taken for hold_over seconds, NaN: what flows is unknown, and a
  /// supervisor that gets NaN as its heartbeat acts (supervisor::beat()).
  currents applied() const noexcept {
    const bool known = state_ != port_state::released || now_ - write_good_ <= hold_over_;
    return known ? applied_ : same_for_each<brake_count>(std::numeric_limits<double>::quiet_NaN());
  }
  /// Whether the brakes have these currents, as far as the device reports: false while it is lost or refuses.
  bool applied_is_known() const noexcept { return !lost_ && bad_write_.what == fault::none; }
  /// Whether the device is lost: nothing can be read or written any more, and no call tries to.
  bool is_lost() const noexcept { return lost_; }
  /// The port, for members that only the port has.
  const Port& port() const noexcept { return port_; }

 private:
  static constexpr double never = -std::numeric_limits<double>::infinity();

  bool holds() const noexcept { return state_ == port_state::active || state_ == port_state::degraded; }
  bool is_positioned() const noexcept { return std::isfinite(encoders_good_); }
  bool is_fit() const noexcept {
    return homed_ && is_positioned() && pending_fault().what == fault::none &&
           !encoders_.rejections().is_too_many() && !forces_.rejections().is_too_many();
  }
  std::string period_error() const {
    return detail::error_text(
        "period [s]", period_.value(),
        detail::indexed("less than ", encoders_.wrap_time(), ", within which a counter of ") +
            detail::indexed(
                "", counter_bits(port_),
                " bits can wrap unseen: shorten it, lower encoders.largest_rate or use a wider counter"));
  }
  // Nothing is to flow without being watched, also where the device refuses to end it
  bool flows() const noexcept { return applied_ != currents{}; }

  // What may be held over lasts too long hold_over seconds after the last time that all was good, or if too
  // many samples were rejected; the rest does at once
  bool lasts(const fault_record& found, double good, bool too_many) const noexcept {
    return releases_immediately(found) || now_ - good > hold_over_ || too_many;
  }
  void watch(const fault_record& found, double& good, bool too_many = false) noexcept {
    if (found.what == fault::none) good = now_;
    else if (releases_immediately(found) || ((holds() || flows()) && lasts(found, good, too_many)))
      fail(found);
  }

  void lose_position(const fault_record& why) noexcept {
    homed_ = false;
    fail(why);
  }

  // since: when a cycle last came [s]
  void fail(const fault_record& why) noexcept { fail(why, now_); }
  void fail(const fault_record& why, double since) noexcept {
    const bool begins = state_ != port_state::released;
    if (why.what == fault::device_lost && why.source != fault_source::force_sensor) lost_ = true;
    if (lost_) homed_ = false;
    if (state_ != port_state::released) {
      reason_ = why;
      release_.begin({since, applied_});
    }
    state_ = port_state::released;
    // A fault that stays is no reason to send a release each cycle
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
  current_limiter<brake_count> limiter_;
  release_profile<brake_count> release_;

  port_state state_ = port_state::closed;
  bool lost_ = false;  // nothing can be read or written any more
  bool homed_ = true;
  fault_record reason_, bad_sample_, bad_write_;
  currents applied_{};
  double now_ = never, dt_ = 0;                                              // [s]
  double encoders_good_ = never, sensor_good_ = never, write_good_ = never;  // when last [s]
};

}  // namespace passive_haptics
