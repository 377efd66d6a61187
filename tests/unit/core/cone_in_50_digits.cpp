// slow, no sanitizers
// The projection onto a cone against an oracle in 50 digits.
#include "cone_oracle.hpp"
#include "cone_size.hpp"

#include <passive_haptics/core/linear/cone.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace ph = passive_haptics;

namespace {

template <class Size>
struct cone : ::testing::Test {
  using number = typename Size::T;
  static constexpr int R = Size::rows, C = Size::columns;
  using half_spaces = ph::matrix<number, R, C>;
  using force = ph::vector<number, R>;
  static constexpr int trials = C < 6 ? 30 : (C < 7 ? 6 : 2);
  static constexpr double eps = static_cast<double>(std::numeric_limits<number>::epsilon());

  // Feasible to rounding at any condition; as near to the truth as the angle between the active columns
  // allows, or, where rounding may choose other columns, that between any (Hoffman's bound).
  enum class angle { of_active, of_any };
  void check(const half_spaces& B, const force& f, const std::string& what,
             angle between = angle::of_active) {
    SCOPED_TRACE(::testing::Message() << what << "\nB =\n" << B << "\nf = " << f.transpose());
    const auto result = ph::project_onto_half_spaces(B, f);
    const double f_norm = static_cast<double>(f.norm());
    const oracle::column p(result.point.data(), result.point.data() + R);
    for (int j = 0; j < C; ++j) {
      EXPECT_GE(result.coefficients[j], number(0));
      const oracle::column b(B.col(j).data(), B.col(j).data() + R);
      const oracle::real length = oracle::norm(b);
      if (length == 0) {
        EXPECT_EQ(result.coefficients[j], number(0)) << "a zero column restricts nothing";
        continue;
      }
      const double violation = static_cast<double>(oracle::dot(b, p) / length);
      EXPECT_LE(violation, (4 * R + 2) * eps * f_norm) << "half-space " << j;
      EXPECT_TRUE(result.coefficients[j] == number(0) || violation >= -(4 * R + 2) * eps * f_norm)
          << "half-space " << j << " is not active";
    }
    const oracle::projection truth = oracle::project<number, R, C>(B, f);
    oracle::column error = p;
    for (std::size_t i = 0; i < error.size(); ++i) error[i] -= truth.point[i];
    const double distance = static_cast<double>(oracle::norm(error));
    const double spread =
        between == angle::of_active ? 1 / truth.angle : std::sqrt(static_cast<double>(C)) / truth.least_angle;
    EXPECT_LE(distance, (4 * R + 2) * eps * f_norm * (1 + spread)) << "forward error";
  }
};

using sizes = ::testing::Types<size<double, 2, 2>, size<double, 3, 3>, size<double, 2, 3>, size<double, 2, 4>,
                               size<double, 3, 4>, size<double, 4, 4>, size<double, 6, 6>, size<double, 7, 7>,
                               size<float, 2, 2>, size<float, 3, 3>, size<float, 3, 4>,
                               size<long double, 3, 3>, size<long double, 4, 4>>;
TYPED_TEST_SUITE(cone, sizes);

// Draws of Gaussian matrices and vectors.
template <class Fixture>
struct problem {
  typename Fixture::half_spaces B;
  typename Fixture::force f;
};
template <class Fixture>
problem<Fixture> draw(ph::testing::random_source& random) {
  problem<Fixture> p;
  for (int j = 0; j < Fixture::C; ++j)
    p.B.col(j) = random.normal_vector<typename Fixture::number, Fixture::R>();
  p.f = random.direction<typename Fixture::number, Fixture::R>();
  return p;
}

TYPED_TEST(cone, gaussian_half_spaces) {
  ph::testing::random_source random(1);
  for (int k = 0; k < 2 * this->trials; ++k) {
    const auto [B, f] = draw<TestFixture>(random);
    this->check(B, f, "seed 1, trial " + std::to_string(k));
  }
}

TYPED_TEST(cone, half_spaces_of_very_different_units) {
  using T = typename TestFixture::number;
  ph::testing::random_source random(2);
  for (int k = 0; k < this->trials; ++k) {
    auto [B, f] = draw<TestFixture>(random);
    for (int j = 0; j < B.cols(); ++j) B.col(j) *= random.positive(T(1e-8), T(1e8));
    this->check(B, f, "seed 2, trial " + std::to_string(k));
  }
}

// Columns a hair from a common direction, or from its opposite: condition up to 1e15, and past what float
// resolves.
TYPED_TEST(cone, nearly_parallel_and_nearly_opposed_half_spaces) {
  using T = typename TestFixture::number;
  ph::testing::random_source random(3);
  for (const double hair : {1e-2, 1e-5, 1e-8, 1e-10, 1e-13, 1e-15}) {
    for (int k = 0; k < this->trials; ++k) {
      auto [B, f] = draw<TestFixture>(random);
      for (int j = 1; j < B.cols(); ++j) {
        const auto off = static_cast<T>(hair) * B.col(j);
        B.col(j) = (random.coin() ? T(1) : T(-1)) * B.col(0) + typename TestFixture::force(off);
      }
      const std::string what = "seed 3, hair " + std::to_string(hair) + ", trial " + std::to_string(k);
      this->check(B, f, what, TestFixture::angle::of_any);
    }
  }
}

TYPED_TEST(cone, zero_and_repeated_and_dependent_half_spaces) {
  using T = typename TestFixture::number;
  ph::testing::random_source random(4);
  for (int k = 0; k < this->trials; ++k) {
    const std::string trial = "seed 4, trial " + std::to_string(k);
    const auto [B, f] = draw<TestFixture>(random);
    auto changed = B;
    changed.col(1).setZero();
    this->check(changed, f, trial + ", zero");
    changed.setZero();
    this->check(changed, f, trial + ", all zero");
    EXPECT_EQ(ph::project_onto_half_spaces(changed, f).point, f);
    changed = B;
    changed.col(1) = T(4) * B.col(0);
    this->check(changed, f, trial + ", repeated");
    changed.col(1) = T(-4) * B.col(0);
    this->check(changed, f, trial + ", opposed");
    changed = B;
    const int last = static_cast<int>(B.cols()) - 1;
    changed.col(last) = B.col(0) + B.col(1);
    this->check(changed, f, trial + ", dependent");
  }
}

TYPED_TEST(cone, forces_on_a_face_inside_and_in_the_polar_cone) {
  using T = typename TestFixture::number;
  using point = typename TestFixture::force;
  ph::testing::random_source random(5);
  for (int k = 0; k < this->trials; ++k) {
    const std::string trial = "seed 5, trial " + std::to_string(k);
    const auto [B, f] = draw<TestFixture>(random);
    const point inside = ph::project_onto_half_spaces(B, f).point;
    this->check(B, inside, trial + ", its own projection");
    const point b = B.col(0).normalized();
    this->check(B, point(f - f.dot(b) * b), trial + ", on a face");
    point polar = point::Zero();
    for (int j = 0; j < B.cols(); ++j) polar += random.uniform(T(0.1), T(1)) * B.col(j);
    this->check(B, polar, trial + ", polar");
    EXPECT_LE(ph::project_onto_half_spaces(B, polar).point.norm(),
              ph::rounding_tolerance<T>(static_cast<int>(B.size())) * polar.norm())
        << trial;
    EXPECT_TRUE(ph::project_onto_half_spaces(B, point(point::Zero())).point.isZero(T(0)));
    EXPECT_TRUE(ph::project_onto_half_spaces(B, point(point::Zero())).coefficients.isZero(T(0)));
  }
}

// Whatever half-spaces it begins with, the answer is the same to rounding, and its own begin it best. Those
// that f violates are told as they are: other ones would be no start.
TYPED_TEST(cone, any_start_gives_the_same_answer) {
  using T = typename TestFixture::number;
  constexpr unsigned sets = 1u << TestFixture::C;
  ph::testing::random_source random(6);
  for (int k = 0; k < this->trials; ++k) {
    const auto problem = draw<TestFixture>(random);
    const auto& B = problem.B;
    const auto& f = problem.f;
    ph::half_space_start left;
    const auto cold = ph::project_onto_half_spaces(B, f, left);
    const auto begun_with = [&](ph::half_space_set active) {
      ph::half_space_start start{active, left.violated};
      return ph::project_onto_half_spaces(B, f, start);
    };
    SCOPED_TRACE(::testing::Message() << "seed 6, trial " << k << "\nB =\n"
                                      << B << "\nf = " << f.transpose());
    for (int j = 0; j < TestFixture::C; ++j)
      EXPECT_EQ((cold.active >> j & 1u) != 0, cold.coefficients[j] > T(0)) << "half-space " << j;
    const T terms = B.colwise().norm().dot(cold.coefficients.transpose()) + T(1);
    for (unsigned start = 0; start < sets; ++start) {
      ASSERT_LE((begun_with(start).point - cold.point).norm(),
                ph::rounding_tolerance<T>(TestFixture::R) * terms)
          << "start " << start;
    }
    EXPECT_EQ(begun_with(cold.active).active, cold.active);
    EXPECT_EQ(begun_with(cold.active | ~(sets - 1)).active, cold.active) << "there are no such half-spaces";
  }
}

// Those without a closed form.
template <class Size>
struct searched_cone : cone<Size> {};

using searched_sizes =
    ::testing::Types<size<double, 2, 3>, size<double, 3, 4>, size<double, 4, 4>, size<double, 6, 6>,
                     size<double, 7, 7>, size<float, 3, 4>, size<long double, 4, 4>>;
TYPED_TEST_SUITE(searched_cone, searched_sizes);

// Where f violates other half-spaces than it did, the start is forgotten: to the last bit it is as though
// there had been none.
TYPED_TEST(searched_cone, after_a_jump_begins_from_nothing) {
  ph::testing::random_source random(7);
  ph::half_space_start start;
  int jumps = 0;
  for (int k = 0; k < 200; ++k) {
    const auto [B, f] = draw<TestFixture>(random);
    const ph::half_space_set before = start.violated;
    const auto warm = ph::project_onto_half_spaces(B, f, start);
    ph::half_space_set violated = 0;
    for (int j = 0; j < TestFixture::C; ++j) violated |= (B.col(j).dot(f) > 0 ? 1u : 0u) << j;
    ASSERT_EQ(start.active, warm.active) << "seed 7, trial " << k;
    ASSERT_EQ(start.violated, violated) << "seed 7, trial " << k;
    if (violated == before) continue;
    ++jumps;
    const auto cold = ph::project_onto_half_spaces(B, f);
    ASSERT_EQ(warm.point, cold.point) << "seed 7, trial " << k;
    ASSERT_EQ(warm.coefficients, cold.coefficients) << "seed 7, trial " << k;
  }
  EXPECT_GT(jumps, 150);
}

// Forces at distances of 1e-17 to 1 of an edge, conditions to 3e13: where lengths are compared, half of the
// digits are lost there.
TEST(cone_in_the_plane, is_exact_to_rounding_however_near_an_edge) {
  using force = ph::vector<double, 2>;
  constexpr std::uint64_t seed = 20040627;
  ph::testing::random_source random(seed);
  SCOPED_TRACE(::testing::Message() << "seed " << seed);
  for (int k = 0; k < 20000; ++k) {
    const double a = random.uniform(-3.0, 3.0), angle = random.positive(4e-14, 1.0);
    ph::matrix<double, 2, 2> B;
    B.col(0) = random.positive(0.01, 100.0) * force(std::cos(a), std::sin(a));
    B.col(1) = force(std::cos(a), std::sin(a)) +
               random.uniform(-1.0, 1.0) * angle * force(-std::sin(a), std::cos(a));
    const double area = std::abs(ph::cross_in_plane<double>(B.col(0), B.col(1)));
    if (area < 3e-14 * B.col(0).norm() * B.col(1).norm()) continue;
    for (int j = 0; j < 2; ++j)
      if (random.uniform(-1.0, 1.0) < 0) B.col(j) = -B.col(j);
    const force n = B.col(k % 2).normalized();
    const double off = random.positive(1e-17, 1.0);
    const force f =
        ((random.uniform(-1.0, 1.0) < 0 ? -1.0 : 1.0) * force(-n[1], n[0]) + off * n).normalized();
    const auto truth = oracle::project<double, 2, 2>(B, f);
    const auto result = ph::project_onto_half_spaces(B, f);
    const oracle::column error{result.point[0] - truth.point[0], result.point[1] - truth.point[1]};
    ASSERT_LE(static_cast<double>(oracle::norm(error)), 1e-15) << "B =\n" << B << "\nf = " << f.transpose();
  }
}

}  // namespace
