/// The laws of a control step as a GoogleTest suite for any mechanism.
///
/// The case is that of mechanism_properties.hpp. Each law is tested for random poses, rates, walls and hands,
/// for each of the 3^m patterns of brakes that rotate either way or are at rest.
#pragma once

#include <passive_haptics/control/direct_control.hpp>
#include <passive_haptics/testing/support/print.hpp>
#include <passive_haptics/testing/support/step_samples.hpp>

#include <gtest/gtest.h>

namespace passive_haptics::testing {

/// Suite of a step's laws.
template <class Case>
class step_properties : public ::testing::Test {
 protected:
  using model = typename Case::mechanism;          ///< The mechanism.
  using number = typename model::scalar;           ///< Its scalar.
  static constexpr int d = model::task_dimension;  ///< d
  static constexpr unsigned seed = 20040627;       ///< Seed of the samples.
  /// Samples per sign pattern, a few thousand in total.
  static constexpr int each = model::brake_count <= 2 ? 300 : (model::brake_count <= 4 ? 60 : 3);

  const model mechanism = Case::make();  ///< The mechanism under test.

  /// One step with a new memory.
  template <class L>
  step_result<model> run(const step_sample<model>& sample,
                         saturation policy = saturation::keep_direction) const {
    step_memory<L> memory;
    return step(mechanism, sample.brakes, sample.touched, L{}, sample.state, memory,
                step_options<number>({}, policy));
  }

  /// Description of the sample for a failure.
  static ::testing::Message describe(const step_sample<model>& sample) {
    return ::testing::Message() << "seed " << seed << ", q = " << sample.state.q.transpose()
                                << ", qd = " << sample.state.qd.transpose()
                                << ", hand_force = " << sample.state.hand_force.transpose()
                                << ", normal = " << sample.wall().normal.transpose()
                                << ", depth = " << sample.wall().depth;
  }

  /// Signs of the force's cone: s* if a self-motion settles, else s.
  static const brake_vector<model>& signs_of_cone(const step_result<model>& result) {
    if constexpr (Settles<model>) return result.settled_signs;
    else return result.signs;
  }

  /// visit(sample, result) for each sample, law and saturation policy.
  template <class Visit>
  void for_each_step(Visit&& visit) const {
    for_each_sample<Case>(mechanism, seed, each, [&](const step_sample<model>& sample) {
      if (::testing::Test::HasFatalFailure()) return;
      SCOPED_TRACE(describe(sample));
      for (const saturation policy : {saturation::keep_direction, saturation::clamp_each}) {
        visit(sample, run<no_direct_control>(sample, policy));
        visit(sample, run<direct_control>(sample, policy));
      }
    });
  }
};

TYPED_TEST_SUITE_P(step_properties);

/// s_i t_i <= 0 exactly, for predicted torques and those of the approximated force (with the settled signs s*
/// if a self-motion settles). Slipping brakes take power exactly; a brake inside its dead band, with the sign
/// of the hand force, gives at most |t_i| times the dead band.
TYPED_TEST_P(step_properties, brakes_never_drive) {
  using T = typename TestFixture::number;
  int working = 0;
  this->for_each_step([&](const auto& sample, const auto& result) {
    ASSERT_EQ(result.outcome, status::ok);
    const auto w = brake_rates(this->mechanism, sample.state.q, sample.state.qd);
    T power = T(0), allowed = T(0);
    for (int i = 0; i < w.size(); ++i) {
      ASSERT_LE(result.signs[i] * result.torque[i], T(0)) << "brake " << i;
      ASSERT_LE(this->signs_of_cone(result)[i] * result.cone_coefficients[i], T(0)) << "brake " << i;
      const T band = sample.brakes.rate_dead_band[i];
      const T own_power = result.torque[i] * w[i];
      ASSERT_TRUE(own_power <= T(0) || !slips(w[i], band)) << "brake " << i;
      if (!slips(w[i], band)) allowed += std::abs(result.torque[i]) * band;
      power += own_power;
    }
    ASSERT_LE(power, allowed * (T(1) + rounding_tolerance<T>(static_cast<int>(w.size()))));
    working += result.torque.isZero(T(0)) ? 0 : 1;
  });
  EXPECT_GT(working, 0) << "no sample made a brake work";
}

/// 0 <= capacity_i <= limit_i exactly, and no predicted torque exceeds its capacity.
TYPED_TEST_P(step_properties, capacity_is_within_its_limits) {
  int limited = 0;
  this->for_each_step([&](const auto& sample, const auto& result) {
    ASSERT_TRUE((result.capacity.array() >= 0).all()) << result.capacity.transpose();
    ASSERT_TRUE((result.capacity.array() <= sample.brakes.torque_limit.array()).all())
        << result.capacity.transpose();
    ASSERT_TRUE((result.torque.array().abs() <= result.capacity.array()).all()) << result.torque.transpose();
    limited += result.saturated ? 1 : 0;
  });
  EXPECT_GT(limited, 0) << "no sample reached a limit";
}

/// A displayed force has the desired component: Fc . n = |Fd|. Its angle with n is gamma, and its torques are
/// the cone coefficients. An exact force is the desired force.
TYPED_TEST_P(step_properties, displayed_force_has_the_desired_component) {
  using M = typename TestFixture::model;
  using T = typename TestFixture::number;
  int seen[4] = {};
  this->for_each_step([&](const auto& sample, const auto& result) {
    ++seen[static_cast<int>(result.display)];
    const auto& Fd = result.desired_force;
    const auto& Fc = result.control_force;
    const T cosine = result.approximation_cosine;
    if (!is_displayed(result.display)) {
      ASSERT_TRUE(result.capacity.isZero(T(0)) && result.torque.isZero(T(0)) && Fc.isZero(T(0)));
      ASSERT_EQ(cosine, T(0));
      return;
    }
    const T tolerance = rounding_tolerance<T>(8) / (cosine * cosine);
    ASSERT_NEAR(Fc.dot(Fd.normalized()) / Fd.norm(), T(1), tolerance);
    ASSERT_NEAR(Fc.norm() * cosine / Fd.norm(), T(1), tolerance);
    ASSERT_TRUE(result.display != display_class::exact || Fc == Fd);
    const auto E = dense_brake_jacobian(this->mechanism, sample.state.q);
    const T condition = Settles<M> ? T(1) / settled_rates<M>::default_share : T(1);
    ASSERT_LE((E.transpose() * Fc - result.cone_coefficients).norm(),
              tolerance * condition * E.norm() * Fc.norm());
    if constexpr (Settles<M>) {  // Fc . v' <= 0, except for brakes within their dead band
      const T given = result.cone_coefficients.cwiseAbs().dot(sample.brakes.rate_dead_band);
      const T rounding = tolerance * condition * Fc.norm() * result.settled_velocity.norm();
      ASSERT_LE(Fc.dot(result.settled_velocity), given + rounding);
    }
  });
  if (M::dof == M::task_dimension) {
    EXPECT_GT(seen[static_cast<int>(display_class::none)], 0);
  }
  EXPECT_GT(seen[static_cast<int>(display_class::approximate)] + seen[static_cast<int>(display_class::exact)],
            0);
}

/// In slip, with 0 < alpha < 1 and no limit reached, the resultant has no normal component: (Fh + alpha Fc) .
/// n = 0, and the brakes' torques are those of alpha Fc.
TYPED_TEST_P(step_properties, direct_control_leaves_nothing_normal) {
  using T = typename TestFixture::number;
  using M = typename TestFixture::model;
  int scaled = 0;
  for_each_sample<TypeParam>(this->mechanism, this->seed, this->each, [&](const step_sample<M>& sample) {
    if (this->HasFatalFailure()) return;
    SCOPED_TRACE(this->describe(sample));
    const auto result = this->template run<direct_control>(sample);
    ASSERT_GE(result.alpha, T(0));
    ASSERT_LE(result.alpha, T(1));
    if (result.display == display_class::none || !(result.alpha > T(0) && result.alpha < T(1))) return;
    const task_vector<M> n = sample.wall().normal.template cast<T>();
    const T cosine = result.approximation_cosine;
    const T left = (sample.state.hand_force + result.alpha * result.control_force).dot(n);
    ASSERT_LE(std::abs(left), rounding_tolerance<T>(8) / (cosine * cosine) * sample.state.hand_force.norm());
    ++scaled;
    const brake_vector<M> w = brake_rates(this->mechanism, sample.state.q, sample.state.qd);
    if (result.saturated || any_sticks(w, sample.brakes)) return;
    const brake_vector<M> commanded = result.alpha * result.cone_coefficients;
    const brake_vector<M> left_over = result.torque.cwiseAbs() - commanded.cwiseAbs();
    ASSERT_LE(left_over.norm(), rounding_tolerance<T>(2) * commanded.norm());
  });
  EXPECT_GT(scaled, 0) << "no sample was scaled by direct control";
}

/// Brakes at rest without hand torque restrict nothing: forces that do not act on joints without a brake are
/// displayed exactly, no torque is predicted, and the brakes hold. Settling self-motion: tested at rest.
TYPED_TEST_P(step_properties, brakes_at_rest_and_unpushed_restrict_nothing) {
  using T = typename TestFixture::number;
  using M = typename TestFixture::model;
  random_source random(this->seed);
  std::array<int, static_cast<std::size_t>(M::brake_count)> at_rest{};
  for (int k = 0; k < 100; ++k) {
    step_sample<M> sample = random_sample<TypeParam>(this->mechanism, at_rest, random);
    sample.state.hand_force.setZero();
    if constexpr (Settles<M>) {
      contact<TestFixture::d> still = sample.wall();
      still.wall_velocity.setZero();
      sample.state.qd.setZero();
      sample.touched.clear();
      sample.touched.push_back(still);
    }
    SCOPED_TRACE(this->describe(sample));
    const auto result = this->template run<no_direct_control>(sample, saturation::clamp_each);
    ASSERT_EQ(result.outcome, status::ok);
    ASSERT_TRUE(result.signs.isZero(T(0)));
    ASSERT_TRUE(result.torque.isZero(T(0)));
    if constexpr (M::brake_count < M::dof) continue;
    ASSERT_EQ(result.display, display_class::exact);
    const brake_vector<M> wanted =
        brake_torque(brake_jacobian(this->mechanism, sample.state.q), result.desired_force);
    const brake_vector<M> held = wanted.cwiseAbs().cwiseMin(sample.brakes.torque_limit);
    const T size = dense_brake_jacobian(this->mechanism, sample.state.q).norm() * result.desired_force.norm();
    ASSERT_LE((result.capacity - held).norm(), rounding_tolerance<T>(2) * size);
    ASSERT_GT(held.norm(), T(0));
  }
}

REGISTER_TYPED_TEST_SUITE_P(step_properties, brakes_never_drive, capacity_is_within_its_limits,
                            displayed_force_has_the_desired_component, direct_control_leaves_nothing_normal,
                            brakes_at_rest_and_unpushed_restrict_nothing);

}  // namespace passive_haptics::testing
