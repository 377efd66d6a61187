/// @file
/// What a control step makes of numbers that are not finite, or barely so, as a GoogleTest suite for any
/// mechanism.
///
/// The case is that of mechanism_properties.hpp.
#pragma once

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/testing/support/print.hpp>
#include <passive_haptics/testing/support/step_samples.hpp>

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>

namespace passive_haptics::testing {

/// Suite of a step's faults; Case as described in mechanism_properties.hpp.
template <class Case>
class fault_properties : public ::testing::Test {
 protected:
  using model = typename Case::mechanism;                       ///< The mechanism.
  using number = typename model::scalar;                        ///< Its scalar.
  static constexpr unsigned seed = 20040627;                    ///< Of the samples.
  static constexpr int each = model::brake_count <= 2 ? 8 : 1;  ///< Samples for each sign pattern.

  const model mechanism = Case::make();  ///< The mechanism under test.

  /// One step against `wall`.
  template <class L>
  step_result<model> run(const step_sample<model>& sample, const contact<model::task_dimension>& wall) const {
    contacts<model::task_dimension, 1> touched;
    touched.push_back(wall);
    step_memory<L> memory;
    return step(mechanism, sample.brakes, touched, L{}, sample.state, memory, step_options<number>());
  }

  /// visit(sample, wall) with every number in turn replaced by `bad`, and the name of that number in the
  /// trace.
  template <class Visit>
  static void for_each_spoiled(const step_sample<model>& sample, double bad, Visit&& visit) {
    step_sample<model> spoiled = sample;
    contact<model::task_dimension> wall = sample.wall();
    for_each_input(spoiled, wall, [&](const std::string& name, auto& value) {
      const auto good = value;
      value = static_cast<std::remove_reference_t<decltype(value)>>(bad);
      SCOPED_TRACE(::testing::Message() << "seed " << seed << ", " << name << " = " << bad);
      visit(spoiled, wall);
      value = good;
    });
  }
};

TYPED_TEST_SUITE_P(fault_properties);

/// NaN or infinity in any single number of any input gives a status, and exactly no capacity and no torque.
TYPED_TEST_P(fault_properties, a_number_that_is_not_finite_releases_the_brakes) {
  using M = typename TestFixture::model;
  int working = 0;
  for_each_sample<TypeParam>(this->mechanism, this->seed, this->each, [&](const step_sample<M>& sample) {
    working += this->template run<no_direct_control>(sample, sample.wall()).capacity.isZero(0) ? 0 : 1;
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()}) {
      this->for_each_spoiled(sample, bad, [&](const step_sample<M>& spoiled, const auto& wall) {
        for (const step_result<M>& result : {this->template run<no_direct_control>(spoiled, wall),
                                             this->template run<direct_control>(spoiled, wall)}) {
          EXPECT_NE(result.outcome, status::ok);
          EXPECT_TRUE(result.capacity.isZero(0) && result.torque.isZero(0));
        }
      });
    }
  });
  EXPECT_GT(working, 0) << "no sample made a brake work";
}

/// Brake lags are not read by laws that do not need them.
TYPED_TEST_P(fault_properties, what_a_law_does_not_need_is_not_read) {
  using M = typename TestFixture::model;
  for_each_sample<TypeParam>(this->mechanism, this->seed, this->each, [&](const step_sample<M>& sample) {
    step_sample<M> spoiled = sample;
    spoiled.brakes.time_constant.setConstant(std::numeric_limits<typename TestFixture::number>::quiet_NaN());
    const auto expected = this->template run<direct_control>(sample, sample.wall());
    const auto result = this->template run<direct_control>(spoiled, sample.wall());
    EXPECT_EQ(result.outcome, status::ok);
    EXPECT_EQ(result.capacity, expected.capacity);
    EXPECT_EQ(result.torque, expected.torque);
  });
}

/// Zero, denormal, and barely finite numbers in any single input give finite torques within the limits, of
/// passive sign; where a step gives up, a status and none.
TYPED_TEST_P(fault_properties, finite_input_gives_finite_output) {
  using T = typename TestFixture::number;
  using M = typename TestFixture::model;
  constexpr double most = static_cast<double>(std::numeric_limits<T>::max());
  constexpr double least = static_cast<double>(std::numeric_limits<T>::denorm_min());
  for_each_sample<TypeParam>(this->mechanism, this->seed, this->each, [&](const step_sample<M>& sample) {
    for (const double extreme : {0.0, least, most, -least, -most}) {
      this->for_each_spoiled(sample, extreme, [&](const step_sample<M>& spoiled, const auto& wall) {
        if ((spoiled.brakes.torque_limit.array() < T(0)).any()) return;  // not valid
        for (const step_result<M>& result : {this->template run<no_direct_control>(spoiled, wall),
                                             this->template run<direct_control>(spoiled, wall)}) {
          EXPECT_TRUE((result.capacity.array() >= T(0)).all() &&
                      (result.capacity.array() <= spoiled.brakes.torque_limit.array()).all())
              << result.capacity.transpose();
          EXPECT_TRUE(all_finite(result.torque)) << result.torque.transpose();
          if (result.outcome != status::ok) {
            EXPECT_TRUE(result.capacity.isZero(T(0)) && result.torque.isZero(T(0)))
                << to_string(result.outcome);
          } else {
            EXPECT_TRUE((result.signs.array() * result.torque.array() <= T(0)).all());
            const bool unit =
                wall.normal.cwiseAbs().maxCoeff() <= 1;  // of another normal nothing is promised
            EXPECT_TRUE(!unit || (all_finite(result.control_force) && all_finite(result.desired_force)));
          }
        }
      });
    }
  });
}

REGISTER_TYPED_TEST_SUITE_P(fault_properties, a_number_that_is_not_finite_releases_the_brakes,
                            what_a_law_does_not_need_is_not_read, finite_input_gives_finite_output);

}  // namespace passive_haptics::testing
