#include <configuration/home.hpp>
#include <devices/haptic_device.hpp>
#include <file_descriptor.hpp>
#include <log/device_name.hpp>
#include <ports/ports.hpp>
#include <report/report.hpp>
#include <session.hpp>

#include <passive_haptics/driver/control_loop.hpp>
#include <passive_haptics/driver/process/recorder.hpp>
#include <passive_haptics/driver/process/supervisor.hpp>
#include <passive_haptics/driver/real_time.hpp>
#include <passive_haptics/driver/safe_port.hpp>
#include <passive_haptics/driver/stop_signals.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string_view>
#include <utility>

namespace example {
namespace {

class session {
 public:
  session(const configuration& c, const session_options& options)
      : configuration_(c),
        options_(options),
        device_(std::make_unique<haptic_device>(c)),
        port_(make_port(c, *device_, port_use::control), make_sensor(c, *device_), c.safety),
        record_(report_sink(options, c)),
        guard_(make_port(c, *device_, port_use::release), c.supervisor, c.safety.at_release,
               c.safety.currents) {}

  int run() {
    // Processes first, then real-time settings, then the device with its threads, which inherit them
    std::string error = record_.start();
    if (error.empty()) error = guard_.start();
    const ph::real_time quick(error.empty() ? configuration_.real_time : ph::real_time_parameters());
    if (error.empty()) error = port_.open();
    if (!error.empty()) {
      std::cerr << "error: " << error << "\n";
      return 1;
    }
    check_watchdog();
    for (const auto& setting : quick.settings())
      std::cout << setting.what << (setting.refused.empty() ? "" : ": failed, " + setting.refused) << "\n";
    std::cout << home_in_words(configuration_) << release_in_words() << std::flush;

    ph::control_loop loop(configuration_.loop);
    begin_ = ph::monotonic_seconds();
    ph::fault_record reason;
    ph::loop_report report =
        loop.run([&](const ph::loop_cycle& now) { return cycle(now); }, [&] { return signals_.stop() != 0; },
                 [&](ph::fault why) {
                   port_.release({why});
                   reason = port_.reason();
                 });
    see_the_release_through(loop, report);
    guard_.stop();
    recorded_ = record_.stop();
    summarise(report, reason);
    const bool log_is_whole = configuration_.log.empty() || (recorded_ && record_.lost() == 0);
    const bool well = reason.what == ph::fault::user && faults_ == 0 && port_.applied_is_known();
    return (well ? 0 : fault_status) + (log_is_whole ? 0 : log_status);
  }

 private:
  static constexpr int fault_status = 3, log_status = 4;  // both: sum

  // A device that releases before the supervisor acts would violate the policy
  void check_watchdog() const {
    const double watchdog = port_.port().watchdog(), latest = configuration_.supervisor.latest();
    if (configuration_.safety.at_release.policy == ph::release_policy::zero || latest < watchdog) return;
    throw std::invalid_argument(
        "[safety] supervisor_timeout [s] = " + ph::detail::number_text(configuration_.supervisor.timeout) +
        ": expected less than 0.8 of the device's watchdog, " + ph::detail::number_text(watchdog) +
        ", or at_release = \"zero\"");
  }

  // Currents after the death of a process
  std::string release_in_words() const {
    const ph::release_parameters& release = configuration_.safety.at_release;
    const double watchdog = port_.port().watchdog();
    const auto seconds = [](double s) { return ph::detail::number_text(s) + " s"; };
    std::string text = "at a release: 0 A";
    if (release.policy == ph::release_policy::ramp)
      text = "at a release: down to 0 A within " + seconds(release.ramp_time);
    if (release.policy == ph::release_policy::hold)
      text =
          "at a release: the last currents stay, at the end of the program for " + seconds(release.hold_time);
    text += "; if the loop dies or stops, its supervisor does so after " +
            seconds(configuration_.supervisor.latest()) + " at most\nif both do: ";
    return text +
           (watchdog > 0
                ? "the device's watchdog releases the brakes after " + seconds(watchdog) + "\n"
                : "nothing releases the brakes, as the device has no watchdog: keep the emergency stop in "
                  "reach\n");
  }

  // After the loop has released the brakes: continues the release each cycle to its end, then 0 A. A threaded
  // port reports the result later
  void see_the_release_through(ph::control_loop<>& loop, ph::loop_report& report) {
    const double end = ph::monotonic_seconds() + configuration_.safety.at_release.max_duration();
    go_on_while(loop, report,
                [&](double now) { return now < end && port_.applied() != ph::brake_currents<max_axes>{}; });
    port_.release_immediately();
    const double latest = ph::monotonic_seconds() + configuration_.safety.hold_over;
    go_on_while(loop, report,
                [&](double now) { return now < latest && !port_.applied_is_known() && !port_.is_lost(); });
  }

  // Cycles without the law
  template <class Condition>
  void go_on_while(ph::control_loop<>& loop, ph::loop_report& report, const Condition& condition) {
    if (!condition(ph::monotonic_seconds())) return;
    const std::int64_t before = number_;
    const ph::loop_report rest = loop.run(
        [&](const ph::loop_cycle& now) {
          record r = device_->blank_record();
          port_.read(now.time);
          device_->cycle(last_samples(now.time), phase::homing, r);  // for the position
          beat(now.time);
          port_.write({});
          log({before + now.number, now.time, now.late}, r);
          return condition(now.time);
        },
        [] { return false; }, [](ph::fault) {});
    report.cycles += rest.cycles;
  }

  void beat(double now) {
    if (!guard_.beat(now, port_.applied())) port_.release({ph::fault::supervisor_lost}, guard_.began());
  }

  bool cycle(const ph::loop_cycle& now) {
    port_.read(now.time);
    const samples read = last_samples(now.time);
    const bool good = port_.pending_fault().what == ph::fault::none;
    if (doing_ != phase::running && port_.state() == ph::port_state::ready && good)
      doing_ = device_->prepare(read);
    const bool released = port_.state() == ph::port_state::released;
    if (signals_.rearm(released) && guard_.alive() && port_.rearm()) {
      guard_.rearm();
      device_->reset();
    }
    if (doing_ == phase::running && port_.state() == ph::port_state::ready) activate(read);

    record r = device_->blank_record();
    const auto wanted = device_->cycle(read, doing_, r);
    beat(now.time);  // last: a release by the supervisor is detected before currents are written
    port_.write(wanted);
    log(now, r);
    return r.time < options_.seconds;
  }

  // Not deep in a wall, which would hold the handle there
  void activate(const samples& read) {
    deepest_ = device_->deepest_wall(read);
    if (!deepest_.is_over(configuration_.start.max_start_depth))
      was_active_ = port_.activate() || was_active_;
  }

  samples last_samples(double now) const noexcept {
    return {now - begin_, port_.position_time(), port_.position(), port_.force()};
  }

  void log(const ph::loop_cycle& now, record& r) {
    number_ = now.number;
    r.time = now.time - begin_;
    r.number = now.number;
    r.doing = doing_;
    r.state = port_.state();
    r.reason = port_.reason();
    if (r.state == ph::port_state::ready && deepest_.is_over(configuration_.start.max_start_depth))
      r.too_deep = deepest_;
    r.needs_homing = port_.needs_homing();
    r.held_over = port_.pending_fault();
    std::copy_n(port_.applied().begin(), r.current.count, r.current.values.begin());
    r.current_is_known = port_.applied_is_known();
    r.late = now.late;
    r.compute = ph::monotonic_seconds() - now.time;
    count_faults(r);
    if (!record_(r)) warn_of_a_full_log();
  }

  // Counts releases by faults, rearmed or not, for the exit status
  void count_faults(const record& r) {
    const bool faulty = r.state == ph::port_state::released && r.reason.what != ph::fault::user;
    if (faulty && !faulty_ && faults_++ == 0) first_fault_ = r.reason;
    faulty_ = faulty;
  }

  // Once, without waiting: the recorder may be dead
  void warn_of_a_full_log() {
    constexpr std::string_view text =
        "warning: log: cycles are lost, as the recorder does not write them in time\n";
    if (std::exchange(warned_, true) || !warnings_.is_open()) return;
    if (write(warnings_.get(), text.data(), text.size()) < 0) return;
  }

  void summarise(const ph::loop_report& report, const ph::fault_record& reason) const {
    const auto line = [](const char* name, const ph::duration_histogram& h) {
      const auto at = [&](double share) { return duration(static_cast<double>(h.percentile(share))); };
      std::cout << name << "  mean " << duration(h.mean()) << ", p50 " << at(0.5) << ", p99 " << at(0.99)
                << ", p99.9 " << at(0.999) << ", max " << duration(static_cast<double>(h.maximum())) << "\n"
                << bars(h);
    };
    std::cout << "\n"
              << report.cycles << " cycles, " << report.missed << " missed, " << report.overruns
              << " overruns\n";
    line("late   ", report.late);
    line("compute", report.compute);
    std::cout << "brakes released: " << to_string(reason) << "\n";
    if (faults_ > 0 && reason != first_fault_)
      std::cout << "releases by a fault before: " << faults_ << ", first: " << to_string(first_fault_)
                << "\n";
    if (!port_.applied_is_known()) std::cout << "the device did not confirm 0 A\n";
    if (!report.exception.empty()) std::cout << "the control law threw: " << report.exception << "\n";
    if (doing_ != phase::running)
      std::cout << (doing_ == phase::homing ? "homing" : "taring")
                << " did not end: " << (faults_ > 0 ? "the brakes were released first" : device_->hindrance())
                << "\n";
    else if (!was_active_ && deepest_.is_over(configuration_.start.max_start_depth))
      std::cout << not_activated_in_words(deepest_) << "\n";
    for (const auto& [device, samples] : {std::pair{"encoders", &port_.encoder_rejections()},
                                          std::pair{"force sensor", &port_.force_rejections()}})
      if (samples->rejected() > 0)
        std::cout << device << ": " << samples->rejected() << " of " << samples->arrived()
                  << " samples rejected ("
                  << ph::detail::number_text(std::round(1000 * samples->share()) / 10) << " %)\n";
    if (port_.arrivals().found() && configuration_.port != "simulated")
      std::cout << "the times of the encoders look like arrival times: "
                << std::lround(100 * port_.arrivals().share())
                << " % came soon after the one before, which makes rates wrong (docs/guide/driver.md)\n";
    if (port_.needs_homing()) std::cout << "the position is lost: start the program again in the home pose\n";
    if (!configuration_.log.empty())
      std::cout << "log: " << configuration_.log
                << (recorded_ ? "" : ".part, as far as it came: the recorder failed") << ", "
                << record_.lost() << " cycles lost\n";
    if (!configuration_.log.empty() && recorded_)
      std::cout << "device: " << device_name(configuration_.log) << "\n";
  }

  configuration configuration_;
  session_options options_;
  std::unique_ptr<haptic_device> device_;
  ph::safe_port<any_brake_port, any_force_sensor> port_;
  ph::recorder<record, report_sink> record_;
  ph::supervisor<any_brake_port> guard_;
  ph::stop_signals signals_;
  // stderr, reopened because it is shared; not for a file, since writing may take long
  file_descriptor warnings_{isatty(STDERR_FILENO) != 0
                                ? open("/proc/self/fd/2", O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC)
                                : -1};
  bool warned_ = false;
  bool was_active_ = false;
  wall_depth deepest_;  // at the last attempt to activate
  phase doing_ = phase::homing;
  double begin_ = 0;         // [s]
  std::int64_t number_ = 0;  // of the last cycle
  int faults_ = 0;           // that released the brakes
  bool faulty_ = false;      // in the last cycle
  ph::fault_record first_fault_;
  bool recorded_ = true;  // true if the recorder ended well
};

}  // namespace

int run_session(const configuration& c, const session_options& options) { return session(c, options).run(); }

}  // namespace example
