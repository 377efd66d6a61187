// slow, optimised
// More brakes than joints: the torques are feasible, nearest, of least norm, and continuous.
#include "../unit/force/priorities_oracle.hpp"

#include <passive_haptics/passive_haptics.hpp>

#include <gtest/gtest.h>

#include <random>

namespace ph = passive_haptics;

namespace {

using device = ph::five_bar<double, 4>;
constexpr int steps = 1000000, sampled_every = 100;

struct sample {
  ph::device_state<device> state;
  ph::contacts<2, 1> touched;
};

// Poses in which the loop closes, motions with some brakes at rest, hands, and walls of any direction.
sample draw(const device& mechanism, std::mt19937_64& engine) {
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> uniform;
  sample s;
  s.state.time = 0;
  do {
    s.state.q = {1.2 + 1.6 * uniform(engine), 0.3 + 1.6 * uniform(engine)};
  } while (!ph::all_finite(mechanism.position(s.state.q)) || mechanism.conditioning(s.state.q).type_2 < 1e-6);
  s.state.qd = {gauss(engine), gauss(engine)};
  if (uniform(engine) < 0.1) s.state.qd[0] = 0;
  if (uniform(engine) < 0.1) s.state.qd[1] = s.state.qd[0];
  s.state.hand_force = {2 * gauss(engine), 2 * gauss(engine)};
  if (uniform(engine) < 0.1) s.state.hand_force.setZero();
  const double a = 2 * std::numbers::pi * uniform(engine);
  s.touched.push_back({.normal = {std::cos(a), std::sin(a)},
                       .depth = std::pow(10.0, -8 * uniform(engine)),
                       .stiffness = std::pow(10.0, 8 * uniform(engine))});
  return s;
}

// Cost of t against the best of all faces: distance to n, then norm.
oracle::list<long double> best_torque(const ph::matrix<double, 2, 4>& G, const ph::vector<double, 4>& s,
                                      const ph::vector<double, 2>& n,
                                      std::vector<oracle::level<long double>>& levels) {
  levels.assign(2, {});
  for (int k = 0; k < 2; ++k) {
    levels[0].rows.push_back({G(k, 0), G(k, 1), G(k, 2), G(k, 3)});
    levels[0].targets.push_back(n[k]);
  }
  oracle::list<long double> lower, upper;
  for (std::size_t i = 0; i < 4; ++i) {
    levels[1].rows.emplace_back(4, 0.0L);
    levels[1].rows.back()[i] = 1;
    levels[1].targets.push_back(0);
    lower.push_back(s[static_cast<int>(i)] < 0 ? 0.0L : -HUGE_VALL);
    upper.push_back(s[static_cast<int>(i)] > 0 ? 0.0L : HUGE_VALL);
  }
  return oracle::solve_by_faces<long double>(levels, lower, upper, 1e-16L);
}

}  // namespace

TEST(redundant_brakes, never_drive_and_come_nearest_with_least_torque) {
  const unsigned seed = 7;
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  std::mt19937_64 engine(seed);
  const device mechanism;
  const ph::brakes_of<device> brakes;
  ph::step_memory<ph::direct_control> memory;
  int exact = 0, approximate = 0, none = 0;
  double worst_distance = 0, worst_norm = 0;
  for (int k = 0; k < steps; ++k) {
    const auto [state, touched] = draw(mechanism, engine);
    const auto result = ph::step(mechanism, brakes, touched, ph::direct_control(), state, memory);
    ASSERT_EQ(result.outcome, ph::status::ok) << "step " << k;
    const ph::brake_vector<device> w = ph::brake_rates(mechanism, state.q, state.qd);
    for (int i = 0; i < 4; ++i) {
      ASSERT_LE(result.signs[i] * result.torque[i], 0.0) << "step " << k;
      ASSERT_TRUE(result.capacity[i] >= 0 && result.capacity[i] <= brakes.torque_limit[i]) << "step " << k;
      if (std::abs(w[i]) > brakes.rate_dead_band[i]) {
        ASSERT_LE(w[i] * result.torque[i], 0.0) << "step " << k;
      }
    }
    exact += result.display == ph::display_class::exact;
    approximate += result.display == ph::display_class::approximate;
    none += result.display == ph::display_class::none;

    if (k % sampled_every != 0) continue;
    const auto G = ph::force_generators(mechanism, state.q);
    const ph::vector<double, 2> n = touched[0].normal;
    const auto unlimited = ph::vector<double, 4>::Constant(HUGE_VAL);
    const auto nearest =
        ph::nearest_torque<double, 2, 4>(G, ph::torques_within<double, 4>(result.signs, unlimited), n);
    std::vector<oracle::level<long double>> levels;
    const auto best = oracle::costs(levels, best_torque(G, result.signs, n, levels));
    const auto ours =
        oracle::costs(levels, {nearest.torque[0], nearest.torque[1], nearest.torque[2], nearest.torque[3]});
    worst_distance = std::max(worst_distance, static_cast<double>(ours[0] - best[0]));
    worst_norm = std::max(worst_norm, static_cast<double>((ours[1] - best[1]) / (best[1] + 1e-6L)));
  }
  std::printf("exact %d, approximate %d, none %d; against the oracle: distance +%.1e, norm +%.1e\n", exact,
              approximate, none, worst_distance, worst_norm);
  EXPECT_LE(worst_distance, 1e-13);
  EXPECT_LE(worst_norm, 1e-9);
  EXPECT_GT(exact, steps / 20);
  EXPECT_GT(approximate, steps / 20);
  EXPECT_GT(none, steps / 100);
}

TEST(redundant_brakes, get_neighbouring_torques_for_neighbouring_forces) {
  std::mt19937_64 engine(8);
  const device mechanism;
  const auto unlimited = ph::vector<double, 4>::Constant(HUGE_VAL);
  for (int path = 0; path < 50; ++path) {
    SCOPED_TRACE(::testing::Message() << "path " << path << ", seed 8");
    const auto start = draw(mechanism, engine).state;
    const auto s = ph::brake_signs<double, 4>(ph::brake_rates(mechanism, start.q, start.qd),
                                              ph::vector<double, 4>::Zero(), {});
    // The desired force turns while the pose drifts: the largest change of torque falls with the step.
    double before = 0;
    for (const int pieces : {1000, 10000}) {
      double largest = 0;
      ph::vector<double, 4> last;
      for (int k = 0; k <= pieces; ++k) {
        const double u = static_cast<double>(k) / pieces, a = 2 * std::numbers::pi * u;
        const ph::joint_vector<device> q = start.q + 1e-3 * u * ph::joint_vector<device>(1, -1);
        const ph::matrix<double, 2, 4> G = ph::force_generators(mechanism, q);
        const auto t = ph::nearest_torque<double, 2, 4>(G, ph::torques_within<double, 4>(s, unlimited),
                                                        {std::cos(a), std::sin(a)})
                           .torque;
        if (k > 0) largest = std::max(largest, (t - last).norm());
        last = t;
      }
      if (pieces > 1000) {
        EXPECT_LE(largest, 0.2 * before) << "the torques jump";
      }
      before = largest;
    }
  }
}

TEST(redundant_brakes, come_nearer_than_any_of_their_subsets) {
  std::mt19937_64 engine(9);
  const device mechanism;
  for (int k = 0; k < 2000; ++k) {
    SCOPED_TRACE(::testing::Message() << "case " << k << ", seed 9");
    const auto [state, touched] = draw(mechanism, engine);
    const auto G = ph::force_generators(mechanism, state.q);
    const auto s = ph::brake_signs<double, 4>(ph::brake_rates(mechanism, state.q, state.qd),
                                              ph::vector<double, 4>::Zero(), {});
    const ph::vector<double, 2> n = touched[0].normal;
    const auto distance = [&](unsigned subset) {
      ph::vector<double, 4> limit;
      for (int i = 0; i < 4; ++i) limit[i] = (subset >> i) & 1u ? HUGE_VAL : 0;
      return (ph::nearest_torque<double, 2, 4>(G, ph::torques_within<double, 4>(s, limit), n).force - n)
          .norm();
    };
    const double all = distance(15);
    for (unsigned subset = 0; subset < 15; ++subset) ASSERT_LE(all, distance(subset) + 1e-13);
  }
}
