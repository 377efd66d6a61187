/// The laws of the nearest displayable force as a GoogleTest suite for any mechanism.
///
/// The case is that of mechanism_properties.hpp. With the cone C of displayable forces, B = [s_i E e_i] and F
/// = Fp + B mu (Moreau). Bounds are rounding of the terms |b_i| mu_i.
#pragma once

#include <passive_haptics/core/linear/cone.hpp>
#include <passive_haptics/force/nearest_force.hpp>
#include <passive_haptics/testing/support/step_samples.hpp>

#include <gtest/gtest.h>

namespace passive_haptics::testing {

/// Suite of the nearest force.
template <class Case>
class projection_properties : public ::testing::Test {
 protected:
  using model = typename Case::mechanism;                          ///< The mechanism.
  using number = typename model::scalar;                           ///< Its scalar.
  static constexpr unsigned seed = 20040627;                       ///< Seed of the samples.
  static constexpr int each = model::brake_count <= 2 ? 300 : 40;  ///< Samples per sign pattern.
  static constexpr number tolerance =
      rounding_tolerance<number>(4 * model::task_dimension);  ///< For a unit force.
  using half_spaces = brake_matrix<model>;                    ///< B
  using force = task_vector<model>;                           ///< F

  /// Sum of |b_i| mu_i, the terms that add up to F - Fp.
  static number terms(const half_spaces& B, const brake_vector<model>& mu) {
    return B.colwise().norm().dot(mu.transpose());
  }

  /// visit(B, F) for unit forces F and every sign pattern.
  template <class Visit>
  static void for_each_problem(Visit&& visit) {
    const model mechanism = Case::make();
    random_source random(seed);
    for_each_sign_pattern<model::brake_count>([&](const auto& signs) {
      const brake_vector<model> s =
          vector<int, model::brake_count>::Map(signs.data()).template cast<number>();
      for (int k = 0; k < each; ++k) {
        if (::testing::Test::HasFatalFailure()) return;
        const joint_vector<model> q = random.between<number, model::dof>(Case::lower(), Case::upper());
        const half_spaces B = dense_brake_jacobian(mechanism, q) * s.asDiagonal();
        const force F = random.direction<number, model::task_dimension>();
        SCOPED_TRACE(::testing::Message() << "seed " << seed << ", q = " << q.transpose()
                                          << ", s = " << s.transpose() << ", F = " << F.transpose());
        visit(B, F);
      }
    });
  }
};

TYPED_TEST_SUITE_P(projection_properties);

/// Fp is in C: B^T Fp <= 0 to rounding of each product, and mu >= 0.
TYPED_TEST_P(projection_properties, nearest_force_is_displayable) {
  this->for_each_problem([&](const auto& B, const auto& F) {
    const auto p = project_onto_half_spaces(B, F);
    for (int i = 0; i < B.cols(); ++i) {
      ASSERT_LE(B.col(i).dot(p.point), this->tolerance * B.col(i).norm()) << "brake " << i;
      ASSERT_GE(p.coefficients[i], 0) << "brake " << i;
    }
  });
}

/// F = Fp + B mu with Fp . B mu = 0, so that Fp . F = |Fp|^2.
TYPED_TEST_P(projection_properties, force_splits_into_orthogonal_parts) {
  this->for_each_problem([&](const auto& B, const auto& F) {
    const auto p = project_onto_half_spaces(B, F);
    ASSERT_LE((F - p.point - B * p.coefficients).norm(),
              this->tolerance * (1 + this->terms(B, p.coefficients)));
    ASSERT_NEAR(p.point.dot(F), p.point.squaredNorm(), this->tolerance);
  });
}

/// The residual is in the polar cone: (F - Fp) . x <= 0 for every x in C.
TYPED_TEST_P(projection_properties, residual_is_in_the_polar_cone) {
  using T = typename TestFixture::number;
  random_source random(this->seed + 1);
  this->for_each_problem([&](const auto& B, const auto& F) {
    const auto p = project_onto_half_spaces(B, F);
    const auto x = project_onto_half_spaces(
        B, typename TestFixture::force(random.direction<T, TestFixture::model::task_dimension>()));
    ASSERT_LE((F - p.point).dot(x.point), this->tolerance * (1 + this->terms(B, p.coefficients)));
  });
}

/// A displayable force is its own nearest force.
TYPED_TEST_P(projection_properties, projection_is_idempotent) {
  this->for_each_problem([&](const auto& B, const auto& F) {
    const auto once = project_onto_half_spaces(B, F);
    const auto twice = project_onto_half_spaces(B, once.point);
    // |Fp - PFp|^2 = Fp . B mu, and Fp violates B^T Fp <= 0 by rounding
    ASSERT_LE((once.point - twice.point).squaredNorm(),
              this->tolerance * (this->tolerance + this->terms(B, twice.coefficients)));
  });
}

/// Positive homogeneity; scaling by powers of two is exact.
TYPED_TEST_P(projection_properties, projection_is_positively_homogeneous) {
  using T = typename TestFixture::number;
  this->for_each_problem([&](const auto& B, const auto& F) {
    const auto p = project_onto_half_spaces(B, F);
    for (const T a : {T(0.25), T(2), T(1024)}) {
      ASSERT_EQ(project_onto_half_spaces(B, typename TestFixture::force(a * F)).point, a * p.point)
          << "a = " << a;
    }
    const auto thrice = project_onto_half_spaces(B, typename TestFixture::force(T(3) * F));
    ASSERT_LE((thrice.point - T(3) * p.point).norm(),
              3 * this->tolerance * (1 + this->terms(B, p.coefficients)));
  });
}

/// nearest_force is this projection for the mechanism's E, dense or diagonal; it is F if all s_i = 0.
TYPED_TEST_P(projection_properties, nearest_force_is_the_projection) {
  using T = typename TestFixture::number;
  using M = typename TestFixture::model;
  const M mechanism = TypeParam::make();
  for_each_sample<TypeParam>(mechanism, this->seed, 20, [&](const step_sample<M>& sample) {
    if (this->HasFatalFailure()) return;
    const auto E = passive_haptics::brake_jacobian(mechanism, sample.state.q);
    const brake_vector<M> w = passive_haptics::brake_rates(mechanism, sample.state.q, sample.state.qd);
    const brake_vector<M> s = brake_signs(w, brake_vector<M>(brake_vector<M>::Zero()), sample.brakes);
    const task_vector<M> F = sample.wall().normal.template cast<T>();
    const auto nearest = nearest_force(E, s, F);
    const typename TestFixture::half_spaces B =
        dense_brake_jacobian(mechanism, sample.state.q) * s.asDiagonal();
    const auto p = project_onto_half_spaces(B, F);
    ASSERT_LE((nearest.force - p.point).norm(), this->tolerance * (1 + this->terms(B, p.coefficients)));
    for (int i = 0; i < M::brake_count; ++i) {
      ASSERT_FALSE(s[i] == T(0) && (nearest.active >> i & 1u) != 0) << "brake " << i << " restricts nothing";
    }
    ASSERT_EQ(nearest_force(E, brake_vector<M>(brake_vector<M>::Zero()), F).force, F);
  });
}

REGISTER_TYPED_TEST_SUITE_P(projection_properties, nearest_force_is_displayable,
                            force_splits_into_orthogonal_parts, residual_is_in_the_polar_cone,
                            projection_is_idempotent, projection_is_positively_homogeneous,
                            nearest_force_is_the_projection);

}  // namespace passive_haptics::testing
