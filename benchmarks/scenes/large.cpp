// Sensing a scene of 100 000 shapes, and a mesh of 100 000 triangles: by a look at everything, by a skip by
// hand, and by the library; and by a plain tree when the handle jumps. The contacts are compared with those
// of a look at everything in each of 20 000 cycles.
#include "parts.hpp"
#include "plain_tree.hpp"
#include "skip_by_hand.hpp"

#include "../../tests/property/sample_meshes.hpp"

#include <passive_haptics/scene/mesh/mesh_surface.hpp>
#include <passive_haptics/scene/world/world.hpp>
#include <passive_haptics/testing/support/percentile.hpp>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace scenes {

namespace ph = passive_haptics;

namespace {

constexpr int shape_count = 100'000;
constexpr int cycles = 20'000;        // 20 s at 1 kHz
constexpr double step_length = 2e-4;  // [m]: 0.2 m/s

constexpr double globe_radius = 0.7;  // [m]

using path = std::vector<ph::point<3>>;

path wandering() {
  ph::testing::random_source random(seed + 1);
  many_shapes::wandering_hand<3> hand(step_length, random);
  path x(cycles);
  for (auto& point : x) point = hand.next();
  return x;
}

// Anywhere in each cycle, as no hand is
path jumping() {
  ph::testing::random_source random(seed + 2);
  path x(cycles);
  for (auto& point : x) point = random.between<double, 3>(ph::point<3>::Zero(), ph::point<3>::Ones());
  return x;
}

// Through the air to the globe, along it and away again, all the way round
path around_globe(double radius) {
  path x(cycles);
  for (int k = 0; k < cycles; ++k) {
    const double angle = step_length / radius * k, height = 0.02 * std::cos(2e-3 * k) + 0.01;
    x[std::size_t(k)] =
        (radius + height) * ph::point<3>(0.8 * std::cos(angle), std::sin(angle), 0.6 * std::cos(angle));
  }
  return x;
}

// Shapes of the scene, each of which counts how often its distance is taken.
long looks = 0;
template <class S>
struct counted : S {
  explicit counted(const S& s) : S(s) {}
  double distance(const ph::point<3>& x) const {
    ++looks;
    return S::distance(x);
  }
};

struct check {
  bool same = true;
  long touched = 0, looks = 0, max_looks = 0;  // most beyond the contacts, in one cycle
};

check against_a_scan(const many_shapes::shapes<3>& all, const path& hand) {
  ph::world_walls<3> walls;
  all.for_each([&]<class S>(const S& s) { walls.add(ph::wall(counted<S>(s))); });
  ph::world<3> world(walls);
  check result;
  for (std::size_t k = 0; k < hand.size(); ++k) {
    if (k % 4000 == 0) std::fprintf(stderr, "checking against a scan: %zu of %zu cycles\n", k, hand.size());
    looks = 0;
    const auto& found = ph::sense(world, hand[k]);
    result.looks += looks;
    result.max_looks = std::max(result.max_looks, looks - found.size() - world.left_out());
    result.touched += found.size();
    result.same = result.same && many_shapes::same(found, many_shapes::scan<4>(all, hand[k]));
  }
  return result;
}

using cycle = std::function<void(const ph::point<3>&)>;

// Mean over the whole path as Google Benchmark times it; of single cycles percentiles, each with the cost of
// two looks at a clock.
void add_row(const std::string& name, const path& hand, const std::function<cycle()>& make,
             bool whole_path = true) {
  benchmark::RegisterBenchmark(("large/" + name).c_str(), [=](benchmark::State& run) {
    const cycle sense = make();
    std::size_t k = 0;
    if (whole_path) {
      for (const auto& x : hand) sense(x);
      while (run.KeepRunningBatch(cycles)) {
        for (const auto& x : hand) sense(x);
      }
      std::vector<double> times;
      for (const auto& x : hand) {
        const auto start = std::chrono::steady_clock::now();
        sense(x);
        times.push_back(
            std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
      }
      const auto ascending = ph::testing::sorted(times);
      for (const auto& [label, share] :
           {std::pair("p50_ns", 0.5), {"p99_ns", 0.99}, {"p99.9_ns", 0.999}, {"max_ns", 1.0}})
        run.counters[label] = ph::testing::percentile(ascending, share);
    } else {
      for (auto _ : run) sense(hand[k++ * 997 % hand.size()]);
    }
  });
}

template <class Scene>
cycle sensing(Scene scene) {
  return [scene]<class X>(const X& x) mutable { benchmark::DoNotOptimize(scene.touched_at(x).size()); };
}

// Made when the first row runs.
const many_shapes::shapes<3>& all_shapes() {
  static const auto all = [] {
    ph::testing::random_source random(seed);
    return many_shapes::shapes<3>(shape_count, random);
  }();
  return all;
}
const ph::mesh<3>& globe() {
  static const ph::mesh<3> mesh(sample_meshes::globe(320, 158, [](const auto&) { return globe_radius; }));
  return mesh;
}

}  // namespace

void add_large_scenes() {
  const path hand = wandering(), jumps = jumping(), round = around_globe(globe_radius);
  add_row(
      "shapes/scan", hand,
      [] {
        return [](const ph::point<3>& x) {
          benchmark::DoNotOptimize(many_shapes::scan<4>(all_shapes(), x).size());
        };
      },
      false);
  add_row("shapes/by hand", hand, [] {
    return [scene = by_hand::skipping_scene(by_hand::shapes_of(all_shapes()), 0.02)](
               const ph::point<3>& x) mutable {
      int touched = 0;
      scene.step(x.data(), [&](int, double) { ++touched; });
      benchmark::DoNotOptimize(touched);
    };
  });
  add_row("shapes/world", hand, [] { return sensing(ph::world<3>(all_shapes().walls())); });
  add_row("jumps/plain tree", jumps, [] { return sensing(plain::tree_of_walls(all_shapes().walls())); });
  add_row("jumps/world", jumps, [] { return sensing(ph::world<3>(all_shapes().walls())); });
  add_row(
      "mesh/scan", round,
      [] {
        return [](const ph::point<3>& x) {
          double nearest = std::numeric_limits<double>::infinity();
          for (int i = 0; i < globe().size(); ++i)
            nearest = std::min(nearest, ph::nearest_point(globe()[i], x).squared_distance);
          benchmark::DoNotOptimize(nearest);
        };
      },
      false);
  add_row("mesh/world", round, [] {
    ph::world_walls<3> walls;
    walls.add(ph::wall(ph::mesh_surface<3>(globe())));
    return sensing(ph::world<3>(walls));
  });
}

std::string print_large_scenes(const benchmarks::results& all) {
  benchmarks::results rows;
  for (const auto& [name, row] : all)
    if (name.starts_with("large/")) rows[name.substr(6)] = row;
  if (rows.empty()) return {};
  std::printf(
      "\nSensing a scene of %zu shapes, and of a mesh of %d triangles, at 0.2 m/s and 1 kHz [ns]; means of "
      "CPU time\n",
      all_shapes().size(), globe().size());
  std::printf("%-16s %10s %8s %8s %8s %8s\n", "", "mean", "p50", "p99", "p99.9", "max");
  for (const auto& [name, row] : rows) {
    std::printf("%-16s %10.1f", name.c_str(), row.cpu_time);
    for (const char* p : {"p50_ns", "p99_ns", "p99.9_ns", "max_ns"}) {
      if (row.counters.contains(p)) std::printf(" %8.0f", row.counters.at(p));
    }
    std::printf("\n");
  }
  if (rows.size() < 7) return {};  // filtered
  const check found = against_a_scan(all_shapes(), wandering());
  std::printf("in %d cycles %ld contacts%s; %.3f distances a cycle, in the worst %ld beyond the contacts\n",
              cycles, found.touched, found.same ? ", the same as by a scan" : "",
              static_cast<double>(found.looks) / cycles, found.max_looks);
  if (!found.same || found.max_looks > 64) {
    std::fprintf(stderr, "error: %s\n",
                 found.same ? "more than 64 distances in one cycle" : "not the contacts of a scan");
    std::exit(1);
  }
  const auto ratio = [&](const char* a, const char* b) { return rows.at(a).cpu_time / rows.at(b).cpu_time; };
  char text[200];
  std::snprintf(
      text, sizeof text,
      "1e5 shapes: scan %.0fx of ours, ours %.2fx of by hand, where it jumps %.2fx of a plain tree; 1e5 "
      "triangles: scan %.0fx of ours",
      ratio("shapes/scan", "shapes/world"), ratio("shapes/world", "shapes/by hand"),
      ratio("jumps/world", "jumps/plain tree"), ratio("mesh/scan", "mesh/world"));
  return text;
}

}  // namespace scenes
