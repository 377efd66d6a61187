// No case at the edges makes a step break a law; devices under test as in devices.hpp.
#pragma once

#include "broken_law.hpp"
#include "effort.hpp"
#include "hard_cases.hpp"

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/control/laws/velocity/velocity_direct_control.hpp>

#include <gtest/gtest.h>

#include <array>

namespace stress {

// Draws `count` cycles of a device and runs each with only the first wall and with all of them.
template <class M>
class gauntlet {
 public:
  gauntlet(std::uint64_t seed, std::uint64_t count) : seed_(seed), count_(count) {}

  // device(k) is the mechanism of cycle k.
  template <class Device>
  void run(Device&& device, const ph::joint_vector<M>& lower, const ph::joint_vector<M>& upper) {
    for (std::uint64_t k = seed_; k < seed_ + count_ && !::testing::Test::HasFatalFailure(); ++k) {
      SCOPED_TRACE(::testing::Message() << "PASSIVE_HAPTICS_STRESS_SEED=" << k);
      const M& mechanism = device(k);
      const auto c = hard_cases<M, walls>(mechanism, lower, upper, k).draw();
      check<ph::direct_control>(mechanism, c, 1);
      check<ph::direct_control>(mechanism, c, walls);
      if constexpr (ph::Dynamics<M>) check<ph::velocity_direct_control>(mechanism, c, walls);
    }
  }

  // Steps against a wall whose force was displayed so.
  std::uint64_t displayed(ph::display_class as) const { return seen_[static_cast<std::size_t>(as)]; }

 private:
  static constexpr int walls = 3;

  template <class L>
  void check(const M& mechanism, const cycle<M, walls>& c, int most) {
    ph::step_memory<L> memory;
    ph::contacts<M::task_dimension, walls> touched;
    for (const auto& wall : c.touched)
      if (touched.size() < most) touched.push_back(wall);
    const auto result = ph::step(mechanism, c.brakes, touched, L{}, c.state, memory, c.options);
    if (result.outcome == ph::status::ok && result.wall_number >= 0)
      ++seen_[static_cast<std::size_t>(result.display)];
    if (const char* law = broken_law_of<L>(mechanism, c.brakes, c.state, touched.size(), result)) {
      FAIL() << law << ", but\n"
             << c << "\nsigns " << result.signs.transpose() << ", torque " << result.torque.transpose()
             << ", capacity " << result.capacity.transpose() << ", control force "
             << result.control_force.transpose() << ", coefficients " << result.cone_coefficients.transpose()
             << ", alpha " << result.alpha << ", cosine " << result.approximation_cosine << ", "
             << to_string(result.display) << ", " << to_string(result.outcome);
    }
  }

  std::uint64_t seed_, count_;
  std::array<std::uint64_t, 3> seen_{};
};

template <class Case>
struct edges : ::testing::Test {};

TYPED_TEST_SUITE_P(edges);

TYPED_TEST_P(edges, break_no_law) {
  using M = typename TypeParam::mechanism;
  const std::uint64_t count = effort(10000, 1000000);
  gauntlet<M> cycles(first_seed(), count);
  const M mechanism = TypeParam::make();
  cycles.run([&](std::uint64_t) -> const M& { return mechanism; }, TypeParam::lower(), TypeParam::upper());
  for (const auto each : {ph::display_class::none, ph::display_class::approximate, ph::display_class::exact})
    EXPECT_GT(cycles.displayed(each), count / 100) << to_string(each);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(edges);
REGISTER_TYPED_TEST_SUITE_P(edges, break_no_law);

}  // namespace stress
