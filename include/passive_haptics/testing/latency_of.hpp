/// Latency of one control cycle of any controller, as rows for Google Benchmark.
///
/// Link benchmark::benchmark, or benchmark::benchmark_main and call it from an initialiser.
#pragma once

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/testing/support/percentile.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace passive_haptics::testing {

/// Numbers of individually timed cycles, for percentiles.
struct latency_options {
  int hot_samples = 10'000;  ///< Rows hot and chain.
  int cold_samples = 1000;   ///< Row cold; each costs an eviction, some milliseconds for a cache of 32 MB.
};

namespace detail {

inline double nanoseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

inline double clock_cost() {
  std::vector<double> samples(1000);
  for (double& sample : samples) sample = nanoseconds_since(std::chrono::steady_clock::now());
  return percentile(sorted(std::move(samples)), 0.5);
}

template <class Call>
double time_of(Call&& call, double clock) {
  std::chrono::steady_clock::now();  // loads its code, which is not part of the cold cycle
  const auto start = std::chrono::steady_clock::now();
  call();
  return std::max(0.0, nanoseconds_since(start) - clock);
}

/// Adds p50, p99, p99.9 and max of these samples [ns] to the row.
inline void report_percentiles(benchmark::State& run, std::vector<double> samples) {
  const auto ascending = sorted(std::move(samples));
  run.counters["p50_ns"] = percentile(ascending, 0.5);
  run.counters["p99_ns"] = percentile(ascending, 0.99);
  run.counters["p99.9_ns"] = percentile(ascending, 0.999);
  run.counters["max_ns"] = ascending.back();
}

/// Reads twice the size of the largest cache, which evicts data, TLB entries and mostly code.
class cache_eviction {
 public:
  cache_eviction() : other_(2 * std::max(max_cache_size(), min_size) / sizeof(std::uint64_t), 1) {}

  void operator()() const {
    constexpr std::size_t line = 64 / sizeof(std::uint64_t);
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < other_.size(); i += line) sum += other_[i];
    benchmark::DoNotOptimize(sum);
  }

 private:
  static constexpr std::size_t min_size = 1u << 22;  // if the machine does not report its caches [byte]
  static std::size_t max_cache_size() {
    int largest = 0;
    for (const auto& cache : benchmark::CPUInfo::Get().caches) largest = std::max(largest, cache.size);
    return static_cast<std::size_t>(largest);
  }
  std::vector<std::uint64_t> other_;
};

template <class M, class S, class L, class State>
class measured_loop {
 public:
  measured_loop(const controller<M, S, L>& control, std::vector<State> states, const latency_options& options)
      : control_(control), states_(std::move(states)), options_(options) {}

  void hot(benchmark::State& run) {
    warm(run, [](State&, const auto&) {});
  }

  void chain(benchmark::State& run) {
    warm(run, [](State& state, const brake_vector<M>& capacity) {
      // Adds 0, which the compiler cannot know. In place: a copy would wait for its parts to be stored
      state.q.array() += typename M::scalar(0) * capacity.sum();
    });
  }

  void cold(benchmark::State& run) {
    if (faulty(run)) return;
    static const cache_eviction evict;
    const double clock = clock_cost();
    std::vector<double> samples;
    std::size_t k = 0;
    for (auto _ : run) {
      evict();
      samples.push_back(time_of([&] { cycle(states_[k]); }, clock));
      run.SetIterationTime(1e-9 * samples.back());
      k = next(k);
    }
    report_percentiles(run, std::move(samples));
  }

 private:
  template <class Wait>
  void warm(benchmark::State& run, Wait&& wait_for) {
    if (faulty(run)) return;
    brake_vector<M> capacity = brake_vector<M>::Zero();
    std::size_t k = 0;
    const auto once = [&] {
      wait_for(states_[k], capacity);
      capacity = cycle(states_[k]);
      k = next(k);
    };
    for (auto _ : run) once();
    const double clock = clock_cost();
    std::vector<double> samples(static_cast<std::size_t>(options_.hot_samples));
    for (double& sample : samples) sample = time_of(once, clock);
    report_percentiles(run, std::move(samples));
  }

  brake_vector<M> cycle(State& state) {
    auto result = decide(state);
    benchmark::DoNotOptimize(result);  // all of it, as a loop may log any part
    return result.capacity;
  }

  /// Increasing times for laws that use time differences.
  auto decide(State& state) {
    if constexpr (needs_rising_time<L>) state.time = time_ += 1e-3;
    return control_(state);
  }

  /// Rejects states with faults, since such cycles end early.
  bool faulty(benchmark::State& run) {
    for (std::size_t k = 0; k < states_.size(); ++k) {
      if (const status s = decide(states_[k]).outcome; s != status::ok) {
        const std::string text = "state " + std::to_string(k) + " gives the fault '" +
                                 std::string(to_string(s)) + "'; give states with outcome ok";
        run.SkipWithError(text.c_str());
        return true;
      }
    }
    return false;
  }

  std::size_t next(std::size_t k) const { return k + 1 < states_.size() ? k + 1 : 0; }

  controller<M, S, L> control_;
  std::vector<State> states_;
  latency_options options_;
  double time_ = 0;  // of the last cycle [s]
};

}  // namespace detail

/// Registers three rows with Google Benchmark that time control(state) cyclically over the given states. Call
/// it before benchmark::RunSpecifiedBenchmarks.
///
///   - name/hot: independent cycles (throughput);
///   - name/chain: each state depends on the capacities of the previous cycle (latency);
///   - name/cold: all caches evicted before each cycle, as in a loop that wakes up once per millisecond.
///
/// Each row has p50_ns, p99_ns, p99.9_ns and max_ns of individually timed cycles. Use about 16 000 states of
/// one kind (in contact, free) in random order, which the branch predictor cannot learn. A state with a fault
/// fails its row. Laws that use time differences (needs_rising_time) get increasing times. Compare rows only
/// within one run. Throws std::invalid_argument without states or samples. Memory: twice the largest cache.
template <class M, class S, class L, class State>
void latency_of(const std::string& name, const controller<M, S, L>& control, std::vector<State> states,
                const latency_options& options = {}) {
  static_assert(is_device_state<State, M, explain>());
  if (states.empty())
    throw std::invalid_argument("latency_of('" + name + "'): states is empty; give at least one");
  for (const int samples : {options.hot_samples, options.cold_samples}) {
    if (samples < 1)
      throw std::invalid_argument("latency_of('" + name + "'): " + std::to_string(samples) +
                                  " samples; give at least one");
  }
  using loop = detail::measured_loop<M, S, L, State>;
  // Each row has its own copy, hence its own memory
  const loop measured(control, std::move(states), options);
  benchmark::RegisterBenchmark((name + "/hot").c_str(),
                               [=](benchmark::State& run) { loop(measured).hot(run); });
  benchmark::RegisterBenchmark((name + "/chain").c_str(),
                               [=](benchmark::State& run) { loop(measured).chain(run); });
  benchmark::RegisterBenchmark((name + "/cold").c_str(),
                               [=](benchmark::State& run) { loop(measured).cold(run); })
      ->Iterations(options.cold_samples)
      ->UseManualTime();
}

}  // namespace passive_haptics::testing
