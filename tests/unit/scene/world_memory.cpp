// slow
// What a world knows of the handle from cycle to cycle: how far it may go unseen, and on which side of a
// sheet it is.
#include "many_shapes.hpp"

#include <passive_haptics/scene/mesh/mesh_surface.hpp>
#include <passive_haptics/scene/world/scene_exchange.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace ph = passive_haptics;

namespace {

constexpr unsigned seed = 20040627;
constexpr double hair = 1e-9;  // [m], thicker than all rounding

template <class Dimension>
struct the_memory_of_a_world : ::testing::Test {
  static constexpr int dimension = Dimension::value;
};
using dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(the_memory_of_a_world, dimensions);

// From anywhere straight into the nearest wall, by a hair, in one cycle or in some: nothing may be skipped
// too long.
TYPED_TEST(the_memory_of_a_world, knows_of_a_wall_that_is_entered_by_a_hair) {
  constexpr int D = TestFixture::dimension;
  for (const int count : {4, 60}) {
    ph::testing::random_source random(seed);
    const many_shapes::shapes<D> all(count, random);
    ph::world<D> w(all.walls());
    for (int k = 0; k < 500; ++k) {
      ph::point<D> x = random.between<double, D>(ph::point<D>::Zero(), ph::point<D>::Ones());
      double nearest = std::numeric_limits<double>::infinity();
      ph::point<D> out = ph::point<D>::Zero();
      all.for_each([&](const auto& shape) {
        if (shape.distance(x) >= nearest) return;
        nearest = shape.distance(x);
        out = shape.gradient(x);
      });
      if (nearest <= 0) continue;
      ASSERT_TRUE(ph::sense(w, x).empty());
      const int cycles = 1 + k % 4;
      for (int i = 1; i <= cycles; ++i) {
        const ph::point<D> there = x - ((nearest + hair) * i / cycles) * out;
        const auto& found = ph::sense(w, there);
        ASSERT_EQ(found.empty(), i < cycles)
            << "seed " << seed << ", trial " << k << ", cycle " << i << " of " << cycles;
        ASSERT_TRUE(many_shapes::same(found, many_shapes::scan<D + 1>(all, there)));
      }
    }
  }
}

// The same where walls come to a handle that rests or goes to meet them.
TYPED_TEST(the_memory_of_a_world, knows_of_a_wall_that_comes_by_a_hair) {
  constexpr int D = TestFixture::dimension;
  ph::testing::random_source random(seed);
  ph::world_walls<D> walls;
  constexpr int count = 3;
  constexpr double radius = 0.01;
  for (int i = 0; i < count; ++i) walls.add_moving(ph::wall(ph::ball<D>(ph::point<D>::Zero(), radius)));
  ph::world<D> w(walls);
  ph::point<D> at[count];
  const auto put = [&](int i, const ph::point<D>& x) {
    at[i] = x;
    EXPECT_TRUE(w.set_motion(i, x, ph::point<D>::Zero()));
  };
  for (int k = 0; k < 1000; ++k) {
    ph::point<D> x = random.direction<double, D>();
    for (int i = 0; i < count; ++i) put(i, x + random.positive(0.02, 5.0) * random.direction<double, D>());
    if (k % 50 == 0) w.reset();
    ASSERT_TRUE(ph::sense(w, x).empty());
    const int coming = k % count, cycles = 1 + k % 5;
    const ph::point<D> way = at[coming] - x, direction = way.normalized();
    const double step = (way.norm() - radius + hair) / cycles,
                 share = k % 2 == 0 ? 0 : random.uniform(0.0, 1.0);
    for (int i = 1; i <= cycles; ++i) {
      put(coming, at[coming] - (1 - share) * step * direction);
      x += share * step * direction;
      int touched = 0;
      for (const auto& c : at) touched += (x - c).norm() < radius;
      ASSERT_EQ(ph::sense(w, x).size(), touched)
          << "seed " << seed << ", trial " << k << ", cycle " << i << " of " << cycles;
      if (i == cycles) {
        ASSERT_GE(touched, 1);
      }
    }
  }
}

// A sheet from edge to edge; its front is up.
template <int D>
ph::mesh_surface<D> sheet() {
  if constexpr (D == 2)
    return ph::mesh_surface<2>(ph::mesh<2>({.vertices = {{-50, 0}, {50, 0}}, .facets = {{1, 0}}}));
  else
    return ph::mesh_surface<3>(
        ph::mesh<3>({.vertices = {{-50, -50, 0}, {50, -50, 0}, {50, 50, 0}, {-50, 50, 0}},
                     .facets = {{0, 1, 2}, {0, 2, 3}}}));
}

// What sheets do with a handle that goes up and down through them: its proxy stays in front of those in front
// of which it was, whatever lies behind them, and behind a sheet it is free.
template <int Count>
class proxy_over_sheets {
 public:
  using heights = std::array<double, static_cast<std::size_t>(Count)>;
  void go(const heights& sheets, double x) {
    sheet_ = -1;
    double proxy = x;
    for (int i = 0; i < Count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (!(proxy_ >= before_[k]) || !(sheets[k] > proxy)) continue;
      proxy = sheets[k];
      sheet_ = i;
    }
    proxy_ = proxy;
    depth_ = proxy - x;
    before_ = sheets;
  }
  void forget() { proxy_ = std::numeric_limits<double>::quiet_NaN(); }
  double depth_at(int sheet) const { return sheet == sheet_ ? depth_ : 0; }

 private:
  double proxy_ = std::numeric_limits<double>::quiet_NaN(), depth_ = 0;
  int sheet_ = -1;
  heights before_{};
};

// Of sheet i [N/m]
double stiffness_of(int i) { return 100.0 + i; }

// Sheets that move, or stay and are followed, and a handle that jumps from side to side of each. `cycle`
// moves the sheets and senses at x; `reset` forgets the handle.
template <int D, class Cycle, class Reset>
void expect_sides_are_kept(const Cycle& cycle, const Reset& reset) {
  ph::testing::random_source random(seed);
  constexpr int moving = 2, all = 3;
  proxy_over_sheets<all> expected;
  ph::point<D> displacement[moving];
  for (auto& d : displacement) d.setZero();
  int held = 0, free_behind = 0;
  for (int k = 0; k < 1500; ++k) {
    if (k % 40 == 39) {
      reset();
      expected.forget();
    }
    // About one of the sheets, which may have moved by more than the handle's height over it, or stands still
    const int about = static_cast<int>(random.uniform(0.0, 2.999));
    if (k % 3 != 0) {
      for (auto& d : displacement) d = random.uniform(-1.0, 1.0) * random.direction<double, D>();
    }
    ph::point<D> x = random.direction<double, D>();
    x[D - 1] = random.wide(1e-3, 0.3) + (about < moving ? displacement[about][D - 1] : 0.0);
    const auto& touched = cycle(k, displacement, x);
    for (const auto& c : touched) ASSERT_EQ(c.stiffness, stiffness_of(c.wall_number));
    std::array<double, all> sheets{};
    for (std::size_t i = 0; i < moving; ++i) sheets[i] = displacement[i][D - 1];
    expected.go(sheets, x[D - 1]);
    for (int i = 0; i < all; ++i) {
      double depth = 0;
      for (const auto& c : touched) depth += c.wall_number == i ? c.depth : 0.0;
      ASSERT_NEAR(depth, expected.depth_at(i), 1e-5) << "seed " << seed << ", cycle " << k << ", sheet " << i;
      held += expected.depth_at(i) > 0;
      free_behind += x[D - 1] < sheets[static_cast<std::size_t>(i)] && expected.depth_at(i) == 0;
    }
  }
  EXPECT_GT(held, 500);
  EXPECT_GT(free_behind, 25);
}

// Two that move, one that is followed but stays.
template <int D>
ph::world_walls<D> three_sheets() {
  ph::world_walls<D> walls;
  for (int i = 0; i < 2; ++i) walls.add_moving(ph::wall(sheet<D>(), stiffness_of(i)));
  walls.add(ph::wall(sheet<D>(), stiffness_of(2)));
  return walls;
}

TYPED_TEST(the_memory_of_a_world, stays_in_front_of_sheets_however_they_move) {
  constexpr int D = TestFixture::dimension;
  ph::world<D, 6> w(three_sheets<D>());
  const auto cycle = [&](int, const auto& displacement, const ph::point<D>& x) -> decltype(auto) {
    for (int i = 0; i < 2; ++i) w.set_motion(i, displacement[i], ph::point<D>::Zero());
    return ph::sense(w, x);
  };
  expect_sides_are_kept<D>(cycle, [&] { w.reset(); });
}

// Another thread publishes worlds that have never seen the handle; each takes over from the one before.
TYPED_TEST(the_memory_of_a_world, is_handed_on_where_scenes_are_exchanged) {
  constexpr int D = TestFixture::dimension;
  using world = ph::world<D, 6>;
  const world unseen(three_sheets<D>());
  ph::scene_exchange<world> exchange(unseen, 0.0);
  ph::latest_scene latest(exchange, {.stale_after = 1e9});
  const auto cycle = [&](int k, const auto& displacement, const ph::point<D>& x) -> decltype(auto) {
    world next = unseen;
    for (int i = 0; i < 2; ++i) next.set_motion(i, displacement[i], ph::point<D>::Zero());
    if (k % 3 != 0) exchange.publish(next, k);
    return ph::sense(latest, x, k);
  };
  expect_sides_are_kept<D>(cycle, [&] { exchange.scene().reset(); });
}

// A plate that is shared, under a hand that is deeper than the plate is thick; other walls come and go.
TYPED_TEST(the_memory_of_a_world, holds_at_a_plate_where_scenes_are_exchanged) {
  constexpr int D = TestFixture::dimension;
  ph::point<D> half = ph::point<D>::Constant(0.1), x = ph::point<D>::Zero();
  half[D - 1] = 0.001;
  ph::world_walls<D> walls;
  walls.add(ph::wall(ph::box<D>(ph::point<D>::Zero(), half)));
  ph::scene_exchange<ph::world<D>> exchange(ph::world<D>(walls), 0.0);
  ph::latest_scene latest(exchange, {.stale_after = 1e9});
  for (int k = 0; k < 20; ++k) {
    walls.add(ph::wall(ph::ball<D>((k - 10.0) * ph::point<D>::UnitX(), 0.1)));
    exchange.publish(ph::world<D>(walls), k);
    x[D - 1] = 0.002 - 0.0005 * k;
    const auto& touched = ph::sense(latest, x, k);
    ASSERT_EQ(touched.size(), x[D - 1] < 0.001 ? 1 : 0) << k;
    for (const auto& c : touched) EXPECT_NEAR(c.depth, 0.001 - x[D - 1], 1e-12) << k;
  }
}

}  // namespace
