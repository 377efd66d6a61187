/// @file
/// The laws of the Shape concept as a GoogleTest suite for any model.
///
///     struct my_case {
///       using shape = my_shape;
///       static shape make() { return shape(...); }
///       static ph::point<2> lower() { return {-1, -1}; }  // a box of points to try [m]
///       static ph::point<2> upper() { return {1, 1}; }
///     };
///     using namespace passive_haptics::testing;
///     INSTANTIATE_TYPED_TEST_SUITE_P(my_shape, shape_properties, my_case);
#pragma once

#include <passive_haptics/scene/shape.hpp>
#include <passive_haptics/testing/support/derivative.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace passive_haptics::testing {

/// Suite of a shape's laws; Case as described at the top of this file.
template <class Case>
class shape_properties : public ::testing::Test {
 protected:
  using shape_type = typename Case::shape;  ///< The shape.
  static_assert(Shape<shape_type>,
                "passive_haptics: shape_properties needs a model of Shape (scene/shape.hpp).");

  static constexpr int point_count = 1000;    ///< Points that are tried.
  static constexpr unsigned seed = 20040627;  ///< Of the points.

  /// A random point of the box.
  static point<shape_type::dimension> draw(random_source& random) {
    return random.between<double, shape_type::dimension>(Case::lower(), Case::upper());
  }

  /// Size of the coordinates [m].
  static double size() { return Case::lower().norm() + Case::upper().norm() + 1; }
  /// Rounding of a distance between points of the box [m].
  static double rounding() { return rounding_tolerance<double>(shape_type::dimension) * size(); }
};

TYPED_TEST_SUITE_P(shape_properties);

/// |distance(x) - distance(y)| <= |x - y|, for far and for near points.
TYPED_TEST_P(shape_properties, distance_is_1_lipschitz) {
  using S = typename TypeParam::shape;
  const S shape = TypeParam::make();
  random_source random(this->seed);
  for (int k = 0; k < this->point_count; ++k) {
    const point<S::dimension> x = this->draw(random);
    const point<S::dimension> near =
        x + random.positive(1e-9, 1e-1) * random.direction<double, S::dimension>();
    for (const point<S::dimension>& y : {this->draw(random), near}) {
      ASSERT_LE(std::abs(shape.distance(x) - shape.distance(y)), (x - y).norm() + this->rounding())
          << "seed " << this->seed << ", x = " << x.transpose() << ", y = " << y.transpose();
    }
  }
}

/// The gradient is a unit vector.
TYPED_TEST_P(shape_properties, gradient_is_a_unit_vector) {
  using S = typename TypeParam::shape;
  const S shape = TypeParam::make();
  random_source random(this->seed);
  for (int k = 0; k < this->point_count; ++k) {
    const point<S::dimension> x = this->draw(random);
    ASSERT_NEAR(shape.gradient(x).norm(), 1, rounding_tolerance<double>(S::dimension))
        << "seed " << this->seed << ", x = " << x.transpose();
  }
}

/// The gradient is the derivative of the distance, along every axis. Points where differences with two steps
/// disagree are left out (a kink lies between them); that may be one in ten.
TYPED_TEST_P(shape_properties, gradient_is_the_derivative_of_distance) {
  using S = typename TypeParam::shape;
  const S shape = TypeParam::make();
  random_source random(this->seed);
  const double h =
      difference_step<double>() * std::min(1.0, (TypeParam::upper() - TypeParam::lower()).minCoeff() / 8);
  const double tolerance = 64 * difference_accuracy<double>() * difference_step<double>() / h * this->size();
  int smooth = 0;
  for (int k = 0; k < this->point_count; ++k) {
    const point<S::dimension> x = this->draw(random);
    SCOPED_TRACE(::testing::Message() << "seed " << this->seed << ", x = " << x.transpose());
    for (int i = 0; i < S::dimension; ++i) {
      const auto along = [&](double s) { return shape.distance(x + s * point<S::dimension>::Unit(i)); };
      const double slope = central_difference(along, h);
      if (std::abs(slope - central_difference(along, h / 2)) > tolerance) continue;
      ++smooth;
      ASSERT_NEAR(shape.gradient(x)[i], slope, 2 * tolerance) << "axis " << i;
    }
  }
  ASSERT_GE(smooth, this->point_count * S::dimension * 9 / 10);
}

/// The Hessian of a shape that tells it is the derivative of the gradient, and leaves the gradient alone.
/// Points where differences with two steps disagree are left out.
TYPED_TEST_P(shape_properties, hessian_is_the_derivative_of_the_gradient) {
  using S = typename TypeParam::shape;
  if constexpr (CurvedShape<S>) {
    const S shape = TypeParam::make();
    random_source random(this->seed);
    const double h =
        difference_step<double>() * std::min(1.0, (TypeParam::upper() - TypeParam::lower()).minCoeff() / 8);
    int smooth = 0;
    for (int k = 0; k < this->point_count; ++k) {
      const point<S::dimension> x = this->draw(random);
      SCOPED_TRACE(::testing::Message() << "seed " << this->seed << ", x = " << x.transpose());
      const matrix<double, S::dimension, S::dimension> H = shape.hessian(x);
      const double tolerance = 1e-6 * (1 + H.norm());
      ASSERT_LE((H * shape.gradient(x)).norm(), rounding_tolerance<double>(S::dimension) * (1 + H.norm()));
      for (int i = 0; i < S::dimension; ++i) {
        const auto along = [&](double s) { return shape.gradient(x + s * point<S::dimension>::Unit(i)); };
        const point<S::dimension> turning = central_difference(along, h);
        if ((turning - central_difference(along, h / 2)).norm() > tolerance) continue;
        ++smooth;
        ASSERT_LE((H.col(i) - turning).norm(), 2 * tolerance) << "axis " << i;
      }
    }
    ASSERT_GE(smooth, this->point_count * S::dimension * 8 / 10);
  }
}

REGISTER_TYPED_TEST_SUITE_P(shape_properties, distance_is_1_lipschitz, gradient_is_a_unit_vector,
                            gradient_is_the_derivative_of_distance,
                            hessian_is_the_derivative_of_the_gradient);

}  // namespace passive_haptics::testing
