// slow, no sanitizers
// Following a mesh and asking it for distances allocates nothing.
#include "allocations.hpp"

#include <passive_haptics/scene/mesh/mesh_solid.hpp>
#include <passive_haptics/scene/mesh/mesh_surface.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/world/world.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include "../property/sample_meshes.hpp"

#include <limits>

namespace {

namespace ph = passive_haptics;

template <int D>
void follow_a_star() {
  ph::testing::random_source random(20040627);
  const ph::mesh<D> m(sample_meshes::star<D>(random, 24));
  const ph::mesh_solid<D> solid(m);
  const ph::mesh_surface<D> surface(m);
  typename ph::mesh_surface<D>::tracker memory;
  ph::point<D> from = 2 * ph::point<D>::UnitX(), x = from;
  int touched = 0, free = 0, several = 0;
  for (int k = 0; k < 1000; ++k) {
    x = 0.99 * (x + random.positive(1e-6, 0.3) * random.direction<double, D>());
    if (k % 50 == 49) x[0] = std::numeric_limits<double>::quiet_NaN();
    int felt = 0;
    double distance = 0;
    ASSERT_EQ(allocations_in([&] {
                surface.follow(from, x, memory, [&](const ph::point<D>&, double) { ++felt; });
                distance = solid.distance(x) + solid.gradient(x).norm();
              }),
              0)
        << "cycle " << k;
    if (std::isnan(distance)) x = from;
    else from = x;
    touched += felt > 0;
    several += felt > 1;
    free += felt == 0;
  }
  EXPECT_GT(touched, 100);
  EXPECT_GT(several, 10);
  EXPECT_GT(free, 40);
}

TEST(no_allocation, in_a_polyline) { follow_a_star<2>(); }
TEST(no_allocation, in_a_mesh) { follow_a_star<3>(); }

// A world whose walls a handle is pushed through, and a copy of it, as another thread publishes them.
TEST(no_allocation, in_a_world_of_meshes_and_its_copies) {
  ph::testing::random_source random(20040627);
  const ph::mesh<3> star(sample_meshes::star<3>(random, 24));
  ph::world_walls<3> walls;
  const int lift = walls.add_moving(ph::wall(ph::mesh_surface<3>(star)));
  walls.add(ph::wall(ph::mesh_solid<3>(star)));
  for (int i = 0; i < 30; ++i) walls.add(ph::wall(ph::ball<3>(random.direction<double, 3>(), 0.2)));
  ph::world<3> first(walls);
  ph::world<3> copy = first, taking_over = first;
  ph::point<3> x = 2 * ph::point<3>::UnitX();
  int touched = 0;
  for (int k = 0; k < 300; ++k) {
    x = 0.99 * (x + random.positive(1e-6, 0.3) * random.direction<double, 3>());
    ASSERT_EQ(allocations_in([&] {
                for (ph::world<3>* world : {&first, &copy, &taking_over}) {
                  world->set_motion(lift, {0, 0, 0.1 * std::sin(0.01 * k)}, {0, 0, 0});
                  touched += !ph::sense(*world, x).empty();
                }
                if (k % 10 == 0) taking_over.remember(first);
              }),
              0)
        << "cycle " << k;
  }
  EXPECT_GT(touched, 50);
}

TEST(no_allocation, in_a_copy_of_a_mesh) {
  ph::testing::random_source random(20040627);
  const ph::mesh_surface<3> surface(ph::mesh<3>(sample_meshes::star<3>(random, 24)));
  EXPECT_EQ(allocations_in([&] { const ph::mesh_surface<3> copy = surface; }), 0);
}

}  // namespace
