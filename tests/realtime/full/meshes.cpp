// Following a mesh and asking it for distances allocates nothing.
#include "../allocations.hpp"

#include <passive_haptics/scene/mesh/mesh_solid.hpp>
#include <passive_haptics/scene/mesh/mesh_surface.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include "../../property/sample_meshes.hpp"

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
  for (int k = 0; k < 5000; ++k) {
    x = 0.99 * (x + random.positive(1e-6, 0.3) * random.direction<double, D>());
    if (k % 100 == 99) x[0] = std::numeric_limits<double>::quiet_NaN();
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
  EXPECT_GT(touched, 500);
  EXPECT_GT(several, 50);
  EXPECT_GT(free, 200);
}

TEST(no_allocation, in_a_polyline) { follow_a_star<2>(); }
TEST(no_allocation, in_a_mesh) { follow_a_star<3>(); }

TEST(no_allocation, in_a_copy_of_a_mesh) {
  ph::testing::random_source random(20040627);
  const ph::mesh_surface<3> surface(ph::mesh<3>(sample_meshes::star<3>(random, 24)));
  EXPECT_EQ(allocations_in([&] { const ph::mesh_surface<3> copy = surface; }), 0);
}

}  // namespace
