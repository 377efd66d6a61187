/// @file
/// The laws of the Mechanism concept as a GoogleTest suite for any model.
///
/// A case names the mechanism, makes one and bounds the poses that are tried (lower < upper in each joint):
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
/// The same case serves dynamics_properties and step_properties. Poses with J singular are welcome; poses
/// where J does not exist are not. Cost: some thousand evaluations of position and jacobian.
#pragma once

#include <passive_haptics/brake/brake_jacobian.hpp>
#include <passive_haptics/testing/support/derivative.hpp>
#include <passive_haptics/testing/support/random.hpp>
#include <passive_haptics/testing/support/small_matrices.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <type_traits>
#include <vector>

namespace passive_haptics::testing {

/// True where position is templated on the scalar, so that a reference in higher precision can be had.
template <class M>
concept PositionTakesLongDouble = requires(const M mechanism, const vector<long double, M::dof> q) {
  { mechanism.position(q) } -> ExactVector<long double, M::task_dimension>;
};

/// Suite of a mechanism's laws; Case as described at the top of this file.
template <class Case>
class mechanism_properties : public ::testing::Test {
 protected:
  using model = typename Case::mechanism;  ///< The mechanism.
  using number = typename model::scalar;   ///< Its scalar.

  static constexpr int pose_count = 200;      ///< Poses that are tried.
  static constexpr unsigned seed = 20040627;  ///< Of the poses.

  /// Scalar of the reference derivative: long double where position takes it.
  using reference_scalar = std::conditional_t<PositionTakesLongDouble<model>, long double, number>;

  /// Step of the differences in joint i.
  static reference_scalar step(int i) {
    return difference_step<reference_scalar>() *
           std::min(reference_scalar(1),
                    static_cast<reference_scalar>(Case::upper()[i] - Case::lower()[i]) / reference_scalar(8));
  }

  /// Random poses, far enough from the bounds for differences.
  static std::vector<joint_vector<model>> poses() {
    random_source random(seed);
    joint_vector<model> margin;
    for (int i = 0; i < model::dof; ++i) margin[i] = static_cast<number>(3 * step(i));
    std::vector<joint_vector<model>> all;
    for (int k = 0; k < pose_count; ++k)
      all.push_back(random.between<number, model::dof>(Case::lower() + margin, Case::upper() - margin));
    return all;
  }

  /// Condition of the transmission: largest over smallest singular value; 1 without one, infinite if rank is
  /// lost.
  static number transmission_condition(const model& mechanism, const joint_vector<model>& q) {
    if constexpr (detail::has_exact_transmission<model>) {
      const matrix<number, model::brake_count, model::dof> A(transmission(mechanism, q));
      return static_cast<number>(condition_of(small_matrix(A)));
    } else {
      return number(1);
    }
  }

  /// dx/dq by differences of position.
  static matrix<reference_scalar, model::task_dimension, model::dof> difference_jacobian(
      const model& mechanism, const joint_vector<model>& q) {
    matrix<reference_scalar, model::task_dimension, model::dof> J;
    for (int i = 0; i < model::dof; ++i) {
      const auto along = [&](reference_scalar s) {
        auto moved = as<reference_scalar>(q);
        moved[i] += s;
        return vector<reference_scalar, model::task_dimension>(mechanism.position(moved));
      };
      J.col(i) = central_difference(along, step(i));
    }
    return J;
  }

  /// J as a dense matrix.
  static matrix<number, model::task_dimension, model::dof> dense_jacobian(const model& mechanism,
                                                                          const joint_vector<model>& q) {
    return matrix<number, model::task_dimension, model::dof>(jacobian(mechanism, q));
  }

  /// Largest entry of position and of J over all poses: what rounding errors are relative to.
  static number size_of(const model& mechanism) {
    number size = number(0);
    for (const joint_vector<model>& q : poses()) {
      const task_vector<model> x = mechanism.position(q);
      size = std::max({size, largest_entry(x), largest_entry(dense_jacobian(mechanism, q))});
    }
    return size;
  }

  /// Rounding of position and of J at q, both of size_of.
  static number rounding_at(const joint_vector<model>& q, number size) {
    return rounding_tolerance<number>(4) * (number(1) + largest_entry(q)) * size;
  }
};

TYPED_TEST_SUITE_P(mechanism_properties);

/// Finite q gives a finite position, the same one each time.
TYPED_TEST_P(mechanism_properties, position_is_finite_and_pure) {
  using M = typename TypeParam::mechanism;
  const M mechanism = TypeParam::make();
  std::vector<task_vector<M>> first;
  for (const joint_vector<M>& q : this->poses()) {
    SCOPED_TRACE(::testing::Message() << "seed " << this->seed << ", q = " << in_a_row(q));
    first.push_back(mechanism.position(q));
    ASSERT_TRUE(all_finite(first.back()));
  }
  std::size_t k = 0;
  for (const joint_vector<M>& q : this->poses()) {
    const task_vector<M> again = mechanism.position(q);
    ASSERT_EQ(again, first[k++]) << "seed " << this->seed << ", q = " << in_a_row(q);
  }
}

/// J is the derivative of position and pure. Against differences of sixth order, in long double if position
/// takes it: then the tolerance is rounding alone, else what such differences can resolve, eps^(6/7).
TYPED_TEST_P(mechanism_properties, jacobian_is_the_derivative_of_position) {
  using M = typename TypeParam::mechanism;
  using T = typename M::scalar;
  using P = typename TestFixture::reference_scalar;
  const M mechanism = TypeParam::make();
  const P size = static_cast<P>(this->size_of(mechanism));
  for (const joint_vector<M>& q : this->poses()) {
    SCOPED_TRACE(::testing::Message() << "seed " << this->seed << ", q = " << in_a_row(q));
    const auto J = this->dense_jacobian(mechanism, q);
    const P rounding = static_cast<P>(rounding_tolerance<T>(4) * (T(1) + largest_entry(q)));
    for (int i = 0; i < M::dof; ++i) {
      const P resolved = P(16) * difference_accuracy<P>() * difference_step<P>() / this->step(i);
      const vector<P, M::task_dimension> expected = this->difference_jacobian(mechanism, q).col(i);
      const task_vector<M> column = J.col(i);
      ASSERT_LE(largest_entry(as<P>(column) - expected), (rounding + resolved) * size)
          << "column " << i << ": " << in_a_row(column) << ", differences give " << in_a_row(expected);
    }
    ASSERT_EQ(this->dense_jacobian(mechanism, q), J);
  }
}

/// A Jacobian that the mechanism gives is that of automatic differentiation, where there are both; where
/// there is one, jacobian() returns it.
TYPED_TEST_P(mechanism_properties, given_and_automatic_jacobian_agree) {
  using M = typename TypeParam::mechanism;
  using T = typename M::scalar;
  const M mechanism = TypeParam::make();
  const T size = this->size_of(mechanism);
  for (const joint_vector<M>& q : this->poses()) {
    SCOPED_TRACE(::testing::Message() << "seed " << this->seed << ", q = " << in_a_row(q));
    const auto J = this->dense_jacobian(mechanism, q);
    if constexpr (detail::differentiates_itself<M>) {
      const T tolerance = this->rounding_at(q, size);
      ASSERT_LE(largest_entry(J - automatic_jacobian(mechanism, q)), tolerance);
    } else if constexpr (detail::jacobian_is_constant<M>) {
      ASSERT_EQ(J, (matrix<T, M::task_dimension, M::dof>(mechanism.jacobian())));
    } else {
      ASSERT_EQ(J, (matrix<T, M::task_dimension, M::dof>(mechanism.jacobian(q))));
    }
  }
}

/// position and jacobian of pose(q) are those of q, to rounding; without a pose of its own, q is the pose.
TYPED_TEST_P(mechanism_properties, pose_has_the_position_and_jacobian_of_q) {
  using M = typename TypeParam::mechanism;
  using T = typename M::scalar;
  const M mechanism = TypeParam::make();
  const T size = this->size_of(mechanism);
  for (const joint_vector<M>& q : this->poses()) {
    SCOPED_TRACE(::testing::Message() << "seed " << this->seed << ", q = " << in_a_row(q));
    const auto at = pose(mechanism, q);
    const T tolerance = this->rounding_at(q, size);
    const task_vector<M> x = mechanism.position(at), expected = mechanism.position(q);
    ASSERT_LE(largest_entry(x - expected), tolerance);
    const matrix<T, M::task_dimension, M::dof> J(jacobian(mechanism, at));
    ASSERT_LE(largest_entry(J - this->dense_jacobian(mechanism, q)), tolerance);
  }
}

/// T is invertible, and E = J T^-1 maps the rates of the brakes to the velocity, v = E w.
TYPED_TEST_P(mechanism_properties, brake_jacobian_maps_brake_rates_to_velocity) {
  using M = typename TypeParam::mechanism;
  using T = typename M::scalar;
  const M mechanism = TypeParam::make();
  random_source random(this->seed);
  for (const joint_vector<M>& q : this->poses()) {
    SCOPED_TRACE(::testing::Message() << "seed " << this->seed << ", q = " << in_a_row(q));
    const joint_vector<M> qd = random.normal_vector<T, M::dof>();
    const brake_vector<M> w = brake_rates(mechanism, q, qd);
    const auto E = matrix<T, M::task_dimension, M::brake_count>(brake_jacobian(mechanism, q));
    const T condition = this->transmission_condition(mechanism, q);
    ASSERT_TRUE(std::isfinite(condition)) << "the transmission has not full column rank";
    const auto J = this->dense_jacobian(mechanism, q);
    ASSERT_LE((E * w - J * qd).norm(), rounding_tolerance<T>(4 * M::dof) * condition * J.norm() * qd.norm());
  }
}

/// Virtual work: torques t = E^T F do at the brakes what F does at the end effector, t . w = F . v.
TYPED_TEST_P(mechanism_properties, brake_torques_do_the_work_of_the_force) {
  using M = typename TypeParam::mechanism;
  using T = typename M::scalar;
  const M mechanism = TypeParam::make();
  random_source random(this->seed);
  for (const joint_vector<M>& q : this->poses()) {
    SCOPED_TRACE(::testing::Message() << "seed " << this->seed << ", q = " << in_a_row(q));
    const joint_vector<M> qd = random.normal_vector<T, M::dof>();
    const task_vector<M> F = random.normal_vector<T, M::task_dimension>();
    const brake_vector<M> w = brake_rates(mechanism, q, qd);
    const brake_vector<M> t = brake_torque(brake_jacobian(mechanism, q), F);
    const auto J = this->dense_jacobian(mechanism, q);
    const T condition = this->transmission_condition(mechanism, q);
    ASSERT_NEAR(t.dot(w), F.dot(J * qd),
                rounding_tolerance<T>(4 * M::dof) * condition * F.norm() * J.norm() * qd.norm());
  }
}

REGISTER_TYPED_TEST_SUITE_P(mechanism_properties, position_is_finite_and_pure,
                            jacobian_is_the_derivative_of_position, given_and_automatic_jacobian_agree,
                            pose_has_the_position_and_jacobian_of_q,
                            brake_jacobian_maps_brake_rates_to_velocity,
                            brake_torques_do_the_work_of_the_force);

}  // namespace passive_haptics::testing
