#include <devices/haptic_device.hpp>
#include <ports/ports.hpp>
#include <report/report.hpp>
#include <session.hpp>

#include <passive_haptics/driver/control_loop.hpp>
#include <passive_haptics/driver/process/recorder.hpp>
#include <passive_haptics/driver/process/supervisor.hpp>
#include <passive_haptics/driver/real_time.hpp>
#include <passive_haptics/driver/safe_port.hpp>
#include <passive_haptics/driver/stop_signals.hpp>

#include <iostream>

namespace example {
namespace {

using brake_port = any_brake_port<axes, axes>;

class session {
 public:
  session(const configuration& c, const session_options& options)
      : configuration_(c),
        options_(options),
        device_(make_device(c)),
        port_(make_port(c, *device_, port_use::control), make_sensor(c, *device_), c.safety),
        record_(report_sink(c.log, options.live, c)),
        guard_(make_port(c, *device_, port_use::release), c.supervisor) {}

  int run() {
    // Processes first, then what makes the loop quick, then the device, whose threads inherit it
    std::string error = record_.start();
    if (error.empty()) error = guard_.start();
    const ph::real_time quick(error.empty() ? configuration_.real_time : ph::real_time_parameters());
    if (error.empty()) error = port_.open();
    if (!error.empty()) {
      std::cerr << "error: " << error << "\n";
      return 1;
    }
    for (const auto& setting : quick.settings())
      std::cout << setting.what << (setting.refused.empty() ? "" : ": refused, " + setting.refused) << "\n";
    std::cout << std::flush;

    ph::control_loop loop(configuration_.loop);
    begin_ = ph::monotonic_seconds();
    ph::fault_record reason;
    const ph::loop_report report =
        loop.run([&](const ph::loop_cycle& now) { return cycle(now); }, [&] { return signals_.stop() != 0; },
                 [&](ph::fault why) {
                   port_.release({why});
                   reason = port_.reason();
                 });
    guard_.stop();
    log_is_whole_ = record_.stop();
    summarise(report, reason);
    return reason.what == ph::fault::user ? 0 : 3;
  }

 private:
  bool cycle(const ph::loop_cycle& now) {
    if (!guard_.beat(now.time)) port_.release({ph::fault::supervisor_lost});
    port_.read(now.time);
    const samples read{now.time, port_.position_time(), port_.position(), port_.force()};
    const bool good = port_.held_over().what == ph::fault::none;
    if (doing_ != phase::running && port_.state() == ph::port_state::ready && good)
      doing_ = device_->prepare(read);
    if (signals_.rearm() && guard_.alive() && port_.rearm()) {
      guard_.rearm();
      device_->reset();
    }
    if (doing_ == phase::running && port_.state() == ph::port_state::ready) port_.activate();

    record r;
    port_.write(device_->cycle(read, doing_, r));
    r.time = now.time - begin_;
    r.number = now.number;
    r.doing = doing_;
    r.state = port_.state();
    r.reason = port_.reason();
    r.needs_homing = port_.needs_homing();
    r.held_over = port_.held_over();
    r.current = port_.applied();
    r.late = now.late;
    r.compute = ph::monotonic_seconds() - now.time;
    record_(r);
    return r.time < options_.seconds;
  }

  void summarise(const ph::loop_report& report, const ph::fault_record& reason) const {
    const auto line = [](const char* name, const ph::duration_histogram& h) {
      const auto at = [&](double share) { return duration(static_cast<double>(h.percentile(share))); };
      std::cout << name << "  mean " << duration(h.mean()) << ", p50 " << at(0.5) << ", p99 " << at(0.99)
                << ", p99.9 " << at(0.999) << ", max " << duration(static_cast<double>(h.largest())) << "\n"
                << bars(h);
    };
    std::cout << "\n"
              << report.cycles << " cycles, " << report.missed << " missed, " << report.overruns
              << " overruns\n";
    line("late   ", report.late);
    line("compute", report.compute);
    std::cout << "brakes released: " << to_string(reason) << "\n";
    if (!report.exception.empty()) std::cout << "the control law threw: " << report.exception << "\n";
    if (doing_ != phase::running)
      std::cout << (doing_ == phase::homing ? "homing" : "taring") << " did not end: something moved\n";
    if (port_.needs_homing()) std::cout << "the encoders lost their way: start again, at the home pose\n";
    if (!configuration_.log.empty())
      std::cout << "log: " << configuration_.log
                << (log_is_whole_ ? "" : ".part, as far as it came: the recorder failed") << ", "
                << record_.lost() << " cycles lost\n";
  }

  configuration configuration_;
  session_options options_;
  std::unique_ptr<haptic_device> device_;
  ph::safe_port<brake_port, any_force_sensor> port_;
  ph::recorder<record, report_sink> record_;
  ph::supervisor<brake_port> guard_;
  ph::stop_signals signals_;
  phase doing_ = phase::homing;
  double begin_ = 0;  // [s]
  bool log_is_whole_ = true;
};

}  // namespace

int run_session(const configuration& c, const session_options& options) { return session(c, options).run(); }

}  // namespace example
