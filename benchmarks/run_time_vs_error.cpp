// Each way to the nearest displayable force of three brakes in three dimensions: time against error and
// against violation of the passive constraint, by the condition of J. The reference has 50 digits.
#include "run_time_vs_error/problems.hpp"
#include "run_time_vs_error/ways.hpp"

#include <results.hpp>

#include <cstdio>
#include <string>
#include <vector>

namespace {

using namespace benchmarks;

constexpr unsigned seed = 20040627;
constexpr std::size_t problems_each = 400;  // of each condition

using problem_sets = std::vector<std::vector<problem>>;  // by condition

std::string at_condition(const char* what, double condition) {
  char text[64];
  std::snprintf(text, sizeof text, "%s at 1e%.0f", what, std::log10(condition));
  return text;
}

// One row: the time over problems of all conditions, what is wrong for each.
template <class Way>
void add_row(const char* name, const problem_sets& sets, const Way& way) {
  benchmark::UserCounters errors;
  std::vector<problem> all;
  for (std::size_t c = 0; c < sets.size(); ++c) {
    std::vector<answer> answers;
    for (const problem& p : sets[c]) answers.push_back(way(p.J, p.s, p.Fd));
    const quality q = quality_of(answers, sets[c]);
    errors[at_condition("worst error", conditions[c])] = q.worst_error;
    errors[at_condition("worst violation", conditions[c])] = q.worst_violation;
    errors[at_condition("worst torque violation", conditions[c])] = q.worst_torque_violation;
    all.insert(all.end(), sets[c].begin(), sets[c].end());
  }
  benchmark::RegisterBenchmark(name, [all, way, errors](benchmark::State& run) {
    run.counters = errors;
    std::size_t k = 0;
    for (auto _ : run) {
      auto result = way(all[k].J, all[k].s, all[k].Fd);
      benchmark::DoNotOptimize(result);
      k = k + 1 < all.size() ? k + 1 : 0;
    }
  });
}

void print_line(const std::string& way, const figures& row) {
  std::printf("%-20s %6.0f |", way.c_str(), row.cpu_time);
  const double shown[] = {1e2, 1e6, 1e10, 1e14};
  for (const char* what : {"worst error", "worst violation"}) {
    for (const double c : shown) std::printf(" %7.0e", row.counters.at(at_condition(what, c)));
    std::printf(" |");
  }
  double torque = 0;
  for (const double c : conditions)
    torque = std::max(torque, row.counters.at(at_condition("worst torque violation", c)));
  std::printf(" %7.0e\n", torque);
}

}  // namespace

int main(int argc, char** argv) {
  ph::testing::random_source random(seed);
  problem_sets sets;
  for (const double condition : conditions) sets.push_back(random_problems(condition, problems_each, random));
  add_row("half-spaces (ours)", sets, half_spaces());
  add_row("inverse", sets, reference_forces_by<explicit_inverse>());
  add_row("partial LU", sets, reference_forces_by<solving<Eigen::PartialPivLU<matrix>>>());
  add_row("pivoted QR", sets, reference_forces_by<solving<Eigen::ColPivHouseholderQR<matrix>>>());
  add_row("damped SVD", sets, reference_forces_by<damped_svd>());
  add_row("clamped torques", sets, clamped_torques());
  std::printf(
      "Three brakes, three dimensions: time [ns], the worst of %zu problems of each condition, seed %u\n"
      "%-27s | %-31s | %-31s | by the\n%-20s %6s | %7s %7s %7s %7s | %7s %7s %7s %7s | torques\n",
      problems_each, seed, "", "error of the force", "violation by the force", "way", "time", "1e2", "1e6",
      "1e10", "1e14", "1e2", "1e6", "1e10", "1e14");
  const results all = run(argc, argv,
                          {"--benchmark_min_time=0.03", "--benchmark_repetitions=5",
                           "--benchmark_enable_random_interleaving=true"});
  for (const auto& [way, row] : all) print_line(way, row);
  std::puts(
      "\nError: |F - Fp| against 50 digits, for clamped torques of the force that they make. Violation: s_i "
      "b_i . F over\n|b_i| |Fd|, with b_i the velocity of the handle for unit rate of brake i.");
  if (all.size() < 6) return 0;  // filtered
  const figures& ours = all.at("half-spaces (ours)");
  std::printf(
      "summary: %.0f ns, inverse %.1fx, LU %.1fx, damped SVD %.1fx; worst error at 1e6: %.0e, LU %.0e\n",
      ours.time, all.at("inverse").time / ours.time, all.at("partial LU").time / ours.time,
      all.at("damped SVD").time / ours.time, ours.counters.at("worst error at 1e6"),
      all.at("partial LU").counters.at("worst error at 1e6"));
}
