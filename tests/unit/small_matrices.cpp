// What the property suites ask of a matrix, against matrices made for a known answer.
#include <passive_haptics/testing/support/random.hpp>
#include <passive_haptics/testing/support/small_matrices.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace ph = passive_haptics;
using namespace ph::testing;

namespace {

constexpr unsigned seed = 20040627;

// U diag(1 ... 1 / condition) V^T
template <int R, int C>
ph::matrix<double, R, C> of_condition(double condition, random_source& random) {
  const auto U = random.orthogonal_directions<R, C>();
  const auto V = random.orthogonal_directions<C>();
  ph::matrix<double, R, C> A = ph::matrix<double, R, C>::Zero();
  for (int k = 0; k < C; ++k) {
    const double size = std::pow(condition, -static_cast<double>(k) / (C - 1));
    for (int i = 0; i < R; ++i) {
      for (int j = 0; j < C; ++j) A(i, j) += size * U(i, k) * V(j, k);
    }
  }
  return A;
}

template <int R, int C>
void expect_condition(random_source& random) {
  for (const double condition : {1.0, 3.0, 1e3, 1e6}) {
    const auto A = of_condition<R, C>(condition, random);
    EXPECT_NEAR(condition_of(small_matrix(A)) / condition, 1, 1e-14 * condition) << A;
  }
}

TEST(small_matrices, have_the_condition_that_they_were_made_with) {
  random_source random(seed);
  for (int k = 0; k < 100; ++k) {
    expect_condition<2, 2>(random);
    expect_condition<3, 3>(random);
    expect_condition<4, 2>(random);
    expect_condition<7, 7>(random);
  }
}

TEST(small_matrices, without_full_rank_have_no_finite_condition) {
  using square = ph::matrix<double, 2, 2>;
  EXPECT_GE(condition_of(small_matrix(square{{1, 2}, {2, 4}})), 1e15);
  EXPECT_FALSE(std::isfinite(condition_of(small_matrix(square{{1, 0}, {2, 0}}))));
  EXPECT_FALSE(std::isfinite(condition_of(small_matrix(square{{0, 0}, {0, 0}}))));
  EXPECT_FALSE(std::isfinite(condition_of(small_matrix(square{{1, std::nan("")}, {0, 1}}))));
}

template <int R, int C>
void expect_solution(random_source& random) {
  const auto A = of_condition<R, C>(100, random);
  const ph::vector<double, C> x = random.normal_vector<double, C>();
  const std::vector<double> found = solution_of(small_matrix(A), small_matrix(ph::vector<double, R>(A * x)));
  for (int j = 0; j < C; ++j) EXPECT_NEAR(found[static_cast<std::size_t>(j)], x[j], 1e-12 * x.norm());
}

TEST(small_matrices, give_back_what_they_were_multiplied_with) {
  random_source random(seed);
  for (int k = 0; k < 100; ++k) {
    expect_solution<2, 2>(random);
    expect_solution<3, 3>(random);
    expect_solution<4, 2>(random);
  }
  using square = ph::matrix<double, 2, 2>;
  const ph::vector<double, 2> b(3, 4);
  EXPECT_EQ(solution_of(small_matrix(square{{0, 1}, {2, 0}}), small_matrix(b)), (std::vector<double>{2, 3}));
}

}  // namespace
