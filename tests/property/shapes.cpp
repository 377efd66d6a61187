#include <experiments/specimens.hpp>
#include <passive_haptics/testing/shape_properties.hpp>

#include <cmath>
#include <map>
#include <numbers>
#include <string>

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

// Each shape of the list has the distance and the normal of the analytic one, the first of its surface, where
// a hand touches it; round meshes and polygons those of the inscribed corners.
TEST(specimens, are_the_analytic_shape_where_they_are_touched) {
  const experiments::place<2> here{.at = {0.1, 0.2}, .normal = {0.6, 0.8}, .along = {0.8, -0.6}, .fine = 720};
  struct sample {
    double distance;
    ph::point<2> normal;
  };
  std::map<experiments::surface, std::vector<sample>> analytic;
  experiments::for_each_specimen<2>([&]<class Make>(const experiments::specimen<Make>& s) {
    if constexpr (ph::Shape<std::invoke_result_t<Make, const experiments::place<2>&>>) {
      const auto shape = s.make(here);
      std::vector<sample> found;
      for (const double forward : {-0.05, -0.01, 0.03})
        for (const double up : {-0.015, 0.02}) {
          const ph::point<2> x = here.point(forward, up);
          found.push_back({shape.distance(x), shape.gradient(x)});
        }
      const auto& expected = analytic.emplace(s.meant, found).first->second;
      const double half =
          std::numbers::pi /
          (std::string(s.name).ends_with("of 12)") || std::string(s.name).ends_with("of 12") ? 12 : 720);
      for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_NEAR(found[k].distance, expected[k].distance, here.radius * (1 - std::cos(half))) << s.name;
        EXPECT_LE((found[k].normal - expected[k].normal).norm(), half) << s.name;
      }
    }
  });
}

}  // namespace

using shapes = ::testing::Types<plane, hollow_disc, kinked>;
INSTANTIATE_TYPED_TEST_SUITE_P(scene, shape_properties, shapes);
