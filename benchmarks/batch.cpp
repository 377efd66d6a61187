// Many states at once against one cycle after the other, of each shipped mechanism: random states, most of
// them in contact; and a design map of as many points. What is timed also stores its results.
#include <passive_haptics/design/map/design_map.hpp>
#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <results.hpp>

#include <array>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace ph = passive_haptics;

namespace {

constexpr unsigned seed = 20040627;
constexpr std::size_t state_count = 1u << 16;  // in random order: branch predictors learn up to 16384

std::vector<std::string> rows;

// Where the next array begins in its page [bytes]: were it the beginning for all, they would share a few
// lines of the cache.
std::size_t next_offset() {
  static std::size_t offset = 0;
  return offset = (offset + 5 * 64) % 4096;
}

template <class T>
class column {
 public:
  column() : offset_(next_offset() / sizeof(T)), all_(offset_ + state_count) {}
  operator std::span<T>() { return std::span<T>(all_).subspan(offset_); }
  operator std::span<const T>() const { return std::span<const T>(all_).subspan(offset_); }
  T& operator[](std::size_t k) { return all_[offset_ + k]; }

 private:
  std::size_t offset_;
  std::vector<T> all_;
};

template <class T, int Components>
struct columns {
  std::array<column<T>, std::size_t(Components)> of;
  template <class X = T>
  ph::component_arrays<X, Components> spans() {
    ph::component_arrays<X, Components> s;
    for (std::size_t i = 0; i < s.size(); ++i) s[i] = of[i];
    return s;
  }
};

// The states one by one and in columns, and room for results.
template <class M>
struct arrays {
  using T = typename M::scalar;
  std::vector<ph::device_state<M>> states;
  columns<T, M::dof> q, qd;
  columns<T, M::task_dimension> hand_force;
  columns<T, M::brake_count> capacity, torque, signs;
  column<ph::status> outcome;
  column<ph::power_class> power;
  column<ph::display_class> display;
  column<T> alpha;

  explicit arrays(std::vector<ph::device_state<M>> given) : states(std::move(given)) {
    for (std::size_t k = 0; k < state_count; ++k) {
      for (int i = 0; i < M::dof; ++i) q.of[std::size_t(i)][k] = states[k].q[i];
      for (int i = 0; i < M::dof; ++i) qd.of[std::size_t(i)][k] = states[k].qd[i];
      for (int i = 0; i < M::task_dimension; ++i) hand_force.of[std::size_t(i)][k] = states[k].hand_force[i];
    }
  }
  ph::batch_states<M> in() {
    return {q.template spans<const T>(), qd.template spans<const T>(), hand_force.template spans<const T>()};
  }
  ph::batch_results<M> commands() { return {capacity.spans(), outcome}; }
  ph::batch_results<M> account() {
    ph::batch_results<M> r = commands();
    r.torque = torque.spans();
    r.signs = signs.spans();
    r.power = power;
    r.display = display;
    r.alpha = alpha;
    return r;
  }
};

// Random poses and rates, three brakes in ten at rest; nine handles in ten are behind `wall`, at most `deep`
// [m]
template <class M, class Wall>
std::vector<ph::device_state<M>> draw(const M& mechanism, const Wall& wall, double deep) {
  using T = typename M::scalar;
  ph::testing::random_source random(seed);
  std::vector<ph::device_state<M>> found;
  while (found.size() < state_count) {
    ph::device_state<M> s;
    for (int i = 0; i < M::dof; ++i) {
      s.q[i] = random.uniform(T(-2), T(2));
      s.qd[i] = (random.uniform(0.0, 1.0) < 0.3 ? T(0.01) : T(1)) * random.uniform(T(-1), T(1));
    }
    for (int i = 0; i < M::task_dimension; ++i) s.hand_force[i] = random.uniform(T(-10), T(10));
    const double depth = -wall.distance(ph::as<double>(mechanism.position(s.q)));
    const bool is_behind = depth > 0, shall_be_behind = found.size() % 10 != 0;
    if (is_behind == shall_be_behind && depth < deep && depth > -deep) found.push_back(s);
  }
  // In random order
  for (std::size_t k = state_count; k-- > 1;)
    std::swap(found[k], found[std::size_t(random.uniform(0.0, double(k + 1)))]);
  for (std::size_t k = 0; k < state_count; ++k) found[k].time = 1e-3 * double(k);
  return found;
}

// The poses of these states as points of a task: the handle moves as there, along the wall's normal
template <class M, class Wall>
ph::task_points<M> points_of(const M& mechanism, const std::vector<ph::device_state<M>>& states,
                             const Wall& wall) {
  ph::task_points<M> points;
  for (const auto& s : states) {
    const ph::task_vector<M> x = mechanism.position(s.q);
    points.append({s.q, ph::velocity(mechanism, s.q, s.qd), wall.gradient(x)}, x);
  }
  return points;
}

template <class M, class L, class Wall, class... More>
void add(const std::string& name, const M& mechanism, const L& law, double deep, const Wall& wall,
         const More&... more) {
  const ph::brakes_of<M> brakes;
  const ph::switchable_brakes<M> brakes_alone;
  const auto scene = ph::scene(ph::wall(wall, 1e4), ph::wall(more, 1e4)...);
  ph::controller single(mechanism, brakes, scene, law);
  const auto data = std::make_shared<arrays<M>>(draw(mechanism, wall, deep));
  rows.push_back(name);
  const auto add_pass = [&](const std::string& way, auto pass) {
    benchmark::RegisterBenchmark((way + "/" + name).c_str(), [pass](benchmark::State& run) mutable {
      for (auto _ : run) {
        pass();
        benchmark::ClobberMemory();
      }
    });
  };
  using command = ph::brake_command<M>;
  using result = typename decltype(single)::result_type;
  add_pass("single", [data, single, got = std::vector<command>(state_count)]() mutable {
    single.reset();
    for (std::size_t k = 0; k < state_count; ++k) got[k] = single.command(data->states[k]);
    benchmark::DoNotOptimize(got.data());
  });
  add_pass("account", [data, single, got = std::vector<result>(state_count)]() mutable {
    single.reset();
    for (std::size_t k = 0; k < state_count; ++k) got[k] = single(data->states[k]);
    benchmark::DoNotOptimize(got.data());
  });
  add_pass("batch", [data, single] { single.batch(data->in(), data->commands()); });
  add_pass("batch account", [data, single] { single.batch(data->in(), data->account()); });
  if constexpr (ph::design_map<M>::has_closed_form)
    add_pass("map", [mechanism, points = points_of(mechanism, data->states, wall), limits = brakes_alone,
                     map = ph::design_map<M>()]() mutable {
      map.assign(mechanism, points, limits, 2.0);
      benchmark::DoNotOptimize(map.max_force.data());
    });
}

void add_all() {
  const ph::half_space<2> across({0, 0.15}, {0, -1});
  const ph::tendon_two_link<double> arm;
  const auto velocity_law = ph::recommended_law(arm, ph::brakes_of<ph::tendon_two_link<double>>());
  add("tendon device", arm, ph::direct_control(), 1e-2, across);
  add("no direct control", arm, ph::no_direct_control(), 1e-2, across);
  add("saturated", arm, ph::saturated_direct_control(), 1e-2, across);
  add("in a disc", arm, ph::direct_control(), 1e-2, ph::disc({0, 0}, 0.2, ph::filling::hollow));
  add("two_link", ph::two_link<double>(), ph::direct_control(), 1e-2, across);
  add("xy_table", ph::xy_table<double>(), ph::direct_control(), 1e-2, across);
  add("five_bar", ph::five_bar<double>(), ph::direct_control(), 1e-2, ph::half_space<2>({0, 0.06}, {0, -1}));
  add("five_bar, 4 brakes", ph::five_bar<double, 4>(), ph::direct_control(), 1e-2,
      ph::half_space<2>({0, 0.06}, {0, -1}));
  add("delta", ph::delta<double>(), ph::direct_control(), 1e-2, ph::half_space<3>({0, 0, -0.07}, {0, 0, 1}));
  add("two walls", arm, ph::direct_control(), 1e-2, across, ph::half_space<2>({0.15, 0}, {-1, 0}));
  add("velocity control", arm, velocity_law, 1e-2, across);
}

}  // namespace

int main(int argc, char** argv) {
  add_all();
  const auto all = benchmarks::run(argc, argv,
                                   {"--benchmark_min_time=0.02", "--benchmark_repetitions=15",
                                    "--benchmark_enable_random_interleaving=true"});
  if (all.size() < 4 * rows.size()) return 0;  // filtered
  std::printf("One state [ns of CPU time], %zu random states in random order, seed %u\n", state_count, seed);
  std::printf("%-20s %9s %8s %7s %9s %8s %7s %7s\n", "", "command", "batch", "ratio", "account", "batch",
              "ratio", "map");
  const auto time = [&](const char* way, const std::string& r) {
    return all.at(way + ("/" + r)).cpu_time / double(state_count);
  };
  for (const std::string& r : rows) {
    std::printf("%-20s %9.1f %8.1f %7.2f %9.1f %8.1f %7.2f", r.c_str(), time("single", r), time("batch", r),
                time("batch", r) / time("single", r), time("account", r), time("batch account", r),
                time("batch account", r) / time("account", r));
    if (all.contains("map/" + r)) std::printf(" %7.1f", time("map", r));
    std::printf("\n");
  }
  const std::string& first = rows.front();
  std::printf("summary: a batch takes %.2f of a single command's time a state, %.2f of its account's (%s)\n",
              time("batch", first) / time("single", first),
              time("batch account", first) / time("account", first), first.c_str());
}
