// slow, optimised
// The nearest point of a mesh and the side of it, against a scan over all facets and against what the mesh
// approximates.
#include <passive_haptics/scene/mesh/mesh_solid.hpp>
#include <passive_haptics/scene/shapes/box.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include "../../property/sample_meshes.hpp"

#include <limits>
#include <numbers>
#include <type_traits>

namespace ph = passive_haptics;
using ph::testing::random_source;

namespace {

constexpr unsigned seed = 20040627;
constexpr double eps = std::numeric_limits<double>::epsilon();

template <int D>
ph::point<D> anywhere(random_source& random, double size) {
  return random.between<double, D>(ph::point<D>::Constant(-size), ph::point<D>::Constant(size));
}

template <class Dimension>
struct a_mesh : ::testing::Test {
  static constexpr int dimension = Dimension::value;
};
using dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(a_mesh, dimensions);

static_assert(ph::BoundedShape<ph::mesh_solid<2>> && ph::BoundedShape<ph::mesh_solid<3>>);

// How often facets go round x: 1 inside, 0 outside of a closed surface. Angles (2-D), solid angles (3-D: A.
// van Oosterom, J. Strackee, The solid angle of a plane triangle, IEEE Trans. Biomedical Engineering 30 (2),
// 1983).
template <int D>
double winding(const ph::mesh_parameters<D>& m, const ph::point<D>& x) {
  double sum = 0;
  for (std::size_t f = 0; f < m.facets.size(); ++f) {
    const auto c = m.corners(f);
    const ph::point<D> a = c[0] - x, b = c[1] - x;
    if constexpr (D == 2) sum += std::atan2(ph::cross_in_plane(a, b), a.dot(b)) / (2 * std::numbers::pi);
    else {
      const ph::point<3> d = c[2] - x;
      const double la = a.norm(), lb = b.norm(), ld = d.norm();
      sum += std::atan2(ph::cross<double>(a, b).dot(d),
                        la * lb * ld + a.dot(b) * ld + b.dot(d) * la + d.dot(a) * lb) /
             (2 * std::numbers::pi);
    }
  }
  return sum;
}

// Distance to a triangle by search: nested golden sections over its two coordinates, in which the distance is
// convex.
template <class F>
long double least(const F& f) {
  const long double golden = (std::sqrt(5.0L) - 1) / 2;
  long double low = 0, high = 1;
  for (int k = 0; k < 60; ++k) {
    const long double left = high - golden * (high - low), right = low + golden * (high - low);
    (f(left) < f(right) ? high : low) = f(left) < f(right) ? right : left;
  }
  return std::fmin(f((low + high) / 2), std::fmin(f(0.0L), f(1.0L)));
}
template <int D>
double searched_distance(const std::array<ph::point<D>, std::size_t(D)>& c, const ph::point<D>& x) {
  using wide = ph::vector<long double, D>;
  const auto as_wide = [](const ph::point<D>& y) { return wide(y.template cast<long double>()); };
  const wide a = as_wide(c[0]), ab = as_wide(c[1]) - a, to_x = as_wide(x) - a;
  if constexpr (D == 2) {
    return static_cast<double>(least([&](long double s) { return wide(to_x - s * ab).norm(); }));
  } else {
    const wide ac = as_wide(c[2]) - a;
    return static_cast<double>(least([&](long double s) {
      const wide left = to_x - s * ab;
      return least([&](long double t) { return wide(left - t * (1 - s) * ac).norm(); });
    }));
  }
}

TYPED_TEST(a_mesh, facet_has_the_nearest_point_that_a_search_finds) {
  constexpr int D = TestFixture::dimension;
  random_source random(seed);
  for (int k = 0; k < 100; ++k) {
    std::array<ph::point<D>, std::size_t(D)> corners;
    for (auto& c : corners) c = anywhere<D>(random, 1);
    if (k % 3 == 0) corners[D - 1] = corners[0] + random.positive(1e-4, 1e-1) * random.direction<double, D>();
    const ph::mesh_facet<D> f{corners, ph::detail::normal_of(corners)};
    const ph::point<D> x = anywhere<D>(random, 2);
    const auto nearest = ph::nearest_point(f, x);
    EXPECT_NEAR(std::sqrt(nearest.squared_distance), searched_distance<D>(corners, x), 1e-8)
        << "seed " << seed << ", facet " << k;
    EXPECT_NEAR((x - nearest.position).norm(), std::sqrt(nearest.squared_distance), 8 * eps);
  }
}

TEST(a_needle, still_has_its_nearest_point) {
  random_source random(seed);
  for (int k = 0; k < 300; ++k) {
    const ph::point<3> a = anywhere<3>(random, 1), along = random.direction<double, 3>();
    const double width = random.positive(1e-9, 1e-3);
    const ph::point<3> across = ph::cross<double>(along, random.direction<double, 3>()).normalized();
    const std::array<ph::point<3>, 3> corners{a, a + along,
                                              a + random.uniform(0.0, 1.0) * along + width * across};
    const ph::mesh_facet<3> f{corners, ph::detail::normal_of(corners)};
    for (const auto& c : corners) EXPECT_NEAR(f.height(c), 0, 4 * eps);
    const ph::point<3> x = anywhere<3>(random, 2);
    const double middle = std::clamp(along.dot(x - a), 0.0, 1.0);
    EXPECT_NEAR(std::sqrt(ph::nearest_point(f, x).squared_distance), (x - a - middle * along).norm(),
                width + 8 * eps)
        << "seed " << seed << ", needle " << k << " of width " << width;
  }
}

TYPED_TEST(a_mesh, of_any_star_is_as_near_as_a_scan_says_and_on_the_same_side) {
  constexpr int D = TestFixture::dimension;
  random_source random(seed);
  for (const int around : {5, 12, 24}) {
    const auto p = sample_meshes::star<D>(random, around);
    const ph::mesh<D> m(sample_meshes::loose(p));
    ASSERT_EQ(m.hole(), "");
    const ph::mesh_solid<D> solid(m);
    int guess = 0, inside = 0;
    for (int k = 0; k < 500; ++k) {
      ph::point<D> x = anywhere<D>(random, 1.2);
      if (k % 3 == 0) {  // near a corner, where the side is hardest to tell
        const auto at = static_cast<std::size_t>(random.uniform(0.0, double(p.vertices.size())));
        x = p.vertices[at] + random.positive(1e-6, 1e-2) * random.direction<double, D>();
      }
      double scanned = std::numeric_limits<double>::infinity();
      for (int i = 0; i < m.size(); ++i)
        scanned = std::min(scanned, std::sqrt(ph::nearest_point(m[i], x).squared_distance));
      const auto nearest = m.nearest(x, guess);
      guess = nearest.facet;
      ASSERT_NEAR(nearest.distance(), scanned, 4 * eps) << "seed " << seed << ", point " << k;
      const bool is_inside = winding(p, x) > 0.5;
      inside += is_inside;
      ASSERT_NEAR(solid.distance(x), is_inside ? -scanned : scanned, 4 * eps)
          << "seed " << seed << ", point " << k << " of a star of " << around;
      ASSERT_NEAR(solid.distance(x - solid.distance(x) * solid.gradient(x)), 0, 64 * eps);
    }
    EXPECT_GT(inside, 30);
    EXPECT_LT(inside, 470);
  }
}

TYPED_TEST(a_mesh, of_a_box_is_the_box) {
  constexpr int D = TestFixture::dimension;
  random_source random(seed);
  const ph::point<D> half = ph::point<D>::LinSpaced(0.4, 0.8);
  const ph::box<D> box(ph::point<D>::Zero(), half);
  const ph::mesh_solid<D> solid(ph::mesh<D>(sample_meshes::box<D>(-half, half)));
  EXPECT_EQ(solid.bounds().lower, -half);
  EXPECT_EQ(solid.bounds().upper, half);
  EXPECT_NEAR(solid.surface().content(), std::pow(2, D) * half.prod(), 4 * eps);
  for (int k = 0; k < 1000; ++k) {
    const auto x = anywhere<D>(random, 1);
    ASSERT_NEAR(solid.distance(x), box.distance(x), 4 * eps) << "seed " << seed << ", x = " << x.transpose();
    ASSERT_LE((solid.gradient(x) - box.gradient(x)).norm(), 1e-12 / std::abs(box.distance(x)));
  }
  for (double t :
       {0.0, 1e-300, 1e-17, 1e-12}) {  // out of a corner and out of a face, from hardly off the surface
    const ph::point<D> out = ph::point<D>::Ones().normalized();
    EXPECT_NEAR(solid.distance(half + t * out), t, 4 * eps);
    EXPECT_GT(solid.gradient(half + t * out).dot(out), 0.5);
    EXPECT_EQ(solid.gradient(half[0] * ph::point<D>::UnitX() + t * ph::point<D>::UnitX()),
              ph::point<D>::UnitX());
  }
}

}  // namespace
