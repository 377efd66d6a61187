// Problems solved by the library and by well-kept solvers: run time, side by side with the error of the
// solutions. Times are for comparing rows of one run; each solution is checked before any is timed.
#include "peers/comparison.hpp"

#include <results.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <string>

namespace {

struct solver {
  std::string name;
  double time;  // [ns] a problem
  peers::errors errors;
};

// One problem, fastest solver first; each solver's time relative to ours is added to `ratios`.
void print(const std::string& problem, std::vector<solver> solvers,
           std::map<std::string, std::string>& ratios) {
  std::sort(solvers.begin(), solvers.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  const auto library =
      std::find_if(solvers.begin(), solvers.end(), [](const solver& one) { return one.name == peers::ours; });
  std::printf("\n%-36s %10s %9s", problem.c_str(), "ns each", "x ours");
  for (const auto& [what, worst] : solvers.front().errors) std::printf(" %11s", what.c_str());
  for (const solver& one : solvers) {
    char ratio[32] = " -";
    if (library != solvers.end()) std::snprintf(ratio, sizeof ratio, " %.2f", one.time / library->time);
    std::printf("\n  %-34s %10.1f %10s", one.name.c_str(), one.time, ratio);
    for (const auto& [what, worst] : one.errors) std::printf(" %11.1e", worst);
    if (one.name != peers::ours) ratios[one.name] += ratio;
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  std::map<std::string, peers::errors> errors;  // by name of the benchmark
  std::vector<std::string> problems;            // in order of appearance
  for (const peers::row& row : peers::rows()) {
    const std::string name = row.problem + "/" + row.solver;
    try {
      errors[name] = row.check();
    } catch (const std::exception& disagreement) {
      std::fprintf(stderr, "peers: %s: %s\n", name.c_str(), disagreement.what());
      return 1;
    }
    if (std::find(problems.begin(), problems.end(), row.problem) == problems.end())
      problems.push_back(row.problem);
    benchmark::RegisterBenchmark(name.c_str(), [found = errors[name], row](benchmark::State& state) {
      for (const auto& [what, worst] : found) state.counters[what] = worst;
      row.run(state);
    });
  }
  const auto all = benchmarks::run(argc, argv,
                                   {"--benchmark_repetitions=5", "--benchmark_min_time=0.1",
                                    "--benchmark_enable_random_interleaving=true"});
  std::map<std::string, std::string> ratios;  // by solver
  for (const std::string& problem : problems) {
    std::vector<solver> timed;
    for (const auto& [name, row] : all)
      if (name.starts_with(problem + "/"))
        timed.push_back({name.substr(problem.size() + 1), row.cpu_time, errors.at(name)});
    if (!timed.empty()) print(problem, timed, ratios);
  }
  for (const auto& [name, figures] : ratios)
    std::printf("summary: x ours, %s:%s\n", name.c_str(), figures.c_str());
  std::printf("\nseed %u; errors are the worst of all problems; absent: %s\n", peers::seed, PEERS_ABSENT);
}
