/// @file
/// Runs the registered benchmarks and keeps their figures, so that a program can print one table of its own.
#pragma once

#include <benchmark/benchmark.h>
#include <passive_haptics/driver/process/standard_descriptors.hpp>

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace benchmarks {

/// Figures of one row; of several repetitions the medians.
struct figures {
  double time = 0;                         ///< Time of one iteration [ns],
  double cpu_time = 0;                     ///< of it what the processor spent on it [ns].
  std::map<std::string, double> counters;  ///< As the row reported them.
};

/// All rows by name.
using results = std::map<std::string, figures>;

/// Called as each row is there.
using row_visitor = std::function<void(const std::string& name, const figures&)>;

namespace detail {

// Newer releases of Google Benchmark renamed the member.
template <class Run>
bool failed(const Run& run) {
  if constexpr (requires { run.error_occurred; }) return run.error_occurred;
  else return run.skipped != decltype(run.skipped){};
}
template <class Run>
std::string message(const Run& run) {
  if constexpr (requires { run.error_message; }) return run.error_message;
  else return run.skip_message;
}

class collector : public benchmark::BenchmarkReporter {
 public:
  explicit collector(row_visitor visit) : visit_(std::move(visit)) {}

  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      const std::string& name = run.run_name.function_name;
      if (failed(run)) {
        std::fprintf(stderr, "error: %s: %s\n", name.c_str(), message(run).c_str());
        any_failed = true;
      } else if (run.repetitions <= 1 || run.aggregate_name == "median") {
        figures& row = all[name];
        row.time = run.GetAdjustedRealTime();
        row.cpu_time = run.GetAdjustedCPUTime();
        for (const auto& [counter, value] : run.counters) row.counters[counter] = value;
        visit_(name, row);
      }
    }
  }

  results all;
  bool any_failed = false;

 private:
  row_visitor visit_;
};

}  // namespace detail

/// Runs what is registered, with Google Benchmark's own options; `defaults` are those that a user may
/// override. `visit` sees each row when it is there. Ends the program with status 2 for an unknown option, 1
/// if a row failed or a standard descriptor is closed for good, 0 if no row was chosen
/// (--benchmark_list_tests).
inline results run(
    int argc, char** argv, std::vector<std::string> defaults = {},
    const row_visitor& visit = [](const std::string&, const figures&) {}) {
  if (!passive_haptics::open_standard_descriptors()) std::perror("/dev/null"), std::exit(1);
  std::vector<char*> arguments(argv, argv + argc);
  for (std::string& option : defaults) arguments.insert(arguments.begin() + 1, option.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) std::exit(2);
  detail::collector collector(visit);
  benchmark::RunSpecifiedBenchmarks(&collector);
  if (collector.any_failed) std::exit(1);
  if (collector.all.empty()) std::exit(0);
  return collector.all;
}

}  // namespace benchmarks
