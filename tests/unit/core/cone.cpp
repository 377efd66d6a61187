// Projections onto cones by hand: on the line, in the plane, in space, by an active set.
#include <passive_haptics/core/linear/active_set.hpp>
#include <passive_haptics/core/linear/space_cone.hpp>
#include <passive_haptics/core/linear/updatable_qr.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ph = passive_haptics;

namespace {

using vec = ph::vector<double, 3>;
using half_spaces = ph::matrix<double, 3, 3>;
using projection = ph::half_space_projection<double, 3, 3>;
constexpr double eps = std::numeric_limits<double>::epsilon();
const half_spaces octant = ph::identity_matrix<double, 3>();  // { p <= 0 }

// On a line a half-space lets f through or leaves 0.
TEST(cone_on_a_line, f_or_zero) {
  using line = ph::matrix<double, 1, 3>;
  using number = ph::vector<double, 1>;
  const auto project = [](const line& B, double f) { return ph::project_onto_half_spaces(B, number(f)); };
  EXPECT_EQ(project({-2, -1, 0}, 3).point[0], 3);
  EXPECT_EQ(project({-2, -1, 0}, 3).active, 0u);
  const auto held = project({0, 4, 1}, 3);
  EXPECT_EQ(held.point[0], 0);
  EXPECT_EQ(held.coefficients, (ph::vector<double, 3>(0, 0.75, 0)));
  EXPECT_EQ(held.active, 2u);
  EXPECT_EQ(project({1, -1, 0}, 0).point[0], 0);
  EXPECT_EQ((ph::project_onto_half_spaces(ph::matrix<double, 1, 1>(1), number(-2)).point[0]), -2);
}

// The third half-space holds f back at the apex as well, with the second.
TEST(cone_in_the_plane, is_held_at_its_apex_by_the_two_that_are_least_parallel) {
  const ph::matrix<double, 2, 3> B{{1, 0, 1}, {0, 1, 1}};
  const auto held = ph::project_onto_half_spaces(B, ph::vector<double, 2>(1, 2));
  EXPECT_EQ(held.point, (ph::vector<double, 2>(0, 0)));
  EXPECT_EQ(held.coefficients, vec(1, 2, 0));
  EXPECT_EQ(held.active, 3u);
}

TEST(space_cone_start, is_taken_where_it_holds_f_back_clear_of_the_others_alone) {
  projection answer;
  const auto is_nearest = [&](ph::half_space_set active, const vec& f) {
    return ph::detail::space_cone_start<double>(octant, f).nearest(active, answer);
  };
  EXPECT_TRUE(is_nearest(1, {1, -1, -1}));
  EXPECT_EQ(answer.point, vec(0, -1, -1));
  EXPECT_TRUE(is_nearest(3, {1, 2, -1}));
  EXPECT_EQ(answer.point, vec(0, 0, -1));
  EXPECT_EQ(answer.coefficients, vec(1, 2, 0));
  EXPECT_EQ(answer.active, 3u);
  EXPECT_FALSE(is_nearest(1, {-1, -1, -1})) << "f lies inside";
  EXPECT_FALSE(is_nearest(3, {-1, 1, -1})) << "the first does not hold f back";
  EXPECT_FALSE(is_nearest(3, {1, -1, -1})) << "nor the second";
  EXPECT_FALSE(is_nearest(1, {1, 1, -1})) << "violates the second";
  EXPECT_FALSE(is_nearest(3, {1, 1, 1})) << "violates the third";
}

// Of the first two either could hold f back alone; the answer lies on the second.
TEST(active_set, comes_from_any_start_to_the_same) {
  const half_spaces B{{1, 1, 0}, {1, 0, 0}, {0, 0, 1}};
  const vec f(2, -1, 0);
  for (unsigned active = 0; active < 8; ++active) {
    ph::half_space_start start{active, 3};  // f violates the first two
    const auto held = ph::detail::active_set<double, 3, 3>(B, f).nearest(start);
    EXPECT_EQ(held.point, vec(0, -1, 0)) << "from " << active;
    EXPECT_EQ(held.coefficients, vec(0, 2, 0)) << "from " << active;
    EXPECT_EQ(held.active, 2u) << "from " << active;
  }
}

TEST(active_set, takes_a_violation_of_rounding_for_none) {
  const vec f(1, eps / 4, -1);
  for (const ph::half_space_set active : {0u, 4u}) {
    ph::half_space_start start{active, 3};
    const auto held = ph::detail::active_set<double, 3, 3>(octant, f).nearest(start);
    EXPECT_EQ(held.point, vec(0, eps / 4, -1)) << "from " << active;
    EXPECT_EQ(held.active, 1u) << "from " << active;
  }
}

TEST(updatable_qr, is_orthogonal_where_columns_nearly_agree) {
  using column = ph::detail::updatable_qr<double, 4, 2>::column;
  using four = ph::vector<double, 4>;
  const four a(0.3, 0.7, -0.2, 0.5), b = a + 1e-9 * four(1, -2, 3, 0.5), f(1, 2, 3, 4);
  ph::detail::updatable_qr<double, 4, 2> qr(column::load(f.data()));
  const double square = (1 + 4 * eps) * a.squaredNorm();  // as anyone may round it
  ASSERT_TRUE(qr.append(column::load(a.data()), square));
  EXPECT_EQ(qr.inverse_square(0), 1 / square) << "that of the first is not made anew";
  ASSERT_TRUE(qr.append(column::load(b.data()), b.squaredNorm()));
  four v, r;
  qr.orthogonal(1).store(v.data());
  qr.clean_residual().store(r.data());
  EXPECT_LE(std::abs(a.dot(v)), 16 * eps * a.norm() * v.norm());
  EXPECT_LE(std::abs(a.dot(r)), 16 * eps * a.norm() * r.norm());
  EXPECT_LE(std::abs(b.dot(r)), 16 * eps * b.norm() * r.norm());
}

}  // namespace
