/// @file
/// Records a test of one brake through a port and a torque sensor.
#pragma once

#include <passive_haptics/bench/bench_sample.hpp>
#include <passive_haptics/core/nth.hpp>
#include <passive_haptics/driver/clock.hpp>
#include <passive_haptics/driver/safe_port.hpp>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace passive_haptics {

/// A test bench: which brake, and units of its encoder and its torque sensor.
struct bench_parameters {
  int brake = 0;                 ///< Of the port, from 0.
  int encoder = 0;               ///< On its axis, from 0.
  int channel = 0;               ///< Of the torque sensor, from 0.
  double radians_per_count = 1;  ///< [rad]; < 0 where counts fall in the positive sense.
  double torque_per_unit = 1;    ///< Of the sensor [N m]; < 0 where it reads a pull in the positive sense.
  double torque_at_zero = 0;     ///< Its reading while nothing pulls [N m].
  double current_limit = 1;      ///< No test goes beyond [A].
  double settling_time = 0.5;    ///< Of the brake under the first current, before the record begins [s].
  double max_rate = 2e5;         ///< Of the encoder: faster is a jump [counts/s].
  double max_reading = std::numeric_limits<double>::infinity();  ///< There the sensor is saturated.
  double hold_over = 0.1;  ///< Longest time without a new good sample, or while writes are refused [s].
  int max_missed = 100;    ///< Periods in a row without a new good sample, then the test ends.

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = bench_parameters;
    return member_table(
        member("brake", &p::brake), member("encoder", &p::encoder), member("channel", &p::channel),
        member("radians_per_count", &p::radians_per_count, "rad", range::finite),
        member("torque_per_unit", &p::torque_per_unit, "N m", range::finite),
        member("torque_at_zero", &p::torque_at_zero, "N m", range::finite),
        member("current_limit", &p::current_limit, "A", range::positive),
        member("settling_time", &p::settling_time, "s", range::not_negative),
        member("max_rate", &p::max_rate, "counts/s", range::positive),
        member("max_reading", &p::max_reading, "", passive_haptics::range{.lower = 0, .open_above = false}),
        member("hold_over", &p::hold_over, "s", range::positive),
        member("max_missed", &p::max_missed, "", range::between(1, 100000).as("1 to 100000")));
  }
  /// The limits of a safe_port to this brake, encoder and channel.
  safe_port_parameters<1, 1> limits() const {
    return {.encoders = {.max_rate = max_rate},
            .sensor = {.range = {max_reading}},
            .currents = {.max_current = {current_limit}, .continuous = {current_limit}},
            .hold_over = hold_over};
  }
};

namespace detail {

// One brake and one encoder of an open port; the other brakes get 0 A
template <BrakePort P>
struct bench_port {
  static constexpr int encoder_count = 1, brake_count = 1;
  P* port;
  std::size_t encoder, brake;

  std::string open() { return {}; }
  port_status read(port_sample<1>& sample) noexcept {
    port_sample<P::encoder_count> all;
    const port_status status = port->read(all);
    sample = {all.time, all.sequence, {all.value[encoder]}, {all.valid[encoder]}};
    return status;
  }
  port_status write(const brake_currents<1>& current) noexcept {
    brake_currents<P::brake_count> all{};
    all[brake] = current[0];
    return port->write(all);
  }
  void release() noexcept { port->release(); }
  int counter_bits() const noexcept { return passive_haptics::counter_bits(*port); }
};

// One channel of an open sensor
template <ForceSensor S>
struct bench_sensor {
  static constexpr int channel_count = 1;
  S* sensor;
  std::size_t channel;

  std::string open() { return {}; }
  port_status read(port_sample<1>& sample) noexcept {
    port_sample<S::channel_count> all;
    const port_status status = sensor->read(all);
    sample = {all.time, all.sequence, {all.value[channel]}, {all.valid[channel]}};
    return status;
  }
};

// The time after a wait that returns it, or else of CLOCK_MONOTONIC [s]
template <class Wait>
double time_after(Wait& wait) {
  if constexpr (std::is_void_v<decltype(wait())>) {
    wait();
    return monotonic_seconds();
  } else {
    return wait();
  }
}

}  // namespace detail

/// The longest time that record_on_bench() takes beyond settling_time and duration [s, CLOCK_BOOTTIME].
inline constexpr double max_bench_overtime = 1;

/// The record of a test: gives the brake `current_at(t)` [A], t in [0, duration] s, while somebody turns its
/// axis, and records each new sample; then releases. Before that it has current_at(0) for the settling_time.
/// Port and sensor are open, and are read and written through a safe_port with p.limits(); the other brakes
/// get 0 A. `wait()` is called before each read: until the next period is due. It returns the time then [s],
/// on the clock of the samples, or nothing if that is CLOCK_MONOTONIC.
///
/// Throws std::invalid_argument with the text of validate(p), or where the port has no such brake, encoder or
/// channel. Throws std::runtime_error that names the fault where the safe_port released the brake, or no good
/// sample came for max_missed periods, and at the latest max_bench_overtime after the test should have
/// ended. In any case the brakes are released. A wait, read or write that never returns keeps the current on:
/// take a threaded_port, and run a supervisor.
template <BrakePort P, ForceSensor S, class Current, class Wait>
std::vector<bench_sample> record_on_bench(P& port, S& sensor, const bench_parameters& p, double duration,
                                          const Current& current_at, Wait&& wait) {
  require_valid(p);
  require_no_error(
      detail::first_error(check_value("brake", p.brake, "", range::between(0, P::brake_count - 1)),
                          check_value("encoder", p.encoder, "", range::between(0, P::encoder_count - 1)),
                          check_value("channel", p.channel, "", range::between(0, S::channel_count - 1)),
                          check_value("duration", duration, "s", range::positive)));
  const auto fail = [&](fault_record why) {
    if (why.channel >= 0)  // by its number on the port or the sensor
      why.channel = why.source == fault_source::encoders ? p.encoder
                    : why.source == fault_source::brakes ? p.brake
                                                         : p.channel;
    throw std::runtime_error(to_string(why).append(": the test ended, the brake is released"));
  };
  safe_port bench(detail::bench_port<P>{&port, std::size_t(p.encoder), std::size_t(p.brake)},
                  detail::bench_sensor<S>{&sensor, std::size_t(p.channel)}, p.limits());
  if (const std::string error = bench.open(); !error.empty()) throw std::runtime_error(error);

  std::vector<bench_sample> all;
  // This clock goes on while the machine is suspended
  const auto boot_seconds = [] { return 1e-9 * static_cast<double>(monotonic_clock().boot_time()); };
  const double begun = boot_seconds();
  const double longest = p.settling_time + duration + max_bench_overtime;
  double start = std::numeric_limits<double>::quiet_NaN();
  for (int missed = 0;;) {
    if (bench.read(detail::time_after(wait)) == port_state::released) fail(bench.reason());
    if (const double lasted = boot_seconds() - begun; lasted > longest)
      throw std::runtime_error(
          detail::error_text("time of the test on this machine's clock [s]", lasted,
                             detail::indexed("at most ", longest,
                                             ": check the clock of the samples, and whether the machine was "
                                             "suspended")));
    double wanted = bench.applied()[0];
    if (bench.pending_fault().what == fault::none) {
      missed = 0;
      if (bench.activate()) start = bench.position_time() + p.settling_time;
      const double time = bench.position_time() - start;
      if (time >= 0)
        all.push_back({time, bench.applied()[0], p.radians_per_count * bench.position()[0],
                       p.torque_per_unit * bench.force()[0] - p.torque_at_zero});
      if (time >= duration) return all;
      wanted = current_at(std::max(time, 0.0));
    } else if (++missed > p.max_missed) {
      fail(bench.pending_fault());
    }
    if (bench.write({wanted > 0 ? std::min(wanted, p.current_limit) : 0}) == port_state::released)
      fail(bench.reason());
  }
}

}  // namespace passive_haptics
