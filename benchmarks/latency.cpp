// How long one control cycle takes, state in, capacities out: each shipped mechanism, each way through the
// step, hot and cold; and the tendon device's cycle by hand. Times are for comparing rows of one run; a
// machine under load slows all of them.
#include "latency/by_hand.hpp"

#include <passive_haptics/testing/latency_of.hpp>

#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <results.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ph = passive_haptics;

namespace {

constexpr unsigned seed = 20040627;
constexpr std::size_t state_count = 1u << 16;  // in random order: branch predictors learn up to 16384

enum class contact_kind { free, exact, approximate, any_contact };
constexpr std::pair<contact_kind, const char*> kinds[] = {{contact_kind::free, "free"},
                                                          {contact_kind::exact, "exact"},
                                                          {contact_kind::approximate, "approximate"},
                                                          {contact_kind::any_contact, "any contact"}};

// Signed distance of the wall's surface from the origin along its normal [m], and the normal: a device is 10
// m in front of the wall, or 10 m behind it, where the wall demands 10 N.
double offset_of(contact_kind kind) { return kind == contact_kind::free ? -10 : 10; }
template <int D>
ph::point<D> outward() {
  return ph::point<D>::Ones().normalized();
}

template <class M>
auto controller_of(const M& mechanism, contact_kind kind,
                   const ph::step_options<typename M::scalar>& options = {}) {
  const auto out = outward<M::task_dimension>();
  const ph::half_space<M::task_dimension> plane(offset_of(kind) * out, out);
  return ph::controller(mechanism, ph::brakes_of<M>(), ph::scene(ph::wall(plane, 1)), ph::direct_control(),
                        options);
}

template <class Result>
bool is_of(contact_kind kind, const Result& result) {
  if (result.outcome != ph::status::ok || (result.wall_number < 0) != (kind == contact_kind::free))
    return false;
  if (kind == contact_kind::any_contact) return true;
  return (result.display == ph::display_class::approximate) == (kind == contact_kind::approximate) &&
         ph::is_displayed(result.display);
}

// Random poses, rates and hand forces; three brakes in ten hardly turn.
template <class M>
std::vector<ph::device_state<M>> random_states(const M& mechanism, contact_kind kind) {
  using T = typename M::scalar;
  ph::testing::random_source random(seed);
  auto control = controller_of(mechanism, kind);
  std::vector<ph::device_state<M>> states;
  for (std::size_t attempts = 0; states.size() < state_count; ++attempts) {
    if (attempts == 1000 * state_count)
      throw std::runtime_error("hardly any random state is of the kind; has the step changed its classes?");
    ph::device_state<M> s;
    s.time = 0;
    s.q = T(1.5) * random.direction<T, M::dof>();
    s.qd = random.direction<T, M::dof>();
    for (T& rate : s.qd) rate *= random.uniform(0.0, 1.0) < 0.3 ? T(0.01) : T(1);
    s.hand_force = T(2) * random.direction<T, M::task_dimension>();
    if (is_of(kind, control(s))) states.push_back(s);
  }
  return states;
}

template <class M>
void add_rows(const std::string& name, const M& mechanism) {
  for (const auto& [kind, label] : kinds)
    ph::testing::latency_of(name + "/" + label, controller_of(mechanism, kind),
                            random_states(mechanism, kind), {.cold_samples = 300});
}

// Roughly a human arm: base, shoulder (2), elbow, wrist (2).
ph::serial_chain_parameters<double, 6, 3> spatial_arm() {
  const auto X = [](double x) { return ph::point<3>(x, 0, 0.1); };
  return {.joints = {ph::revolute_joint<double>(ph::point<3>::UnitZ(), X(0)),
                     ph::revolute_joint<double>(ph::point<3>::UnitY(), X(0)),
                     ph::revolute_joint<double>(ph::point<3>::UnitX(), X(0)),
                     ph::revolute_joint<double>(ph::point<3>::UnitY(), X(0.25)),
                     ph::revolute_joint<double>(ph::point<3>::UnitZ(), X(0.5)),
                     ph::revolute_joint<double>(ph::point<3>::UnitY(), X(0.5))},
          .handle = ph::point<3>(0.6, 0, 0.1)};
}

using arm = ph::tendon_two_link<double>;

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

by_hand::command step_by_hand(const by_hand::wall& wall, const ph::device_state<arm>& s) {
  return by_hand::step(device, wall,
                       {s.q[0], s.q[1], s.qd[0], s.qd[1], s.hand_force[0], s.hand_force[1], s.time});
}

template <class Cycle>
void add_hot_row(const std::string& name, const std::vector<ph::device_state<arm>>& states, Cycle cycle) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& run) mutable {
    std::size_t k = 0;
    for (auto _ : run) {
      auto result = cycle(states[k++ % state_count]);
      benchmark::DoNotOptimize(result);
    }
  });
}

// Capacities only, without the account: by the library and by hand, which command the same.
void add_rows_by_hand() {
  const auto out = outward<2>();
  for (const auto& [kind, label] : kinds) {
    const by_hand::wall wall{out[0], out[1], offset_of(kind), 1};
    ph::step_options<double> options;
    options.limits = ph::saturation::clamp_each;
    auto library = controller_of(arm(), kind, options);
    const auto states = random_states(arm(), kind);
    for (const auto& s : states) {
      const auto expected = library.command(s).capacity;
      const auto got = step_by_hand(wall, s);
      const double off =
          std::max(std::abs(got.capacity_1 - expected[0]), std::abs(got.capacity_2 - expected[1]));
      if (!(off <= 1e-6 * expected.maxCoeff()))
        throw std::runtime_error("the cycle by hand commands other torques");
    }
    add_hot_row(std::string("library/") + label, states,
                [=](const auto& s) mutable { return library.command(s); });
    add_hot_row(std::string("by hand/") + label, states,
                [=](const auto& s) { return step_by_hand(wall, s); });
  }
}

void print_rows_by_hand(const benchmarks::results& all) {
  std::printf("\ntendon_two_link<double>, capacities only, hot [ns of CPU time]\n");
  std::printf("%-38s %8s %8s %8s\n", "way through the step", "library", "by hand", "ratio");
  for (const auto& [kind, label] : kinds) {
    const double library = all.at(std::string("library/") + label).cpu_time;
    const double by_hand = all.at(std::string("by hand/") + label).cpu_time;
    std::printf("%-38s %8.1f %8.1f %8.2f\n", label, library, by_hand, library / by_hand);
  }
}

// One line of the table once its three rows are there.
class latency_table {
 public:
  void add(const std::string& name, const benchmarks::figures& row) {
    const auto slash = name.rfind('/');
    const std::string kind = name.substr(slash + 1);
    rows_[kind] = row;
    if (kind != "cold") return;
    const auto& hot = rows_["hot"].counters;
    const auto& cold = row.counters;
    if (!headed_) {
      std::printf("One control cycle [ns], %zu random states, seed %u; CPU: less what others took\n",
                  state_count, seed);
      std::printf("%-38s %6s %6s %7s %6s | %6s %6s %6s %7s | %7s %7s %7s\n", "", "hot", "CPU", "chained",
                  "CPU", "hot", "", "", "", "cold", "", "");
      std::printf("%-38s %6s %6s %7s %6s | %6s %6s %6s %7s | %7s %7s %7s\n",
                  "mechanism / way through the step", "mean", "mean", "mean", "mean", "p50", "p99", "p99.9",
                  "max", "p50", "p99", "max");
      headed_ = true;
    }
    std::printf("%-38s %6.0f %6.0f %7.0f %6.0f | %6.0f %6.0f %6.0f %7.0f | %7.0f %7.0f %7.0f\n",
                name.substr(0, slash).c_str(), rows_["hot"].time, rows_["hot"].cpu_time, rows_["chain"].time,
                rows_["chain"].cpu_time, hot.at("p50_ns"), hot.at("p99_ns"), hot.at("p99.9_ns"),
                hot.at("max_ns"), cold.at("p50_ns"), cold.at("p99_ns"), cold.at("max_ns"));
    std::fflush(stdout);
    rows_.clear();
  }

 private:
  std::map<std::string, benchmarks::figures> rows_;
  bool headed_ = false;
};

}  // namespace

int main(int argc, char** argv) {
  add_rows("two_link<double>", ph::two_link<double>());
  add_rows("tendon_two_link<double>", ph::tendon_two_link<double>());
  add_rows("tendon_two_link<float>", ph::tendon_two_link<float>());
  add_rows("xy_table<double>", ph::xy_table<double>());
  add_rows("five_bar<double, 2>", ph::five_bar<double, 2>());
  add_rows("five_bar<double, 4>", ph::five_bar<double, 4>());
  add_rows("delta<double>", ph::delta<double>());
  add_rows("serial_chain<double, 3, 2>",
           ph::serial_chain<double, 3, 2>(ph::planar_arm<double, 3>({0.15, 0.15, 0.1})));
  add_rows("serial_chain<double, 6, 3>", ph::serial_chain<double, 6, 3>(spatial_arm()));
  add_rows_by_hand();
  latency_table table;
  const auto all = benchmarks::run(argc, argv, {"--benchmark_min_time=0.2"},
                                   [&](const auto& name, const auto& row) { table.add(name, row); });
  const std::string tendons = "tendon_two_link<double>/";
  if (all.contains("by hand/any contact") && all.contains("library/free")) print_rows_by_hand(all);
  if (all.contains(tendons + "any contact/cold") && all.contains("by hand/any contact")) {
    const double contact = all.at(tendons + "any contact/hot").cpu_time;
    std::printf(
        "\nsummary: tendon_two_link: %.0f ns in contact, free %.2fx, chained %.2fx, cold %.0fx; capacities "
        "only "
        "%.2fx of by hand\n",
        contact, all.at(tendons + "free/hot").cpu_time / contact,
        all.at(tendons + "any contact/chain").cpu_time / contact,
        all.at(tendons + "any contact/cold").counters.at("p50_ns") / contact,
        all.at("library/any contact").cpu_time / all.at("by hand/any contact").cpu_time);
  }
}
