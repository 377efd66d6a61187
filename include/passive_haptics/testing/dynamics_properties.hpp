/// The laws of the Dynamics concept as a GoogleTest suite for any model.
///
/// The case is that of mechanism_properties.hpp; add `static constexpr bool has_gravity = true;` if the bias
/// torque includes gravity.
#pragma once

#include <passive_haptics/core/linear/cholesky.hpp>
#include <passive_haptics/mechanism/dynamics.hpp>
#include <passive_haptics/mechanism/jacobian.hpp>
#include <passive_haptics/testing/support/derivative.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace passive_haptics::testing {

/// Suite of a mechanism's dynamics.
template <class Case>
class dynamics_properties : public ::testing::Test {
 protected:
  using model = typename Case::mechanism;  ///< The mechanism.
  using number = typename model::scalar;   ///< Its scalar.
  static_assert(Dynamics<model>,
                "passive_haptics: dynamics_properties needs a mechanism that models Dynamics.");

  static constexpr unsigned seed = 20040627;  ///< Seed of the motions.

  /// True if c(q, 0) may be nonzero.
  static constexpr bool has_gravity() {
    if constexpr (requires { Case::has_gravity; }) return Case::has_gravity;
    else return false;
  }

  const model mechanism = Case::make();  ///< The mechanism under test.

  /// visit(q, qd) for random motions with unit rates; all laws are homogeneous in qd.
  template <class Visit>
  void for_each_motion(Visit&& visit) const {
    random_source random(seed);
    const joint_vector<model> margin = (Case::upper() - Case::lower()) / number(4);
    for (int k = 0; k < 200 && !::testing::Test::HasFatalFailure(); ++k) {
      const auto q = random.between<number, model::dof>(Case::lower() + margin, Case::upper() - margin);
      const joint_vector<model> qd = random.direction<number, model::dof>();
      SCOPED_TRACE(::testing::Message()
                   << "seed " << seed << ", q = " << q.transpose() << ", qd = " << qd.transpose());
      visit(q, qd);
    }
  }

  /// Step of the differences along qd that stays within the bounds.
  static number step() {
    return difference_step<number>() *
           std::min(number(1), number((Case::upper() - Case::lower()).minCoeff()) / number(4));
  }

  /// Relative accuracy of the differences.
  static number accuracy() {
    return number(64) * difference_accuracy<number>() * difference_step<number>() / step();
  }

  /// Dense J.
  jacobian_matrix<model> dense_jacobian(const joint_vector<model>& q) const {
    return jacobian_matrix<model>(passive_haptics::jacobian(mechanism, q));
  }

  /// qd . M qd.
  number twice_energy(const joint_vector<model>& q, const joint_vector<model>& qd) const {
    return qd.dot(mechanism.mass_matrix(q) * qd);
  }

  /// c(q, qd) - c(q, 0).
  joint_vector<model> motion_torque(const joint_vector<model>& q, const joint_vector<model>& qd) const {
    return mechanism.bias_torque(q, qd) - mechanism.bias_torque(q, joint_vector<model>::Zero());
  }
};

TYPED_TEST_SUITE_P(dynamics_properties);

/// M(q) is symmetric to rounding and positive definite.
TYPED_TEST_P(dynamics_properties, mass_matrix_is_symmetric_positive_definite) {
  using M = typename TestFixture::model;
  using T = typename TestFixture::number;
  this->for_each_motion([&](const joint_vector<M>& q, const joint_vector<M>& qd) {
    const matrix<T, M::dof, M::dof> mass = this->mechanism.mass_matrix(q);
    ASSERT_LE((mass - mass.transpose()).norm(), rounding_tolerance<T>(1) * mass.norm());
    ASSERT_TRUE((cholesky<T, M::dof>(mass).is_positive_definite())) << mass;
    ASSERT_GT(qd.dot(mass * qd), T(0));
  });
}

/// bias_acceleration is Jd qd, the derivative of J along qd.
TYPED_TEST_P(dynamics_properties, bias_acceleration_is_the_change_of_the_jacobian) {
  using M = typename TestFixture::model;
  using T = typename TestFixture::number;
  this->for_each_motion([&](const joint_vector<M>& q, const joint_vector<M>& qd) {
    const auto velocity = [&](T s) -> task_vector<M> { return this->dense_jacobian(q + s * qd) * qd; };
    const task_vector<M> expected = central_difference(velocity, this->step());
    const task_vector<M> given = this->mechanism.bias_acceleration(q, qd);
    ASSERT_LE((given - expected).norm(), this->accuracy() * this->dense_jacobian(q).norm())
        << "bias_acceleration " << given.transpose() << ", differences give " << expected.transpose();
    const joint_vector<M> at_rest = joint_vector<M>::Zero();
    ASSERT_TRUE(this->mechanism.bias_acceleration(q, at_rest).isZero(T(0)));
  });
}

/// Inertial forces do no work: qd . (Md qd / 2 - (c(q, qd) - c(q, 0))) = 0; c(q, 0) = 0 without gravity.
TYPED_TEST_P(dynamics_properties, bias_torque_keeps_the_kinetic_energy) {
  using M = typename TestFixture::model;
  using T = typename TestFixture::number;
  this->for_each_motion([&](const joint_vector<M>& q, const joint_vector<M>& qd) {
    const auto along_the_motion = [&](T s) { return this->twice_energy(q + s * qd, qd); };
    const T growth = central_difference(along_the_motion, this->step()) / T(2);
    ASSERT_NEAR(growth, qd.dot(this->motion_torque(q, qd)),
                this->accuracy() * this->mechanism.mass_matrix(q).norm());
    const joint_vector<M> at_rest = this->mechanism.bias_torque(q, joint_vector<M>::Zero());
    ASSERT_TRUE(TestFixture::has_gravity() || at_rest.isZero(T(0))) << at_rest.transpose();
  });
}

/// c(q, qd) - c(q, 0) follows from M by Lagrange's equations: Md qd - grad(qd . M qd) / 2.
TYPED_TEST_P(dynamics_properties, bias_torque_follows_from_the_mass_matrix) {
  using M = typename TestFixture::model;
  using T = typename TestFixture::number;
  this->for_each_motion([&](const joint_vector<M>& q, const joint_vector<M>& qd) {
    const auto momentum = [&](T s) -> joint_vector<M> {
      return this->mechanism.mass_matrix(q + s * qd) * qd;
    };
    joint_vector<M> expected = central_difference(momentum, this->step());
    for (int i = 0; i < M::dof; ++i) {
      const auto along_axis = [&](T s) { return this->twice_energy(q + s * joint_vector<M>::Unit(i), qd); };
      expected[i] -= central_difference(along_axis, this->step()) / T(2);
    }
    const joint_vector<M> c = this->motion_torque(q, qd);
    ASSERT_LE((c - expected).norm(), this->accuracy() * this->mechanism.mass_matrix(q).norm())
        << "c = " << c.transpose() << ", M gives " << expected.transpose();
  });
}

/// M, c and Jd qd of pose(q) and q agree to rounding.
TYPED_TEST_P(dynamics_properties, pose_has_the_dynamics_of_q) {
  using M = typename TestFixture::model;
  const auto tolerance = this->accuracy();
  this->for_each_motion([&](const joint_vector<M>& q, const joint_vector<M>& qd) {
    const mechanism_pose<M> pose(this->mechanism, q);
    const auto mass = this->mechanism.mass_matrix(q);
    ASSERT_LE((pose.mass_matrix() - mass).norm(), tolerance * mass.norm());
    ASSERT_LE((pose.bias_torque(qd) - this->mechanism.bias_torque(q, qd)).norm(), tolerance * mass.norm());
    ASSERT_LE((pose.bias_acceleration(qd) - this->mechanism.bias_acceleration(q, qd)).norm(),
              tolerance * this->dense_jacobian(q).norm());
  });
}

REGISTER_TYPED_TEST_SUITE_P(dynamics_properties, mass_matrix_is_symmetric_positive_definite,
                            bias_acceleration_is_the_change_of_the_jacobian,
                            bias_torque_keeps_the_kinetic_energy, bias_torque_follows_from_the_mass_matrix,
                            pose_has_the_dynamics_of_q);

}  // namespace passive_haptics::testing
