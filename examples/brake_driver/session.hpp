/// @file
/// From a configuration to brakes that hold: everything started in its order, the loop, and the summary.
#pragma once

#include <any_port.hpp>
#include <configuration.hpp>
#include <ports.hpp>
#include <report.hpp>
#include <simulation.hpp>

#include <passive_haptics/driver/control_loop.hpp>
#include <passive_haptics/driver/real_time.hpp>
#include <passive_haptics/driver/recorder.hpp>
#include <passive_haptics/driver/safe_port.hpp>
#include <passive_haptics/driver/stop_signals.hpp>
#include <passive_haptics/driver/supervisor.hpp>

#include <cmath>
#include <iostream>
#include <limits>
#include <memory>

namespace example {

/// How a session is to run.
struct session_options {
  double seconds = std::numeric_limits<double>::infinity();  ///< When it ends by itself.
  bool live = true;                                          ///< Whether the terminal shows it.
};

/// One run of a device with mechanism M under a law.
template <class M, class Law>
class session {
 public:
  session(const M& mechanism, const Law& law, const configuration& c, const session_options& options)
      : configuration_(c),
        options_(options),
        calibration_(mechanism, {c.encoders, c.rates, c.curves, c.force}, c.sensor_frame),
        control_(mechanism, c.brakes, ph::world<2>(c.walls), law),
        homing_(calibration_.encoders, calibration_.axis_positions(c.home), c.homing),
        tare_({.duration = c.homing.duration, .tolerance = c.tare_tolerance}) {}

  /// 0, or 1 where the device could not be opened or a fault released the brakes.
  int run() {
    const configuration& c = configuration_;
    const auto plant =
        c.port == "simulated" ? std::make_shared<simulation<M>>(control_.mechanism(), c) : nullptr;
    ph::safe_port<any_brake_port<axes, axes>, any_force_sensor> port(
        make_port<M>(c, plant, port_use::control), make_sensor<M>(c, plant), c.safety);

    // Processes first, then the device, then what makes the loop quick
    recorder_type record(report_sink(c.log, options_.live, c));
    ph::supervisor<any_brake_port<axes, axes>> guard(make_port<M>(c, plant, port_use::release), c.supervisor);
    for (const std::string& complaint : {record.start(), guard.start(), port.open()}) {
      if (complaint.empty()) continue;
      std::cerr << "error: " << complaint << "\n";
      return 1;
    }
    ph::stop_signals signals;
    const ph::real_time quick(c.real_time);
    for (const auto& setting : quick.settings())
      std::cout << setting.what << (setting.refused.empty() ? "" : ": refused, " + setting.refused) << "\n";
    std::cout << std::flush;

    ph::control_loop loop(c.loop);
    const double start = ph::monotonic_seconds();
    const auto report = loop.run(
        [&](const ph::loop_cycle& now) {
          record(cycle(now, start, port, guard, signals));
          return now.time - start < options_.seconds;
        },
        [&] { return signals.stop() != 0; },
        [&](ph::fault why) {
          if (why == ph::fault::user) reason_ = port.reason();
          port.release({why});
        });

    record.stop();
    guard.stop();
    summarise(report, record.lost());
    return reason_.what == ph::fault::none && report.ended_by == ph::fault::none ? 0 : 1;
  }

 private:
  using recorder_type = ph::recorder<example::record, report_sink>;

  template <class Port, class Guard>
  example::record cycle(const ph::loop_cycle& now, double start, Port& port, Guard& guard,
                        ph::stop_signals& signals) {
    if (!guard.beat(now.time)) port.release({ph::fault::supervisor_lost});
    port.read(now.time);
    auto state = calibration_.state(port.position_time(), port.position(), port.force());
    state.time = now.time;
    if (phase_ != phase::running) prepare(port);
    if (signals.rearm() && port.rearm()) {
      guard.rearm();
      control_.reset();
    }
    if (phase_ == phase::running && port.state() == ph::port_state::ready) port.activate();

    ph::step_result_for<M, ph::world<2>::contacts_type> decided;
    if (phase_ == phase::running) decided = control_(state);
    port.write(calibration_.currents(decided.capacity));

    example::record r;
    r.time = now.time - start;
    r.number = now.number;
    r.phase = phase_;
    r.state = port.state();
    r.reason = port.reason();
    r.bridged = port.bridged();
    r.outcome = decided.outcome;
    r.power = decided.power;
    r.display = decided.display;
    r.gamma = decided.desired_force.isZero(0) ? 0 : decided.approximation_angle();
    r.alpha = decided.alpha;
    const ph::task_vector<M> x = control_.mechanism().position(state.q);
    for (int i = 0; i < 2; ++i) {
      const auto k = static_cast<std::size_t>(i);
      r.q[k] = state.q[i];
      r.qd[k] = state.qd[i];
      r.x[k] = x[i];
      r.hand[k] = state.hand_force[i];
      r.desired[k] = decided.desired_force[i];
      r.capacity[k] = decided.capacity[i];
    }
    r.current = port.applied();
    r.late = now.late;
    r.compute = ph::monotonic_seconds() - now.time;
    return r;
  }

  // The handle rests at its home pose, then the hand is off the sensor; meanwhile no brake holds
  template <class Port>
  void prepare(Port& port) {
    if (port.bridged().what != ph::fault::none || port.state() != ph::port_state::ready) return;
    if (phase_ == phase::homing) {
      if (homing_.add(port.position_time(), calibration_.counts()) != ph::steady_status::done) return;
      calibration_.encoders.set_zero_count(homing_.zero_count());
      phase_ = configuration_.tare ? phase::taring : phase::running;
    } else {
      const ph::vector<double, sensor_channels> raw(port.force().data());
      if (tare_.add(port.position_time(), raw) != ph::steady_status::done) return;
      calibration_.force.set_tare(
          calibration_.force.tare_of(tare_.mean(), calibration_.sensor_frame(configuration_.home)));
      phase_ = phase::running;
    }
  }

  void summarise(const ph::loop_report& report, std::uint64_t lost) const {
    const auto line = [](const char* name, const ph::duration_histogram& h) {
      std::cout << name << "  mean " << duration(h.mean()) << ", p50 "
                << duration(static_cast<double>(h.percentile(0.5))) << ", p99 "
                << duration(static_cast<double>(h.percentile(0.99))) << ", p99.9 "
                << duration(static_cast<double>(h.percentile(0.999))) << ", max "
                << duration(static_cast<double>(h.largest())) << "\n"
                << bars(h);
    };
    std::cout << "\n"
              << report.cycles << " cycles, " << report.missed << " missed, " << report.overruns
              << " overruns\n";
    line("late   ", report.late);
    line("compute", report.compute);
    std::cout << "brakes released: " << (reason_.what == ph::fault::none ? "at the end" : to_string(reason_))
              << "\n";
    if (!report.exception.empty()) std::cout << "the control law threw: " << report.exception << "\n";
    if (phase_ != phase::running)
      std::cout << (phase_ == phase::homing ? "homing" : "taring") << " did not end: something moved\n";
    if (!configuration_.log.empty())
      std::cout << "log: " << configuration_.log << ", " << lost << " cycles lost\n";
  }

  configuration configuration_;
  session_options options_;
  ph::device_calibration<M, sensor_channels, ph::planar_sensor_frame<2>> calibration_;
  ph::controller<M, ph::world<2>, Law> control_;
  ph::homing<axes> homing_;
  ph::steady_mean<sensor_channels> tare_;
  phase phase_ = phase::homing;
  ph::incident reason_;
};

/// Runs mechanism M under the law that the configuration names.
template <class M>
int run_session(const M& mechanism, const configuration& c, const session_options& options) {
  if (c.law == "velocity_direct_control")
    return session(mechanism, ph::velocity_direct_control(), c, options).run();
  if (c.law == "no_direct_control") return session(mechanism, ph::no_direct_control(), c, options).run();
  return session(mechanism, ph::direct_control(), c, options).run();
}

/// Each in a file of its own.
int run_tendon_two_link(const configuration& c, const session_options& options);
int run_xy_table(const configuration& c, const session_options& options);
int run_five_bar(const configuration& c, const session_options& options);

}  // namespace example
