// Packs: of each state what the arithmetic of single numbers gives, and choices that no branch makes.
#include <passive_haptics/core/finite.hpp>
#include <passive_haptics/core/linear/lane_products.hpp>
#include <passive_haptics/core/scalar/pack_sine_cosine.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace ph = passive_haptics;

namespace {

constexpr int width = ph::native_pack_width<double>;
using pack = ph::pack<double, width>;
using mask = ph::pack_mask<double, width>;
using limits = std::numeric_limits<double>;

static_assert(std::is_same_v<ph::number_of<pack>, double> && std::is_same_v<ph::number_of<double>, double>);
static_assert(std::is_same_v<ph::truth_of<pack>, mask> && std::is_same_v<ph::truth_of<double>, bool>);
static_assert(sizeof(pack) == width * sizeof(double));

constexpr std::array<double, 9> values{0,
                                       -0.0,
                                       1.5,
                                       -2.25,
                                       limits::denorm_min(),
                                       1e300,
                                       limits::infinity(),
                                       -limits::infinity(),
                                       limits::quiet_NaN()};

bool is_same(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
}

// Calls f(x, y) for packs of all pairs of values.
template <class F>
void for_each_pair(F&& f) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t j = 0; j < values.size(); ++j) {
      std::array<double, width> x, y;
      for (std::size_t k = 0; k < width; ++k) {
        x[k] = values[(i + k) % values.size()];
        y[k] = values[(j + 2 * k) % values.size()];
      }
      f(pack::load(x.data()), pack::load(y.data()));
    }
  }
}

TEST(packs, have_the_arithmetic_of_each_number) {
  for_each_pair([](pack x, pack y) {
    for (int k = 0; k < width; ++k) {
      EXPECT_TRUE(is_same((x + y)[k], x[k] + y[k]));
      EXPECT_TRUE(is_same((x - y)[k], x[k] - y[k]));
      EXPECT_TRUE(is_same((x * y)[k], x[k] * y[k]));
      EXPECT_TRUE(is_same((x / y)[k], x[k] / y[k]));
      EXPECT_TRUE(is_same((-x)[k], -x[k]));
      EXPECT_TRUE(is_same(abs(x)[k], std::abs(x[k])));
      EXPECT_TRUE(is_same(sqrt(x)[k], std::sqrt(x[k])));
      EXPECT_TRUE(is_same(copysign(x, y)[k], std::copysign(x[k], y[k])));
      EXPECT_TRUE(is_same(min(x, y)[k], y[k] < x[k] ? y[k] : x[k]));
      EXPECT_TRUE(is_same(max(x, y)[k], x[k] < y[k] ? y[k] : x[k]));
    }
  });
}

TEST(packs, compare_and_choose_for_each_state) {
  enum class colour { red, green };
  for_each_pair([](pack x, pack y) {
    for (int k = 0; k < width; ++k) {
      EXPECT_EQ((x < y)[k], x[k] < y[k]);
      EXPECT_EQ((x <= y)[k], x[k] <= y[k]);
      EXPECT_EQ((x > y)[k], x[k] > y[k]);
      EXPECT_EQ((x >= y)[k], x[k] >= y[k]);
      EXPECT_EQ((x == y)[k], x[k] == y[k]);
      EXPECT_EQ((x != y)[k], x[k] != y[k]);
      EXPECT_EQ((!(x < y))[k], !(x[k] < y[k]));
      EXPECT_EQ(((x < y) & (x > pack(0)))[k], x[k] < y[k] && x[k] > 0);
      EXPECT_EQ(((x < y) | (x > pack(0)))[k], x[k] < y[k] || x[k] > 0);
      EXPECT_TRUE(is_same(select(x < y, x, 3.0)[k], x[k] < y[k] ? x[k] : 3));
      EXPECT_EQ(select(x < y, colour::red, colour::green)[k], x[k] < y[k] ? colour::red : colour::green);
      EXPECT_EQ((select(x < y, colour::red, colour::green) == colour::red)[k], x[k] < y[k]);
      EXPECT_EQ(select(x<y, x> pack(0), false)[k], x[k] < y[k] && x[k] > 0);
      EXPECT_EQ(all_finite(x, y)[k], std::isfinite(x[k]) && std::isfinite(y[k]));
    }
  });
}

TEST(packs, are_none_where_no_state_is) {
  EXPECT_TRUE(none(mask(false)));
  EXPECT_FALSE(none(mask(true)));
  for (int k = 0; k < width; ++k) {
    pack x = 0;
    x.v[k] = 1;
    EXPECT_FALSE(none(x > pack(0)));
    EXPECT_TRUE(none(x > pack(1)));
  }
}

TEST(packs, repeat_a_number_with_its_sign) {
  for (const double x : values)
    for (int k = 0; k < width; ++k) EXPECT_TRUE(is_same(pack(x)[k], x));
}

// Angles of a few turns, of a thousand, and beyond 1e5 rad in some states: pairs as of single angles
TEST(packs, have_the_sines_of_single_angles) {
  ph::testing::random_source random(1);
  for (int n = 0; n < 4000; ++n) {
    pack x, y;
    const double scale = n % 4 == 0 ? 1e6 : n % 4 == 1 ? 1e3 : 4;
    for (int k = 0; k < width; ++k) {
      x.v[k] = random.uniform(-scale, scale);
      y.v[k] = random.coin() ? random.uniform(-4.0, 4.0) : random.uniform(-scale, scale);
    }
    if (n % 50 == 0) y.v[n / 50 % width] = values[std::size_t(n / 50) % values.size()];
    const auto [first, second] = ph::sine_cosine(x, y);
    for (int k = 0; k < width; ++k) {
      const auto [a, b] = ph::sine_cosine(x[k], y[k]);
#if defined(__FMA__) || defined(__aarch64__)
      const auto agree = [](double p, double q) { return is_same(p, q) || std::abs(p - q) < 1e-15; };
#else
      const auto agree = is_same;
#endif
      EXPECT_TRUE(agree(first.sine[k], a.sine) && agree(first.cosine[k], a.cosine)) << x[k];
      EXPECT_TRUE(agree(second.sine[k], b.sine) && agree(second.cosine[k], b.cosine)) << y[k];
    }
  }
}

// Lanes and matrices of packs: the products of each state
TEST(packs, are_a_scalar_of_lanes_and_matrices) {
  ph::testing::random_source random(2);
  ph::matrix<pack, 2, 2> A;
  ph::vector<pack, 2> x;
  for (int k = 0; k < width; ++k) {
    for (int i = 0; i < 4; ++i) A(i / 2, i % 2).v[k] = random.uniform(-1.0, 1.0);
    for (int i = 0; i < 2; ++i) x[i].v[k] = random.uniform(-1.0, 1.0);
  }
  const auto Ax = ph::times(A, x), ATx = ph::transposed_times(A, x);
  const ph::lanes<pack, 2> l = x;
  for (int k = 0; k < width; ++k) {
    const ph::matrix<double, 2, 2> Ak{{A(0, 0)[k], A(0, 1)[k]}, {A(1, 0)[k], A(1, 1)[k]}};
    const ph::vector<double, 2> xk(x[0][k], x[1][k]);
    EXPECT_NEAR(Ax[0][k], ph::times(Ak, xk)[0], 1e-15);
    EXPECT_NEAR(ATx[1][k], ph::transposed_times(Ak, xk)[1], 1e-15);
    EXPECT_NEAR(x.dot(x)[k], xk.dot(xk), 1e-15);
    EXPECT_EQ(any(l > ph::lanes<pack, 2>(0.0))[k], xk.maxCoeff() > 0);
    EXPECT_EQ(sgn(l)[1][k], ph::sgn(xk[1]));
    EXPECT_EQ(swapped(l)[0][k], xk[1]);
    EXPECT_EQ(least(l)[k], xk.minCoeff());
  }
}

}  // namespace
