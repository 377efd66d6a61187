// optimised
// A world of many walls is touched where a look at each of them says so, however few it looks at. In three
// dimensions: world_memory.cpp.
#include "many_shapes.hpp"

#include <passive_haptics/scene/scene.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/capsule.hpp>
#include <passive_haptics/scene/shapes/complement.hpp>
#include <passive_haptics/scene/shapes/moving.hpp>
#include <passive_haptics/scene/shapes/offset.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace ph = passive_haptics;

namespace {

constexpr unsigned seed = 20040627;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// How often distances were asked for since it was set to zero.
long looks = 0;

template <class S>
struct counted : S {
  using S::S;
  explicit counted(const S& s) : S(s) {}
  double distance(const ph::point<S::dimension>& x) const {
    ++looks;
    return S::distance(x);
  }
};

template <int D>
ph::world_walls<D> counted_walls(const many_shapes::shapes<D>& all) {
  ph::world_walls<D> walls;
  all.for_each([&]<class S>(const S& s) { walls.add(ph::wall(counted<S>(s))); });
  return walls;
}

TEST(world, is_touched_as_a_scan_says_after_jumps_near_and_far) {
  ph::testing::random_source random(seed);
  const many_shapes::shapes<2> all(1000, random);
  ph::world<2> w(counted_walls(all));
  ph::point<2> x = ph::point<2>::Constant(0.5);
  int touched = 0;
  for (int k = 0; k < 5000; ++k) {
    switch (k % 7) {
      case 0: x = random.between<double, 2>(ph::point<2>::Constant(-0.1), ph::point<2>::Constant(1.1)); break;
      case 1: x += 1e-17 * random.direction<double, 2>(); break;
      case 2:
        if (k % 70 == 2) x = 1e3 * random.direction<double, 2>();
        if (k % 700 == 2) x = 1e200 * random.direction<double, 2>();
        break;
      default: x += random.positive(1e-6, 0.2) * random.direction<double, 2>();
    }
    const auto& found = ph::sense(w, x);
    ASSERT_TRUE(many_shapes::same(found, many_shapes::scan<3>(all, x))) << "seed " << seed << ", jump " << k;
    touched += found.size();
  }
  EXPECT_GT(touched, 500);
}

// Without a margin at first, when most cycles look at nothing.
TEST(world, is_touched_from_its_margin_on_as_a_scan_says) {
  ph::testing::random_source random(seed);
  const many_shapes::shapes<2> all(300, random);
  ph::world<2, 8> w(counted_walls(all));
  many_shapes::wandering_hand<2> hand(5e-4, random);
  int touched = 0, before_touch = 0;
  looks = 0;
  double margin = 0;
  for (int k = 0; k < 8000; ++k) {
    if (k == 3000) {
      EXPECT_LT(looks, 3000);
    }
    if (k % 1000 == 999 && k > 3000) w.set_margin(margin = random.uniform(0.0, 0.006));
    ph::point<2> x = hand.next();
    if (k % 500 == 499) x += random.direction<double, 2>();  // a jump
    const auto& found = ph::sense(w, x);
    ASSERT_TRUE(many_shapes::same(found, many_shapes::scan<8>(all, x, margin)))
        << "seed " << seed << ", cycle " << k;
    for (const auto& c : found) ++(c.depth < 0 ? before_touch : touched);
  }
  EXPECT_GT(touched, 10);
  EXPECT_GT(before_touch, 30);
  EXPECT_LT(looks, 16'000);
}

// The bound of a cycle: 64 looks beyond the contacts, at any speed.
TEST(world, looks_at_few_in_the_worst_cycle) {
  ph::testing::random_source random(seed);
  const many_shapes::shapes<2> all(2000, random);
  ph::world<2, 8> w(counted_walls(all));
  long worst = 0;
  for (const double step : {2e-6, 2e-4, 2e-3, 2e-2}) {
    many_shapes::wandering_hand<2> hand(step, random);
    for (int k = 0; k < 5000; ++k) {
      looks = 0;
      const auto& found = ph::sense(w, hand.next());
      worst = std::max(worst, looks - found.size() - w.left_out());
    }
  }
  EXPECT_LE(worst, 64);
}

// Two rooms without bounds: a hand at the wall of the inner one, and the outer one 9 m further off.
TEST(world, looks_at_an_unbounded_wall_only_when_it_is_due) {
  using room = counted<ph::ball<2>>;
  ph::world_walls<2> walls;
  for (const double radius : {1.0, 10.0})
    walls.add(ph::wall(room(ph::point<2>::Zero(), radius, ph::filling::hollow)));
  ph::world<2> w(walls);
  const auto at = [&](double r) { return ph::sense(w, ph::point<2>(r * ph::point<2>::UnitX())).size(); };
  for (const double r : {0.999, 0.9991}) EXPECT_EQ(at(r), 0);
  looks = 0;
  for (int k = 0; k < 100; ++k) EXPECT_EQ(at(1.001 - 1e-6 * k), 1) << k;
  EXPECT_EQ(looks, 100) << "of the inner one alone";
}

TEST(world, finds_all_of_many_walls_in_one_place) {
  ph::testing::random_source random(seed);
  ph::world_walls<2> walls;
  constexpr int count = 200;
  for (int i = 0; i < count; ++i) walls.add(ph::wall(ph::ball<2>(ph::point<2>::Zero(), 0.004), 1e3 + i));
  ph::world<2> w(walls);
  for (int k = 0; k < 100; ++k) {
    const auto& found = ph::sense(w, ph::point<2>(0.002 * random.direction<double, 2>()));
    ASSERT_EQ(found.size(), 3);
    EXPECT_EQ(w.left_out(), count - 3);
    for (int i = 0; i < 3; ++i)
      EXPECT_EQ(found[i].wall_number, count - 3 + i) << "those of the largest forces";
    EXPECT_TRUE(ph::sense(w, ph::point<2>(0.02 * random.direction<double, 2>())).empty());
  }
}

// A heap of balls of all sizes up to a centimetre (a proxy feels larger ones that overlap), and steps of all
// sizes: the next list may reach less far than the handle went meanwhile.
TEST(world, is_touched_as_a_scan_says_in_a_heap_of_all_sizes) {
  ph::testing::random_source random(seed);
  many_shapes::shapes<2> all(0, random);
  const ph::point<2> middle = ph::point<2>::Constant(0.5);
  for (int i = 0; i < 3000; ++i) {
    const double spread = random.positive(1e-5, 0.3);
    all.balls.emplace_back(middle + spread * random.normal_vector<double, 2>(),
                           std::min((0.03) * spread, 4.9e-3));
  }
  ph::world<2> w(counted_walls(all));
  ph::point<2> x = middle;
  int touched = 0;
  for (int k = 0; k < 5000; ++k) {
    const double r = (x - middle).norm();  // the size of the balls about x, too
    if (r < 1e-5 || r > 0.5) x = middle + random.positive(1e-4, 0.3) * random.direction<double, 2>();
    else x += random.positive(0.01, 1.0) * r * random.direction<double, 2>();
    const auto& found = ph::sense(w, x);
    ASSERT_TRUE(many_shapes::same(found, many_shapes::scan<3>(all, x))) << "seed " << seed << ", step " << k;
    touched += found.size();
  }
  EXPECT_GT(touched, 250);
}

// With a list of so few that what is near keeps driving out what is further: from anywhere straight to the
// last that has room.
TEST(world, looks_at_all_that_is_touched_however_few_it_lists) {
  constexpr int count = 100, listed = 3, steps = 10;
  constexpr double radius = 0.02;
  ph::testing::random_source random(seed);
  const auto anywhere = [&] { return random.between<double, 2>(ph::point<2>::Zero(), ph::point<2>::Ones()); };
  std::vector<ph::point<2>> balls;
  std::vector<ph::bounding_box<2>> boxes;
  for (int i = 0; i < count; ++i) {
    balls.push_back(anywhere());
    boxes.push_back(ph::box_about<2>(balls.back(), radius));
  }
  const ph::bounding_volume_tree<2> tree(boxes);
  ph::neighbour_list<2, listed> near(0, tree.scale());
  for (int k = 0; k < 200; ++k) {
    const ph::point<2> from = anywhere();
    auto by_distance = balls;
    const auto last = by_distance.begin() + listed - 1;
    std::nth_element(by_distance.begin(), last, by_distance.end(), [&](const auto& a, const auto& b) {
      return (a - from).squaredNorm() < (b - from).squaredNorm();
    });
    for (int i = 0; i <= steps; ++i) {
      const ph::point<2> x = from + (*last - from) * i / steps;
      const auto distance = [&](const auto& ball) { return (x - ball).norm() - radius; };
      auto missed = std::count_if(balls.begin(), balls.end(), [&](const auto& b) { return distance(b) < 0; });
      if (!near.idle(x))
        near.visit(tree, x, [&](ph::world_item item) {
          const double free =
              distance(balls[static_cast<std::size_t>(tree.item(static_cast<int>(item.place())))]);
          missed -= free < 0;
          return std::max(free, 0.0);
        });
      ASSERT_EQ(missed, 0) << "seed " << seed << ", trial " << k << ", step " << i;
    }
  }
}

TEST(world, tells_of_a_position_that_is_none_and_forgets_it) {
  ph::world_walls<2> walls;
  walls.add(ph::wall(ph::ball<2>(ph::point<2>::Zero(), 0.01)));
  ph::world<2> w(walls);
  const ph::point<2> inside = 0.005 * ph::point<2>::UnitX();
  EXPECT_EQ(ph::sense(w, inside).size(), 1);
  ph::world<2> empty{ph::world_walls<2>()};
  EXPECT_TRUE(ph::sense(empty, inside).empty());
  for (const double bad : {nan, HUGE_VAL, -HUGE_VAL}) {
    ph::point<2> x = inside;
    x[1] = bad;
    ASSERT_EQ(ph::sense(w, x).size(), 1);
    EXPECT_TRUE(std::isnan(ph::sense(w, x)[0].depth));
    EXPECT_EQ(ph::sense(w, inside)[0].depth, 0.005);
    EXPECT_TRUE(ph::sense(w, ph::point<2>(2 * inside + 2 * inside)).empty());
  }
}

TEST(world, copies_have_a_memory_of_their_own) {
  ph::testing::random_source random(seed);
  const many_shapes::shapes<2> all(500, random);
  ph::world<2> a(counted_walls(all));
  many_shapes::wandering_hand<2> hand(1e-3, random), other(1e-3, random);
  for (int k = 0; k < 100; ++k) ph::sense(a, hand.next());
  ph::world<2> b = a;
  for (int k = 0; k < 500; ++k) {
    const ph::point<2> x = hand.next(), y = other.next();
    ASSERT_TRUE(many_shapes::same(ph::sense(a, x), many_shapes::scan<3>(all, x)));
    ASSERT_TRUE(many_shapes::same(ph::sense(b, y), many_shapes::scan<3>(all, y)));
    if (k % 100 == 0) b.reset();
  }
}

TEST(world, is_of_any_shape_with_bounds_or_without) {
  const ph::point<2> e = ph::point<2>::UnitX(), o = ph::point<2>::Zero();
  ph::world_walls<2> walls;
  auto scan = ph::scene(ph::wall(ph::ball<2>(o, 0.1)), ph::wall(ph::capsule<2>(0.3 * e, 2 * e, 0.1)),
                        ph::wall(ph::offset(ph::box<2>(3 * e, ph::point<2>::Constant(0.2)), 0.05)),
                        ph::wall(ph::complement(ph::ball<2>(o, 10))),
                        ph::wall(ph::ball<2>(o, 12, ph::filling::hollow)),
                        ph::wall(ph::offset(ph::ball<2>(5 * e, 0.2), -0.05)));
  scan.for_each([&](int number, const auto& wall) {
    if (number < 5) walls.add(wall);
  });
  walls.add(ph::any_wall<2>(scan.get<5>(), ph::box_about<2>(5 * e, 0.2)));
  ph::world<2, 8> w(walls);
  ph::testing::random_source random(seed);
  int touched[6] = {};
  for (int k = 0; k < 3000; ++k) {
    const ph::point<2> x = random.positive(1e-3, 15.0) * (k % 2 == 0 ? random.direction<double, 2>() : e);
    ASSERT_TRUE(many_shapes::same(ph::sense(w, x), ph::sense(scan, x))) << "seed " << seed << ", point " << k;
    for (const auto& c : ph::sense(w, x)) ++touched[c.wall_number];
  }
  for (const int n : touched) EXPECT_GT(n, 2);
}

// A wall that lies where it was told.
struct wall_within {
  static constexpr int dimension = 2;
  ph::bounding_box<2> box;
  ph::bounding_box<2> bounds() const { return box; }
  double distance(const ph::point<2>&) const { return 1; }
  ph::point<2> gradient(const ph::point<2>&) const { return {1, 0}; }
};

TEST(a_world, refuses_a_wall_that_is_nowhere) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto said_of = [](const ph::bounding_box<2>& box) {
    ph::world_walls<2> walls;
    walls.add(ph::wall(ph::ball<2>({0, 0}, 1)));
    walls.add(ph::wall(wall_within{box}));
    return validate(walls);
  };
  EXPECT_EQ(said_of({{0, 0}, {0, 0}}), "");
  EXPECT_EQ(said_of({{-infinity, -1}, {1, infinity}}), "");
  const std::string name = "bounds of wall 1 of a world: upper[";
  EXPECT_EQ(said_of({{0, 1}, {1, 0}}), name + "1] [m] = 0: expected at least lower, 1");
  EXPECT_EQ(said_of({{1, 0}, {0, 1}}), name + "0] [m] = 0: expected at least lower, 1");
  EXPECT_EQ(said_of({{nan, 0}, {1, 1}}), name + "0] [m] = 1: expected at least lower, nan");
  EXPECT_EQ(said_of({{0, 0}, {1, nan}}), name + "1] [m] = nan: expected at least lower, 0");
  ph::world_walls<2> given;
  given.add(ph::any_wall<2>(ph::wall(ph::ball<2>({0, 0}, 1)), ph::box_about<2>({0, 0}, -1)));
  EXPECT_THROW(ph::world<2>{given}, std::invalid_argument);
}

// Stores where the handle came from, and counts from 7 in one byte of its tracker how often it was asked.
struct following_wall {
  static constexpr int dimension = 2;
  struct tracker {
    signed char count = 7;
  };
  inline static ph::point<2> came_from = ph::point<2>::Zero();
  inline static int count = 0;
  ph::bounding_box<2> bounds() const { return ph::box_about<2>({0, 0}, 1); }
  template <class Add>
  double follow(const ph::point<2>& from, const ph::point<2>&, tracker& t, Add&&) const {
    came_from = from;
    count = t.count++;
    return 0;
  }
};

TEST(a_world, that_forgets_the_handle_begins_again) {
  ph::world_walls<2> walls;
  walls.add(ph::wall(following_wall{}));
  ph::world<2> w(walls);
  for (int again = 0; again < 2; ++again) {
    for (int k = 0; k < 3; ++k) {
      ph::sense(w, {0.1 * k, 0});
      EXPECT_EQ(following_wall::came_from.hasNaN(), k == 0);
      EXPECT_TRUE(k == 0 || following_wall::came_from == ph::point<2>(0.1 * (k - 1), 0));
      EXPECT_EQ(following_wall::count, 7 + k);
    }
    w.reset();
  }
}

TEST(world, has_walls_that_move) {
  ph::testing::random_source random(seed);
  const many_shapes::shapes<2> all(300, random);
  ph::world_walls<2> walls = counted_walls(all);
  const ph::ball<2> ball(ph::point<2>::Constant(0.5), 0.05);
  const int moved = walls.add_moving(ph::wall(ball));
  const int still = walls.add_moving(ph::wall(ph::ball<2>(ph::point<2>::Constant(0.2), 0.02)));
  ph::world<2, 8> w(walls);
  ph::moving truth(ball);
  many_shapes::wandering_hand<2> hand(2e-4, random);
  ph::point<2> displacement = ph::point<2>::Zero();
  int touched = 0;
  for (int k = 0; k < 10'000; ++k) {
    const ph::point<2> x = hand.next();
    const ph::point<2> velocity = random.normal_vector<double, 2>();
    if (k % 3 != 0) {  // it comes after the handle
      const ph::point<2> to = x - ph::point<2>::Constant(0.5) - displacement;
      displacement += 1e-4 * to.stableNormalized() + 1e-5 * velocity;
      ASSERT_TRUE(w.set_motion(moved, displacement, velocity));
      truth.set_motion(displacement, velocity);
    }
    auto expected = many_shapes::scan<8>(all, x);
    if (truth.distance(x) < 0) {
      auto c = ph::contact_of(ph::wall(truth), x, truth.distance(x));
      c.wall_number = moved;
      expected.append_unchecked(c);
      ++touched;
    }
    if ((x - ph::point<2>::Constant(0.2)).norm() > 0.02) {
      ASSERT_TRUE(many_shapes::same(ph::sense(w, x), expected)) << "seed " << seed << ", cycle " << k;
    }
  }
  EXPECT_GT(touched, 200);
  EXPECT_FALSE(w.set_motion(still - 2, displacement, displacement)) << "it was not added as moving";
  EXPECT_FALSE(w.set_motion(99'999, displacement, displacement));
  EXPECT_FALSE(w.set_motion(moved, ph::point<2>::Constant(nan), displacement));
}

TEST(a_world, adds_the_velocity_of_a_wall_to_that_of_its_shape) {
  ph::moving belt(ph::half_space<2>({0, 0}, {1, 0}));
  belt.set_motion({0, 0}, {0, 2});
  ph::world_walls<2> walls;
  const int lid = walls.add_moving(ph::wall(belt, 10));
  ph::world<2> w(walls);
  w.set_motion(lid, {0, 0}, {1, 0});
  w.extrapolate(HUGE_VAL);
  ASSERT_EQ(ph::sense(w, {-0.1, 0}).size(), 1);
  EXPECT_EQ(ph::sense(w, {-0.1, 0})[0].wall_velocity, ph::point<2>(1, 2));
  EXPECT_EQ(ph::sense(w, {-0.1, 0})[0].depth, 0.1);
}

// Of walls that demand equal forces, those of lower numbers are kept; of one wall's contacts the deepest
// comes first.
TEST(strongest_contacts, are_the_first_of_equals_whatever_the_order) {
  for (const bool backwards : {false, true}) {
    ph::strongest_contacts<2, 2> found;
    for (int k = 0; k < 4; ++k)
      found.add({.depth = 0.1, .stiffness = 10, .wall_number = backwards ? 3 - k : k});
    EXPECT_EQ(found.in_order()[0].wall_number, 0);
    EXPECT_EQ(found.in_order()[1].wall_number, 1);
    EXPECT_EQ(found.left_out(), 2);
    found.clear();
    for (const double depth : {0.1, 0.3}) found.add({.depth = depth, .stiffness = 10, .wall_number = 7});
    EXPECT_EQ(found.in_order()[0].depth, 0.3);
  }
}

TEST(any_wall, tells_what_its_wall_tells) {
  const ph::wall disc(ph::disc({1, 2}, 0.5), 300);
  const ph::any_wall<2> wall(disc), copy = wall, equal(disc);
  EXPECT_TRUE(wall.shares(copy));
  EXPECT_FALSE(wall.shares(equal));
  EXPECT_EQ(wall.tracker_size(), 0u);
  EXPECT_EQ(wall.bounds().lower, ph::point<2>(0.5, 1.5));
  ph::contacts<2, 2> found;
  EXPECT_EQ(wall.look({9, 9}, {1, 3}, 0, nullptr, found), 0.5);
  EXPECT_EQ(wall.look({9, 9}, {1, 2.5}, 0, nullptr, found), 0);
  EXPECT_TRUE(found.empty()) << "not on the surface itself";
  EXPECT_EQ(wall.look({9, 9}, {1, 2.25}, 0, nullptr, found), 0);
  ASSERT_EQ(found.size(), 1);
  EXPECT_EQ(found[0].depth, 0.25);
  EXPECT_EQ(found[0].stiffness, 300);
  EXPECT_EQ(found[0].normal, ph::point<2>(0, 1));
}

}  // namespace
