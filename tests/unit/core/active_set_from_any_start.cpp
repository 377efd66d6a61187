// slow
// The active set in random cones of many sizes, from every start.
#include <passive_haptics/core/linear/active_set.hpp>
#include <passive_haptics/core/linear/cone.hpp>

#include "nearest_point.hpp"

namespace {

// Wherever it begins: with what held another force, with members that do not hold this one, with all.
template <int Rows, int Columns>
void expect_nearest_from_any_start(int problems) {
  SCOPED_TRACE(::testing::Message() << Rows << " x " << Columns);
  ph::testing::random_source random(3);
  for (int k = 0; k < problems; ++k) {
    const problem<Rows, Columns> p(random);
    ph::half_space_start left;
    const auto cold = ph::project_onto_half_spaces(p.B, p.f, left);
    expect_nearest(cold, p.B, p.f);
    EXPECT_EQ(left.active, cold.active);
    for (unsigned active = 0; active < 2u << Columns; ++active) {
      SCOPED_TRACE(::testing::Message() << "seed 3, problem " << k << ", from " << active);
      ph::half_space_start start{active, left.violated};
      const auto warm = ph::project_onto_half_spaces(p.B, p.f, start);
      expect_nearest(warm, p.B, p.f);
      ASSERT_LE((warm.point - cold.point).norm(), 1e-12);
      if (Columns <= Rows) {
        ASSERT_EQ(warm.active, cold.active) << "more may hold an apex otherwise";
      }
      ASSERT_EQ(start.active, warm.active);
      ASSERT_EQ(start.violated, left.violated);
    }
  }
}

TEST(active_set, is_nearest_from_any_start) {
  expect_nearest_from_any_start<3, 5>(40);
  expect_nearest_from_any_start<4, 4>(40);
  expect_nearest_from_any_start<6, 6>(40);
}

// So many that the rare ones are among them in which several members must leave, one after the other.
template <int Rows, int Columns>
void expect_nearest_of_many() {
  SCOPED_TRACE(::testing::Message() << Rows << " x " << Columns << ", seed 20");
  ph::testing::random_source random(20);
  for (int k = 0; k < 4000; ++k) {
    const problem<Rows, Columns> p(random);
    ph::half_space_start start{};
    for (int j = 0; j < Columns; ++j) {
      start.violated |= (p.B.col(j).dot(p.f) > 0 ? 1u : 0u) << j;
      start.active |= (random.coin() ? 1u : 0u) << j;
    }
    expect_nearest(ph::project_onto_half_spaces(p.B, p.f, start), p.B, p.f);
  }
}

TEST(active_set, meets_the_conditions_of_the_nearest_point_in_many_cones) {
  expect_nearest_of_many<3, 5>();
  expect_nearest_of_many<4, 7>();
  expect_nearest_of_many<6, 9>();
}

}  // namespace
