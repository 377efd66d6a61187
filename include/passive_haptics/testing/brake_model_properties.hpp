/// The laws of the BrakeModel concept as a GoogleTest suite for any model.
///
/// A case has
///
///     using model = ...;                            // the model under test
///     static model make();                          // an instance
///     static constexpr double inverse_error = 0;    // of an optional command_for, by the maximum limit
#pragma once

#include <passive_haptics/testing/support/brake_model_laws.hpp>

#include <gtest/gtest.h>

#include <cstdint>

namespace passive_haptics::testing {

/// Suite of a brake model's laws.
template <class Case>
class brake_model_properties : public ::testing::Test {
 protected:
  static_assert(is_brake_model<typename Case::model, explain>());
  static constexpr std::uint64_t seed = 20040627;   ///< Seed of the commands.
  const typename Case::model brake = Case::make();  ///< The model under test.
};

TYPED_TEST_SUITE_P(brake_model_properties);

/// No energy is created over 1e6 random steps, and the torque stays within its limit.
TYPED_TEST_P(brake_model_properties, takes_energy_alone_and_keeps_its_limit) {
  EXPECT_EQ(broken_energy_law(this->brake, this->seed, 1000000), "");
}

/// Invalid input counts as the concept defines.
TYPED_TEST_P(brake_model_properties, takes_any_command_time_step_and_rate) {
  EXPECT_EQ(broken_input_law(this->brake, this->seed), "");
}

/// First order in the time step, or exact.
TYPED_TEST_P(brake_model_properties, half_the_time_step_is_half_the_error) {
  EXPECT_EQ(broken_time_step_law(this->brake, this->seed), "");
}

/// command_for is as accurate as inverse_error.
TYPED_TEST_P(brake_model_properties, the_inverse_ends_nearest) {
  if constexpr (InvertibleBrakeModel<typename TypeParam::model>) {
    EXPECT_EQ(broken_inverse_law(this->brake, this->seed, TypeParam::inverse_error), "");
  }
}

/// Valid parameters.
TYPED_TEST_P(brake_model_properties, parameters_are_valid) {
  if constexpr (Parameters<typename TypeParam::model>) {
    EXPECT_EQ(validate(this->brake), "");
  }
}

REGISTER_TYPED_TEST_SUITE_P(brake_model_properties, takes_energy_alone_and_keeps_its_limit,
                            takes_any_command_time_step_and_rate, half_the_time_step_is_half_the_error,
                            the_inverse_ends_nearest, parameters_are_valid);

}  // namespace passive_haptics::testing
