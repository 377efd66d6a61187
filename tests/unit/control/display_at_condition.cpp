// slow
// What is called exact, at any condition of the Jacobian: all that is met to the rounding of its terms, and
// nothing else.
#include "../support.hpp"

#include <passive_haptics/control/controller.hpp>
#include <passive_haptics/control/pipelines/several_walls.hpp>
#include <passive_haptics/control/pipelines/torque_law.hpp>
#include <passive_haptics/mechanism/models/two_link.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using device = ph::two_link<double>;
using wide = Eigen::Matrix<long double, 2, 1>;
constexpr unsigned condition_seed = 3;
constexpr double bends[] = {1, 0.3, 0.1, 0.03, 0.01, 1e-3, 1e-4, 1e-6};  // [rad], condition 5 to 5e6

// An arm whose elbow is nearly straight; its brakes slip.
ph::device_state<device> bent_state(double bend, ph::testing::random_source& random) {
  const auto rate = [&] { return random.coin() ? 1.0 : -1.0; };
  return state_of<device>({random.uniform(-3.0, 3.0), bend}, {rate(), rate()});
}

// F with J^T F = t, and the size of the terms that add up to it [N].
struct balanced_force {
  wide F;
  double terms;
};
balanced_force force_of(const device& arm, const ph::vector<double, 2>& q, const wide& t) {
  const Eigen::Matrix<long double, 2, 2> J = arm.jacobian(q).cast<long double>();
  const long double det = J(0, 0) * J(1, 1) - J(0, 1) * J(1, 0);
  Eigen::Matrix<long double, 2, 2> G;  // J^-T
  G << J(1, 1), -J(1, 0), -J(0, 1), J(0, 0);
  G /= det;
  return {G * t, static_cast<double>((G.cwiseAbs() * t.cwiseAbs()).norm())};
}

// Two walls that together demand F, not parallel.
ph::contacts<2, 2> walls_for(const wide& F, ph::testing::random_source& random) {
  const double first = random.uniform(0.0, 6.28), second = first + random.positive(2e-4, 2.8);
  ph::contacts<2, 2> walls;
  for (const double angle : {first, second}) {
    ph::contact<2> c{.normal = {std::cos(angle), std::sin(angle)}, .depth = 1};
    if (c.normal.cast<long double>().dot(F) < 0) c.normal = -c.normal;
    c.stiffness = static_cast<double>(c.normal.cast<long double>().dot(F));
    walls.push_back(c);
  }
  return walls;
}

ph::step_result_of_contacts<device, 2> step(const device& arm, const ph::contacts<2, 2>& walls,
                                            const ph::device_state<device>& state) {
  ph::step_memory<ph::no_direct_control> memory;
  return ph::step(arm, ph::unlimited_brakes(), walls, ph::no_direct_control(), state, memory);
}

TEST(several_walls, what_the_brakes_meet_is_exact_at_any_condition) {
  const device arm;
  ph::testing::random_source random(condition_seed);
  for (const double bend : bends) {
    for (int k = 0; k < 500; ++k) {
      const auto state = bent_state(bend, random);
      const wide t(-state.qd[0] * random.positive(0.1, 3.0), -state.qd[1] * random.positive(0.1, 3.0));
      const auto result = step(arm, walls_for(force_of(arm, state.q, t).F, random), state);
      ASSERT_EQ(result.outcome, ph::status::ok);
      ASSERT_EQ(result.display, ph::display_class::exact)
          << "seed " << condition_seed << ", bend " << bend << ", " << k;
      ASSERT_NE(result.power, ph::power_class::passive_2);
    }
  }
}

TEST(several_walls, what_the_brakes_do_not_meet_is_not_exact) {
  const device arm;
  ph::testing::random_source random(condition_seed);
  int seen = 0;
  for (const double bend : bends) {
    for (int k = 0; k < 500; ++k) {
      const auto state = bent_state(bend, random);
      // One brake would have to drive, by a share of 1e-12 to 1 of the other's torque
      const double driven = random.positive(1e-12, 1.0);
      wide t(-state.qd[0] * random.positive(0.1, 3.0), state.qd[1] * driven);
      if (random.coin()) t = wide(state.qd[0] * driven, t[0] * state.qd[0] * state.qd[1]);
      const auto demanded = force_of(arm, state.q, t);
      const auto walls = walls_for(demanded.F, random);
      const auto result = step(arm, walls, state);
      ASSERT_EQ(result.outcome, ph::status::ok);
      double missing = 0;
      for (const auto& report : result.contacts)
        missing = std::max(missing, std::abs(report.wanted - report.displayed));
      if (missing <= 1e-13 * demanded.terms) continue;
      ++seen;
      ASSERT_NE(result.display, ph::display_class::exact)
          << "seed " << condition_seed << ", bend " << bend << ", " << k << ": missing " << missing;
    }
  }
  EXPECT_GT(seen, 2000);
}

// A law that commands the torques which balance Fd.
struct balancing_torques {
  static constexpr bool commands_torques = true;
  template <class M, class E, int D, int Capacity, class B>
  ph::brake_vector<M> torque(const ph::brake_situation<M, E, B>& now,
                             const ph::contacts<D, Capacity>& touched) const noexcept {
    const auto Fd = ph::desired_force_of<typename M::scalar>(touched[0]);
    return ph::brake_torque(now.E, ph::vector<double, 2>(Fd.magnitude * Fd.direction));
  }
};

TEST(torque_law, what_its_torques_make_is_exact_at_any_condition) {
  const device arm;
  ph::testing::random_source random(condition_seed);
  for (const double bend : bends) {
    for (int k = 0; k < 300; ++k) {
      const auto state = bent_state(bend, random);
      const wide t(-state.qd[0] * random.positive(0.1, 3.0), -state.qd[1] * random.positive(0.1, 3.0));
      const ph::vector<double, 2> F = force_of(arm, state.q, t).F.cast<double>();
      ph::contacts<2, 1> wall;
      wall.push_back({.normal = F.normalized(), .depth = 1, .stiffness = F.norm()});
      ph::step_memory<balancing_torques> memory;
      const auto result = ph::step(arm, ph::unlimited_brakes(), wall, balancing_torques(), state, memory);
      ASSERT_EQ(result.outcome, ph::status::ok);
      ASSERT_EQ(result.display, ph::display_class::exact)
          << "seed " << condition_seed << ", bend " << bend << ", " << k;
    }
  }
}

}  // namespace
