// A tree of boxes finds what a scan over all boxes finds, all at once or a little at a time.
#include <passive_haptics/scene/bounding_volume_tree.hpp>
#include <passive_haptics/testing/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ph = passive_haptics;

namespace {

constexpr unsigned seed = 20040627;
constexpr double everything = std::numeric_limits<double>::infinity();

template <int D>
double squared_distance(const ph::bounding_box<D>& b, const ph::point<D>& x) {
  return (b.lower - x).cwiseMax(x - b.upper).cwiseMax(0).squaredNorm();
}

template <int D>
std::vector<ph::bounding_box<D>> random_boxes(int count, ph::testing::random_source& random) {
  std::vector<ph::bounding_box<D>> boxes;
  for (int i = 0; i < count; ++i) {
    const ph::point<D> centre = random.normal_vector<double, D>();
    boxes.push_back(ph::box_about<D>(centre, random.positive(1e-6, 1.0)));
  }
  return boxes;
}

template <class Dimension>
struct tree : ::testing::Test {
  static constexpr int dimension = Dimension::value;
};
using dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(tree, dimensions);

TYPED_TEST(tree, finds_every_box_within_a_radius_and_no_box_that_is_not) {
  constexpr int D = TestFixture::dimension;
  ph::testing::random_source random(seed);
  for (const int count : {0, 1, 2, 3, 100, 1000}) {
    const auto boxes = random_boxes<D>(count, random);
    const ph::bounding_volume_tree<D> all(boxes);
    EXPECT_EQ(all.size(), boxes.size());
    for (int k = 0; k < 200; ++k) {
      const ph::point<D> x = 1.5 * random.normal_vector<double, D>();
      const double radius = random.positive(1e-3, 3.0), rounding = 1e-6;  // boxes are kept in float
      std::vector<int> found(boxes.size());
      all.visit_within([&](const auto& b) { return b.squared_distance(x); }, radius * radius,
                       [&](int item, double) { ++found[static_cast<std::size_t>(item)]; });
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        const double distance = std::sqrt(squared_distance<D>(boxes[i], x));
        if (distance <= radius) {
          ASSERT_EQ(found[i], 1) << "seed " << seed << ", box " << i;
        } else if (distance > radius + rounding) {
          ASSERT_EQ(found[i], 0) << "seed " << seed << ", box " << i;
        }
      }
    }
  }
}

TYPED_TEST(tree, finds_the_nearest_box_a_node_at_a_time) {
  constexpr int D = TestFixture::dimension;
  ph::testing::random_source random(seed);
  const auto boxes = random_boxes<D>(1000, random);
  const ph::bounding_volume_tree<D> all(boxes);
  for (int k = 0; k < 100; ++k) {
    const ph::point<D> x = 3 * random.normal_vector<double, D>();
    double limit = everything;
    const auto bound = [&](const auto& b) { return b.squared_distance(x); };
    auto search = all.start(bound);
    int looks = 0;
    for (; !search.done(); ++looks)
      all.go_on(search, bound, limit, [&](int, double d) { limit = std::min(limit, d); }, 1);
    double nearest = everything;
    for (const auto& b : boxes) nearest = std::min(nearest, squared_distance<D>(b, x));
    EXPECT_NEAR(std::sqrt(limit), std::sqrt(nearest), 1e-6) << "seed " << seed << ", point " << k;
    EXPECT_LE(looks, 1000) << "most of 2000 nodes are not looked at";
  }
}

TYPED_TEST(tree, a_box_in_float_holds_the_box) {
  constexpr int D = TestFixture::dimension;
  ph::testing::random_source random(seed);
  for (int k = 0; k < 1000; ++k) {
    const ph::point<D> corner = random.positive(1e-20, 1e20) * random.normal_vector<double, D>();
    const ph::bounding_volume_tree<D> all({{corner, corner}});
    int found = 0;
    all.visit_within([&](const auto& b) { return b.squared_distance(corner); }, 0.0,
                     [&](int, double) { ++found; });
    EXPECT_EQ(found, 1) << corner.transpose();
  }
}

TYPED_TEST(tree, of_equal_boxes_is_balanced) {
  constexpr int D = TestFixture::dimension;
  const std::vector<ph::bounding_box<D>> boxes(100'000, ph::box_about<D>(ph::point<D>::Zero(), 1));
  int found = 0;
  ph::bounding_volume_tree<D>(boxes).visit_within([](const auto&) { return 0.0; }, 0.0,
                                                  [&](int, double) { ++found; });
  EXPECT_EQ(found, 100'000);
}

}  // namespace
