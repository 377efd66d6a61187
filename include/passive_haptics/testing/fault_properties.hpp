/// Control steps with inputs that are not finite, or barely finite, as a GoogleTest suite for any mechanism.
///
/// The case is that of mechanism_properties.hpp, or a law_case of control_law_properties.hpp for laws other
/// than the two of the paper.
#pragma once

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/testing/support/print.hpp>
#include <passive_haptics/testing/support/step_samples.hpp>

#include <gtest/gtest.h>

#include <initializer_list>
#include <limits>
#include <string>
#include <type_traits>

namespace passive_haptics::testing {

/// Suite of a step's faults.
template <class Case>
class fault_properties : public ::testing::Test {
 protected:
  using model = typename Case::mechanism;                       ///< The mechanism.
  using number = typename model::scalar;                        ///< Its scalar.
  static constexpr unsigned seed = 20040627;                    ///< Seed of the samples.
  static constexpr int each = model::brake_count <= 2 ? 8 : 1;  ///< Samples per sign pattern.

  const model mechanism = Case::make();  ///< The mechanism under test.

  /// visit(run) for the case's law, or both of the paper's; run(sample, wall) is one step.
  template <class Visit>
  void for_each_law(Visit&& visit) const {
    const auto visit_one = [&]<class L>(L law) {
      visit([this, law](const step_sample<model>& sample, const contact<model::task_dimension>& wall) {
        contacts<model::task_dimension, 1> touched;
        touched.push_back(wall);
        step_memory<L> memory;
        return step(mechanism, sample.brakes, touched, law, sample.state, memory, step_options<number>());
      });
    };
    if constexpr (requires { typename Case::law; }) {
      visit_one(typename Case::law());
    } else {
      visit_one(no_direct_control());
      visit_one(direct_control());
    }
  }

  /// False for a TorqueLaw, for which the force of maximum torques may overflow.
  static constexpr bool scales() {
    if constexpr (requires { typename Case::law; }) return ScalingLaw<typename Case::law>;
    else return true;
  }

  /// visit(run, sample, wall) with each number in turn replaced by each of `spoilers`, named in the trace.
  template <class Visit>
  void for_each_spoiled(std::initializer_list<double> spoilers, Visit&& visit) const {
    for_each_sample<Case>(mechanism, seed, each, [&](step_sample<model> sample) {
      contact<model::task_dimension> wall = sample.wall();
      for_each_input(sample, wall, [&](const std::string& name, auto& value) {
        const auto good = value;
        for (const double bad : spoilers) {
          value = static_cast<std::remove_reference_t<decltype(value)>>(bad);
          SCOPED_TRACE(::testing::Message() << "seed " << seed << ", " << name << " = " << bad);
          for_each_law([&](const auto& run) { visit(run, sample, wall); });
        }
        value = good;
      });
    });
  }
};

TYPED_TEST_SUITE_P(fault_properties);

/// NaN or infinity in any input gives an error status, and exactly zero capacity and torque.
TYPED_TEST_P(fault_properties, a_number_that_is_not_finite_releases_the_brakes) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  this->for_each_spoiled({std::numeric_limits<double>::quiet_NaN(), infinity, -infinity},
                         [&](const auto& run, const auto& sample, const auto& wall) {
                           const auto result = run(sample, wall);
                           EXPECT_NE(result.outcome, status::ok);
                           EXPECT_TRUE(result.capacity.isZero(0) && result.torque.isZero(0));
                         });
}

/// Laws that do not need brake lags do not read them; some brakes work.
TYPED_TEST_P(fault_properties, what_a_law_does_not_need_is_not_read) {
  using M = typename TestFixture::model;
  int working = 0;
  for_each_sample<TypeParam>(this->mechanism, this->seed, this->each, [&](const step_sample<M>& sample) {
    step_sample<M> spoiled = sample;
    spoiled.brakes.time_constant.setConstant(std::numeric_limits<typename TestFixture::number>::quiet_NaN());
    this->for_each_law([&](const auto& run) {
      const auto expected = run(sample, sample.wall()), result = run(spoiled, sample.wall());
      EXPECT_EQ(result.outcome, status::ok);
      EXPECT_EQ(result.capacity, expected.capacity);
      EXPECT_EQ(result.torque, expected.torque);
      working += expected.capacity.isZero(0) ? 0 : 1;
    });
  });
  EXPECT_GT(working, 0) << "no sample made a brake work";
}

/// Zero, denormal, and barely finite inputs give finite passive torques within limits, or an error status.
TYPED_TEST_P(fault_properties, finite_input_gives_finite_output) {
  using T = typename TestFixture::number;
  constexpr double largest = static_cast<double>(std::numeric_limits<T>::max());
  constexpr double least = static_cast<double>(std::numeric_limits<T>::denorm_min());
  this->for_each_spoiled({0.0, least, largest, -least, -largest}, [&](const auto& run, const auto& sample,
                                                                      const auto& wall) {
    const auto limit = sample.brakes.torque_limit.array();
    if ((limit < T(0)).any()) return;  // not valid
    const auto result = run(sample, wall);
    EXPECT_TRUE((result.capacity.array() >= T(0)).all() && (result.capacity.array() <= limit).all())
        << result.capacity.transpose();
    EXPECT_TRUE(all_finite(result.torque)) << result.torque.transpose();
    EXPECT_TRUE((result.torque.array().abs() <= result.capacity.array()).all()) << result.torque.transpose();
    EXPECT_TRUE((result.signs.array() * result.torque.array() <= T(0)).all());
    if (result.outcome != status::ok) {
      EXPECT_TRUE(result.capacity.isZero(T(0))) << to_string(result.outcome);
      return;
    }
    EXPECT_TRUE(is_unit(wall.normal)) << wall.normal.transpose();
    EXPECT_TRUE(all_finite(result.desired_force));
    EXPECT_TRUE(!TestFixture::scales() || all_finite(result.control_force));
  });
}

REGISTER_TYPED_TEST_SUITE_P(fault_properties, a_number_that_is_not_finite_releases_the_brakes,
                            what_a_law_does_not_need_is_not_read, finite_input_gives_finite_output);

}  // namespace passive_haptics::testing
