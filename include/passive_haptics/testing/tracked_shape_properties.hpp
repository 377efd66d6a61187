/// The laws of the TrackedShape concept as a GoogleTest suite; cases as in shape_properties.hpp.
#pragma once

#include <passive_haptics/scene/world/tracked_shape.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace passive_haptics::testing {

/// Suite of a tracked shape's laws.
template <class Case>
class tracked_shape_properties : public ::testing::Test {
 protected:
  using model = typename Case::shape;  ///< The shape.
  static_assert(TrackedShape<model>,
                "passive_haptics: tracked_shape_properties needs a model of TrackedShape "
                "(scene/world/tracked_shape.hpp).");
  static constexpr int d = model::dimension;  ///< d
  static constexpr int cycle_count = 5000;    ///< Number of cycles.
  static constexpr unsigned seed = 20040627;  ///< Seed of the path.
  using memory = typename model::tracker;     ///< State of a handle.

  /// One contact.
  struct touch {
    point<d> normal;  ///< Unit normal.
    double depth;     ///< [m]

    bool operator==(const touch&) const = default;  ///< Bitwise.
  };
  /// Result of one call.
  struct answer {
    std::vector<touch> felt;  ///< Contacts.
    double may_go;            ///< Allowed distance of the handle [m].
  };

  const model shape = Case::make();  ///< The shape under test.

  /// One call.
  answer follow(const point<d>& from, const point<d>& x, memory& t) const {
    answer a;
    a.may_go =
        shape.follow(from, x, t, [&](const point<d>& n, double depth) { a.felt.push_back({n, depth}); });
    return a;
  }

  /// visit(from, x, memory before) for each cycle of a random path of small steps and leaps within the box.
  template <class Visit>
  void for_each_cycle(const Visit& visit) const {
    random_source random(seed);
    const auto anywhere = [&] { return random.template between<double, d>(Case::lower(), Case::upper()); };
    memory t;
    point<d> from = anywhere(), x = from;
    for (int k = 0; k < cycle_count; ++k) {
      if (::testing::Test::HasFatalFailure()) return;
      SCOPED_TRACE(::testing::Message() << "seed " << seed << ", cycle " << k << ", x = " << x.transpose());
      visit(from, x, t);
      follow(from, x, t);
      from = x;
      const double size = (Case::upper() - Case::lower()).norm();
      x = k % 50 == 0
              ? anywhere()
              : point<d>((x + random.positive(1e-6, 0.03) * size * random.template direction<double, d>())
                             .cwiseMax(Case::lower())
                             .cwiseMin(Case::upper()));
    }
  }
};

TYPED_TEST_SUITE_P(tracked_shape_properties);

/// At most `dimension` contacts with unit normal and depth > 0; nothing is skipped during contact.
TYPED_TEST_P(tracked_shape_properties, contacts_have_a_direction_and_a_depth) {
  int touched = 0, free = 0;
  this->for_each_cycle([&](const auto& from, const auto& x, auto t) {
    const auto found = this->follow(from, x, t);
    ASSERT_LE(found.felt.size(), static_cast<std::size_t>(this->d));
    for (const auto& c : found.felt) {
      ASSERT_NEAR(c.normal.norm(), 1, rounding_tolerance<double>(this->d));
      ASSERT_GT(c.depth, 0);
      ASSERT_TRUE(std::isfinite(c.depth));
    }
    ASSERT_GE(found.may_go, 0);
    ASSERT_TRUE(found.felt.empty() || found.may_go == 0);
    ++(found.felt.empty() ? free : touched);
  });
  EXPECT_GT(touched, 0);
  EXPECT_GT(free, 0);
}

/// The handle touches nothing within the allowed distance, nor outside the bounds.
TYPED_TEST_P(tracked_shape_properties, what_may_be_skipped_is_free) {
  random_source random(this->seed);
  int tried = 0;
  this->for_each_cycle([&](const auto& from, const auto& x, auto t) {
    const double may_go = this->follow(from, x, t).may_go;
    if (!(may_go > 0)) return;
    using at = point<TypeParam::shape::dimension>;
    const at close_by = x + random.uniform(0.0, 1.0) * may_go *
                                random.template direction<double, TypeParam::shape::dimension>();
    ASSERT_TRUE(this->follow(x, close_by, t).felt.empty());
    // along the outside of a face of the bounds
    const auto bounds = this->shape.bounds();
    const int axis = tried % this->d;
    at start = bounds.lower, end = bounds.upper;
    start[axis] = end[axis] = tried % 2 == 0 ? bounds.lower[axis] : bounds.upper[axis];
    typename TypeParam::shape::tracker fresh;
    this->follow(start, start, fresh);
    ASSERT_TRUE(this->follow(start, end, fresh).felt.empty());
    ++tried;
  });
  EXPECT_GT(tried, 0);
}

/// Equal memories and positions give equal results and memories.
TYPED_TEST_P(tracked_shape_properties, the_answer_depends_on_nothing_else) {
  this->for_each_cycle([&](const auto& from, const auto& x, auto t) {
    auto other = t;
    for (int again = 0; again < 2; ++again) {
      const auto one = this->follow(from, x, t), two = this->follow(from, x, other);
      ASSERT_EQ(one.may_go, two.may_go);
      ASSERT_TRUE(one.felt == two.felt);
    }
  });
}

/// NaN in x gives a NaN depth and leaves the memory.
TYPED_TEST_P(tracked_shape_properties, no_number_is_no_place) {
  this->for_each_cycle([&](const auto& from, const auto& x, auto t) {
    auto unaware = t;
    auto bad = x;
    bad[this->d - 1] = std::numeric_limits<double>::quiet_NaN();
    const auto nothing = this->follow(from, bad, t);
    ASSERT_EQ(nothing.felt.size(), 1u);
    ASSERT_TRUE(std::isnan(nothing.felt[0].depth));
    ASSERT_EQ(nothing.may_go, 0);
    const auto one = this->follow(from, x, t), two = this->follow(from, x, unaware);
    ASSERT_EQ(one.may_go, two.may_go);
    ASSERT_TRUE(one.felt == two.felt);
  });
}

REGISTER_TYPED_TEST_SUITE_P(tracked_shape_properties, contacts_have_a_direction_and_a_depth,
                            what_may_be_skipped_is_free, the_answer_depends_on_nothing_else,
                            no_number_is_no_place);

}  // namespace passive_haptics::testing
