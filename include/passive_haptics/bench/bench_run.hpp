/// Recording of a brake test through a port and a torque sensor.
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

/// Parameters of a test bench.
struct bench_parameters {
  int brake = 0;                 ///< Brake of the port, from 0.
  int encoder = 0;               ///< Encoder on its axis, from 0.
  int channel = 0;               ///< Channel of the torque sensor, from 0.
  double radians_per_count = 1;  ///< [rad]; < 0 if counts fall in the positive sense.
  double torque_per_unit = 1;    ///< [N m]; < 0 if the sensor reads positive torques as negative.
  double torque_at_zero = 0;     ///< Reading without load [N m].
  double current_limit = 1;      ///< Maximum of all tests [A].
  double settling_time = 0.5;    ///< Time at the first current before the record begins [s].
  double max_rate = 2e5;         ///< Higher rates count as a jump [counts/s].
  double max_reading = std::numeric_limits<double>::infinity();  ///< Saturation of the sensor.
  double hold_over = 0.1;  ///< Maximum time without a new good sample, or with rejected writes [s].
  int max_missed = 100;    ///< Maximum number of successive periods without a new good sample.

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
  /// Limits of a safe_port for this brake, encoder and channel.
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

// The time returned by wait(), or else CLOCK_MONOTONIC [s]
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

/// Maximum time of record_on_bench() beyond settling_time and duration [s, CLOCK_BOOTTIME].
inline constexpr double max_bench_overtime = 1;

/// Records a test: applies `current_at(t)` [A], t in [0, duration] s, to the brake while its axis is turned,
/// after current_at(0) for the settling_time, and records each new sample. Port and sensor must be open; they
/// are used through a safe_port with p.limits(). `wait()` returns when the next period is due, with that time
/// [s] on the clock of the samples, or without a value for CLOCK_MONOTONIC.
///
/// Throws std::invalid_argument with the text of validate(p), or for a brake, encoder or channel that does
/// not exist. Throws std::runtime_error for a fault, after max_missed periods without a good sample, and
/// max_bench_overtime after the expected end. The brakes are released in all cases, except by a call that
/// never returns: use a threaded_port, and run a supervisor.
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
    if (why.channel >= 0)  // number on the port or the sensor
      why.channel = why.source == fault_source::encoders ? p.encoder
                    : why.source == fault_source::brakes ? p.brake
                                                         : p.channel;
    throw std::runtime_error(to_string(why).append(": the test ended, the brake is released"));
  };
  safe_port bench(detail::bench_port<P>{&port, std::size_t(p.encoder), std::size_t(p.brake)},
                  detail::bench_sensor<S>{&sensor, std::size_t(p.channel)}, p.limits());
  if (const std::string error = bench.open(); !error.empty()) throw std::runtime_error(error);

  std::vector<bench_sample> all;
  // This clock also runs while the machine is suspended
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
