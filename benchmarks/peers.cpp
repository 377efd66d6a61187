// Problems solved by the library and by well-kept solvers: run time, side by side with the error of the
// solutions. Times are for comparing rows of one run; each solution is checked before any is timed.
#include "peers/comparison.hpp"

#include <passive_haptics/driver/process/standard_descriptors.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <map>
#include <string>

namespace {

struct result {
  peers::row row;
  peers::errors errors;
  std::vector<double> times;  // [ns] a problem, one a repetition

  double time() const {
    auto sorted = times;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }
};

using results = std::map<std::string, result>;  // by name of the benchmark

class collector : public benchmark::BenchmarkReporter {
 public:
  explicit collector(results& all) : all_(all) {}

  bool ReportContext(const Context& context) override {
    PrintBasicContext(&GetErrorStream(), context);
    return true;
  }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      all_.at(run.run_name.function_name).times.push_back(run.GetAdjustedCPUTime());
    }
  }

 private:
  results& all_;
};

void print(const std::string& problem, std::vector<result> solvers) {
  std::sort(solvers.begin(), solvers.end(),
            [](const result& a, const result& b) { return a.time() < b.time(); });
  const auto library = std::find_if(solvers.begin(), solvers.end(),
                                    [](const result& one) { return one.row.solver == peers::ours; });
  std::printf("\n%-36s %10s %9s", problem.c_str(), "ns each", "x ours");
  for (const auto& [what, worst] : solvers.front().errors) std::printf(" %11s", what.c_str());
  for (const result& one : solvers) {
    std::printf("\n  %-34s %10.1f ", one.row.solver.c_str(), one.time());
    if (library == solvers.end()) std::printf("%9s", "-");
    else std::printf("%9.2f", one.time() / library->time());
    for (const auto& [what, worst] : one.errors) std::printf(" %11.1e", worst);
  }
  std::printf("\n");
}

// Each solver's time relative to ours, one figure a problem.
void summarise(const std::vector<std::string>& problems, const results& all) {
  std::map<std::string, std::string> ratios;  // by solver
  for (const std::string& problem : problems) {
    const auto library = all.find(problem + "/" + peers::ours);
    if (library == all.end() || library->second.times.empty()) continue;
    for (const auto& [name, one] : all) {
      if (one.row.problem != problem || one.times.empty() || one.row.solver == peers::ours) continue;
      std::array<char, 32> ratio{};
      std::snprintf(ratio.data(), ratio.size(), " %.2f", one.time() / library->second.time());
      ratios[one.row.solver] += ratio.data();
    }
  }
  for (const auto& [solver, figures] : ratios)
    std::printf("summary: x ours, %s:%s\n", solver.c_str(), figures.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  if (!passive_haptics::open_standard_descriptors()) return std::perror("/dev/null"), 1;
  // What is given on the command line comes later and wins
  std::array defaults{std::string("--benchmark_repetitions=5"), std::string("--benchmark_min_time=0.1"),
                      std::string("--benchmark_enable_random_interleaving=true")};
  std::vector<char*> arguments{argv[0]};
  for (std::string& one : defaults) arguments.push_back(one.data());
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;

  results all;
  std::vector<std::string> problems;  // in order of appearance
  for (const peers::row& row : peers::rows()) {
    const std::string name = row.problem + "/" + row.solver;
    try {
      all[name] = {row, row.check(), {}};
    } catch (const std::exception& disagreement) {
      std::fprintf(stderr, "peers: %s: %s\n", name.c_str(), disagreement.what());
      return 1;
    }
    if (std::find(problems.begin(), problems.end(), row.problem) == problems.end())
      problems.push_back(row.problem);
    benchmark::RegisterBenchmark(name.c_str(), [errors = all[name].errors, row](benchmark::State& state) {
      for (const auto& [what, worst] : errors) state.counters[what] = worst;
      row.run(state);
    });
  }

  collector report(all);
  benchmark::RunSpecifiedBenchmarks(&report);
  for (const std::string& problem : problems) {
    std::vector<result> timed;
    for (const auto& [name, one] : all)
      if (one.row.problem == problem && !one.times.empty()) timed.push_back(one);
    if (!timed.empty()) print(problem, timed);
  }
  summarise(problems, all);
  std::printf("\nseed %u; errors are the worst of all problems; absent: %s\n", peers::seed, PEERS_ABSENT);
}
