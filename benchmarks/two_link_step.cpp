// One control cycle of the tendon device along a plane wall under direct control: the library's, written by
// hand for this device alone, in scalars and with a brake in each half of a register, and from the textbook
// with solvers of Eigen. The lanes by hand check their input as the library does. The library also predicts
// the torques (3) and reports what it did; the others return capacities and a region only.
#include "two_link_step/lanes_by_hand.hpp"
#include "two_link_step/textbook.hpp"

#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <results.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

namespace ph = passive_haptics;

namespace {

using arm = ph::tendon_two_link<double>;
using controller = ph::controller<arm, ph::static_scene<ph::half_space<2>>, ph::direct_control>;

constexpr unsigned seed = 20040627;
constexpr std::size_t state_count = 1u << 16;  // in random order: branch predictors learn up to 16384
constexpr double wall_stiffness = 1e4;         // at most 10 N: some torques are over their limit, some not

struct situation {
  std::string name;
  std::vector<ph::device_state<arm>> states;
};

const double reduction_2 = ph::tendon_two_link_parameters<double>().reduction_2;
const by_hand::device device{arm().parameters().length_1,
                             arm().parameters().length_2,
                             reduction_2,
                             1 / reduction_2,
                             ph::brakes_of<arm>().rate_dead_band[0],
                             ph::brakes_of<arm>().torque_limit[0],
                             ph::brakes_of<arm>().torque_dead_band[0],
                             ph::step_options<double>().min_cosine,
                             ph::rounding_tolerance<double>(1)};
const by_hand::wall wall{0, -1, -0.225, wall_stiffness};  // y = 0.225 m, free below: section 5.1

by_hand::measurement measured(const ph::device_state<arm>& s) {
  return {s.q[0], s.q[1], s.qd[0], s.qd[1], s.hand_force[0], s.hand_force[1], s.time};
}

// Random states that the cycle puts in one of these regions; three brakes in ten are at rest
situation draw(const std::string& name, std::initializer_list<by_hand::region> regions) {
  ph::testing::random_source random(seed);
  const arm mechanism;
  situation found{name, {}};
  const bool is_free = *regions.begin() == by_hand::region::free;
  const auto rate = [&] { return random.uniform(0.0, 1.0) < 0.3 ? 0.01 : 1.0; };
  while (found.states.size() < state_count) {
    const double y = is_free ? random.uniform(0.2, 0.22) : 0.225 + random.uniform(1e-5, 1e-3);
    ph::device_state<arm> s;
    s.time = 0;
    s.q = mechanism.inverse({random.uniform(0.045, 0.17), y}, ph::elbow::left).q;
    for (int i = 0; i < 2; ++i) s.qd[i] = rate() * random.uniform(-1.0, 1.0);
    s.hand_force = {random.uniform(-2.0, 2.0), random.uniform(-1.0, 3.0)};
    const auto where = by_hand::step(device, wall, measured(s)).where;
    if (std::find(regions.begin(), regions.end(), where) != regions.end()) found.states.push_back(s);
  }
  return found;
}

controller make_controller() {
  const ph::half_space<2> plane({0, 0.225}, {0, -1});
  ph::step_options<double> options;
  options.limits = ph::saturation::clamp_each;  // as the others
  return controller(arm(), ph::brakes_of<arm>(), ph::scene(ph::wall(plane, wall_stiffness)), {}, options);
}

constexpr std::array ways{"library", "its account", "lanes",     "by hand",
                          "inverse", "partial LU",  "damped SVD"};

using way = std::function<by_hand::command(const ph::device_state<arm>&)>;

// All ways command the same torques
bool agree(const situation& where, const std::string& name, const way& other) {
  controller library = make_controller();
  for (const auto& state : where.states) {
    const auto expected = library(state).capacity;
    const auto got = other(state);
    const double off =
        std::max(std::abs(got.capacity_1 - expected[0]), std::abs(got.capacity_2 - expected[1]));
    if (off <= 1e-6 * expected.maxCoeff()) continue;
    std::fprintf(stderr, "error: %s/%s: capacities %g %g N m, the library's are %g %g\n", name.c_str(),
                 where.name.c_str(), got.capacity_1, got.capacity_2, expected[0], expected[1]);
    return false;
  }
  return true;
}

template <class Cycle>
void add_row(const std::string& name, const situation& where, Cycle cycle) {
  benchmark::RegisterBenchmark((name + "/" + where.name).c_str(),
                               [where, cycle](benchmark::State& run) mutable {
                                 std::size_t k = 0;
                                 for (auto _ : run) {
                                   auto result = cycle(where.states[k++ % where.states.size()]);
                                   benchmark::DoNotOptimize(result);
                                 }
                               });
}

}  // namespace

int main(int argc, char** argv) {
  using enum by_hand::region;
  const std::vector<situation> situations{draw("free", {free}), draw("exact", {exact}),
                                          draw("approximate", {approximate}),
                                          draw("any contact", {exact, approximate, none})};
  const auto in_lanes = [](const ph::device_state<arm>& s) {
    return by_hand::lanes(device, wall, measured(s));
  };
  const auto hand = [](const ph::device_state<arm>& s) { return by_hand::step(device, wall, measured(s)); };
  const auto inverse = [](const ph::device_state<arm>& s) {
    return textbook::step<textbook::inverse>(device, wall, measured(s));
  };
  const auto lu = [](const ph::device_state<arm>& s) {
    return textbook::step<textbook::partial_lu>(device, wall, measured(s));
  };
  const auto svd = [](const ph::device_state<arm>& s) {
    return textbook::step<textbook::damped_svd>(device, wall, measured(s));
  };
  for (const situation& where : situations) {
    if (!agree(where, "by hand", hand) || !agree(where, "lanes", in_lanes) ||
        !agree(where, "inverse", inverse) || !agree(where, "partial LU", lu))
      return 1;  // damping changes the torques
    add_row("library", where, [control = make_controller()](const ph::device_state<arm>& s) mutable {
      return control.command(s);
    });
    add_row("its account", where,
            [control = make_controller()](const ph::device_state<arm>& s) mutable { return control(s); });
    add_row("lanes", where, in_lanes);
    add_row("by hand", where, hand);
    add_row("inverse", where, inverse);
    add_row("partial LU", where, lu);
    add_row("damped SVD", where, svd);
  }
  const auto all = benchmarks::run(argc, argv,
                                   {"--benchmark_min_time=0.05", "--benchmark_repetitions=9",
                                    "--benchmark_enable_random_interleaving=true"});
  if (all.size() < ways.size() * situations.size()) return 0;  // filtered
  std::printf("One control cycle [ns of CPU time], %zu random states, seed %u\n", state_count, seed);
  std::printf("%-12s %8s %8s %12s %12s\n", "", "free", "exact", "approximate", "any contact");
  const auto time = [&](const std::string& way, const char* where) {
    return all.at(way + "/" + where).cpu_time;
  };
  for (const char* way : ways)
    std::printf("%-12s %8.1f %8.1f %12.1f %12.1f\n", way, time(way, "free"), time(way, "exact"),
                time(way, "approximate"), time(way, "any contact"));
  const double ours = time("library", "any contact");
  std::printf(
      "summary: in contact %.2fx of the lanes by hand, %.2fx of by hand; inverse %.1fx, partial LU %.1fx, "
      "damped SVD %.1fx of the library; its account %.2fx; free %.2fx of contact\n",
      ours / time("lanes", "any contact"), ours / time("by hand", "any contact"),
      time("inverse", "any contact") / ours, time("partial LU", "any contact") / ours,
      time("damped SVD", "any contact") / ours, time("its account", "any contact") / ours,
      time("library", "free") / ours);
}
