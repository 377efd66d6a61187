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

/// Suite of a shape's laws.
template <class Case>
class shape_properties : public ::testing::Test {
 protected:
  using shape_type = typename Case::shape;  ///< The shape.
  static_assert(Shape<shape_type>,
                "passive_haptics: shape_properties needs a model of Shape (scene/shape.hpp).");

  static constexpr int point_count = 1000;    ///< Number of tested points.
  static constexpr unsigned seed = 20040627;  ///< Seed of the points.

  static constexpr int dimension = shape_type::dimension;  ///< d
  const shape_type shape = Case::make();                   ///< The shape under test.

  /// visit(x, random) for random points of the box.
  template <class Visit>
  void for_each_point(Visit&& visit) const {
    random_source random(seed);
    for (int k = 0; k < point_count && !::testing::Test::HasFatalFailure(); ++k) {
      const point<dimension> x = random.between<double, dimension>(Case::lower(), Case::upper());
      SCOPED_TRACE(::testing::Message() << "seed " << seed << ", x = " << x.transpose());
      visit(x, random);
    }
  }

  /// Size of the coordinates [m].
  static double size() { return Case::lower().norm() + Case::upper().norm() + 1; }
  /// Rounding of a distance between points of the box [m].
  static double rounding() { return rounding_tolerance<double>(dimension) * size(); }
  /// Step of the differences [m], limited by the box.
  static double step() {
    return difference_step<double>() * std::min(1.0, (Case::upper() - Case::lower()).minCoeff() / 8);
  }
};

TYPED_TEST_SUITE_P(shape_properties);

/// |distance(x) - distance(y)| <= |x - y|, for distant and nearby points.
TYPED_TEST_P(shape_properties, distance_is_1_lipschitz) {
  constexpr int d = TestFixture::dimension;
  this->for_each_point([&](const point<d>& x, random_source& random) {
    const point<d> close_by = x + random.positive(1e-9, 1e-1) * random.direction<double, d>();
    const point<d> far_off = random.between<double, d>(TypeParam::lower(), TypeParam::upper());
    for (const point<d>& y : {far_off, close_by}) {
      ASSERT_LE(std::abs(this->shape.distance(x) - this->shape.distance(y)),
                (x - y).norm() + this->rounding())
          << "y = " << y.transpose();
    }
  });
}

/// The gradient is a unit vector.
TYPED_TEST_P(shape_properties, gradient_is_a_unit_vector) {
  this->for_each_point([&](const auto& x, auto&) {
    ASSERT_NEAR(this->shape.gradient(x).norm(), 1, rounding_tolerance<double>(this->dimension));
  });
}

/// The gradient is the derivative of the distance along each axis. Points at which differences with two steps
/// disagree, because of a kink between them, are left out; at most one in ten.
TYPED_TEST_P(shape_properties, gradient_is_the_derivative_of_distance) {
  constexpr int d = TestFixture::dimension;
  const double h = this->step();
  const double tolerance = 64 * difference_accuracy<double>() * difference_step<double>() / h * this->size();
  int smooth = 0;
  this->for_each_point([&](const point<d>& x, auto&) {
    for (int i = 0; i < d; ++i) {
      const auto along = [&](double s) { return this->shape.distance(x + s * point<d>::Unit(i)); };
      const double slope = central_difference(along, h);
      if (std::abs(slope - central_difference(along, h / 2)) > tolerance) continue;
      ++smooth;
      ASSERT_NEAR(this->shape.gradient(x)[i], slope, 2 * tolerance) << "axis " << i;
    }
  });
  ASSERT_GE(smooth, this->point_count * d * 9 / 10);
}

/// An optional Hessian is the derivative of the gradient, symmetric, with the gradient in its null space.
/// Points at which differences with two steps disagree are left out.
TYPED_TEST_P(shape_properties, hessian_is_the_derivative_of_the_gradient) {
  constexpr int d = TestFixture::dimension;
  if constexpr (CurvedShape<typename TypeParam::shape>) {
    const double h = this->step();
    int smooth = 0;
    this->for_each_point([&](const point<d>& x, auto&) {
      const matrix<double, d, d> H = this->shape.hessian(x);
      const double tolerance = 1e-6 * (1 + H.norm());
      const double rounding = this->rounding() * (1 + H.norm());
      ASSERT_LE((H * this->shape.gradient(x)).norm(), rounding);
      ASSERT_LE((H - H.transpose()).norm(), rounding);
      for (int i = 0; i < d; ++i) {
        const auto along = [&](double s) { return this->shape.gradient(x + s * point<d>::Unit(i)); };
        const point<d> change = central_difference(along, h);
        if ((change - central_difference(along, h / 2)).norm() > tolerance) continue;
        ++smooth;
        ASSERT_LE((H.col(i) - change).norm(), 2 * tolerance) << "axis " << i;
      }
    });
    ASSERT_GE(smooth, this->point_count * d * 8 / 10);
  }
}

REGISTER_TYPED_TEST_SUITE_P(shape_properties, distance_is_1_lipschitz, gradient_is_a_unit_vector,
                            gradient_is_the_derivative_of_distance,
                            hessian_is_the_derivative_of_the_gradient);

}  // namespace passive_haptics::testing
