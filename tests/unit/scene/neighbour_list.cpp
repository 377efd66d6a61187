// How long a list of neighbours lasts: until an item may have been reached, and hardly shorter.
#include <passive_haptics/scene/bounds/bounding_box.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/world/neighbour_list.hpp>
#include <passive_haptics/scene/world/world.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace ph = passive_haptics;

namespace {

// Points on the x axis; how often the list was asked about them, and which of them it looked at.
struct points_on_a_line {
  std::vector<double> places;
  ph::bounding_volume_tree<2> tree;
  ph::neighbour_list<2> near;
  int visits = 0;
  std::vector<double> seen{};

  explicit points_on_a_line(std::vector<double> at) : places(std::move(at)) {
    std::vector<ph::bounding_box<2>> boxes;
    for (const double x : places) boxes.push_back(ph::box_about<2>({x, 0}, 0));
    tree = ph::bounding_volume_tree<2>(boxes);
    near = ph::neighbour_list<2>(0, tree.scale());
  }

  void go(double x) {
    seen.clear();
    if (near.idle({x, 0})) return;
    ++visits;
    near.visit(tree, {x, 0}, [&](ph::world_item item) {
      seen.push_back(places[static_cast<std::size_t>(tree.item(static_cast<int>(item.place())))]);
      return std::abs(seen.back() - x);
    });
  }
};

// A metre from the origin, on the negative side; more than a list holds.
std::vector<double> row_of_points() {
  std::vector<double> places;
  for (int i = 0; i < 100; ++i) places.push_back(-1 - 0.01 * i);
  return places;
}

TEST(a_list_of_neighbours, is_idle_until_the_nearest_may_be_reached) {
  points_on_a_line line({-3, 2});
  for (int k = 0; k < 2; ++k) line.go(0);
  EXPECT_TRUE(line.seen.empty());
  EXPECT_TRUE(line.near.idle({1.999, 0}));
  EXPECT_TRUE(line.near.idle({0, -1.999}));
  EXPECT_FALSE(line.near.idle({2, 0}));
  line.go(2);
  EXPECT_EQ(line.seen, std::vector<double>{2});
}

TEST(a_list_of_neighbours, begins_where_it_is_collected) {
  points_on_a_line line(row_of_points());
  for (int k = 0; k < 2; ++k) line.go(5);
  EXPECT_TRUE(line.near.idle({5, 3}));
}

// Away from more points than it holds, a thousand cycles for each metre: it is collected in a few of them.
// All coordinates are exact in either frame, so that it is asked in the same cycles.
TEST(a_list_of_neighbours, knows_no_origin) {
  const auto asked_in = [](double origin) {
    std::vector<double> places;
    for (int i = 0; i < 100; ++i) places.push_back(origin - 1 - i / 128.0);
    points_on_a_line line(places);
    std::vector<int> cycles;
    for (int k = 0; k <= 3000; ++k) {
      const int before = line.visits;
      line.go(origin + k / 1024.0);
      if (line.visits > before) cycles.push_back(k);
    }
    return cycles;
  };
  EXPECT_GT(asked_in(0).size(), 5U);
  EXPECT_LT(asked_in(0).size(), 60U);
  EXPECT_EQ(asked_in(1024), asked_in(0));
}

// Something is touched all the way, so that it is asked in each cycle and the way is a sum of many.
TEST(a_list_of_neighbours, loses_nothing_of_a_way_in_many_steps) {
  const ph::bounding_volume_tree<2> tree({ph::box_about<2>({0, 0}, 0)});
  ph::neighbour_list<2> near(1, tree.scale());
  bool seen = false;
  const auto go = [&](double x) {
    seen = false;
    near.visit(tree, {x, 0}, [&](ph::world_item item) {
      seen |= item.is_in_tree();
      return item.is_in_tree() ? std::abs(x) : 0;
    });
  };
  for (int k = 0; k < 2; ++k) go(0);
  for (int k = 1; k <= 512; ++k) go(k / 1024.0);
  for (int k = 511; k >= 0; --k) go(k / 1024.0);
  EXPECT_TRUE(seen);
}

// A hand that jumps: no list is made for a place that it will have left, until it may be a place to stay.
TEST(a_list_of_neighbours, is_not_collected_where_the_hand_has_jumped_but_tried_some_day) {
  points_on_a_line line(row_of_points());
  for (int k = 0; k < 2; ++k) line.go(0);
  EXPECT_TRUE(line.near.idle({0, 0}));
  int jumps = 0;
  for (; jumps < 1000; ++jumps) {
    line.go(jumps % 2 == 0 ? 3 : 0);
    if (line.near.idle({jumps % 2 == 0 ? 3.0 : 0.0, 0})) break;
  }
  EXPECT_GT(jumps, 100);
  EXPECT_LT(jumps, 1000);
}

TEST(a_list_of_neighbours, stays_idle_while_what_moves_is_further_off_than_the_hand) {
  const ph::bounding_volume_tree<2> none;
  ph::neighbour_list<2> near(1, 1);
  for (int k = 0; k < 2; ++k) near.visit(none, {0, 0}, [](ph::world_item) { return 0.9; });
  ASSERT_TRUE(near.idle({0.89, 0}));
  near.moved(0, 0.1);
  EXPECT_TRUE(near.idle({0.79, 0}));
  EXPECT_FALSE(near.idle({0.81, 0}));
  near.moved(0, 0.9);
  EXPECT_FALSE(near.idle({0, 0}));
}

// Distances are rounded far from the origin, and near it by the far centre of a moving ball.
TEST(a_world, is_touched_as_soon_as_the_handle_is_behind_a_wall) {
  constexpr unsigned seed = 20040627;
  ph::testing::random_source random(seed);
  int touched = 0;
  const auto expect_touch = [&](auto shape, bool moves, const ph::point<2>& place, const ph::point<2>& out) {
    ph::world_walls<2> walls;
    if (moves) walls.add_moving(ph::wall(shape));
    else walls.add(ph::wall(shape));
    ph::world<2> w(walls);
    for (int again = 0; again < 2; ++again) EXPECT_TRUE(ph::sense(w, place + out).empty());
    const ph::point<2> x = place + random.uniform(-1e-9, 1e-9) * out;
    const bool behind = shape.distance(x) < 0;
    ASSERT_EQ(ph::sense(w, x).size(), behind ? 1 : 0) << "seed " << seed << ", moves " << moves;
    touched += behind;
  };
  for (int k = 0; k < 1000; ++k) {
    const ph::point<2> out = random.direction<double, 2>(), along(-out.y(), out.x()),
                       place = random.direction<double, 2>();
    expect_touch(ph::half_space<2>(1e6 * (place + along), out), false, 1e6 * place, out);
    expect_touch(ph::ball<2>(place - 1e6 * out, 1e6), true, place, out);
  }
  EXPECT_GT(touched, 600);
}

}  // namespace
