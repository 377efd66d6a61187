// A tree of boxes finds what a scan over all boxes finds, all at once or a little at a time.
// In three dimensions: world_memory.cpp.
#include <passive_haptics/scene/bounds/bounding_volume_tree.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ph = passive_haptics;

namespace {

constexpr unsigned tree_seed = 20040627;
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

TEST(tree, finds_every_box_within_a_radius_once_and_few_others) {
  ph::testing::random_source random(tree_seed);
  long visited = 0, wanted = 0;
  for (const int count : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 100, 1000}) {
    const auto boxes = random_boxes<2>(count, random);
    const ph::bounding_volume_tree<2> all(boxes);
    EXPECT_EQ(all.size(), boxes.size());
    for (int k = 0; k < 50; ++k) {
      const ph::point<2> x = 1.5 * random.normal_vector<double, 2>();
      const double radius = k == 0 ? everything : random.positive(1e-3, 3.0);
      std::vector<int> found(boxes.size());
      all.visit_within(ph::squared_distance_from<2>(x), radius * radius, [&](int place, double bound) {
        const int item = all.item(place);
        ++found[static_cast<std::size_t>(item)];
        ASSERT_LE(bound, squared_distance<2>(boxes[static_cast<std::size_t>(item)], x))
            << "seed " << tree_seed << ", box " << item;
      });
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        const bool within = squared_distance<2>(boxes[i], x) <= radius * radius;
        ASSERT_LE(found[i], 1);
        ASSERT_GE(found[i], within ? 1 : 0) << "seed " << tree_seed << ", box " << i;
        visited += found[i];
        wanted += within ? 1 : 0;
      }
    }
  }
  EXPECT_LT(visited, 2 * wanted);
}

TEST(tree, finds_the_nearest_box_a_node_at_a_time) {
  ph::testing::random_source random(tree_seed);
  const auto boxes = random_boxes<2>(1000, random);
  const ph::bounding_volume_tree<2> all(boxes);
  int all_looks = 0;
  for (int k = 0; k < 100; ++k) {
    const ph::point<2> x = 3 * random.normal_vector<double, 2>();
    double limit = everything;
    const auto bound = ph::squared_distance_from<2>(x);
    auto search = all.start();
    int looks = 0;
    for (; !search.done(); ++looks)
      all.go_on(
          search, bound, limit,
          [&](int place, double) {
            const auto& box = boxes[static_cast<std::size_t>(all.item(place))];
            limit = std::min(limit, squared_distance<2>(box, x));
          },
          1);
    double nearest = everything;
    for (const auto& b : boxes) nearest = std::min(nearest, squared_distance<2>(b, x));
    EXPECT_EQ(limit, nearest) << "seed " << tree_seed << ", point " << k;
    EXPECT_LE(looks, 120) << "most nodes are not looked at";
    all_looks += looks;
  }
  EXPECT_LE(all_looks, 1000) << "nearer branches come first";
}

// Wherever it has got to, a copy goes on to the same items.
TEST(tree, a_search_is_copied_with_what_is_left_of_it) {
  ph::testing::random_source random(tree_seed);
  const ph::bounding_volume_tree<2> all(random_boxes<2>(300, random));
  const auto bound = ph::squared_distance_from<2>(ph::point<2>::Zero());
  auto search = all.start();
  double limit = 1;
  while (!search.done()) {
    std::vector<int> rest, again;
    auto one = search, other = one;
    EXPECT_FALSE(other.done());
    all.go_on(one, bound, limit, [&](int place, double) { rest.push_back(place); });
    all.go_on(other, bound, limit, [&](int place, double) { again.push_back(place); }, 1);
    EXPECT_LE(again.size(), 16u) << "a node at a time";
    all.go_on(other, bound, limit, [&](int place, double) { again.push_back(place); });
    EXPECT_EQ(rest, again);
    all.go_on(search, bound, limit, [](int, double) {}, 1);
  }
}

// How many nodes a search opens that goes on once for what holds x.
template <int D>
int opened(const ph::bounding_volume_tree<D>& all, const ph::point<D>& x, int budget) {
  int nodes = 0;
  const auto distance = ph::squared_distance_from<D>(x);
  const auto bound = [&](const ph::four_outer_boxes<D>& boxes) {
    ++nodes;
    return distance(boxes);
  };
  auto search = all.start();
  double limit = 0;
  all.go_on(search, bound, limit, [](int, double) {}, budget);
  return nodes;
}

// Points that lie the closer the nearer they are to 0, the furthest first or last.
template <int D>
std::vector<ph::bounding_box<D>> ever_closer(int axis, bool furthest_first) {
  std::vector<ph::bounding_box<D>> boxes;
  for (int k = 0; k < 500; ++k)
    boxes.push_back(ph::box_about<D>(std::pow(0.98, k) * ph::point<D>::Unit(axis), 0));
  if (!furthest_first) std::reverse(boxes.begin(), boxes.end());
  return boxes;
}

TEST(tree, leads_to_a_place_by_as_many_nodes_as_it_is_deep) {
  constexpr int levels = 4;  // of 500 items, up to four in a leaf
  for (int axis = 0; axis < 2; ++axis) {
    for (const bool furthest_first : {false, true}) {
      const auto boxes = ever_closer<2>(axis, furthest_first);
      const ph::bounding_volume_tree<2> all(boxes);
      int nodes = 0;
      for (const auto& box : boxes) nodes += opened<2>(all, box.lower, 99);
      EXPECT_EQ(nodes, 500 * levels) << "axis " << axis;
      for (const int budget : {1, 2, 3}) EXPECT_EQ(opened<2>(all, boxes[300].lower, budget), budget);
    }
  }
}

// In float, too, the box that is searched holds the box.
TEST(tree, finds_a_box_at_its_very_distance) {
  ph::testing::random_source random(tree_seed);
  const auto finds = [](const ph::bounding_box<2>& box, const ph::point<2>& x) {
    int found = 0;
    ph::bounding_volume_tree<2>({box}).visit_within(
        ph::squared_distance_from<2>(x), squared_distance<2>(box, x), [&](int, double) { ++found; });
    return found;
  };
  for (int k = 0; k < 2000; ++k) {
    const auto boxes = random_boxes<2>(1, random);
    EXPECT_EQ(finds(boxes[0], 3 * random.normal_vector<double, 2>()), 1)
        << "seed " << tree_seed << ", box " << k;
    const ph::point<2> corner = random.positive(1e-20, 1e20) * random.normal_vector<double, 2>();
    EXPECT_EQ(finds({corner, corner}, corner), 1) << corner.transpose();
  }
}

// On the axis on which all lie, the box about some is as far as the nearest of them.
TEST(tree, opens_no_node_that_is_further_than_the_limit) {
  const ph::bounding_volume_tree<2> all(ever_closer<2>(0, true));
  ph::testing::random_source random(tree_seed);
  for (int k = 0; k < 200; ++k) {
    const ph::point<2> x = random.uniform(-1.0, 2.0) * ph::point<2>::UnitX();
    const auto distance = ph::squared_distance_from<2>(x);
    const double limit = random.positive(1e-3, 2.0);
    bool root = true;
    const auto bound = [&](const ph::four_outer_boxes<2>& boxes) {
      const auto squared = distance(boxes);
      double nearest = everything;
      for (int i = 0; i < 4; ++i) nearest = std::min(nearest, double(squared[i]));
      EXPECT_TRUE(root || nearest <= (1 + 1e-5) * limit) << "seed " << tree_seed << ", limit " << limit;
      root = false;
      return squared;
    };
    all.visit_within(bound, limit, [](int, double) {});
  }
}

// Points on a line, of which at each cut in the middle only a fifth lie beyond it.
void add_lopsided(double lower, double upper, int count, std::vector<double>& places) {
  if (count < 5) {
    for (int k = 0; k < count; ++k)
      places.push_back(k == 0 ? lower : k == 1 ? upper : lower + (upper - lower) / (k + 2));
    return;
  }
  const int beyond = (count + 3) / 5;
  const double middle = lower + (upper - lower) / 2;
  add_lopsided(lower, lower + 0.49 * (upper - lower), count - beyond, places);
  if (beyond == 1) places.push_back(upper);
  else add_lopsided(middle + 0.01 * (upper - lower), upper, beyond, places);
}

// No branch has more than 3/7 of its node's items: after five there are at most four left of 276.
TEST(tree, is_as_deep_as_it_says_at_most) {
  std::vector<double> places;
  add_lopsided(0, 1, 276, places);
  std::vector<ph::bounding_box<2>> boxes;
  for (const double at : places) boxes.push_back(ph::box_about<2>(at * ph::point<2>::UnitX(), 0));
  const ph::bounding_volume_tree<2> all(boxes);
  int max_depth = 0;
  for (const auto& box : boxes) max_depth = std::max(max_depth, opened<2>(all, box.lower, 99));
  EXPECT_LE(max_depth, 5);
}

TEST(a_tree, knows_how_large_its_coordinates_are) {
  EXPECT_EQ(ph::bounding_volume_tree<2>({{{-3, 1}, {2, 1.5}}, {{0, -2}, {1, 2.5}}}).scale(), 3);
  EXPECT_EQ(ph::bounding_volume_tree<2>({{{-3, 1}, {2, 1.5}}, {{0, -2}, {1, 3.5}}}).scale(), 3.5);
  EXPECT_EQ(ph::bounding_volume_tree<2>().scale(), 0);
  EXPECT_TRUE(ph::bounding_volume_tree<2>().start().done());
}

TEST(a_bounding_box, grows) {
  ph::bounding_box<2> box;
  box.extend(ph::point<2>(1, -2));
  EXPECT_EQ(box.lower, ph::point<2>(1, -2));
  EXPECT_EQ(box.upper, ph::point<2>(1, -2));
  box.extend(ph::bounding_box<2>{{0, -1}, {0.5, 3}});
  EXPECT_EQ(box.lower, ph::point<2>(0, -2));
  EXPECT_EQ(box.upper, ph::point<2>(1, 3));
  EXPECT_EQ(box.grown(0.25).lower, ph::point<2>(-0.25, -2.25));
  EXPECT_EQ(box.grown(0.25).upper, ph::point<2>(1.25, 3.25));
}

TEST(tree, of_equal_boxes_is_balanced) {
  const std::vector<ph::bounding_box<2>> boxes(10'000, ph::box_about<2>(ph::point<2>::Zero(), 1));
  int found = 0;
  ph::bounding_volume_tree<2>(boxes).visit_within(ph::squared_distance_from<2>(ph::point<2>::Zero()), 0.0,
                                                  [&](int, double) { ++found; });
  EXPECT_EQ(found, 10'000);
}

}  // namespace
