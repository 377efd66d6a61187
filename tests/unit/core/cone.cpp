// Projections onto cones by hand: on the line, in the plane, in space.
#include <passive_haptics/core/linear/active_set.hpp>
#include <passive_haptics/core/linear/cone.hpp>

#include "nearest_point.hpp"

#include <Eigen/LU>

#include <bit>
#include <cmath>
#include <limits>

namespace {

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
  const auto by_the_first = project({4, 8, 0}, 3);
  EXPECT_EQ(by_the_first.coefficients, (ph::vector<double, 3>(0.75, 0, 0)));
  EXPECT_EQ(by_the_first.active, 1u);
  EXPECT_EQ(project({1, -1, 0}, 0).point[0], 0);
  EXPECT_EQ(project({0.5, 0, 0}, 0.5).point[0], 0);
  EXPECT_EQ(project({1, 0, 0}, -2).point[0], -2);
}

template <int Columns>
void expect_nearest_in_the_plane() {
  ph::testing::random_source random(1);
  for (int k = 0; k < 200; ++k) {
    const problem<2, Columns> p(random);
    expect_nearest(ph::project_onto_half_spaces(p.B, p.f), p.B, p.f);
  }
}

TEST(cone_in_the_plane, is_held_by_what_is_in_the_way) {
  expect_nearest_in_the_plane<1>();
  expect_nearest_in_the_plane<2>();
  expect_nearest_in_the_plane<4>();
}

// Opposed, alike, zero: two half-spaces that have no edges of their own.
TEST(cone_in_the_plane, of_two_that_are_parallel) {
  using pair = ph::vector<double, 2>;
  const auto project = [](double first, double second, const pair& f) {
    const ph::matrix<double, 2, 2> B{{3 * first, 3 * second}, {4 * first, 4 * second}};
    return ph::project_onto_half_spaces(B, f);
  };
  const pair f(3 - 4, 4 + 3);  // along both and one length to the left
  const auto same = project(1, 2, f), opposed = project(1, -2, f), one = project(0, 2, f);
  for (const auto& held : {same, opposed, one}) {
    EXPECT_TRUE(held.point.isApprox(pair(-4, 3), 1e-15)) << held.point.transpose();
    EXPECT_EQ(held.point.dot(pair(3, 4)), 0);
  }
  EXPECT_EQ(same.coefficients, pair(1, 0));
  EXPECT_EQ(opposed.coefficients, pair(1, 0));
  EXPECT_EQ(opposed.active, 1u);
  EXPECT_EQ(one.coefficients, pair(0, 0.5));
  EXPECT_EQ(one.active, 2u);
  EXPECT_EQ(project(-1, -2, f).point, f);
  EXPECT_EQ(project(0, 0, f).point, f);
}

// Along one of two normals f is held back by that one alone.
TEST(cone_in_the_plane, of_two_is_held_at_its_apex_by_the_one_that_f_lies_along) {
  const ph::matrix<double, 2, 2> B{{3, -1}, {4, 2}};
  const auto held = ph::project_onto_half_spaces(B, ph::vector<double, 2>(6, 8));
  EXPECT_EQ(held.point, (ph::vector<double, 2>(0, 0)));
  EXPECT_EQ(held.coefficients, (ph::vector<double, 2>(2, 0)));
  EXPECT_EQ(held.active, 1u);
}

// Squares of products that are no numbers in float decide nothing.
TEST(cone_in_the_plane, of_two_is_held_at_its_apex_also_where_products_are_tiny) {
  const ph::matrix<float, 2, 2> B{{1e-20f, 0.5f}, {1e-20f, -3.0f}};
  const auto held = ph::project_onto_half_spaces(B, ph::vector<float, 2>(1, 4e-16f));
  EXPECT_EQ(held.point, (ph::vector<float, 2>(0, 0)));
  EXPECT_EQ(held.active, 3u);
}

// What has no half-space of its own: coincident, opposed and zero columns beside others, f = 0, on an edge.
TEST(cone_in_the_plane, of_four_that_are_degenerate) {
  using pair = ph::vector<double, 2>;
  const auto project = [](const ph::matrix<double, 2, 4>& B, const pair& f) {
    const auto cold = ph::project_onto_half_spaces(B, f);
    for (ph::half_space_set before = 0; before < 16; ++before) {
      ph::half_space_set violated = 0;
      for (int j = 0; j < 4; ++j) violated |= (B.col(j).dot(f) > 0 ? 1u : 0u) << j;
      ph::half_space_start start{before, violated};
      EXPECT_LE((ph::project_onto_half_spaces(B, f, start).point - cold.point).norm(), 4 * eps) << before;
    }
    return cold;
  };
  const ph::matrix<double, 2, 4> coincident{{2, 2, 1, 0}, {0, 0, 0, 0}}, slit{{1, -1, 3, 0}, {0, 0, 0, 0}},
      point{{1, -1, 0, 0}, {0, 0, 1, -1}}, none{{0, 0, 0, 0}, {0, 0, 0, 0}};
  EXPECT_EQ(project(coincident, {3, 1}).point, pair(0, 1));
  EXPECT_EQ(std::popcount(project(coincident, {3, 1}).active), 1);
  EXPECT_EQ(project(coincident, {-3, 1}).point, pair(-3, 1));
  EXPECT_EQ(project(coincident, {0, 1}).point, pair(0, 1)) << "f lies on the edge";
  EXPECT_EQ(project(coincident, {0, 1}).active, 0u);
  EXPECT_EQ(project(slit, {3, 1}).point, pair(0, 1));
  EXPECT_EQ(project(slit, {-3, 1}).point, pair(0, 1));
  EXPECT_EQ(project(point, {3, 1}).point, pair(0, 0)) << "the cone is the apex alone";
  EXPECT_EQ(project(point, {3, 1}).coefficients, (ph::vector<double, 4>(3, 0, 1, 0)));
  EXPECT_EQ(project(none, {3, 1}).point, pair(3, 1));
  for (const auto& B : {coincident, slit, point, none}) {
    EXPECT_EQ(project(B, {0, 0}).point, pair(0, 0));
    EXPECT_EQ(project(B, {0, 0}).active, 0u);
  }
}

// A point of each face, edge and so on, pushed out of the cone by what meets there: all solvers know it.
TEST(cone_in_space, has_its_nearest_point_on_each_face_and_edge_and_at_the_apex) {
  ph::testing::random_source random(2);
  int taken = 0, right = 0;
  for (int k = 0; k < 100; ++k) {
    const half_spaces B = problem<3, 3>(random).B, away = B.inverse().transpose();
    if (away.norm() * B.norm() > 100) continue;
    for (ph::half_space_set held = 0; held < 8; ++held) {
      SCOPED_TRACE(::testing::Message() << "seed 2, cone " << k << ", half-spaces " << held);
      vec p = vec::Zero(), mu = vec::Zero();
      for (int j = 0; j < 3; ++j) {
        const double size = random.uniform(0.1, 2.0);
        if ((held >> j & 1u) != 0) mu[j] = size;
        else p -= size * away.col(j);
      }
      const vec f = p + B * mu;
      const auto expect_answer = [&](const projection& answer) {
        EXPECT_EQ(answer.active, held);
        EXPECT_LE((answer.point - p).norm(), 1e-12 * (1 + p.norm()));
        EXPECT_LE((answer.coefficients - mu).norm(), 1e-12);
        for (int j = 0; j < 3; ++j) EXPECT_EQ(answer.coefficients[j] == 0, mu[j] == 0);
      };
      projection answer{vec(7, 8, 9), vec(4, 5, 6), 8};
      EXPECT_TRUE(ph::detail::space_cone<double>(B, f).nearest(answer));
      expect_answer(answer);
      ph::half_space_set violated = 0;
      for (int j = 0; j < 3; ++j) violated |= (B.col(j).dot(f) > 0 ? 1u : 0u) << j;
      for (unsigned before = 0; before < 16; ++before) {
        const projection untouched{vec(7, 8, 9), vec(4, 5, 6), 8};
        answer = untouched;
        if (ph::detail::space_cone_start<double>(B, f).nearest(before, answer)) {
          EXPECT_EQ(before, held);
          expect_answer(answer);
          ++taken;
        } else {
          EXPECT_EQ(answer.point, untouched.point);
          EXPECT_EQ(answer.active, untouched.active);
        }
        for (const ph::half_space_set then : {violated, violated ^ 1u}) {
          ph::half_space_start start{before, then}, of_set{before, then};
          expect_answer(ph::project_onto_half_spaces(B, f, start));
          EXPECT_EQ(start.active, held);
          expect_answer(ph::detail::active_set<double, 3, 3>(B, f).nearest(of_set));
          EXPECT_EQ(of_set.active, held);
          EXPECT_EQ(of_set.violated, violated);
        }
      }
      right += held != 0 && held != 7;
    }
  }
  EXPECT_GT(taken, 0.9 * right) << "others are narrow edges";
}

TEST(space_cone, is_of_lengths_whose_products_of_four_are_numbers) {
  for (const double square : {1.1e-30, 1.0, 0.9e30}) EXPECT_TRUE(ph::detail::is_moderate(square)) << square;
  for (const double square : {0.0, 0.9e-30, 1.1e30}) EXPECT_FALSE(ph::detail::is_moderate(square)) << square;
  for (const float square : {1.1e-8f, 1.0f, 0.9e8f}) EXPECT_TRUE(ph::detail::is_moderate(square)) << square;
  for (const float square : {0.0f, 0.9e-8f, 1.1e8f}) EXPECT_FALSE(ph::detail::is_moderate(square)) << square;
}

TEST(space_cone_start, is_left_where_rounding_or_a_narrow_edge_would_decide) {
  const double clear = ph::rounding_tolerance<double>(3);
  projection answer;
  const auto is_nearest = [&](const half_spaces& B, ph::half_space_set active, const vec& f) {
    return ph::detail::space_cone_start<double>(B, f).nearest(active, answer);
  };
  for (const double side : {1.1, 0.9}) {
    const double h = side * clear * std::sqrt(2);  // |f|^2 = 2
    EXPECT_EQ(is_nearest(octant, 1, {1, -h, -1}), side > 1);
    EXPECT_EQ(is_nearest(octant, 1, {1, -1, -h}), side > 1);
    half_spaces low = octant;  // its third half-space nearly contains the edge of the others
    low.col(2) << 1, 0, side * clear;
    EXPECT_EQ(is_nearest(low, 3, {1, 2, -3}), side > 1);
    half_spaces narrow = octant;
    const double sine = side / 4;
    narrow.col(1) << 3 * std::sqrt(1 - sine * sine), 3 * sine, 0;
    EXPECT_EQ(is_nearest(narrow, 3, 2 * narrow.col(0) + narrow.col(1) - narrow.col(2)), side > 1);
  }
  // Of lengths out of range no products are made
  for (const double length : {1e16, 1e-16}) {
    for (int j = 0; j < 3; ++j) {
      half_spaces scaled = octant;
      scaled.col(j) *= length;
      const int k = (j + 1) % 3, l = (j + 2) % 3;
      const auto pushed_by = [&](ph::half_space_set set) {
        return vec((set & 1u) != 0 ? 1 : -1, (set & 2u) != 0 ? 1 : -1, (set & 4u) != 0 ? 1 : -1);
      };
      for (const ph::half_space_set with : {1u << j, 1u << j | 1u << k, 1u << j | 1u << l})
        EXPECT_FALSE(is_nearest(scaled, with, pushed_by(with))) << j << " of " << with;
      EXPECT_TRUE(is_nearest(scaled, 1u << k, pushed_by(1u << k)));
      EXPECT_FALSE(ph::detail::space_cone<double>(scaled, pushed_by(7)).nearest(answer));
      scaled.col(j).setZero();
      EXPECT_TRUE(ph::detail::space_cone<double>(scaled, pushed_by(1u << j | 1u << k)).nearest(answer));
      EXPECT_EQ(answer.active, 1u << k) << "a zero column restricts nothing";
    }
  }
}

// To rounding of their lengths, 4 eps of the sine, two half-spaces are one; a hair more and the second holds
// f back farther.
TEST(cone, takes_half_spaces_that_are_parallel_to_rounding_for_one) {
  const double parallel = ph::rounding_tolerance<double>(1);
  for (const double hair : {0.9 * parallel, 1.1 * parallel}) {
    const unsigned holds = hair < parallel ? 1 : 2;
    const double x = hair < parallel ? 0 : -hair;
    const auto in_the_plane = ph::project_onto_half_spaces(ph::matrix<double, 2, 2>{{1, 1}, {0, hair}},
                                                           ph::vector<double, 2>(1, 1));
    EXPECT_EQ(in_the_plane.active, holds);
    EXPECT_NEAR(in_the_plane.point[0], x, eps);
    projection in_space;
    const half_spaces B{{1, 1, 0}, {0, hair, 0}, {0, 0, 1}};
    ASSERT_TRUE(ph::detail::space_cone<double>(B, vec(1, 1, -1)).nearest(in_space));
    EXPECT_EQ(in_space.active, holds);
    EXPECT_NEAR(in_space.point[0], x, eps);
    for (const double sign : {-1.0, 1.0})
      EXPECT_EQ(ph::are_parallel(sign * 4 * hair, 2.0, 8.0), hair < parallel);
  }
  EXPECT_TRUE(ph::are_parallel(0.0, 0.0, 1.0));
}

}  // namespace
