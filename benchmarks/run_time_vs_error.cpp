// Each way to the nearest displayable force: time against error and against violation of the passive
// constraint, by the condition of J. One table, one picture; all figures are in the JSON file. The reference
// has 50 digits.
#include "run_time_vs_error/problems.hpp"
#include "run_time_vs_error/ways.hpp"

#include <output.hpp>
#include <results.hpp>

#include <cstdio>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using namespace benchmarks;

constexpr unsigned seed = 20040627;
constexpr int problems_each = 400;  // of each condition

// A problem in the scalars of one way: Pose for J, Force for all that is computed from it.
template <class Pose, class Force, int D>
struct input {
  ph::matrix<Pose, D, D> J;
  ph::vector<Force, D> s, Fd;

  explicit input(const problem<D>& p)
      : J(p.J.template cast<Pose>()), s(p.s.template cast<Force>()), Fd(p.Fd.template cast<Force>()) {}

  template <class Way>
  answer<Force, D> solve(const Way& way) const {
    return way(ph::matrix<Force, D, D>(J.template cast<Force>()), s, Fd);
  }
};

template <class T, int D>
answer<long double, D> exactly(const answer<T, D>& a) {
  return {a.force.template cast<long double>(), a.torque.template cast<long double>()};
}

template <int D>
using problem_sets = std::vector<std::vector<problem<D>>>;  // by condition

std::string at_condition(const char* what, double condition) {
  char text[64];
  std::snprintf(text, sizeof text, "%s at 1e%.0f", what, std::log10(condition));
  return text;
}

// One row: the time over problems of all conditions, what is wrong for each.
template <class Pose, class Force, int D, class Way>
void add_row(const std::string& name, const problem_sets<D>& sets, const Way& way) {
  const auto row = [&sets, way, errors = benchmark::UserCounters()](benchmark::State& run) mutable {
    std::vector<input<Pose, Force, D>> inputs;
    for (const auto& set : sets) {
      for (const auto& p : set) inputs.emplace_back(p);
    }
    benchmark::DoNotOptimize(inputs.data());
    benchmark::ClobberMemory();  // where g++ 12 sees both conversions it leaves out the rounding of J to
                                 // float
    if (errors.empty()) {        // only at the first of many calls
      std::size_t k = 0;
      for (std::size_t c = 0; c < sets.size(); ++c) {
        std::vector<answer<long double, D>> answers;
        for (std::size_t i = 0; i < sets[c].size(); ++i) answers.push_back(exactly(inputs[k++].solve(way)));
        const quality q = quality_of(answers, sets[c]);
        errors[at_condition("worst error", conditions[c])] = q.worst_error;
        errors[at_condition("median error", conditions[c])] = q.median_error;
        errors[at_condition("worst violation", conditions[c])] = q.worst_violation;
        errors[at_condition("worst torque violation", conditions[c])] = q.worst_torque_violation;
      }
    }
    run.counters = errors;
    std::size_t k = 0;
    for (auto _ : run) {
      auto result = inputs[k].solve(way);
      benchmark::DoNotOptimize(result);
      k = k + 1 < inputs.size() ? k + 1 : 0;
    }
  };
  benchmark::RegisterBenchmark(name.c_str(), row);
}

template <class Pose, class Force, int D>
void add_ways(const char* scalar, const problem_sets<D>& sets) {
  const std::string suffix = std::string("/").append(scalar) + "/d=" + std::to_string(D);
  const auto add = [&](const char* way_name, const auto& way) {
    add_row<Pose, Force, D>(way_name + suffix, sets, way);
  };
  add("half-spaces (ours)", half_spaces());
  add("inverse", reference_forces_by<explicit_inverse>());
  add("partial LU", reference_forces_by<solving<partial_lu>>());
  add("pivoted QR", reference_forces_by<solving<pivoted_qr>>());
  // For a square matrix of full rank this is the pivoted QR; it takes long to compile
  if constexpr (std::is_same_v<Force, double>)
    add("complete orthogonal", reference_forces_by<solving<orthogonal>>());
  add("damped SVD", reference_forces_by<damped_svd>());
  add("clamped torques", clamped_torques());
}

template <int D>
void add_dimension() {
  static const problem_sets<D> sets = [] {
    ph::testing::random_source random(seed);
    problem_sets<D> all;
    for (const double condition : conditions)
      all.push_back(random_problems<D>(condition, problems_each, random));
    return all;
  }();
  add_ways<double, double, D>("double", sets);
  add_ways<float, float, D>("float", sets);
  add_ways<float, double, D>("mixed", sets);
  add_ways<long double, long double, D>("long double", sets);
}

const char* const ways[] = {"half-spaces (ours)",  "inverse",    "partial LU",     "pivoted QR",
                            "complete orthogonal", "damped SVD", "clamped torques"};

void print_line(const results& all, const std::string& way, const char* scalar, int d) {
  const auto row = all.find(way + "/" + scalar + "/d=" + std::to_string(d));
  if (row == all.end()) return;  // filtered out
  const auto& [time, cpu_time, counters] = row->second;
  std::printf("%-20s %-11s %6.0f |", way.c_str(), scalar, cpu_time);
  const double shown[] = {1e2, 1e6, 1e10, 1e14};
  for (const double c : shown) std::printf(" %7.0e", counters.at(at_condition("worst error", c)));
  std::printf(" |");
  for (const double c : shown) std::printf(" %7.0e", counters.at(at_condition("worst violation", c)));
  double torque = 0;
  for (const double c : conditions)
    torque = std::max(torque, counters.at(at_condition("worst torque violation", c)));
  std::printf(" | %7.0e\n", torque);
}

void print_table(const results& all) {
  for (const int d : {2, 3}) {
    std::printf(
        "\n%d brakes, %d dimensions: time [ns], the worst of %d problems of each condition, |Fd| = 1, seed "
        "%u\n",
        d, d, problems_each, seed);
    std::printf("%-32s %6s | %-31s | %-31s | %s\n", "", "", "error of the force", "violation by the force",
                "by the");
    std::printf("%-20s %-11s %6s | %7s %7s %7s %7s | %7s %7s %7s %7s | %s\n", "way", "scalar", "time", "1e2",
                "1e6", "1e10", "1e14", "1e2", "1e6", "1e10", "1e14", "torques");
    for (const char* way : ways) print_line(all, way, "double", d);
    for (const char* scalar : {"float", "mixed", "long double"}) print_line(all, ways[0], scalar, d);
  }
  std::puts(
      "\nError: |F - Fp| against 50 digits, for clamped torques of the force that they make. Violation: s_i "
      "b_i . F over\n"
      "|b_i| |Fd|, with b_i the velocity of the handle for unit rate of brake i. Mixed: J in float, the rest "
      "in double.");
}

// Names who has a smaller worst error than ours in double, and where. Under 4 eps all are rounded solutions.
std::string beaten_by(const results& all, int d) {
  const std::string suffix = "/double/d=" + std::to_string(d);
  std::string text;
  for (const double c : conditions) {
    const std::string what = at_condition("worst error", c);
    const double ours = all.at(ways[0] + suffix).counters.at(what);
    for (const char* way : ways) {
      const double theirs = all.at(way + suffix).counters.at(what);
      char line[160];
      std::snprintf(line, sizeof line, "  d = %d, condition 1e%.0f: %s %.1e, ours %.1e\n", d, std::log10(c),
                    way, theirs, ours);
      if (theirs < ours && ours > 4 * std::numeric_limits<double>::epsilon()) text += line;
    }
  }
  return text;
}

// Blocks for the picture: for each dimension the other ways in double, then ours in each scalar.
std::string picture_data(const results& all) {
  std::ostringstream data;
  data << "# way, scalar, time [ns], worst error at condition 1e2, 1e6, 1e10\n";
  const auto add = [&](const std::string& way, const std::string& scalar, int d) {
    const figures& row = all.at(way + "/" + scalar + "/d=" + std::to_string(d));
    data << way << "," << scalar << "," << row.time;
    for (const double c : {1e2, 1e6, 1e10})
      data << "," << std::max(1e-20, row.counters.at(at_condition("worst error", c)));  // the axis has no 0
    data << "\n";
  };
  for (const int d : {2, 3}) {
    for (const char* way : {"inverse", "partial LU", "pivoted QR", "damped SVD", "clamped torques"})
      add(way, "double", d);  // the complete orthogonal decomposition lies on the pivoted QR
    data << "\n\n";
    for (const char* scalar : {"float", "mixed", "double", "long double"}) add(ways[0], scalar, d);
    data << "\n\n";
  }
  return data.str();
}

void draw_picture(const results& all) {
  example::write_file("run_time_vs_error.csv", picture_data(all));
  example::draw(".", "run_time_vs_error", R"(
set terminal svg size 1100,560 font 'sans,12' background 'white'
set output output
set datafile separator ','
set multiplot layout 1,2 title 'Nearest displayable force: time against worst error (dot: condition 1e6, bar: 1e2 to 1e10)'
set logscale xy
set grid lc rgb '#dddddd'
set xlabel 'time [ns]'
set ylabel 'worst error of the force, |Fd| = 1'
set xrange [0.5:10000]
set yrange [1e-20:1e12]
set format y '10^{%T}'
set key top right
do for [d=2:3] {
  set title sprintf('%d brakes, %d dimensions', d, d)
  plot 'run_time_vs_error.csv' index 2*d-4 using 3:5:4:6 with yerrorbars pt 7 ps 0.8 lc rgb '#d55e00' title 'others, double', \
       '' index 2*d-4 using ($3*1.12):5:1 with labels left rotate by 20 font ',10' notitle, \
       '' index 2*d-3 using 3:5:4:6 with yerrorbars pt 7 ps 0.8 lc rgb '#0072b2' title 'half-spaces (ours)', \
       '' index 2*d-3 using 3:5 with lines dt 3 lc rgb '#0072b2' notitle, \
       '' index 2*d-3 using ($3/1.12):5:2 with labels right font ',10' tc rgb '#0072b2' notitle
}
unset multiplot
)");
}

}  // namespace

int main(int argc, char** argv) {
  add_dimension<2>();
  add_dimension<3>();
  constexpr std::size_t rows = 2 * (4 * std::size(ways) - 2);  // see add_ways
  const results all = run(argc, argv,
                          {"--benchmark_min_time=0.03", "--benchmark_repetitions=5",
                           "--benchmark_enable_random_interleaving=true"});
  print_table(all);
  if (all.size() < rows) return 0;  // filtered: no picture of a part
  const std::string beaten = beaten_by(all, 2) + beaten_by(all, 3);
  std::printf("\nSmaller worst error than ours in double, over 4 eps:%s\n%s\n", beaten.empty() ? " none" : "",
              beaten.c_str());
  draw_picture(all);
  const auto& ours = all.at("half-spaces (ours)/double/d=3");
  const auto times = [&](const char* way) {
    return all.at(std::string(way) + "/double/d=3").time / ours.time;
  };
  std::printf(
      "summary: d = 3: %.0f ns, inverse %.1fx, LU %.1fx, damped SVD %.1fx; worst error at 1e6: %.0e, LU "
      "%.0e\n",
      ours.time, times("inverse"), times("partial LU"), times("damped SVD"),
      ours.counters.at("worst error at 1e6"),
      all.at("partial LU/double/d=3").counters.at("worst error at 1e6"));
}
