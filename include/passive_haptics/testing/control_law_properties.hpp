/// The laws of control laws as a GoogleTest suite for any law on any mechanism.
///
/// A case is a law_case<MechanismCase, Law>; fault_properties.hpp accepts the same case.
#pragma once

#include <passive_haptics/control/control_law.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/testing/support/print.hpp>
#include <passive_haptics/testing/support/step_samples.hpp>

#include <gtest/gtest.h>

namespace passive_haptics::testing {

/// A law on a mechanism.
template <class MechanismCase, class Law>
struct law_case : MechanismCase {
  using law = Law;  ///< The law.
};

/// Suite of a law's properties.
template <class Case>
class control_law_properties : public ::testing::Test {
 protected:
  static_assert(ControlLaw<typename Case::law>);
  using model = typename Case::mechanism;          ///< The mechanism.
  using number = typename model::scalar;           ///< Its scalar.
  using memory = step_memory<typename Case::law>;  ///< Memory of a step.
  static constexpr unsigned seed = 20040627;       ///< Seed of the samples.
  static constexpr int m = model::brake_count;     ///< Brakes.
  static constexpr int each = m <= 2 ? 100 : 20;   ///< Samples per sign pattern.

  const model mechanism = Case::make();  ///< The mechanism under test.

  /// One step against `wall`.
  step_result<model> run(const step_sample<model>& sample, const contact<model::task_dimension>& wall,
                         memory& remembered) const {
    contacts<model::task_dimension, 1> touched;
    touched.push_back(wall);
    return step(mechanism, sample.brakes, touched, typename Case::law{}, sample.state, remembered,
                step_options<number>());
  }

  /// Slipping brakes take power, brakes at rest hold against the hand; all finite and within limits.
  static void expect_passive(const step_result<model>& result, const step_sample<model>& sample,
                             const brake_vector<model>& w) {
    ASSERT_TRUE(all_finite(result.capacity, result.torque));
    ASSERT_TRUE((result.capacity.array() >= 0).all()) << result.capacity.transpose();
    ASSERT_TRUE((result.capacity.array() <= sample.brakes.torque_limit.array()).all())
        << result.capacity.transpose();
    ASSERT_TRUE((result.torque.array().abs() <= result.capacity.array()).all()) << result.torque.transpose();
    for (int i = 0; i < m; ++i) {
      ASSERT_LE(result.signs[i] * result.torque[i], number(0)) << "brake " << i;
      ASSERT_TRUE(result.torque[i] * w[i] <= number(0) || !slips(w[i], sample.brakes.rate_dead_band[i])) << i;
    }
  }
};

TYPED_TEST_SUITE_P(control_law_properties);

/// Never positive power or torques above a limit, for any memory; some brakes work.
TYPED_TEST_P(control_law_properties, brakes_never_drive_and_stay_within_their_limits) {
  using M = typename TestFixture::model;
  typename TestFixture::memory kept;
  int working = 0;
  double time = 0;
  for_each_sample<TypeParam>(this->mechanism, this->seed, this->each, [&](step_sample<M> sample) {
    if (this->HasFatalFailure()) return;
    const auto w = brake_rates(this->mechanism, sample.state.q, sample.state.qd);
    sample.state.time = time += 1e-3;
    typename TestFixture::memory fresh;
    for (auto* used : {&kept, &fresh}) {
      const auto result = this->run(sample, sample.wall(), *used);
      ASSERT_EQ(result.outcome, status::ok) << to_string(result.outcome);
      this->expect_passive(result, sample, w);
      working += result.torque.isZero(0) ? 0 : 1;
    }
  });
  EXPECT_GT(working, 0) << "no sample made a brake work";
}

/// Equal memories and equal input give equal results.
TYPED_TEST_P(control_law_properties, is_pure_apart_from_its_memory) {
  using M = typename TestFixture::model;
  typename TestFixture::memory one, other;
  for_each_sample<TypeParam>(this->mechanism, this->seed, this->each, [&](const step_sample<M>& sample) {
    if (this->HasFatalFailure()) return;
    const auto a = this->run(sample, sample.wall(), one);
    const auto b = this->run(sample, sample.wall(), other);
    ASSERT_EQ(a.capacity, b.capacity);
    ASSERT_EQ(a.torque, b.torque);
    ASSERT_EQ(a.outcome, b.outcome);
  });
}

REGISTER_TYPED_TEST_SUITE_P(control_law_properties, brakes_never_drive_and_stay_within_their_limits,
                            is_pure_apart_from_its_memory);

}  // namespace passive_haptics::testing
