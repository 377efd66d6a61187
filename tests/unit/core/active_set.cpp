// The active set by hand: its starts, its sets, and the decomposition that it updates.
#include <passive_haptics/core/linear/active_set.hpp>
#include <passive_haptics/core/linear/cone.hpp>
#include <passive_haptics/core/linear/updatable_qr.hpp>

#include "nearest_point.hpp"

#include <Eigen/LU>

#include <limits>

namespace {

// Let anyone leave but the first that would become negative on the way, and half-spaces take turns for ever.
TEST(active_set, lets_the_first_leave_that_is_in_the_way) {
  const ph::matrix<double, 6, 9> B{{1, 1, -2, 2, -1, -2, -2, 0, -1}, {-2, -1, 0, 2, 2, -1, -1, -2, 2},
                                   {2, 2, 2, -2, 2, -2, -2, 2, -1},  {2, 1, -1, 1, -2, 2, 2, -1, 0},
                                   {1, -2, 2, 2, -1, -2, 0, -1, -2}, {0, 2, -1, -2, 1, -1, -2, 2, 0}};
  const ph::vector<double, 6> f(2, -1, -1, 1, 0, -3);
  ph::half_space_start start{198, 105};  // f violates these
  expect_nearest(ph::project_onto_half_spaces(B, f, start), B, f);
}

// Either of two sets holds f back at the apex.
TEST(active_set, begins_with_what_held_before_if_f_violates_the_same) {
  const ph::matrix<double, 3, 4> B{{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}};
  const auto held_from = [&](ph::half_space_start start) {
    return ph::project_onto_half_spaces(B, vec(3, 4, 1), start);
  };
  EXPECT_EQ(held_from({7, 15}).coefficients, (ph::vector<double, 4>(3, 4, 1, 0)));
  EXPECT_EQ(held_from({11, 15}).coefficients, (ph::vector<double, 4>(2, 3, 0, 1)));
  EXPECT_EQ(held_from({7, 15}).active, 7u);
  EXPECT_EQ(held_from({11, 15}).active, 11u);
  for (const ph::half_space_set then : {0u, 7u, 14u})
    EXPECT_EQ(held_from({7, then}).active, 11u) << "f jumped: the fourth is violated most";
}

TEST(active_set, passes_over_half_spaces_whose_squares_are_no_numbers) {
  const double least = std::numeric_limits<double>::min();
  const auto held = [](double length) {
    ph::matrix<double, 3, 4> B{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, -1}};
    B.col(1) *= length;
    return ph::project_onto_half_spaces(B, vec(1, 2, -3)).point;
  };
  EXPECT_EQ(held(1), vec(0, 0, 0));
  EXPECT_EQ(held(std::sqrt(4 * least)), vec(0, 0, 0));
  for (const double length : {std::sqrt(least / 4), 1e-200, 0.0})
    EXPECT_EQ(held(length), vec(0, 2, 0)) << length;
}

// Beside the first the square of what is left of the second is no number.
TEST(active_set, passes_over_a_half_space_that_is_too_short_beside_another) {
  ph::matrix<double, 3, 4> B{{1, 0.8, 0, 0}, {0, 0.6, 0, 0}, {0, 0, 1, -1}};
  B.col(1) *= std::sqrt(2 * std::numeric_limits<double>::min());
  for (unsigned active = 0; active < 16; active += 4) {  // the first two enter, the fourth does not hold
    ph::half_space_start start{active, 7};
    const auto held = ph::project_onto_half_spaces(B, vec(9, 2, 1), start);
    EXPECT_EQ(held.point, vec(0, 2, 0)) << "from " << active;
    EXPECT_EQ(held.active, 5u) << "from " << active;
  }
}

// Beside the third the second is too short, but the third does not stay.
TEST(active_set, looks_again_at_what_was_too_short_beside_another) {
  ph::matrix<double, 3, 4> B{{0, 1, -1, 0}, {2, 0, 1, 0}, {2, 0, -2, -1}};
  B.col(1) *= std::sqrt(1.1 * std::numeric_limits<double>::min());
  ph::half_space_start start{8, 7};
  const auto held = ph::project_onto_half_spaces(B, vec(1, 6, 2), start);
  EXPECT_EQ(held.point, vec(0, 0, 0));
  EXPECT_EQ(held.active, 11u);
}

TEST(active_set, sees_a_small_violation_beside_a_long_half_space) {
  ph::testing::random_source random(5);
  for (int k = 0; k < 20; ++k) {
    const vec n = random.direction<double, 3>(),
              f = 2 * n + ph::cross<double>(n, random.direction<double, 3>());
    const vec foot = f - 2 * n;
    ph::matrix<double, 3, 2> B;
    B << 1e12 * n, ph::cross<double>(n, foot) + 1e-6 * foot;
    ph::half_space_start start{1, 3};  // f violates both
    expect_nearest(ph::project_onto_half_spaces(B, f, start), B, f);
    EXPECT_EQ(start.active, 3u);
  }
}

// b_1 makes f alone; beside it b_0 has a coefficient of 0 exactly.
TEST(active_set, lets_go_what_holds_with_nothing) {
  const half_spaces B{{1, 1, 0}, {0, 1, 0}, {0, 0, 1}};
  for (unsigned active = 0; active < 8; ++active) {
    ph::half_space_start start{active, 3};
    const auto held = ph::detail::active_set<double, 3, 3>(B, vec(1, 1, 0)).nearest(start);
    EXPECT_EQ(held.point, vec(0, 0, 0)) << "from " << active;
    EXPECT_EQ(held.coefficients, vec(0, 1, 0)) << "from " << active;
    EXPECT_EQ(held.active, 2u) << "from " << active;
  }
}

// What is left of it is rounding, which violates nothing.
TEST(active_set, of_a_force_along_one_half_space_is_held_by_it_alone) {
  ph::testing::random_source random(12);
  for (int k = 0; k < 200; ++k) {
    half_spaces B;
    for (int j = 0; j < 3; ++j) B.col(j) = random.direction<double, 3>();
    const vec f = 1.3 * B.col(0);
    ph::half_space_start start;
    const auto held = ph::detail::active_set<double, 3, 3>(B, f).nearest(start);
    EXPECT_EQ(held.active, 1u) << "seed 12, trial " << k;
    EXPECT_LE(held.point.norm(), 4 * eps * f.norm()) << "seed 12, trial " << k;
  }
}

TEST(active_set, takes_a_violation_of_up_to_one_rounding_for_none) {
  for (const double roundings : {0.25, 0.8, 1.5}) {
    for (const ph::half_space_set active : {0u, 1u, 4u}) {
      SCOPED_TRACE(::testing::Message() << roundings << " from " << active);
      ph::half_space_start start{active, 3};
      const auto held =
          ph::detail::active_set<double, 3, 3>(octant, vec(1, roundings * eps, -1)).nearest(start);
      EXPECT_EQ(held.point, vec(0, roundings > 1 ? 0 : roundings * eps, -1));
      EXPECT_EQ(held.active, roundings > 1 ? 3u : 1u);
    }
  }
}

TEST(updatable_qr, refuses_what_depends_on_its_columns_to_rounding) {
  using qr_of = ph::detail::updatable_qr<double, 2, 2>;
  using pair = ph::vector<double, 2>;
  const double parallel = ph::rounding_tolerance<double>(1), least = std::numeric_limits<double>::min();
  const auto takes = [](const pair& a, const pair& b) {
    const pair f(1, 2);
    qr_of qr(qr_of::column::load(f.data()));
    EXPECT_TRUE(qr.append(qr_of::column::load(a.data()), a.squaredNorm()));
    const bool taken = qr.append(qr_of::column::load(b.data()), b.squaredNorm());
    EXPECT_EQ(qr.size(), taken ? 2 : 1);
    pair r;
    qr.clean_residual().store(r.data());
    EXPECT_EQ(r == pair(0, 0), taken) << "two span the plane";
    return taken;
  };
  for (const double length : {1.0, 1024.0}) {
    EXPECT_TRUE(takes({1, 0}, {length, 1.1 * parallel * length}));
    EXPECT_FALSE(takes({1, 0}, {length, 0.9 * parallel * length}));
  }
  EXPECT_TRUE(takes({1, 0}, {0, std::sqrt(2 * least)}));
  EXPECT_FALSE(takes({1, 0}, {0, std::sqrt(least / 2)}));
  EXPECT_FALSE(takes({1, 0}, {0, 0}));
}

TEST(updatable_qr, is_orthogonal_where_columns_nearly_agree) {
  using column = ph::detail::updatable_qr<double, 3, 2>::column;
  for (const double hair : {1e-9, 1e-14}) {
    const vec a(0.3, 0.7, -0.2), b = a + hair * vec(1, -2, 3), f(1, 2, 3);
    ph::detail::updatable_qr<double, 3, 2> qr(column::load(f.data()));
    const double square = (1 + 4 * eps) * a.squaredNorm();  // as anyone may round it
    ASSERT_TRUE(qr.append(column::load(a.data()), square));
    EXPECT_EQ(qr.inverse_square(0), 1 / square) << "that of the first is not made anew";
    ASSERT_TRUE(qr.append(column::load(b.data()), b.squaredNorm()));
    vec v, r;
    qr.orthogonal(1).store(v.data());
    qr.clean_residual().store(r.data());
    EXPECT_NEAR(qr.inverse_square(1) * v.squaredNorm(), 1, 8 * eps);
    EXPECT_LE(std::abs(a.dot(v)), 16 * eps * a.norm() * v.norm());
    EXPECT_LE(std::abs(a.dot(r)), 16 * eps * a.norm() * r.norm());
    EXPECT_LE(std::abs(b.dot(r)), 16 * eps * b.norm() * r.norm());
  }
}

TEST(updatable_qr, leaves_a_residual_that_is_orthogonal_to_rounding_of_its_own) {
  using column = ph::detail::updatable_qr<double, 3, 2>::column;
  ph::testing::random_source random(6);
  for (int k = 0; k < 20; ++k) {
    const vec a = random.direction<double, 3>(), b = random.direction<double, 3>();
    const vec f = a + 0.3 * b + 1e-10 * random.direction<double, 3>();
    ph::detail::updatable_qr<double, 3, 2> qr(column::load(f.data()));
    for (const vec& c : {a, b}) ASSERT_TRUE(qr.append(column::load(c.data()), c.squaredNorm()));
    vec r;
    qr.clean_residual().store(r.data());
    for (const vec& c : {a, b}) EXPECT_LE(std::abs(c.dot(r)), 16 * eps * r.norm()) << "seed 6, trial " << k;
  }
}

// With what held another force, with members that do not hold this one, with all.
template <int Rows, int Columns>
void expect_nearest_from_any_start(int problems) {
  ph::testing::random_source random(3);
  for (int k = 0; k < problems; ++k) {
    SCOPED_TRACE(::testing::Message() << Rows << " x " << Columns << ", seed 3, problem " << k);
    const problem<Rows, Columns> p(random);
    ph::half_space_start left;
    const auto cold = ph::project_onto_half_spaces(p.B, p.f, left);
    expect_nearest(cold, p.B, p.f);
    for (unsigned active = 0; active < 2u << Columns; ++active) {
      ph::half_space_start start{active, left.violated};
      const auto warm = ph::project_onto_half_spaces(p.B, p.f, start);
      expect_nearest(warm, p.B, p.f);
      ASSERT_LE((warm.point - cold.point).norm(), 1e-12) << "from " << active;
      ASSERT_EQ(start.active, warm.active);
      ASSERT_EQ(start.violated, left.violated);
    }
  }
}

TEST(active_set, is_nearest_from_any_start) {
  expect_nearest_from_any_start<3, 4>(40);
  expect_nearest_from_any_start<6, 9>(20);
}

}  // namespace
