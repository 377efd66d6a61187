// How long one control cycle takes, state in, capacities out: each shipped mechanism, each way through the
// step, hot and cold. Times are for comparing rows of one run; a machine under load slows all of them.
#include <passive_haptics/testing/latency_of.hpp>

#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <results.hpp>

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ph = passive_haptics;

namespace {

constexpr unsigned seed = 20040627;
constexpr int state_count = 64;

enum class contact_kind { free, exact, approximate };
constexpr std::pair<contact_kind, const char*> kinds[] = {
    {contact_kind::free, "free"}, {contact_kind::exact, "exact"}, {contact_kind::approximate, "approximate"}};

// A plane and states about it that differ a little, so that nothing is folded into a constant.
template <class M>
struct situation {
  ph::half_space<M::task_dimension> plane;
  std::vector<ph::device_state<M>> states;
};

template <class M>
auto controller_at(const M& mechanism, const ph::half_space<M::task_dimension>& plane) {
  return ph::controller(mechanism, ph::brakes_of<M>(), ph::scene(ph::wall(plane)), ph::direct_control());
}

template <class M>
bool is_of(contact_kind kind, const M& mechanism, const situation<M>& candidate) {
  const auto expected =
      kind == contact_kind::approximate ? ph::display_class::approximate : ph::display_class::exact;
  auto control = controller_at(mechanism, candidate.plane);
  return std::all_of(candidate.states.begin(), candidate.states.end(), [&](const auto& state) {
    const auto result = control(state);
    return result.outcome == ph::status::ok && result.display == expected &&
           (result.wall < 0) == (kind == contact_kind::free);
  });
}

// Nothing if chance gave another kind, or a pose that does not exist.
template <class M>
std::optional<situation<M>> random_situation(const M& mechanism, contact_kind kind,
                                             ph::testing::random_source& random) {
  using T = typename M::scalar;
  constexpr int n = M::dof, d = M::task_dimension;
  ph::device_state<M> middle;
  middle.q = T(1.5) * random.direction<T, n>();
  middle.qd = random.direction<T, n>();
  middle.hand_force = T(2) * random.direction<T, d>();
  const ph::point<d> x = mechanism.position(middle.q).template cast<double>();
  const ph::point<d> out = random.direction<double, d>();
  if (!ph::all_finite(x)) return {};
  const double depth = kind == contact_kind::free ? -0.01 : 1e-3;
  situation<M> candidate{ph::half_space<d>(x + depth * out, out), {}};
  for (int k = 0; k < state_count; ++k) {
    candidate.states.push_back(middle);
    candidate.states.back().q += T(1e-4) * random.direction<T, n>();
  }
  if (!is_of(kind, mechanism, candidate)) return {};
  return candidate;
}

template <class M>
void add_rows(const std::string& name, const M& mechanism) {
  constexpr int attempts = 1'000'000;
  ph::testing::random_source random(seed);
  for (const auto& [kind, label] : kinds) {
    for (int k = 0;; ++k) {
      if (k == attempts)
        throw std::runtime_error(name + ": none of " + std::to_string(attempts) + " random states is '" +
                                 label + "'; has the step changed its classes?");
      if (auto found = random_situation(mechanism, kind, random)) {
        ph::testing::latency_of(name + "/" + label, controller_at(mechanism, found->plane),
                                std::move(found->states), {.cold_samples = 300});
        break;
      }
    }
  }
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
      std::printf("One control cycle [ns]\n%-38s %7s %7s | %6s %6s %6s %7s | %7s %7s %7s\n", "", "hot,",
                  "chained", "hot", "", "", "", "cold", "", "");
      std::printf("%-38s %7s %7s | %6s %6s %6s %7s | %7s %7s %7s\n", "mechanism / way through the step",
                  "mean", "mean", "p50", "p99", "p99.9", "max", "p50", "p99", "max");
      headed_ = true;
    }
    std::printf("%-38s %7.0f %7.0f | %6.0f %6.0f %6.0f %7.0f | %7.0f %7.0f %7.0f\n",
                name.substr(0, slash).c_str(), rows_["hot"].time, rows_["chain"].time, hot.at("p50_ns"),
                hot.at("p99_ns"), hot.at("p99.9_ns"), hot.at("max_ns"), cold.at("p50_ns"), cold.at("p99_ns"),
                cold.at("max_ns"));
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
  latency_table table;
  const auto all = benchmarks::run(argc, argv, {"--benchmark_min_time=0.2"},
                                   [&](const auto& name, const auto& row) { table.add(name, row); });
  const std::string arm = "tendon_two_link<double>/";
  if (all.contains(arm + "approximate/cold") && all.contains(arm + "free/hot")) {
    const double contact = all.at(arm + "approximate/hot").time;
    std::printf("\nsummary: tendon two_link: %.0f ns approximate, free %.2fx, chained %.2fx, cold %.0fx\n",
                contact, all.at(arm + "free/hot").time / contact,
                all.at(arm + "approximate/chain").time / contact,
                all.at(arm + "approximate/cold").counters.at("p50_ns") / contact);
  }
}
