/// The laws of the Mechanism concept as a GoogleTest suite for any model.
///
/// A case defines the mechanism, an instance, and bounds of the tested poses (lower < upper in each joint):
///
///     struct my_case {
///       using mechanism = my_arm<double>;
///       static mechanism make() { return mechanism(); }
///       static ph::joint_vector<mechanism> lower() { return {-3, -3}; }
///       static ph::joint_vector<mechanism> upper() { return {3, 3}; }
///     };
///     using namespace passive_haptics::testing;
///     INSTANTIATE_TYPED_TEST_SUITE_P(my_arm, mechanism_properties, my_case);
///
/// It also serves dynamics_properties and step_properties. Poses with singular J are allowed; poses without J
/// are not. The suite prints the detected optional members: a misspelt one is missing there.
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/design/description.hpp>
#include <passive_haptics/testing/support/derivative.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <type_traits>
#include <vector>

namespace passive_haptics::testing {

/// True if position is templated on the scalar, which allows a reference in higher precision.
template <class M>
concept PositionTakesLongDouble = requires(const M mechanism, const vector<long double, M::dof> q) {
  { mechanism.position(q) } -> ExactVector<long double, M::task_dimension>;
};

/// Suite of a mechanism's laws.
template <class Case>
class mechanism_properties : public ::testing::Test {
 protected:
  using model = typename Case::mechanism;  ///< The mechanism.
  using number = typename model::scalar;   ///< Its scalar.

  static constexpr int pose_count = 200;      ///< Number of tested poses.
  static constexpr unsigned seed = 20040627;  ///< Seed of the poses.

  /// Scalar of the reference derivative: long double if position accepts it.
  using reference_scalar = std::conditional_t<PositionTakesLongDouble<model>, long double, number>;

  /// Step of the differences in joint i.
  static reference_scalar step(int i) {
    return difference_step<reference_scalar>() *
           std::min(reference_scalar(1),
                    static_cast<reference_scalar>(Case::upper()[i] - Case::lower()[i]) / reference_scalar(8));
  }

  const model mechanism = Case::make();  ///< The mechanism under test.

  /// Prints the optional members once.
  static void SetUpTestSuite() {
    std::cout << "optional members: " << to_text(passive_haptics::describe<model>()) << "\n";
  }

  /// visit(q) for random poses, far enough from the bounds for differences.
  template <class Visit>
  void for_each_pose(Visit&& visit) const {
    random_source random(seed);
    joint_vector<model> margin;
    for (int i = 0; i < model::dof; ++i) margin[i] = static_cast<number>(3 * step(i));
    for (int k = 0; k < pose_count && !::testing::Test::HasFatalFailure(); ++k) {
      const auto q = random.between<number, model::dof>(Case::lower() + margin, Case::upper() - margin);
      SCOPED_TRACE(::testing::Message() << "seed " << seed << ", q = " << q.transpose());
      visit(q);
    }
  }

  /// Maximum magnitude of an entry; NaN if one is NaN.
  template <class Expression>
  static auto max_entry(const Expression& A) {
    return A.cwiseAbs().template maxCoeff<Eigen::PropagateNaN>();
  }

  /// |T| |T^+|, an upper bound of the condition of the transmission; 1 without one, NaN for deficient rank.
  number transmission_condition(const joint_vector<model>& q) const {
    if constexpr (passive_haptics::detail::has_exact_transmission<model>) {
      const transmission_matrix<model> A(passive_haptics::transmission(mechanism, q));
      return A.norm() * pseudo_inverse(A).norm();
    } else {
      return number(1);
    }
  }

  /// Random joint rates; with fewer brakes than joints, T^+ T qd, at which the other joints rest.
  joint_vector<model> braked_rates(const joint_vector<model>& q, random_source& random) const {
    joint_vector<model> qd = random.normal_vector<number, model::dof>();
    if constexpr (model::brake_count < model::dof) {
      const transmission_matrix<model> A(passive_haptics::transmission(mechanism, q));
      qd = pseudo_inverse(A) * brake_vector<model>(A * qd);
    }
    return qd;
  }

  /// dx/dq_i by differences of position.
  vector<reference_scalar, model::task_dimension> difference_column(const joint_vector<model>& q,
                                                                    int i) const {
    const auto along = [&](reference_scalar s) {
      auto moved = as<reference_scalar>(q);
      moved[i] += s;
      return vector<reference_scalar, model::task_dimension>(mechanism.position(moved));
    };
    return central_difference(along, step(i));
  }

  /// Dense J.
  jacobian_matrix<model> dense_jacobian(const joint_vector<model>& q) const {
    return jacobian_matrix<model>(passive_haptics::jacobian(mechanism, q));
  }

  /// Maximum entry of position and J over all poses, the scale of rounding errors.
  number size() const {
    number size = number(0);
    for_each_pose([&](const joint_vector<model>& q) {
      const task_vector<model> x = mechanism.position(q);
      size = std::max({size, max_entry(x), max_entry(dense_jacobian(q))});
    });
    return size;
  }

  /// Rounding of position and J at q for this size.
  static number rounding_at(const joint_vector<model>& q, number size) {
    return rounding_tolerance<number>(4) * (number(1) + max_entry(q)) * size;
  }
};

TYPED_TEST_SUITE_P(mechanism_properties);

/// Finite q gives a finite and reproducible position.
TYPED_TEST_P(mechanism_properties, position_is_finite_and_pure) {
  using M = typename TestFixture::model;
  std::vector<task_vector<M>> first;
  this->for_each_pose([&](const joint_vector<M>& q) {
    first.push_back(this->mechanism.position(q));
    ASSERT_TRUE(all_finite(first.back()));
  });
  std::size_t k = 0;
  this->for_each_pose([&](const joint_vector<M>& q) {
    const task_vector<M> again = this->mechanism.position(q);
    ASSERT_EQ(again, first[k++]);
  });
}

/// J is pure and the derivative of position, by differences of sixth order. In long double, if position
/// accepts it, the tolerance is rounding; else eps^(6/7), the resolution of such differences.
TYPED_TEST_P(mechanism_properties, jacobian_is_the_derivative_of_position) {
  using M = typename TestFixture::model;
  using P = typename TestFixture::reference_scalar;
  const P size = static_cast<P>(this->size());
  this->for_each_pose([&](const joint_vector<M>& q) {
    const auto J = this->dense_jacobian(q);
    const P rounding = static_cast<P>(this->rounding_at(q, 1));
    for (int i = 0; i < M::dof; ++i) {
      const P resolved = P(16) * difference_accuracy<P>() * difference_step<P>() / this->step(i);
      const auto expected = this->difference_column(q, i);
      const task_vector<M> column = J.col(i);
      ASSERT_LE(this->max_entry(as<P>(column) - expected), (rounding + resolved) * size)
          << "column " << i << ": " << column.transpose() << ", differences give " << expected.transpose();
    }
    ASSERT_EQ(this->dense_jacobian(q), J);
  });
}

/// The mechanism's Jacobian equals the automatic one; jacobian() returns the one that exists.
TYPED_TEST_P(mechanism_properties, given_and_automatic_jacobian_agree) {
  using M = typename TestFixture::model;
  const auto size = this->size();
  this->for_each_pose([&](const joint_vector<M>& q) {
    const auto J = this->dense_jacobian(q);
    if constexpr (passive_haptics::detail::differentiates_itself<M>)
      ASSERT_LE(this->max_entry(J - automatic_jacobian(this->mechanism, q)), this->rounding_at(q, size));
    else if constexpr (passive_haptics::detail::jacobian_is_constant<M>)
      ASSERT_EQ(J, jacobian_matrix<M>(this->mechanism.jacobian()));
    else ASSERT_EQ(J, jacobian_matrix<M>(this->mechanism.jacobian(q)));
  });
}

/// position and jacobian of pose(q) and q agree to rounding; without a pose type, q is the pose.
TYPED_TEST_P(mechanism_properties, pose_has_the_position_and_jacobian_of_q) {
  using M = typename TestFixture::model;
  const auto size = this->size();
  this->for_each_pose([&](const joint_vector<M>& q) {
    const mechanism_pose<M> pose(this->mechanism, q);
    const auto tolerance = this->rounding_at(q, size);
    const task_vector<M> x = pose.position(), expected = this->mechanism.position(q);
    ASSERT_LE(this->max_entry(x - expected), tolerance);
    ASSERT_LE(this->max_entry(jacobian_matrix<M>(pose.jacobian()) - this->dense_jacobian(q)), tolerance);
  });
}

/// T has full rank, and v = E w with E = J T^+ while joints without a brake rest.
TYPED_TEST_P(mechanism_properties, brake_jacobian_maps_brake_rates_to_velocity) {
  using M = typename TestFixture::model;
  using T = typename TestFixture::number;
  random_source random(this->seed);
  this->for_each_pose([&](const joint_vector<M>& q) {
    const joint_vector<M> qd = this->braked_rates(q, random);
    const task_vector<M> v = brake_jacobian(this->mechanism, q) * brake_rates(this->mechanism, q, qd);
    const T condition = this->transmission_condition(q);
    ASSERT_TRUE(std::isfinite(condition)) << "the transmission has not full rank";
    const auto J = this->dense_jacobian(q);
    ASSERT_LE((v - J * qd).norm(), rounding_tolerance<T>(4 * M::dof) * condition * J.norm() * qd.norm());
  });
}

/// Virtual work: t = E^T F does the work of F, t . w = F . v, while joints without a brake rest.
TYPED_TEST_P(mechanism_properties, brake_torques_do_the_work_of_the_force) {
  using M = typename TestFixture::model;
  using T = typename TestFixture::number;
  random_source random(this->seed);
  this->for_each_pose([&](const joint_vector<M>& q) {
    const joint_vector<M> qd = this->braked_rates(q, random);
    const task_vector<M> F = random.normal_vector<T, M::task_dimension>();
    const brake_vector<M> w = brake_rates(this->mechanism, q, qd);
    const brake_vector<M> t = brake_torque(brake_jacobian(this->mechanism, q), F);
    const auto J = this->dense_jacobian(q);
    ASSERT_NEAR(t.dot(w), F.dot(J * qd),
                rounding_tolerance<T>(4 * M::dof) * this->transmission_condition(q) * F.norm() * J.norm() *
                    qd.norm());
  });
}

REGISTER_TYPED_TEST_SUITE_P(mechanism_properties, position_is_finite_and_pure,
                            jacobian_is_the_derivative_of_position, given_and_automatic_jacobian_agree,
                            pose_has_the_position_and_jacobian_of_q,
                            brake_jacobian_maps_brake_rates_to_velocity,
                            brake_torques_do_the_work_of_the_force);

}  // namespace passive_haptics::testing
