// How long one control cycle takes, state in, capacities out: each shipped mechanism, each way through the
// step, hot and cold. Times are for comparing rows of one run; a machine under load slows all of them.
#include <passive_haptics/testing/latency_of.hpp>

#include <passive_haptics/passive_haptics.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <results.hpp>

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

// A device 10 m before a plane wall, or 10 m behind it, where the wall demands 10 N.
template <class M>
auto controller_of(const M& mechanism, contact_kind kind) {
  const ph::point<M::task_dimension> out = ph::point<M::task_dimension>::Ones().normalized();
  const ph::half_space<M::task_dimension> plane((kind == contact_kind::free ? -10 : 10) * out, out);
  return ph::controller(mechanism, ph::brakes_of<M>(), ph::scene(ph::wall(plane, 1)), ph::direct_control());
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
  latency_table table;
  const auto all = benchmarks::run(argc, argv, {"--benchmark_min_time=0.2"},
                                   [&](const auto& name, const auto& row) { table.add(name, row); });
  const std::string arm = "tendon_two_link<double>/";
  if (all.contains(arm + "any contact/cold") && all.contains(arm + "free/hot")) {
    const double contact = all.at(arm + "any contact/hot").cpu_time;
    std::printf("\nsummary: tendon two_link: %.0f ns in contact, free %.2fx, chained %.2fx, cold %.0fx\n",
                contact, all.at(arm + "free/hot").cpu_time / contact,
                all.at(arm + "any contact/chain").cpu_time / contact,
                all.at(arm + "any contact/cold").counters.at("p50_ns") / contact);
  }
}
