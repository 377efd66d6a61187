// How the nearest displayable force scales: n = 1 .. 6 dimensions; m = n, n + 1 and 2 n brakes. The
// half-space form where m = n, the generator form with torques of least norm beyond (m between takes times
// between, and minutes to compile). Random Gaussian problems, cold start.
#include "parts.hpp"

#include <passive_haptics/force/nearest_force.hpp>
#include <passive_haptics/force/torques/nearest_torque.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <output.hpp>

#include <array>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>

namespace scenes {

namespace ph = passive_haptics;

namespace {

constexpr int largest = 6;  // n
constexpr int problem_count = 256;

template <int N, int M>
struct problem {
  ph::matrix<double, N, M> A;  // E or G
  ph::vector<double, M> s;     // signs of the brakes
  ph::vector<double, N> Fd;    // unit
};

template <int N, int M>
std::array<problem<N, M>, problem_count> random_problems() {
  ph::testing::random_source random(seed);
  std::array<problem<N, M>, problem_count> all;
  for (auto& p : all) {
    for (int i = 0; i < M; ++i) p.A.col(i) = random.normal_vector<double, N>();
    for (int i = 0; i < M; ++i) p.s[i] = random.coin() ? 1 : -1;
    p.Fd = random.direction<double, N>();
  }
  return all;
}

template <int N, int M>
ph::vector<double, N> nearest(const problem<N, M>& p) {
  if constexpr (M == N) {
    return ph::nearest_force(p.A, p.s, p.Fd).force;
  } else {
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    const auto box = ph::torques_within<double, M>(p.s, ph::vector<double, M>::Constant(unlimited));
    return ph::nearest_torque(p.A, box, p.Fd).force;
  }
}

std::string row_name(int n, int m) { return "dimensions/n=" + std::to_string(n) + "/m=" + std::to_string(m); }

template <int N, int M>
void add_row() {
  benchmark::RegisterBenchmark(row_name(N, M).c_str(), [](benchmark::State& run) {
    const auto problems = random_problems<N, M>();
    std::size_t k = 0;
    for (auto _ : run) {
      auto force = nearest(problems[k++ % problems.size()]);
      benchmark::DoNotOptimize(force);
    }
  });
}

template <int N>
void add_rows() {
  add_row<N, N>();
  if constexpr (N > 1) add_row<N, N + 1>();
  add_row<N, 2 * N>();
}

// "n, m = n, m = n + 1, m = 2 n"
std::string line(const benchmarks::results& all, int n, const char* separator) {
  std::string text = std::to_string(n);
  for (const int m : {n, n + 1, 2 * n}) {
    char entry[32];
    std::snprintf(entry, sizeof entry, "%s%6.0f", separator, all.at(row_name(n, m)).cpu_time);
    text += entry;
  }
  return text + "\n";
}

void draw_picture(const benchmarks::results& all) {
  std::string data = "# n, time [ns] for m = n, m = n + 1, m = 2 n\n";
  for (int n = 1; n <= largest; ++n) data += line(all, n, ", ");
  example::write_file("scenes.csv", data);
  example::draw(".", "scenes", R"(
set terminal svg size 700,480 font 'sans,12' background 'white'
set output output
set datafile separator ','
set title 'Nearest displayable force by n dimensions and m brakes'
set logscale y
set grid lc rgb '#dddddd'
set xlabel 'n'
set ylabel 'time [ns]'
set xrange [0.7:6.3]
set key left top
plot 'scenes.csv' using 1:4 with linespoints lw 2 pt 5 lc rgb '#d55e00' title 'm = 2 n: generators', \
     '' using 1:3 with linespoints lw 2 pt 9 lc rgb '#009e73' title 'm = n + 1: generators', \
     '' using 1:2 with linespoints lw 2 pt 7 lc rgb '#0072b2' title 'm = n: half-spaces'
)");
}

}  // namespace

void add_dimensions() {
  [&]<int... N>(std::integer_sequence<int, N...>) {
    (add_rows<N + 1>(), ...);
  }(std::make_integer_sequence<int, largest>());
}

std::string print_dimensions(const benchmarks::results& all) {
  for (int n = 1; n <= largest; ++n)
    for (const int m : {n, n + 1, 2 * n})
      if (!all.contains(row_name(n, m))) return {};  // filtered: no picture of a part
  std::printf("\nNearest force [ns of CPU time], %d problems each, seed %u\nn   m = n   n + 1     2 n\n",
              problem_count, seed);
  for (int n = 1; n <= largest; ++n) std::printf("%s", line(all, n, "  ").c_str());
  draw_picture(all);
  const auto time = [&](int n, int m) { return all.at(row_name(n, m)).cpu_time; };
  char text[200];
  std::snprintf(
      text, sizeof text,
      "m = n: %.0f ns for n = 2, %.1fx for 4, %.1fx for 6; m = 2 n: %.0fx of m = n for 2, %.0fx for 6",
      time(2, 2), time(4, 4) / time(2, 2), time(6, 6) / time(2, 2), time(2, 4) / time(2, 2),
      time(6, 12) / time(6, 6));
  return text;
}

}  // namespace scenes
