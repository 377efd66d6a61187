// slow
// A handle in corners, wedges and slots made of triangles: the contacts are those from half-spaces.
#include <passive_haptics/scene/mesh/mesh_surface.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include "tracked_handle.hpp"

#include <Eigen/Geometry>

#include <array>
#include <numbers>
#include <vector>

namespace ph = passive_haptics;
using ph::testing::random_source;
using plane = ph::half_space<3>;

namespace {

constexpr unsigned seed = 20040627;
const ph::point<3> middle(0, 0, -0.14);
constexpr double reach = 0.04;  // about there

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

struct place {
  ph::mesh_surface<3> surface;
  std::vector<plane> planes;  // the first two triangles lie in the first, and so on
};

// A place turned anyhow; build(mesh) adds rectangles about the origin.
template <class Build>
place turned(random_source& random, const Build& build) {
  ph::mesh_parameters<3> m;
  build(m);
  const Eigen::Vector4d any = random.normal_vector<double, 4>();
  const ph::matrix<double, 3, 3> R = Eigen::Quaterniond(any).normalized().toRotationMatrix();
  for (auto& v : m.vertices) v = ph::point<3>(R * v + middle);
  const ph::triangle_mesh mesh(m);
  std::vector<plane> planes;
  for (int i = 0; i < mesh.size(); i += 2) planes.emplace_back(mesh[i].corners[0], mesh[i].normal);
  return {ph::mesh_surface<3>(mesh), planes};
}

// The contacts from half-spaces, in their order.
std::vector<tracked::touch<3>> behind(const std::vector<plane>& planes, const ph::point<3>& x) {
  std::vector<tracked::touch<3>> touched;
  for (const plane& p : planes)
    if (p.distance(x) < 0) touched.push_back({p.gradient(x), -p.distance(x)});
  return touched;
}

// Those that the mesh makes, in the order of the half-spaces.
std::vector<tracked::touch<3>> sorted(const std::vector<tracked::touch<3>>& felt,
                                      const std::vector<plane>& planes, const ph::point<3>& x) {
  std::vector<tracked::touch<3>> touched;
  for (const plane& p : planes)
    for (const auto& c : felt)
      if ((c.normal - p.gradient(x)).norm() < 1e-12) touched.push_back(c);
  return touched;
}

// From a free start to any x, at once and by way of another: contacts as from the half-spaces that `expected`
// picks. Returns how often there were 0, 1, 2 and 3.
template <class Start, class Expected>
std::array<int, 4> press(const place& at, random_source& random, const Start& start,
                         const Expected& expected) {
  std::array<int, 4> seen{};
  for (int k = 0; k < 1000; ++k) {
    const ph::point<3> x = middle + reach * random.uniform(0.0, 1.0) * random.direction<double, 3>();
    tracked::handle<3> h(at.surface);
    h.go(start(random));
    const std::vector<plane> planes = expected(h.x, x);
    if (k % 2 == 0) h.go(h.x + random.uniform(0.0, 1.0) * (x - h.x));
    h.go(x);
    const auto from_planes = behind(planes, x), from_mesh = sorted(h.felt, planes, x);
    ++seen[from_planes.size()];
    EXPECT_EQ(h.felt.size(), from_planes.size()) << "seed " << seed << ", press " << k;
    EXPECT_EQ(from_mesh.size(), from_planes.size()) << "seed " << seed << ", press " << k;
    if (::testing::Test::HasFailure()) return seen;
    for (std::size_t i = 0; i < from_planes.size(); ++i) {
      EXPECT_NEAR(from_mesh[i].depth, from_planes[i].depth, 1e-15);
      EXPECT_LE((from_mesh[i].normal - from_planes[i].normal).norm(), 1e-15);
    }
  }
  return seen;
}

// A point a little in front of all planes, near the middle.
auto in_front_of(const std::vector<plane>& planes) {
  return [&planes](random_source& random) {
    for (;;) {
      const ph::point<3> x = middle + 0.04 * random.normal_vector<double, 3>();
      bool free = true;
      for (const plane& p : planes) free = free && p.distance(x) > 0;
      if (free) return x;
    }
  };
}

// Up is the free side; seen against the normal, `along`, `away` run counterclockwise.
const ph::point<3> ex = ph::point<3>::UnitX(), ey = ph::point<3>::UnitY(), ez = ph::point<3>::UnitZ(),
                   zero = ph::point<3>::Zero();

TEST(a_handle, in_the_corner_of_a_room_of_triangles) {
  random_source random(seed);
  for (int turn = 0; turn < 5; ++turn) {
    const auto corner = turned(random, [](auto& m) {
      add_rectangle(m, 0.25 * ex, 0.25 * ex, 0.5 * ey);  // floor, free above
      add_rectangle(m, 0.25 * ey, 0.25 * ey, 0.5 * ez);
      add_rectangle(m, 0.25 * ez, 0.25 * ez, 0.5 * ex);
    });
    const auto seen = press(corner, random, in_front_of(corner.planes),
                            [&](const auto&, const auto&) { return corner.planes; });
    for (const int count : seen) EXPECT_GT(count, 50);
  }
}

TEST(a_handle, in_a_hollow_wedge_of_30_degrees) {
  random_source random(seed);
  const double angle = std::numbers::pi / 6;
  for (int turn = 0; turn < 5; ++turn) {
    const auto wedge = turned(random, [&](auto& m) {
      add_rectangle(m, zero, 0.5 * ex, 0.5 * ey);
      add_rectangle(m, zero, -0.5 * ex, 0.5 * (std::cos(angle) * ey + std::sin(angle) * ez));
    });
    const auto seen = press(wedge, random, in_front_of(wedge.planes),
                            [&](const auto&, const auto&) { return wedge.planes; });
    for (const std::size_t i : {0u, 1u, 2u}) EXPECT_GT(seen[i], 30);
  }
}

TEST(a_handle, on_a_sharp_edge_of_30_degrees) {
  random_source random(seed);
  const double angle = std::numbers::pi / 6;
  for (int turn = 0; turn < 5; ++turn) {
    const auto edge = turned(random, [&](auto& m) {
      add_rectangle(m, zero, -0.5 * ex, 0.5 * ey);
      add_rectangle(m, zero, 0.5 * ex, 0.5 * (std::cos(angle) * ey + std::sin(angle) * ez));
    });
    // In through a face, that face alone holds the handle, even behind the other, as long as the face is what
    // is above it.
    const auto pressed = [&](const ph::point<3>& from, const ph::point<3>& x) {
      for (const int face : {0, 1}) {
        const plane &in = edge.planes[std::size_t(face)], &other = edge.planes[std::size_t(1 - face)];
        const double before = in.distance(from), after = in.distance(x);
        if (!(before > 0 && after < 0)) continue;
        const ph::point<3> crossing = from + before / (before - after) * (x - from);
        const ph::point<3> foot = x - after * in.gradient(x);
        if (other.distance(crossing) < 0 && other.distance(foot) < 0) return std::vector<plane>{in};
      }
      return std::vector<plane>{};
    };
    const auto seen = press(
        edge, random,
        [&](random_source& r) {
          for (;;) {
            const ph::point<3> x = middle + 0.1 * r.normal_vector<double, 3>();
            if (edge.planes[0].distance(x) > 0 || edge.planes[1].distance(x) > 0) return x;
          }
        },
        pressed);
    EXPECT_GT(seen[0], 50);
    EXPECT_GT(seen[1], 20);
  }
}

TEST(a_handle, in_a_slot_between_two_planes) {
  random_source random(seed);
  for (int turn = 0; turn < 5; ++turn) {
    const auto slot = turned(random, [](auto& m) {
      add_rectangle(m, -0.25 * ey - 0.005 * ez, 0.5 * ex, 0.5 * ey);
      add_rectangle(m, -0.25 * ey + 0.005 * ez, -0.5 * ex, 0.5 * ey);
    });
    const auto seen =
        press(slot, random, in_front_of(slot.planes), [&](const auto&, const auto&) { return slot.planes; });
    EXPECT_GT(seen[0], 50);
    EXPECT_GT(seen[1], 300);
    EXPECT_EQ(seen[2], 0);
  }
}

}  // namespace
