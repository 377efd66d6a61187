/// @file
/// The laws of the Dynamics concept as a GoogleTest suite for any model.
///
/// The case is that of mechanism_properties.hpp; one whose bias torque includes gravity adds
/// `static constexpr bool has_gravity = true;`.
#pragma once

#include <passive_haptics/core/linear/cholesky.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>
#include <passive_haptics/testing/support/derivative.hpp>
#include <passive_haptics/testing/support/random.hpp>
#include <passive_haptics/testing/support/small_matrices.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace passive_haptics::testing {

/// Suite of a mechanism's dynamics; Case as described at the top of this file.
template <class Case>
class dynamics_properties : public ::testing::Test {
 protected:
  using model = typename Case::mechanism;  ///< The mechanism.
  using number = typename model::scalar;   ///< Its scalar.
  static_assert(Dynamics<model>,
                "passive_haptics: dynamics_properties needs a mechanism that models Dynamics.");

  static constexpr unsigned seed = 20040627;  ///< Of the motions.

  /// True if c(q, 0) may be other than 0.
  static constexpr bool has_gravity() {
    if constexpr (requires { Case::has_gravity; }) return Case::has_gravity;
    else return false;
  }

  /// A pose and a unit rate.
  struct motion {
    joint_vector<model> q;   ///< [rad or m]
    joint_vector<model> qd;  ///< [rad/s or m/s]
  };

  /// Random motions. Unit rates: all laws are homogeneous in qd.
  static std::vector<motion> motions() {
    random_source random(seed);
    const joint_vector<model> margin = (Case::upper() - Case::lower()) / number(4);
    std::vector<motion> all;
    for (int k = 0; k < 200; ++k) {
      const auto q = random.between<number, model::dof>(Case::lower() + margin, Case::upper() - margin);
      all.push_back({q, random.direction<number, model::dof>()});
    }
    return all;
  }

  /// Step of the differences along qd, short enough not to leave the bounds.
  static number step() {
    return difference_step<number>() *
           std::min(number(1), number((Case::upper() - Case::lower()).minCoeff()) / number(4));
  }

  /// Accuracy of the differences relative to the size of what is differentiated.
  static number accuracy() {
    return number(64) * difference_accuracy<number>() * difference_step<number>() / step();
  }

  /// J as a dense matrix.
  static matrix<number, model::task_dimension, model::dof> dense_jacobian(const model& mechanism,
                                                                          const joint_vector<model>& q) {
    return matrix<number, model::task_dimension, model::dof>(jacobian(mechanism, q));
  }

  /// qd . M qd.
  static number twice_energy(const model& mechanism, const joint_vector<model>& q,
                             const joint_vector<model>& qd) {
    return qd.dot(mechanism.mass_matrix(q) * qd);
  }
};

TYPED_TEST_SUITE_P(dynamics_properties);

/// M(q) is symmetric to rounding and positive definite.
TYPED_TEST_P(dynamics_properties, mass_matrix_is_symmetric_positive_definite) {
  using M = typename TypeParam::mechanism;
  using T = typename M::scalar;
  const M mechanism = TypeParam::make();
  for (const auto& [q, qd] : this->motions()) {
    SCOPED_TRACE(::testing::Message() << "seed " << this->seed << ", q = " << in_a_row(q));
    const matrix<T, M::dof, M::dof> mass = mechanism.mass_matrix(q);
    ASSERT_LE((mass - mass.transpose()).norm(), rounding_tolerance<T>(1) * mass.norm());
    ASSERT_TRUE((cholesky<T, M::dof>(mass).is_positive_definite())) << mass;
    ASSERT_GT(qd.dot(mass * qd), T(0));
  }
}

/// bias_acceleration is Jd qd, the derivative of J along qd.
TYPED_TEST_P(dynamics_properties, bias_acceleration_is_the_change_of_the_jacobian) {
  using M = typename TypeParam::mechanism;
  using T = typename M::scalar;
  const M mechanism = TypeParam::make();
  for (const auto& [q0, rate] : this->motions()) {
    const joint_vector<M> q = q0, qd = rate;
    SCOPED_TRACE(::testing::Message()
                 << "seed " << this->seed << ", q = " << in_a_row(q) << ", qd = " << in_a_row(qd));
    const auto velocity = [&](T s) -> task_vector<M> {
      return this->dense_jacobian(mechanism, q + s * qd) * qd;
    };
    const task_vector<M> expected = central_difference(velocity, this->step());
    const T size = this->dense_jacobian(mechanism, q).norm();
    const task_vector<M> given = mechanism.bias_acceleration(q, qd);
    ASSERT_LE((given - expected).norm(), this->accuracy() * size)
        << "bias_acceleration " << in_a_row(given) << ", differences give " << in_a_row(expected);
    ASSERT_EQ(largest_entry(task_vector<M>(mechanism.bias_acceleration(q, joint_vector<M>::Zero()))), T(0));
  }
}

/// Inertial forces do no work of their own: qd . (Md qd / 2 - (c(q, qd) - c(q, 0))) = 0; without gravity c(q,
/// 0) = 0.
TYPED_TEST_P(dynamics_properties, bias_torque_keeps_the_kinetic_energy) {
  using M = typename TypeParam::mechanism;
  using T = typename M::scalar;
  const M mechanism = TypeParam::make();
  for (const auto& [q0, rate] : this->motions()) {
    const joint_vector<M> q = q0, qd = rate;
    SCOPED_TRACE(::testing::Message()
                 << "seed " << this->seed << ", q = " << in_a_row(q) << ", qd = " << in_a_row(qd));
    const joint_vector<M> at_rest = mechanism.bias_torque(q, joint_vector<M>::Zero());
    const joint_vector<M> motion_torque = mechanism.bias_torque(q, qd) - at_rest;
    const auto along_the_motion = [&](T s) { return this->twice_energy(mechanism, q + s * qd, qd); };
    const T growth = central_difference(along_the_motion, this->step()) / T(2);
    ASSERT_NEAR(growth, qd.dot(motion_torque), this->accuracy() * mechanism.mass_matrix(q).norm());
    ASSERT_TRUE(TestFixture::has_gravity() || largest_entry(at_rest) == T(0)) << in_a_row(at_rest);
  }
}

/// c(q, qd) - c(q, 0) is what Lagrange's equations make of M: Md qd - grad(qd . M qd) / 2.
TYPED_TEST_P(dynamics_properties, bias_torque_follows_from_the_mass_matrix) {
  using M = typename TypeParam::mechanism;
  using T = typename M::scalar;
  const M mechanism = TypeParam::make();
  for (const auto& [q0, rate] : this->motions()) {
    const joint_vector<M> q = q0, qd = rate;
    SCOPED_TRACE(::testing::Message()
                 << "seed " << this->seed << ", q = " << in_a_row(q) << ", qd = " << in_a_row(qd));
    const auto momentum = [&](T s) -> joint_vector<M> { return mechanism.mass_matrix(q + s * qd) * qd; };
    joint_vector<M> expected = central_difference(momentum, this->step());
    for (int i = 0; i < M::dof; ++i) {
      const joint_vector<M> axis = joint_vector<M>::Unit(i);
      const auto along_the_motion = [&](T s) { return this->twice_energy(mechanism, q + s * axis, qd); };
      expected[i] -= central_difference(along_the_motion, this->step()) / T(2);
    }
    const joint_vector<M> c =
        mechanism.bias_torque(q, qd) - mechanism.bias_torque(q, joint_vector<M>::Zero());
    ASSERT_LE((c - expected).norm(), this->accuracy() * mechanism.mass_matrix(q).norm())
        << "c = " << in_a_row(c) << ", M gives " << in_a_row(expected);
  }
}

REGISTER_TYPED_TEST_SUITE_P(dynamics_properties, mass_matrix_is_symmetric_positive_definite,
                            bias_acceleration_is_the_change_of_the_jacobian,
                            bias_torque_keeps_the_kinetic_energy, bias_torque_follows_from_the_mass_matrix);

}  // namespace passive_haptics::testing
