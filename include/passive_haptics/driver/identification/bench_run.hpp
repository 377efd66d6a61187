/// @file
/// Records a test of one brake through a port and a torque sensor.
#pragma once

#include <passive_haptics/driver/identification/bench_sample.hpp>
#include <passive_haptics/driver/port.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
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
  int most_missed = 100;         ///< Periods in a row without a new sample, then the test ends.

  /// The table of core/parameters.hpp.
  static constexpr auto members() {
    using p = bench_parameters;
    return member_table(
        member("brake", &p::brake), member("encoder", &p::encoder), member("channel", &p::channel),
        member("radians_per_count", &p::radians_per_count, "rad", range::finite, plausible(-0.1, 0.1)),
        member("torque_per_unit", &p::torque_per_unit, "N m", range::finite, plausible(-100, 100)),
        member("torque_at_zero", &p::torque_at_zero, "N m", range::finite, plausible(-1, 1)),
        member("current_limit", &p::current_limit, "A", range::positive, plausible(0.001, 100)),
        member("settling_time", &p::settling_time, "s", range::not_negative, plausible(0, 60)),
        member("most_missed", &p::most_missed, "", range::between(1, 100000).as("1 to 100000")));
  }
};

/// Gives the brake `current_at(t)` [A], t in [0, duration] s, while somebody turns its axis, and records each
/// new sample; then releases. Before that it has current_at(0) for the settling_time. `wait()` is called
/// before each read: until the next period is due. The port and the sensor are open; the other brakes are
/// released.
///
/// Throws std::invalid_argument with the text of validate(p), or where the port has no such brake, encoder or
/// channel; std::runtime_error where a transfer fails or nothing new comes, with the brakes released.
template <BrakePort P, ForceSensor S, class Current, class Wait>
std::vector<bench_sample> record_on_bench(P& port, S& sensor, const bench_parameters& p, double duration,
                                          const Current& current_at, Wait&& wait) {
  require_valid(p);
  require_no_error(
      detail::first_error(check_value("brake", p.brake, "", range::between(0, P::brake_count - 1)),
                          check_value("encoder", p.encoder, "", range::between(0, P::encoder_count - 1)),
                          check_value("channel", p.channel, "", range::between(0, S::channel_count - 1)),
                          check_value("duration", duration, "s", range::positive)));
  struct releases {
    P& port;
    ~releases() { port.release(); }
  } at_the_end{port};
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const auto require_ok = [](port_status s, const char* what) {
    if (s == port_status::failed)
      throw std::runtime_error(std::string(what).append(": ").append(to_string(s)));
    return s == port_status::ok;
  };

  std::vector<bench_sample> all;
  port_sample<P::encoder_count> axes;
  port_sample<S::channel_count> torque;
  const double turn = counter_bits(port) > 0 ? std::ldexp(1.0, counter_bits(port)) : 0;
  double count = std::numeric_limits<double>::quiet_NaN(), start = 0, told = 0;
  brake_currents<P::brake_count> currents{};
  for (int missed = 0;;) {
    wait();
    const bool fresh = require_ok(port.read(axes), "port");
    const bool felt = require_ok(sensor.read(torque), "torque sensor");
    if (!fresh || !felt || !axes.valid[at(p.encoder)] || !torque.valid[at(p.channel)]) {
      if (++missed > p.most_missed)
        throw std::runtime_error(detail::error_text("periods without a new valid sample", missed,
                                                    "at most most_missed: check the port and the sensor"));
      continue;
    }
    missed = 0;
    const double read = axes.value[at(p.encoder)];
    if (std::isnan(count)) {
      start = axes.time + p.settling_time;
      count = read;
    }
    count += turn > 0 ? std::remainder(read - count, turn) : read - count;
    const double time = axes.time - start;
    if (time >= 0)
      all.push_back({time, told, p.radians_per_count * count,
                     p.torque_per_unit * torque.value[at(p.channel)] - p.torque_at_zero});
    if (time >= duration) return all;
    const double wanted = current_at(std::max(time, 0.0));
    told = currents[at(p.brake)] = wanted > 0 ? std::min(wanted, p.current_limit) : 0;
    require_ok(port.write(currents), "port");
  }
}

}  // namespace passive_haptics
