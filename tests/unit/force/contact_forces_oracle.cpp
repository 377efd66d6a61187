// slow, optimised, no sanitizers
// Several contacts: the torques are the best in the stated order of priority, against every face of the
// torque box, in long double.
#include "priorities_oracle.hpp"

#include <passive_haptics/force/approximation.hpp>
#include <passive_haptics/force/torques/contact_forces.hpp>

#include <gtest/gtest.h>

#include <random>

namespace ph = passive_haptics;

namespace {

using Real = long double;
constexpr Real tie = 1e-15L;

template <int D, int Brakes>
struct random_case {
  static constexpr int capacity = 4;
  ph::matrix<double, D, Brakes> G;
  ph::force_map<double, D, Brakes> map;
  ph::torque_box<double, Brakes> box;
  std::array<ph::contact_demand<double, D>, capacity> demands;
  int count;
  double hand;  // |Fh|
};

// Poses, motions and hands of a device: contacts being left want what the hand presses, the others stiff
// walls.
template <int D, int Brakes>
random_case<D, Brakes> draw(std::mt19937_64& engine) {
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> uniform;
  random_case<D, Brakes> c;
  for (int i = 0; i < D * Brakes; ++i) c.G.data()[i] = 5 * gauss(engine);
  c.map.G = c.G;
  ph::vector<double, Brakes> s, limit;
  for (int i = 0; i < Brakes; ++i) {
    const double u = uniform(engine);
    s[i] = u < 0.1 ? 0 : (u < 0.55 ? 1 : -1);
    limit[i] = uniform(engine) < 0.05 ? 0 : 0.2 + uniform(engine);
  }
  c.box = ph::torques_within(s, limit);
  ph::vector<double, D> Fh;
  for (auto& x : Fh) x = 2 * gauss(engine);
  c.hand = Fh.norm();
  c.count = 1 + static_cast<int>(4 * uniform(engine));
  for (int j = 0; j < c.count; ++j) {
    ph::vector<double, D> n;
    for (auto& x : n) x = gauss(engine);
    if (j > 0 && uniform(engine) < 0.1) n = -c.demands[0].normal;  // opposed walls
    if (j > 0 && uniform(engine) < 0.1) n = c.demands[0].normal;   // coincident walls
    n.normalize();
    const bool left = uniform(engine) < 0.5;
    const double stiff = std::pow(10.0, 5 * uniform(engine));
    c.demands[static_cast<std::size_t>(j)] = {n, left ? std::min(stiff, std::max(0.0, -n.dot(Fh))) : stiff,
                                              left};
  }
  return c;
}

template <int D, int Brakes>
std::vector<oracle::level<Real>> levels_of(const random_case<D, Brakes>& c) {
  std::vector<oracle::level<Real>> levels;
  for (const bool first : {true, false}) {
    oracle::level<Real> l;
    for (int j = 0; j < c.count; ++j) {
      const auto& demand = c.demands[static_cast<std::size_t>(j)];
      if (demand.has_priority != first) continue;
      const ph::vector<double, D>& n = demand.normal;
      oracle::list<Real> row;
      for (int i = 0; i < Brakes; ++i) {
        Real sum = 0;
        for (int k = 0; k < D; ++k) sum += Real(n[k]) * Real(c.G(k, i));
        row.push_back(sum);
      }
      l.rows.push_back(row);
      l.targets.push_back(demand.force);
    }
    if (!l.rows.empty()) levels.push_back(l);
  }
  oracle::level<Real> drag, effort;
  for (int k = 0; k < D; ++k) {
    oracle::list<Real> row;
    for (int i = 0; i < Brakes; ++i) row.push_back(c.G(k, i));
    drag.rows.push_back(row);
    drag.targets.push_back(0);
  }
  for (int i = 0; i < Brakes; ++i) {
    effort.rows.emplace_back(Brakes, Real(0));
    effort.rows.back()[static_cast<std::size_t>(i)] = 1;
    effort.targets.push_back(0);
  }
  levels.push_back(drag);
  levels.push_back(effort);
  return levels;
}

struct tally {
  int met = 0, reported = 0;
};

template <int D, int Brakes>
void compare(int cases, unsigned seed, tally& sum) {
  SCOPED_TRACE(::testing::Message() << "d = " << D << ", m = " << Brakes << ", seed " << seed);
  std::mt19937_64 engine(seed);
  for (int k = 0; k < cases; ++k) {
    const auto c = draw<D, Brakes>(engine);
    const auto answer = ph::contact_forces<double, D, Brakes, 4>(c.map, c.box, c.demands, c.count);
    ASSERT_TRUE((answer.torque.array() >= c.box.lower.array()).all()) << "case " << k;
    ASSERT_TRUE((answer.torque.array() <= c.box.upper.array()).all()) << "case " << k;

    const auto levels = levels_of(c);
    oracle::list<Real> lower, upper, torque;
    for (int i = 0; i < Brakes; ++i) {
      lower.push_back(c.box.lower[i]);
      upper.push_back(c.box.upper[i]);
      torque.push_back(answer.torque[i]);
    }
    const auto best = oracle::solve_by_faces<Real>(levels, lower, upper, tie);
    const auto best_costs = oracle::costs(levels, best), costs = oracle::costs(levels, torque);
    for (std::size_t l = 0; l < levels.size(); ++l) {
      const Real about = 1 + best_costs[l] + oracle::length(levels[l].targets);
      const double excess = static_cast<double>((costs[l] - best_costs[l]) / about);
      ASSERT_LE(excess, 1e-9) << "case " << k << ", level " << l;
      if (excess < -1e-9) break;  // a better level pays for worse ones after it; the oracle's ties are looser
    }
    for (int j = 0; j < c.count; ++j) {
      const auto& demand = c.demands[static_cast<std::size_t>(j)];
      if (!demand.has_priority) continue;
      Real reached = 0;
      for (int i = 0; i < Brakes; ++i) {
        for (int r = 0; r < D; ++r)
          reached += Real(demand.normal[r]) * Real(c.G(r, i)) * best[static_cast<std::size_t>(i)];
      }
      const bool allowed = static_cast<double>(abs(reached - Real(demand.force))) <= 1e-15 * c.hand;
      const double left = std::abs(answer.displayed[static_cast<std::size_t>(j)] - demand.force) / c.hand;
      if (allowed) {
        ++sum.met;
        ASSERT_LE(left, 1e-12) << "case " << k << ", contact " << j;
      } else {
        ++sum.reported;
        ASSERT_GT(left, 0) << "case " << k << ", contact " << j;
      }
    }
  }
}

void record(const tally& sum) {
  EXPECT_GT(sum.met, 100);
  EXPECT_GT(sum.reported, 100);
}

}  // namespace

TEST(contact_forces, are_the_best_in_the_order_of_priority) {
  tally sum;
  compare<2, 4>(3000, 13, sum);
  compare<3, 3>(5000, 21, sum);
  record(sum);
}

// Vertices with more bounds than variables, walls that oppose each other, brakes that hardly act on them:
// what releases a bound must tell a multiplier from rounding and may not give up.
TEST(contact_forces, are_the_best_where_several_bounds_meet) {
  tally sum;
  compare<2, 4>(900, 1001, sum);
  compare<2, 4>(2500, 1009, sum);
  record(sum);
}

// One contact being left, within the limits: F = alpha Fc (12), in half-space form as in generator form.
TEST(contact_forces, of_one_contact_are_those_of_direct_control) {
  std::mt19937_64 engine(41);
  std::normal_distribution<double> gauss;
  int displayed = 0;
  for (int k = 0; k < 4000; ++k) {
    SCOPED_TRACE(::testing::Message() << "case " << k << ", seed 41");
    ph::matrix<double, 3, 3> E;
    for (auto& x : E.reshaped()) x = 0.2 * gauss(engine);
    ph::vector<double, 3> s, n;
    for (int i = 0; i < 3; ++i) s[i] = gauss(engine) > 0 ? 1 : -1;
    for (auto& x : n) x = gauss(engine);
    n.normalize();
    const auto Fc = ph::approximate(E, s, n, 0.0174);
    if (!ph::is_displayed(Fc.display)) continue;
    ++displayed;
    const double wanted = 2;
    const auto unlimited = ph::vector<double, 3>::Constant(HUGE_VAL);
    const auto answer = ph::contact_forces<double, 3, 3, 1>(
        ph::invert_brake_jacobian(E), ph::torques_within<double, 3>(s, unlimited), {{{n, wanted, true}}}, 1);
    const double condition = E.norm() * ph::pseudo_inverse(E).norm();
    const double size = wanted * Fc.force.norm() / Fc.cosine();
    ASSERT_LE((answer.force - wanted * Fc.force).norm(), 1e-14 * condition * size);
    ASSERT_NEAR(answer.displayed[0], wanted, 1e-13 * condition);
  }
  EXPECT_GT(displayed, 1000);
}
