// How long one control cycle takes: state in, capacities out, for each shipped mechanism and each way through the step.
// Times are for comparing rows of one run; a machine under load slows all of them.
#include <passive_haptics/passive_haptics.hpp>

#include <benchmark/benchmark.h>

#include <array>
#include <cstdlib>
#include <string>

namespace ph = passive_haptics;

namespace {

template <class M>
using states = std::array<ph::device_state<M>, 64>;

// States about `x` that differ a little, so that nothing is folded into a constant.
template <class M, class Inverse>
states<M> moving_about(const M& mechanism, Inverse&& inverse, const ph::task_vector<M>& x,
                       const ph::task_vector<M>& v) {
  using T = typename M::scalar;
  states<M> all;
  for (std::size_t k = 0; k < all.size(); ++k) {
    auto& state = all[k];
    state.q = inverse(mechanism, x + ph::task_vector<M>(T(1e-6) * static_cast<T>(k), T(0)));
    const ph::matrix<T, M::task_dimension, M::dof> J(ph::jacobian(mechanism, state.q));
    state.qd = J.partialPivLu().solve(v);
    state.hand_force = ph::task_vector<M>(T(0.5), T(2));
  }
  return all;
}

enum class contact_kind { free, exact, approximate };

// A direction inside the cone of what the brakes can display, or a little outside of it.
template <class M>
ph::point<2> normal_for(contact_kind kind, const M& mechanism, const ph::device_state<M>& state) {
  const ph::brake_vector<M> w = ph::brake_rates(mechanism, state.q, state.qd);
  const auto R = ph::reference_forces(mechanism, state.q).G.template cast<double>().eval();
  const ph::point<2> g1 = -ph::sgn(double(w[0])) * R.col(0).normalized();
  const ph::point<2> g2 = -ph::sgn(double(w[1])) * R.col(1).normalized();
  return (kind == contact_kind::approximate ? ph::point<2>(g2 - 0.3 * g1) : ph::point<2>(g1 + g2))
      .normalized();
}

template <class M, class Inverse>
void control_cycle(benchmark::State& run, const M& mechanism, Inverse inverse, contact_kind kind) {
  using T = typename M::scalar;
  const ph::task_vector<M> x(T(0.12), T(0.225));
  const auto all = moving_about(mechanism, inverse, x, ph::task_vector<M>(T(0.05), T(-0.03)));
  const ph::point<2> n = normal_for(kind, mechanism, all[0]);
  const double depth = kind == contact_kind::free ? -0.01 : 1e-3;
  const ph::half_space<2> plane(x.template cast<double>() + depth * n, n);
  ph::controller control(mechanism, ph::brakes_of<M>(), ph::scene(ph::wall(plane)), ph::direct_control());

  const auto expected =
      kind == contact_kind::approximate ? ph::display_class::approximate : ph::display_class::exact;
  const auto probe = control(all[0]);
  if (probe.outcome != ph::status::ok || probe.display != expected ||
      (probe.wall < 0) != (kind == contact_kind::free)) {
    run.SkipWithError("the state is not of the kind that this row names");
    return;
  }
  std::size_t k = 0;
  for (auto _ : run) {
    auto result = control(all[k++ % all.size()]);
    benchmark::DoNotOptimize(result);
  }
}

template <class M, class Inverse>
void add_rows(const std::string& name, Inverse inverse) {
  using enum contact_kind;
  for (const auto& [kind, label] :
       {std::pair{free, "free"}, {exact, "exact"}, {approximate, "approximate"}}) {
    const std::string row = std::string(name).append("/").append(label);
    benchmark::RegisterBenchmark(row.c_str(), [inverse, kind = kind](benchmark::State& run) {
      control_cycle(run, M(), inverse, kind);
    });
  }
}

}  // namespace

int main(int argc, char** argv) {
  const auto elbow_left = [](const auto& arm, const auto& x) { return arm.inverse(x, ph::elbow::left).q; };
  const auto direct = [](const auto& table, const auto& x) { return table.inverse(x).q; };
  add_rows<ph::two_link<double>>("two_link<double>", elbow_left);
  add_rows<ph::tendon_two_link<double>>("tendon_two_link<double>", elbow_left);
  add_rows<ph::tendon_two_link<float>>("tendon_two_link<float>", elbow_left);
  add_rows<ph::xy_table<double>>("xy_table<double>", direct);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
