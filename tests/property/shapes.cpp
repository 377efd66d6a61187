#include <passive_haptics/scene/shapes/ball.hpp>
#include <passive_haptics/scene/shapes/half_space.hpp>
#include <passive_haptics/testing/shape_properties.hpp>

#include <cmath>

namespace ph = passive_haptics;
using namespace passive_haptics::testing;

namespace {

template <class Shape>
struct in_a_box {
  using shape = Shape;
  using point = ph::point<Shape::dimension>;
  static point lower() { return point::Constant(-1); }
  static point upper() { return point::Constant(1); }
};

struct plane : in_a_box<ph::half_space<2>> {
  static shape make() { return shape({0.1, -0.2}, {3, -4}); }
};
struct hollow_disc : in_a_box<ph::disc> {
  static shape make() { return shape({0.2, 0.1}, 0.5, ph::filling::hollow); }
};

// A user's own: a strip between two planes, with a kink in the middle where no gradient exists.
struct strip {
  static constexpr int dimension = 2;
  double distance(const ph::point<2>& x) const { return 0.4 - std::abs(x[1]); }
  ph::point<2> gradient(const ph::point<2>& x) const { return {0, x[1] > 0 ? -1.0 : 1.0}; }
};
struct kinked : in_a_box<strip> {
  static shape make() { return {}; }
};

}  // namespace

using shapes = ::testing::Types<plane, hollow_disc, kinked>;
INSTANTIATE_TYPED_TEST_SUITE_P(scene, shape_properties, shapes);
