// A scene with a cost that depends on the touched walls only: a hand moves among 10 to 100 000 small balls
// over a hill of triangles. A table and a picture compare the work and time per cycle with a full scan.
#include <command_line.hpp>
#include <output.hpp>

#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/plant/random_numbers.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <random>
#include <sstream>
#include <vector>

namespace ph = passive_haptics;

namespace {

constexpr unsigned seed = 20040627;
constexpr int cycles = 20'000;        // 20 s at 1 kHz
constexpr double step_length = 2e-4;  // [m]: 0.2 m/s

// A custom shape: a ball that counts calls of distance().
struct counting_ball {
  static constexpr int dimension = 3;
  double distance(const ph::point<3>& x) const {
    ++*looks;
    return ball.distance(x);
  }
  ph::point<3> gradient(const ph::point<3>& x) const { return ball.gradient(x); }
  ph::bounding_box<3> bounds() const { return ball.bounds(); }  // allows distant ones to be skipped
  ph::ball<3> ball;
  long* looks;
};

ph::point<3> anywhere(std::mt19937_64& random) {
  return {ph::uniform_number(random), ph::uniform_number(random), ph::uniform_number(random)};
}

std::vector<ph::ball<3>> balls(int count) {
  std::mt19937_64 random(seed);
  std::vector<ph::ball<3>> all;
  for (int i = 0; i < count; ++i) {
    const ph::point<3> centre = anywhere(random);
    all.emplace_back(centre, 1e-3 + 4e-3 * ph::uniform_number(random));
  }
  return all;
}

ph::mesh_surface<3> hill() {
  ph::height_field_parameters field;
  field.columns = field.rows = 201;
  field.spacing_x = field.spacing_y = 5e-3;
  for (int k = 0; k < field.columns * field.rows; ++k) {
    const double x = 5e-3 * (k % field.columns), y = 5e-3 * (k / field.columns);
    field.heights.push_back(0.2 + 0.1 * std::sin(6 * x) * std::cos(6 * y));
  }
  return ph::mesh_surface<3>(ph::triangle_mesh(ph::height_field(field)));
}

// Positions of the hand each millisecond: straight lines between random places.
std::vector<ph::point<3>> wandering() {
  std::mt19937_64 random(seed + 1);
  std::vector<ph::point<3>> path{{0.5, 0.5, 0.5}};
  for (ph::point<3> to = anywhere(random); path.size() < cycles;) {
    const ph::point<3> way = to - path.back();
    if (way.norm() < step_length) to = anywhere(random);
    else path.push_back(path.back() + step_length * way.normalized());
  }
  return path;
}

// Median of several runs along the path, since other programs disturb some of them.
template <class F>
double nanoseconds_each(const std::vector<ph::point<3>>& path, std::size_t stride, const F& f) {
  constexpr std::size_t runs = 5;
  std::array<double, runs> each;
  for (double& one : each) {
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t k = 0; k < path.size(); k += stride) f(path[k]);
    const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
    one = spent.count() / static_cast<double>((path.size() + stride - 1) / stride);
  }
  std::nth_element(each.begin(), each.begin() + runs / 2, each.end());
  return each[runs / 2];
}

}  // namespace

int main(int argc, char** argv) try {
  const auto directory = example::output_directory(
      argc, argv, "large_scene", "Cost of a cycle in a large scene: a table, large_scene.svg and its data.");
  const auto path = wandering();
  const auto surface = hill();
  std::ostringstream data;
  std::printf("A hill of %d triangles, and balls [ns, medians of five runs: read ratios]\n",
              surface.surface().size());
  std::printf("%8s %10s %18s %16s %16s %16s\n", "balls", "contacts", "looks in a cycle", "in the worst",
              "a cycle [ns]", "all balls [ns]");
  for (const int count : {10, 100, 1000, 10'000, 100'000}) {
    const auto all = balls(count);
    ph::world_walls<3> walls, counted_walls;
    long looks = 0, most = 0, total = 0, contacts = 0;
    walls.add(ph::wall(surface));
    counted_walls.add(ph::wall(surface));
    for (const auto& ball : all) {
      walls.add(ph::wall(ball));
      counted_walls.add(ph::wall(counting_ball{ball, &looks}));
    }
    ph::world<3> world(walls), counted(counted_walls);
    for (const auto& x : path) {
      looks = 0;
      contacts += ph::sense(counted, x).size();
      total += looks;
      most = std::max(most, looks);
    }
    int touched = 0;  // printed, so that the work is not optimised away
    const double each =
        nanoseconds_each(path, 1, [&](const auto& x) { touched += ph::sense(world, x).size(); });
    const double scan = nanoseconds_each(path, 40, [&](const auto& x) {
      for (const auto& ball : all) touched += ball.distance(x) < 0;
    });
    std::printf("%8d %10ld %18.3f %16ld %16.0f %16.0f%s\n", count, contacts,
                static_cast<double>(total) / cycles, most, each, scan, touched < 0 ? "?" : "");
    std::fflush(stdout);
    data << count << "," << static_cast<double>(total) / cycles << "," << each << "," << scan << "\n";
  }
  example::write_file(directory / "large_scene.csv", "balls,looks,cycle_ns,scan_ns\n" + data.str());
  example::draw(directory, "large_scene", R"(set terminal svg size 720,420 background '#ffffff'
set output output
set datafile separator ','
set logscale xy
set xlabel 'balls in the scene'
set ylabel 'time of a cycle [ns]'
set format '10^{%T}'
set key left top
set grid
plot 'large_scene.csv' every ::1 using 1:4 with linespoints lw 2 pt 7 lc rgb '#999999' title 'a look at every ball', \
     '' every ::1 using 1:3 with linespoints lw 2 pt 7 lc rgb '#0072b2' title 'a world, with the hill'
)");
} catch (const std::exception& error) {
  std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
