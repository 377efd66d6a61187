// slow
// Torque limits in a whole step, against the same step with brakes that have none; and what is left of a
// law's torques.
#include "../support.hpp"

#include <passive_haptics/control/pipelines/torque_law.hpp>

#include <passive_haptics/mechanism/models/delta.hpp>
#include <passive_haptics/mechanism/models/tendon_two_link.hpp>
#include <passive_haptics/mechanism/models/xy_table.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

template <class M>
struct torque_limits : ::testing::Test {};
using limited_mechanisms = ::testing::Types<ph::xy_table<double>, ph::tendon_two_link<float>,
                                            ph::tendon_two_link<double>, ph::delta<double>>;
TYPED_TEST_SUITE(torque_limits, limited_mechanisms);

// The law holds of every brake: keep_direction scales all by the smallest factor that one of them needs.
TYPED_TEST(torque_limits, scale_all_brakes_by_the_smallest_factor_or_cut_each) {
  using M = TypeParam;
  using T = typename M::scalar;
  constexpr int m = M::brake_count, D = M::task_dimension;
  const M mechanism;
  constexpr unsigned seed = 20040627;
  ph::testing::random_source random(seed);
  int cut[std::size_t(m + 1)] = {};
  for (int k = 0; k < 3000; ++k) {
    const ph::joint_vector<M> q =
        ph::joint_vector<M>::NullaryExpr([&] { return random.uniform(T(0.3), T(0.9)); });
    const auto state =
        state_of<M>(q, ph::joint_vector<M>::NullaryExpr([&] { return random.wide(T(0.1), T(3)); }));
    ph::contacts<D, 1> touched;
    touched.push_back(asking_for<D>(random.positive(0.1, 100.0) * random.direction<double, D>()));
    const auto step = [&](const auto& brakes, ph::saturation policy) {
      ph::step_memory<ph::no_direct_control> memory;
      ph::step_options<T> options;
      options.limits = policy;
      return ph::step(mechanism, brakes, touched, ph::no_direct_control{}, state, memory, options);
    };
    const ph::brake_vector<M> free = step(ph::unlimited_brakes(), ph::saturation::clamp_each).capacity;
    ph::brakes_of<M> brakes;
    for (int i = 0; i < m; ++i) {
      brakes.torque_limit[i] = random.positive(T(0.1), T(3)) * (free[i] > T(0) ? free[i] : T(1));
      brakes.rate_dead_band[i] = T(0);
    }
    T factor = T(1);
    int over = 0;
    for (int i = 0; i < m; ++i) {
      if (free[i] > brakes.torque_limit[i]) ++over;
      if (free[i] > T(0)) factor = std::min(factor, brakes.torque_limit[i] / free[i]);
    }
    ++cut[over];
    const auto kept = step(brakes, ph::saturation::keep_direction),
               clamped = step(brakes, ph::saturation::clamp_each);
    const T size = free.norm();
    expect_near(kept.capacity, ph::brake_vector<M>(factor * free), static_cast<double>(size));
    expect_near(clamped.capacity, ph::brake_vector<M>(free.cwiseMin(brakes.torque_limit)),
                static_cast<double>(size));
    for (const auto& result : {kept, clamped}) {
      ASSERT_TRUE((result.capacity.array() <= brakes.torque_limit.array()).all())
          << "seed " << seed << ", trial " << k;
      ASSERT_EQ(result.saturated, over > 0) << "seed " << seed << ", trial " << k;
    }
  }
  for (int over = 0; over <= m; ++over) EXPECT_GT(cut[over], 50) << over << " brakes over their limits";
}

// A law that commands the torques it was made with.
struct fixed_torques {
  static constexpr bool commands_torques = true;
  struct memory {};
  double wanted[2] = {};
  template <class Situation, class Contacts>
  auto torque(const Situation& now, const Contacts&, memory&) const noexcept {
    auto t = now.w;
    using T = typename decltype(t)::Scalar;
    t[0] = static_cast<T>(wanted[0]);
    t[1] = static_cast<T>(wanted[1]);
    return t;
  }
};

template <class T>
struct a_torque_law : ::testing::Test {};
TYPED_TEST_SUITE(a_torque_law, scalars);

TYPED_TEST(a_torque_law, never_drives_a_brake_and_stays_within_its_limits) {
  using T = TypeParam;
  using M = ph::xy_table<T>;
  constexpr unsigned seed = 20040627;
  ph::testing::random_source random(seed);
  ph::brakes_of<M> brakes;
  brakes.torque_limit = {T(2), T(0.5)};
  ph::contacts<2, 1> touched;
  touched.push_back({.normal = {0.6, 0.8}, .depth = 1e-3, .stiffness = 1e3});
  int driving = 0, saturated = 0;
  for (int k = 0; k < 500; ++k) {
    const fixed_torques law{{random.wide(0.1, 4.0), random.wide(0.1, 4.0)}};
    const auto state = state_of<M>({0, 0}, {random.wide(T(0.1), T(1)), random.wide(T(0.1), T(1))});
    ph::step_memory<fixed_torques> memory;
    const auto result = ph::step(M(), brakes, touched, law, state, memory);
    ASSERT_EQ(result.outcome, ph::status::ok);
    bool over = false;
    for (int i = 0; i < 2; ++i) {
      const T wanted = static_cast<T>(law.wanted[i]), limit = brakes.torque_limit[i];
      const bool drives = wanted * state.qd[i] > T(0);
      EXPECT_EQ(result.capacity[i], drives ? T(0) : std::min(std::abs(wanted), limit)) << "seed " << seed;
      EXPECT_EQ(result.torque[i], drives ? T(0) : std::clamp(wanted, -limit, limit)) << "seed " << seed;
      over = over || (!drives && std::abs(wanted) > limit);  // a brake that is released is at no limit
      driving += drives;
    }
    EXPECT_EQ(result.saturated, over);
    saturated += over;
  }
  EXPECT_GT(driving, 100);
  EXPECT_GT(saturated, 100);
}

TYPED_TEST(a_torque_law, that_commands_no_number_releases_the_brakes) {
  using M = ph::xy_table<TypeParam>;
  ph::contacts<2, 1> touched;
  touched.push_back({.normal = {0.6, 0.8}, .depth = 1e-3, .stiffness = 1e3});
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL}) {
    for (const fixed_torques& law : {fixed_torques{{bad, 0.1}}, fixed_torques{{0.1, bad}}}) {
      ph::step_memory<fixed_torques> memory;
      const auto result =
          ph::step(M(), ph::brakes_of<M>(), touched, law, state_of<M>({0, 0}, {1, 1}), memory);
      EXPECT_EQ(result.outcome, ph::status::result_not_finite);
      EXPECT_TRUE(result.capacity.isZero(0) && result.torque.isZero(0));
    }
  }
}

}  // namespace
