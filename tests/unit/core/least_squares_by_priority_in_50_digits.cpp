// slow, optimised, no sanitizers
// Least squares with priorities and bounds in closed form, against every face of the box in 50 digits.
#include "../force/priorities_oracle.hpp"

#include <passive_haptics/core/linear/least_squares_by_priority.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace ph = passive_haptics;

namespace {

using real =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
constexpr unsigned seed = 20040627;
constexpr double infinity = std::numeric_limits<double>::infinity();

template <int N>
struct problem {
  ph::vector<double, N> lower, upper;
  ph::least_squares_level<double, 3, N> first, second;
  ph::least_squares_level<double, N, N> last;
};

template <int Rows, int N>
oracle::level<real> exactly(const ph::least_squares_level<double, Rows, N>& level) {
  oracle::level<real> wide;
  for (int i = 0; i < Rows; ++i) {
    wide.rows.emplace_back();
    for (int j = 0; j < N; ++j) wide.rows.back().push_back(level.A(i, j));
    wide.targets.push_back(level.b[i]);
  }
  return wide;
}

// Levels of any rank: rows may be 0, repeat one of this level or the one before, or oppose it.
template <int N>
problem<N> draw(ph::testing::random_source& random) {
  problem<N> p;
  for (int i = 0; i < N; ++i) {
    p.lower[i] = random.coin() ? 0 : (random.coin() ? -infinity : -random.positive(0.1, 2.0));
    p.upper[i] = random.coin() && p.lower[i] < 0 ? 0 : (random.coin() ? infinity : random.positive(0.1, 2.0));
    if (random.uniform(0.0, 1.0) < 0.05) p.lower[i] = p.upper[i] = random.uniform(-1.0, 1.0);
  }
  ph::matrix<double, 6, N> rows;
  for (int i = 0; i < 6; ++i) {
    const double kind = random.uniform(0.0, 1.0);
    rows.row(i) = random.normal_vector<double, N>().transpose();
    if (kind < 0.3) rows.row(i).setZero();
    else if (kind < 0.5 && i > 0) rows.row(i) = (random.coin() ? -2 : 0.5) * rows.row(i - 1);
    (i < 3 ? p.first : p.second).A.row(i % 3) = rows.row(i);
    (i < 3 ? p.first : p.second).b[i % 3] = random.wide(0.01, 100.0);
  }
  p.last.A = random.positive(0.1, 10.0) * ph::identity_matrix<double, N>();
  if (random.coin()) p.last.b = random.normal_vector<double, N>();
  return p;
}

// |A x - b| of each level beyond the least, by the size of the terms of the levels so far.
template <int N>
std::array<double, 3> excess(const problem<N>& p, const ph::vector<double, N>& x) {
  const std::vector<oracle::level<real>> levels{exactly(p.first), exactly(p.second), exactly(p.last)};
  oracle::list<real> lower, upper, found;
  for (int i = 0; i < N; ++i) {
    lower.push_back(p.lower[i]);
    upper.push_back(p.upper[i]);
    found.push_back(x[i]);
  }
  const auto best = oracle::solve_by_faces<real>(levels, lower, upper, real(1e-30));
  const auto least = oracle::costs(levels, best), costs = oracle::costs(levels, found);
  const double size[] = {p.first.A.norm() * x.norm() + p.first.b.norm(),
                         p.second.A.norm() * x.norm() + p.second.b.norm(),
                         p.last.A.norm() * x.norm() + p.last.b.norm()};
  std::array<double, 3> more{};
  double terms = 0;
  for (std::size_t l = 0; l < 3; ++l) {
    terms = std::max(terms, size[l]);
    if (terms > 0) more[l] = static_cast<double>(costs[l] - least[l]) / terms;
  }
  return more;
}

// The first row of the first level is not 0, the second nearly twice that.
template <int N>
void make_nearly_parallel(problem<N>& p, double apart, ph::testing::random_source& random) {
  const ph::vector<double, N> a = random.direction<double, N>(), d = random.direction<double, N>();
  p.first.A.row(0) = a.transpose();
  p.first.A.row(1) = (2 * a + apart * (d - d.dot(a) * a).normalized()).transpose();
}

// `most` of the excess of the first level, and of the later ones.
template <int N>
void expect_best(int cases, double apart, std::array<double, 2> most) {
  ph::testing::random_source random(seed);
  double worst[2] = {0, 0};
  int held = 0;
  for (int k = 0; k < cases; ++k) {
    SCOPED_TRACE(::testing::Message() << "N = " << N << ", seed " << seed << ", case " << k);
    auto p = draw<N>(random);
    if (apart > 0) make_nearly_parallel(p, apart, random);
    const ph::vector<double, N> x =
        ph::least_squares_by_priority(p.lower, p.upper, p.first, p.second, p.last);
    ASSERT_TRUE((x.array() >= p.lower.array() && x.array() <= p.upper.array()).all());
    const auto more = excess(p, x);
    worst[0] = std::max(worst[0], more[0]);
    worst[1] = std::max({worst[1], more[1], more[2]});
    ASSERT_LE(more[0], most[0]);
    ASSERT_LE(std::max(more[1], more[2]), most[1]);
    held += (x.array() == p.lower.array() || x.array() == p.upper.array()).any();
  }
  std::printf(
      "N = %d, rows %g apart: %d cases, %d at a bound, first level %.1e over the least, others %.1e\n", N,
      apart, cases, held, worst[0], worst[1]);
  EXPECT_GT(held, cases / 3);
}

}  // namespace

TEST(least_squares_by_priority, is_the_best_of_all_faces_in_50_digits) {
  expect_best<2>(2000, 0, {1e-14, 1e-14});
  expect_best<4>(200, 0, {1e-14, 1e-13});
}

TEST(least_squares_by_priority, of_rows_that_are_nearly_parallel) {
  for (const double apart : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    expect_best<2>(300, apart, {1e-14, 1e-14 / apart});
  }
}
