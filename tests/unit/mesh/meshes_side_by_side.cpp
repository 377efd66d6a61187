// slow
// Walls side by side are felt as one: meshes, and shapes beside them, stop one proxy of the handle.
#include <passive_haptics/scene/mesh/mesh_solid.hpp>
#include <passive_haptics/scene/mesh/mesh_surface.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/box.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/scene/world/world.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include "../../property/sample_meshes.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace side_by_side {
namespace ph = passive_haptics;
using at = ph::point<3>;

constexpr double size = 0.2;           // of a floor [m]
constexpr double exact = 1e-9 * size;  // [m]
constexpr double pressed = 1e-3;       // depth of the hand [m]
constexpr unsigned seed = 20040627;

// A rectangle of the floor z = 0, its corners one after the other.
ph::mesh_parameters<3> sheet(double x0, double y0, double x1, double y1) {
  return {{{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}
// A block whose top is this rectangle.
ph::mesh_parameters<3> block(double x0, double y0, double x1, double y1, double bottom = -0.05) {
  return sample_meshes::box<3>({x0, y0, bottom}, {x1, y1, 0});
}
ph::any_wall<3> surface(const ph::mesh_parameters<3>& m) {
  return ph::wall(ph::mesh_surface<3>(ph::triangle_mesh(m)));
}
ph::any_wall<3> solid(const ph::mesh_parameters<3>& m) {
  return ph::wall(ph::mesh_solid<3>(ph::triangle_mesh(m)));
}
ph::any_wall<3> box(double x0, double y0, double x1, double y1) {
  return ph::wall(ph::box<3>({.centre = {(x0 + x1) / 2, (y0 + y1) / 2, -0.025},
                              .half_extents = {(x1 - x0) / 2, (y1 - y0) / 2, 0.025}}));
}

ph::world<3> world_of(const std::vector<ph::any_wall<3>>& walls) {
  ph::world_walls<3> all;
  for (const auto& w : walls) all.add(w);
  return ph::world<3>(all);
}

// What comes out of the walls at x: the sum of depth times normal [m].
at felt(ph::world<3>& world, const at& x) {
  at sum = at::Zero();
  for (const auto& c : ph::sense(world, x)) sum += c.depth * c.normal;
  return sum;
}

// The hand goes down over the first place and then through all of them, pressed into the floor.
void expect_one_floor(const std::string& name, ph::world<3> world, const std::vector<at>& places) {
  SCOPED_TRACE(name);
  for (int k = 0; k <= 20; ++k) felt(world, places[0] + at(0, 0, pressed - 1e-4 * k));
  for (std::size_t leg = 1; leg < places.size(); ++leg) {
    constexpr int steps = 150;
    for (int k = 0; k <= steps; ++k) {
      const at x = places[leg - 1] + (places[leg] - places[leg - 1]) * k / steps - at(0, 0, pressed);
      const at push = felt(world, x);
      ASSERT_LT((push - at(0, 0, pressed)).norm(), exact)
          << "at " << x.transpose() << ": " << push.transpose();
    }
  }
}

const std::vector<at> across{{0.05, 0.05, 0}, {0.15, 0.05, 0}, {0.05, 0.06, 0}};
const std::vector<at> over_a_corner{{0.02, 0.01, 0}, {0.18, 0.19, 0}, {0.02, 0.18, 0}, {0.15, 0.03, 0}};

// Also a junction in the shape of a T
TEST(meshes_side_by_side, sheets_are_one_floor) {
  expect_one_floor("two", world_of({surface(sheet(0, 0, 0.1, 0.2)), surface(sheet(0.1, 0, 0.2, 0.2))}),
                   across);
  expect_one_floor("four",
                   world_of({surface(sheet(0, 0, 0.1, 0.1)), surface(sheet(0.1, 0, 0.2, 0.1)),
                             surface(sheet(0, 0.1, 0.1, 0.2)), surface(sheet(0.1, 0.1, 0.2, 0.2))}),
                   over_a_corner);
  expect_one_floor("T",
                   world_of({surface(sheet(0, 0, 0.2, 0.1)), surface(sheet(0, 0.1, 0.07, 0.2)),
                             surface(sheet(0.07, 0.1, 0.2, 0.2))}),
                   over_a_corner);
}

TEST(meshes_side_by_side, blocks_are_one_floor) {
  for (const auto& make : {surface, solid}) {
    expect_one_floor("four",
                     world_of({make(block(0, 0, 0.1, 0.1)), make(block(0.1, 0, 0.2, 0.1)),
                               make(block(0, 0.1, 0.1, 0.2)), make(block(0.1, 0.1, 0.2, 0.2))}),
                     over_a_corner);
    expect_one_floor("box last", world_of({make(block(0, 0, 0.1, 0.2)), box(0.1, 0, 0.2, 0.2)}), across);
    expect_one_floor("box first", world_of({box(0, 0, 0.1, 0.2), make(block(0.1, 0, 0.2, 0.2))}), across);
  }
  expect_one_floor("a sheet, a surface and a solid",
                   world_of({surface(sheet(0, 0, 0.07, 0.2)), surface(block(0.07, 0, 0.13, 0.2)),
                             solid(block(0.13, 0, 0.2, 0.2))}),
                   across);
  expect_one_floor(
      "a sheet and boxes",
      world_of({surface(sheet(0, 0, 0.07, 0.2)), box(0.07, 0, 0.13, 0.2), box(0.13, 0, 0.2, 0.2)}), across);
}

// Also where no mesh is near: boxes that overlap, and a plate half as thick as the hand is deep.
TEST(meshes_side_by_side, boxes_and_a_plate_are_one_floor) {
  expect_one_floor("overlap", world_of({box(0, 0, 0.101, 0.2), box(0.1, 0, 0.2, 0.2)}), across);
  const ph::box<3> plate(at(0.1, 0.1, -pressed / 4), at(0.1, 0.1, pressed / 4));
  expect_one_floor("plate", world_of({ph::wall(plate)}), over_a_corner);
}

// A half-space that bears the floor on one side, and one that is the corner beside it.
TEST(meshes_side_by_side, a_half_space_beside_a_mesh) {
  const ph::any_wall<3> floor = ph::wall(ph::half_space<3>({0, 0, 0}, {0, 0, 1}));
  expect_one_floor("mesh in the floor", world_of({surface(sheet(0, 0, 0.1, 0.2)), floor}), across);
  expect_one_floor("block in the floor", world_of({floor, solid(block(0.08, 0, 0.12, 0.2))}), across);

  ph::world<3> corner =
      world_of({surface(sheet(0, 0, 0.2, 0.2)), ph::wall(ph::half_space<3>({0.1, 0, 0}, {-1, 0, 0}))});
  felt(corner, {0.05, 0.1, 1e-3});
  for (int k = 0; k <= 100; ++k) {
    const double beyond = 0.02 * k / 100 - 0.01;
    const at push = felt(corner, {0.1 + beyond, 0.1, -pressed});
    ASSERT_LT((push - at(-std::max(0.0, beyond), 0, pressed)).norm(), 2e-7) << beyond;
  }
}

// A handle that is first seen inside, or that jumps there, has come through the nearest side.
TEST(meshes_side_by_side, push_a_hand_out_that_is_first_seen_inside) {
  const at inside(0.1, 0.1, -0.004);
  for (const ph::any_wall<3>& wall : {surface(block(0, 0, 0.2, 0.2)), solid(block(0, 0, 0.2, 0.2))}) {
    ph::world<3> world = world_of({wall, surface(sheet(0.5, 0, 0.6, 0.2))});
    ASSERT_LT((felt(world, inside) - at(0, 0, 0.004)).norm(), exact);
    ASSERT_LT((felt(world, inside - at(0.01, 0, 0)) - at(0, 0, 0.004)).norm(), exact);
    world.reset();
    ASSERT_LT((felt(world, {0.197, 0.1, -0.01}) - at(0.003, 0, 0)).norm(), exact);
  }
  ph::world<3> beside = world_of({box(0, 0, 0.2, 0.2), surface(sheet(0.5, 0, 0.6, 0.2))});
  ASSERT_LT((felt(beside, inside) - at(0, 0, 0.004)).norm(), exact);
  felt(beside, {0.1, 0.1, 0.5});
  ASSERT_LT((felt(beside, inside) - at(0, 0, 0.004)).norm(), exact);
}

// Deep under a floor the proxy meets what stands on it, however far that is from the hand.
TEST(meshes_side_by_side, a_block_on_the_floor_stops_a_hand_deep_below) {
  constexpr double deep = 0.03;
  for (const auto& make : {surface, solid}) {
    ph::mesh_parameters<3> bump = block(0.1, 0.05, 0.12, 0.15, -0.01);
    for (at& v : bump.vertices) v[2] += 0.01;
    ph::world<3> world = world_of({surface(sheet(0, 0, 0.2, 0.2)), make(bump)});
    for (int k = 0; k <= 100; ++k) felt(world, {0.02, 0.1, 0.001 - deep * k / 100});
    for (int k = 0; k <= 100; ++k) {
      const double x = 0.02 + 0.12 * k / 100;
      const at push = felt(world, {x, 0.1, 0.001 - deep});
      ASSERT_LT((push - at(-std::max(0.0, x - 0.1), 0, deep - 0.001)).norm(), 3e-7)
          << x << ": " << push.transpose();
    }
  }
}

// Two sheets that move together, and one that moves along beside one that stands.
TEST(meshes_side_by_side, are_one_floor_that_moves) {
  for (const bool both : {true, false}) {
    ph::world_walls<3> walls;
    const int first = walls.add_moving(surface(sheet(0, 0, 0.1, 0.2)));
    const int second = walls.add_moving(surface(sheet(0.1, 0, 0.2, 0.2)));
    ph::world<3> world(walls);
    for (int k = 0; k <= 500; ++k) {
      const double time = 2e-3 * k;
      // Up and down; where one stands, along the seam
      const at moved = both ? at(0.01 * std::sin(5 * time), 0, 0.02 * std::sin(3 * time))
                            : at(0, 0.03 * std::sin(4 * time), 0);
      world.set_motion(first, both ? moved : at(at::Zero()), at::Zero());
      world.set_motion(second, moved, at::Zero());
      const at on_floor(0.05 + 0.1 * (0.5 - 0.5 * std::cos(6 * time)), 0.1,
                        k < 20 ? pressed - 1e-4 * k : -pressed);
      const at push = felt(world, on_floor + (both ? moved : at(at::Zero())));
      if (k <= 20) continue;
      ASSERT_LT((push - at(0, 0, pressed)).norm(), exact)
          << "both " << both << ", cycle " << k << ": " << push.transpose();
    }
  }
}

// A floor that rises takes the hand's proxy along, however fast it passes the hand.
TEST(meshes_side_by_side, a_sheet_that_passes_the_hand_holds_it) {
  ph::world_walls<3> walls;
  const int lift = walls.add_moving(surface(sheet(0, 0, 0.1, 0.2)));
  walls.add(surface(sheet(0.1, 0, 0.2, 0.2)));
  ph::world<3> world(walls);
  for (const double rate : {1e-4, 3e-3}) {
    world.reset();
    for (int k = 0; k <= 10; ++k) {
      world.set_motion(lift, {0, 0, rate * k - 5.5 * rate}, at::Zero());
      const at push = felt(world, {0.05, 0.1, 0});
      ASSERT_LT((push - at(0, 0, std::max(0.0, rate * k - 5.5 * rate))).norm(), 1e-9) << rate << ", " << k;
    }
  }
}

// Near its surface, over edges, too, a shape in a world with a mesh far off is felt as itself.
template <class Shape>
void expect_felt_as_itself(const Shape& shape) {
  ph::world<3> world = world_of({ph::wall(shape), surface(sheet(1, 1, 1.2, 1.2))});
  ph::testing::random_source random(seed);
  at x(0, 0.049, 0.05);
  int touched = 0;
  for (int k = 0; k < 4000; ++k) {
    x += 2e-4 * random.direction<double, 3>();
    const double distance = shape.distance(x);
    x += (std::clamp(distance, -0.003, 0.003) - distance) * shape.gradient(x);
    const at expected = std::max(0.0, -shape.distance(x)) * shape.gradient(x);
    ASSERT_LT((felt(world, x) - expected).norm(), 1e-8)
        << "seed " << seed << ", cycle " << k << " at " << x.transpose();
    touched += !expected.isZero(0);
  }
  EXPECT_GT(touched, 200);
}

TEST(meshes_side_by_side, a_shape_far_from_a_mesh_is_felt_as_ever) {
  expect_felt_as_itself(ph::ball<3>({0, 0, 0}, 0.05));
  expect_felt_as_itself(ph::ball<3>({0, 0, 0}, 0.05, ph::filling::hollow));
  expect_felt_as_itself(ph::box<3>({0, 0, 0}, {0.05, 0.05, 0.05}));
}

// One mesh, cut in two along edges: what a random hand feels is equal.
TEST(meshes_side_by_side, a_mesh_cut_in_two_is_felt_as_the_whole) {
  ph::mesh_parameters<3> whole, low, high;
  constexpr int n = 12;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j)
      whole.vertices.push_back({0.2 * i / n, 0.2 * j / n, 0.01 * std::sin(1.1 * i) * std::cos(0.9 * j)});
  low.vertices = high.vertices = whole.vertices;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j, b = a + n + 1;
      for (const auto& facet : {std::array{a, b, b + 1}, std::array{a, b + 1, a + 1}}) {
        whole.facets.push_back(facet);
        ((i + j) % 3 == 0 ? low : high).facets.push_back(facet);
      }
    }
  }
  ph::world<3> one = world_of({surface(whole)}), two = world_of({surface(low), surface(high)});
  ph::testing::random_source random(seed);
  at x(0.1, 0.1, 0.03);
  int touched = 0;
  for (int k = 0; k < 4000; ++k) {
    x += 3e-4 * random.direction<double, 3>();
    x = x.cwiseMax(at(0.02, 0.02, -0.012)).cwiseMin(at(0.18, 0.18, 0.011));
    const at push = felt(two, x), expected = felt(one, x);
    ASSERT_LT((push - expected).norm(), 1e-8) << "seed " << seed << ", cycle " << k << " at " << x.transpose()
                                              << ": " << push.transpose() << " for " << expected.transpose();
    touched += !push.isZero(0);
  }
  EXPECT_GT(touched, 200);
}

// What is skipped changes nothing: a world of many meshes against one of which nothing is far.
TEST(meshes_side_by_side, far_ones_are_skipped_exactly) {
  ph::testing::random_source random(seed);
  std::vector<ph::any_wall<3>> walls;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double x = 0.05 * i, y = 0.05 * j;
      walls.push_back((i + j) % 2 == 0 ? solid(block(x, y, x + 0.05, y + 0.05))
                                       : box(x, y, x + 0.05, y + 0.05));
    }
  ph::world<3> skipping = world_of(walls), looking = world_of(walls);
  at x(0.1, 0.1, 0.01);
  int touched = 0;
  for (int k = 0; k < 2000; ++k) {
    const bool leap = k % 100 == 0;
    x += (leap ? 0.05 : 4e-4) * random.direction<double, 3>();
    x = x.cwiseMax(at(0.005, 0.005, -0.004)).cwiseMin(at(0.195, 0.195, 0.02));
    looking.set_margin(k % 2 == 0 ? 0 : 1e-300);  // so that all that is near is looked at anew
    const at push = felt(skipping, x), expected = felt(looking, x);
    ASSERT_LT((push - expected).norm(), 1e-12)
        << "seed " << seed << ", cycle " << k << " at " << x.transpose();
    touched += !push.isZero(0);
  }
  EXPECT_GT(touched, 200);
}

}  // namespace side_by_side
