// How the nearest displayable force scales: n = 1 .. 8 dimensions, m = n .. 2 n brakes. The half-space form where m = n, the
// generator form with torques of least norm beyond. Random Gaussian problems, cold start.
#include <passive_haptics/force/nearest_force.hpp>
#include <passive_haptics/force/nearest_torque.hpp>
#include <passive_haptics/testing/random.hpp>

#include <output.hpp>
#include <results.hpp>

#include <array>
#include <cstdio>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

namespace ph = passive_haptics;

namespace {

constexpr unsigned seed = 20040627;
constexpr int largest = 8;  // n

template <int N, int M>
struct problem {
  ph::matrix<double, N, M> A;  // E or G
  ph::vector<double, M> s;     // signs of the brakes
  ph::vector<double, N> Fd;    // unit
};

template <int N, int M>
std::array<problem<N, M>, 256> random_problems() {
  ph::testing::random_source random(seed);
  std::array<problem<N, M>, 256> all;
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

std::string row_name(int n, int m) { return "n=" + std::to_string(n) + "/m=" + std::to_string(m); }

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
  [&]<int... More>(std::integer_sequence<int, More...>) {
    (add_row<N, N + More>(), ...);
  }(std::make_integer_sequence<int, N + 1>());
}

void print_table(const benchmarks::results& all) {
  std::printf("Nearest force [ns], %u problems each, seed %u\n  n  m = n", 256u, seed);
  for (int more = 1; more <= largest; ++more) std::printf("   n + %d", more);
  for (int n = 1; n <= largest; ++n) {
    std::printf("\n%3d", n);
    for (int m = n; m <= 2 * n; ++m) {
      const auto row = all.find(row_name(n, m));
      if (row == all.end()) std::printf("%8s", "-");
      else std::printf("%8.0f", row->second.time);
    }
  }
  std::puts("\n");
}

void draw_picture(const benchmarks::results& all) {
  std::ostringstream data;
  data << "# n, m, time [ns]\n";
  for (int more = 0; more <= largest; ++more) {
    for (int n = std::max(1, more); n <= largest; ++n)
      data << n << ", " << n + more << ", " << all.at(row_name(n, n + more)).time << "\n";
    data << "\n\n";
  }
  example::write_file("scaling.csv", data.str());
  example::draw(".", "scaling", R"(
set terminal svg size 800,520 font 'sans,12' background 'white'
set output output
set datafile separator ', '
set title 'Nearest displayable force: time by dimensions n and brakes m'
set logscale y
set grid lc rgb '#dddddd'
set xlabel 'n'
set ylabel 'time [ns]'
set xrange [0.7:8.3]
set key outside right
plot 'scaling.csv' index 0 using 1:3 with linespoints lw 2 pt 7 lc rgb '#0072b2' title 'm = n: half-spaces', \
     for [k=1:8] 'scaling.csv' index k using 1:3 with linespoints pt 6 ps 0.6 lc palette frac k/8. title sprintf('m = n + %d', k)
)");
}

}  // namespace

int main(int argc, char** argv) {
  [&]<int... N>(std::integer_sequence<int, N...>) {
    (add_rows<N + 1>(), ...);
  }(std::make_integer_sequence<int, largest>());
  const auto all = benchmarks::run(argc, argv,
                                   {"--benchmark_min_time=0.03", "--benchmark_repetitions=5",
                                    "--benchmark_enable_random_interleaving=true"});
  print_table(all);
  if (all.size() < largest * (largest + 3) / 2) return 0;  // filtered: no picture of a part
  draw_picture(all);
  const auto time = [&](int n, int m) { return all.at(row_name(n, m)).time; };
  std::printf(
      "summary: m = n: %.0f ns for n = 2, %.1fx for 4, %.1fx for 8; m = 2 n: %.0fx of m = n for 2, %.0fx for "
      "8\n",
      time(2, 2), time(4, 4) / time(2, 2), time(8, 8) / time(2, 2), time(2, 4) / time(2, 2),
      time(8, 16) / time(8, 8));
}
