// slow, optimised
// A mesh of a hundred thousand facets against what it approximates.
#include <passive_haptics/scene/mesh/mesh_solid.hpp>
#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include "../../property/sample_meshes.hpp"

#include <limits>
#include <type_traits>

namespace ph = passive_haptics;
using ph::testing::random_source;

namespace {

constexpr unsigned shape_seed = 20040627;
constexpr double rounding = std::numeric_limits<double>::epsilon();

template <class Dimension>
struct a_fine_mesh : ::testing::Test {
  static constexpr int dimension = Dimension::value;
};
using dimensions = ::testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(a_fine_mesh, dimensions);

TYPED_TEST(a_fine_mesh, of_a_ball_is_the_ball_within_its_sagitta) {
  constexpr int D = TestFixture::dimension;
  random_source random(shape_seed);
  const double radius = 0.7;
  const auto p = [&] {
    const auto same = [&](const auto&) { return radius; };
    if constexpr (D == 2) return sample_meshes::ring(10'000, same);
    else return sample_meshes::globe(320, 158, same);
  }();
  const ph::mesh_solid<D> solid{ph::mesh<D>(p)};
  const ph::ball<D> ball(ph::point<D>::Zero(), radius);
  const double error = sample_meshes::sagitta(p, radius);
  ASSERT_GE(solid.surface().size(), D == 2 ? 10'000 : 100'000);
  ASSERT_LT(error, 2e-4);
  std::vector<ph::point<D>> points(D == 3 ? 30'000 : 10'000);
  for (auto& x : points) x = random.uniform(0.0, 1.1) * random.direction<double, D>();
  for (const auto& x : points) {
    const double beyond = solid.distance(x) - ball.distance(x);  // the mesh lies inside
    ASSERT_GE(beyond, -4 * rounding) << "seed " << shape_seed << ", x = " << x.transpose();
    ASSERT_LE(beyond, error + 4 * rounding) << "seed " << shape_seed << ", x = " << x.transpose();
  }
}

}  // namespace
