// Samples of a bench that a test computes or simulates, and what a fit says of them.
#pragma once

#include <simulated_bench.hpp>

#include <passive_haptics/bench/bench_run.hpp>
#include <passive_haptics/bench/current_ramp.hpp>

#include <algorithm>
#include <exception>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace bench_samples {

namespace ph = passive_haptics;
using samples = std::vector<ph::bench_sample>;
using function = std::function<double(double)>;

constexpr auto exact = ph::sensor_noise::none;

// At 1 kHz from millisecond 0 to the last, of an axis that turns at 2 rad/s: current(k), torque(k, current).
template <class Current, class Torque>
samples at_1_khz(int last, const Current& current, const Torque& torque, double begin = 0) {
  samples all;
  for (int k = 0; k <= last; ++k) {
    const double I = current(k);
    all.push_back({begin + 1e-3 * k, I, 2e-3 * k, torque(k, I)});
  }
  return all;
}

// The message of what f() throws, without the name of the library; "nothing" where it returns.
template <class F>
std::string thrown_by(F&& f) {
  constexpr std::string_view library = "passive_haptics: ";
  try {
    f();
  } catch (const std::exception& e) {
    const std::string_view text = e.what();
    return std::string(text.starts_with(library) ? text.substr(library.size()) : text);
  }
  return "nothing";
}

// Rises from 0.1 N m at 0 A to 1.1 N m at 2 A, in steps that are surer than their error of 0.01 N m.
inline ph::current_ramp measured_ramp() {
  ph::current_ramp ramp;
  ramp.max_current = 2;
  ramp.residual_torque = {0.1, 0.01};
  for (std::size_t i = 0; i < ramp.rising.size(); ++i)
    ramp.rising[i] = ramp.falling[i] = {0.1 + 0.1 * static_cast<double>(i), 0.01};
  ramp.hysteresis = {0.25, 0.01};
  return ramp;
}

// A simulated bench of any brake: to the compiler one type of port.
struct any_bench {
  std::function<double()> wait, counts, reading, time;
  std::function<void(double)> set;
};
inline samples record(const any_bench& bench, double duration, const function& current,
                      const ph::bench_parameters& p) {
  example::simulated_bench_port<const any_bench> port{&bench};
  example::simulated_torque_sensor<const any_bench> sensor{&bench};
  return ph::record_on_bench(port, sensor, p, duration, current, bench.wait);
}

// What a bench records of a brake whose axis turns at rate(t), with current(t), whose command is command(I).
template <class Model>
samples record(const Model& brake, const function& command, const function& rate, const function& current,
               double duration, const example::simulated_bench_parameters& how = {}) {
  example::simulated_bench<Model> bench(brake, command, rate, how);
  ph::bench_parameters p;
  p.radians_per_count = how.resolution;
  return record(
      {[&] { return bench.wait(); }, [&] { return bench.counts(); }, [&] { return bench.reading(); },
       [&] { return bench.time(); }, [&](double I) { bench.set(I); }},
      duration, current, p);
}

}  // namespace bench_samples
