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

// What became of the cases.
struct tally {
  std::array<std::uint64_t, 10> outcomes{};
  std::array<std::uint64_t, 3> displays{};
  template <class Result>
  void add(const Result& r) {
    ++outcomes[static_cast<std::size_t>(r.outcome)];
    if (r.outcome == ph::status::ok && r.wall_number >= 0) ++displays[static_cast<std::size_t>(r.display)];
  }
  void print() const {
    const auto as = [](std::uint64_t n) { return static_cast<unsigned long long>(n); };
    std::printf("display: none %llu, approximate %llu, exact %llu; faults:", as(displays[0]), as(displays[1]),
                as(displays[2]));
    for (std::size_t s = 1; s < outcomes.size(); ++s) {
      if (outcomes[s] > 0) std::printf(" %llu %s;", as(outcomes[s]), to_string(ph::status(s)).data());
    }
    std::printf("\n");
  }
};

// Draws `count` cycles of a device and runs each with the first wall alone and with all of them.
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
      check<ph::no_direct_control, 1>(mechanism, c);
      check<ph::direct_control, walls>(mechanism, c);
      if constexpr (ph::Dynamics<M>) check<ph::velocity_direct_control, walls>(mechanism, c);
    }
  }

  const tally& seen() const { return seen_; }

 private:
  static constexpr int walls = 3;

  template <class L, int Capacity>
  void check(const M& mechanism, const cycle<M, walls>& c) {
    ph::step_memory<L> memory;
    ph::contacts<M::task_dimension, Capacity> touched;
    for (const auto& wall : c.touched) touched.push_back(wall);
    const auto result = ph::step(mechanism, c.brakes, touched, L{}, c.state, memory, c.options);
    seen_.add(result);
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
  tally seen_;
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
  cycles.seen().print();
  EXPECT_GT(cycles.seen().displays[0], count / 100);
  EXPECT_GT(cycles.seen().displays[1] + cycles.seen().displays[2], count / 100);
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(edges);
REGISTER_TYPED_TEST_SUITE_P(edges, break_no_law);

}  // namespace stress
