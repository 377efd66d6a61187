// slow
// A handle in wedges made of triangles: the contacts are those from half-spaces. Corners of a room, ridges
// and thin plates are in mesh_surface.cpp.
#include <passive_haptics/scene/mesh/mesh_surface.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include "tracked_handle.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace ph = passive_haptics;
using ph::testing::random_source;
using plane = ph::half_space<3>;

namespace {

// A rectangle: half a metre along the edge, the other half metre away from it.
void add_rectangle(ph::mesh_parameters<3>& m, const ph::point<3>& edge, const ph::point<3>& along,
                   const ph::point<3>& away) {
  const int first = static_cast<int>(m.vertices.size());
  for (const ph::point<3>& v : {ph::point<3>(edge - along), ph::point<3>(edge + along),
                                ph::point<3>(edge + along + away), ph::point<3>(edge - along + away)})
    m.vertices.push_back(v);
  m.facets.push_back({first, first + 1, first + 2});
  m.facets.push_back({first, first + 2, first + 3});
}

// From anywhere in front of a hollow wedge, which is turned anyhow, to any place near its edge, at once and
// by way of another.
TEST(a_handle, in_a_hollow_wedge_of_30_degrees) {
  constexpr unsigned seed = 20040627;
  constexpr double angle = std::numbers::pi / 6, reach = 0.04;
  const ph::point<3> middle(0, 0, -0.14);
  random_source random(seed);
  std::array<int, 3> seen{};  // how often there were 0, 1 and 2 contacts
  for (int k = 0; k < 1000; ++k) {
    const Eigen::Vector4d any = random.normal_vector<double, 4>();
    const ph::matrix<double, 3, 3> R = Eigen::Quaterniond(any).normalized().toRotationMatrix();
    ph::mesh_parameters<3> m;
    add_rectangle(m, middle, 0.5 * R.col(0), 0.5 * R.col(1));
    add_rectangle(m, middle, -0.5 * R.col(0), 0.5 * R * ph::point<3>(0, std::cos(angle), std::sin(angle)));
    const ph::triangle_mesh mesh(m);
    const plane planes[] = {plane(middle, mesh[0].normal), plane(middle, mesh[2].normal)};

    ph::point<3> start;
    do start = middle + reach * random.normal_vector<double, 3>();
    while (!(std::min(planes[0].distance(start), planes[1].distance(start)) > 0));
    const ph::point<3> x = middle + reach * random.uniform(0.0, 1.0) * random.direction<double, 3>();
    tracked::handle<3> h{ph::mesh_surface<3>(mesh)};
    h.go(start);
    if (k % 2 == 0) h.go(start + random.uniform(0.0, 1.0) * (x - start));
    h.go(x);
    std::size_t behind = 0;
    for (const plane& p : planes) {
      if (!(p.distance(x) < 0)) continue;
      ++behind;
      const ph::point<3> n = p.gradient(x);
      const auto of_p = [&](const auto& c) { return (c.normal - n).norm() < 1e-12; };
      const auto found = std::find_if(h.felt.begin(), h.felt.end(), of_p);
      ASSERT_NE(found, h.felt.end()) << "seed " << seed << ", press " << k;
      EXPECT_NEAR(found->depth, -p.distance(x), 1e-15);
    }
    ASSERT_EQ(h.felt.size(), behind) << "seed " << seed << ", press " << k;
    ++seen[behind];
  }
  for (const int count : seen) EXPECT_GT(count, 30);
}

}  // namespace
