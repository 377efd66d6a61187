// A terrain is felt as the heights say.
#include <passive_haptics/scene/mesh/height_field.hpp>
#include <passive_haptics/testing/support/random.hpp>

#include <gtest/gtest.h>

#include "tracked_handle.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace ph = passive_haptics;

namespace {

ph::height_field_parameters flat() {
  return {3, 2, 0.1, 0.2, std::vector<double>(6, 0.0), ph::point<3>::Zero()};
}

TEST(a_height_field, says_what_is_wrong_with_its_parameters) {
  EXPECT_EQ(validate(flat()), "");
  const auto says = [](auto&& change) {
    auto p = flat();
    change(p);
    return validate(p);
  };
  const std::string grid = ": expected 2 or more, and at most 2^31 triangles in all";
  EXPECT_EQ(says([](auto& p) { p.columns = 1; }), "columns of a height_field = 1" + grid);
  EXPECT_EQ(says([](auto& p) { p.rows = -1; }), "rows of a height_field = -1" + grid);
  EXPECT_EQ(says([](auto& p) { p.columns = p.rows = 100'000; }),
            "columns x rows of a height_field = 10000000000" + grid);
  EXPECT_EQ(says([](auto& p) { p.columns = p.rows = 1 << 15; }),
            "columns x rows of a height_field = 1073741824" + grid);
  EXPECT_EQ(says([](auto& p) {
              p.columns = (1 << 15) - 1;
              p.rows = (1 << 15) + 1;
            }),
            "number of heights of a height_field = 6: expected columns x rows, 1073741823")
      << "one point less has room";
  EXPECT_EQ(says([](auto& p) { p.spacing_x = 0; }),
            "spacing_x of a height_field [m] = 0: expected a finite number > 0");
  EXPECT_EQ(says([](auto& p) { p.spacing_y = -1; }),
            "spacing_y of a height_field [m] = -1: expected a finite number > 0");
  EXPECT_EQ(says([](auto& p) { p.heights.pop_back(); }),
            "number of heights of a height_field = 5: expected columns x rows, 6");
  EXPECT_EQ(says([](auto& p) { p.heights[4] = INFINITY; }),
            "heights[4] of a height_field [m] = inf: expected a finite number");
  EXPECT_EQ(says([](auto& p) { p.origin[2] = std::nan(""); }),
            "origin[2] of a height_field [m] = nan: expected a finite number");
  EXPECT_THROW(ph::height_field({}), std::invalid_argument);
  EXPECT_EQ(ph::height_field_parameters().origin, ph::point<3>(0, 0, 0));
}

TEST(a_height_field, has_two_triangles_a_cell_that_look_up) {
  ph::testing::random_source random(20040627);
  ph::height_field_parameters p{7, 5, 0.1, 0.2, {}, {1, 2, 3}};
  for (int k = 0; k < 35; ++k) p.heights.push_back(random.uniform(-0.3, 0.3));
  const auto m = ph::height_field(p);
  ASSERT_EQ(m.facets.size(), 48u);
  EXPECT_EQ(validate(m), "");
  EXPECT_EQ(m.vertices[7 * 3 + 2], ph::point<3>(1.2, 2 + 3 * 0.2, 3 + p.heights[23]));
  double area = 0;
  for (std::size_t f = 0; f < m.facets.size(); ++f) {
    const auto c = m.corners(f);
    const double z = ph::cross<double>(c[1] - c[0], c[2] - c[0])[2];
    EXPECT_GT(z, 0);
    area += z / 2;
  }
  EXPECT_NEAR(area, 0.6 * 0.8, 1e-15);
}

TEST(a_height_field, is_cut_where_the_heights_differ_less) {
  const auto facets = [](double a, double b, double d, double c) {  // counterclockwise a b c d
    return ph::height_field({2, 2, 0.1, 0.2, {a, b, d, c}, {0, 0, 0}}).facets;
  };
  using triangles = std::vector<std::array<int, 3>>;
  const triangles from_a_to_c{{0, 1, 3}, {0, 3, 2}}, from_b_to_d{{0, 1, 2}, {1, 3, 2}};
  EXPECT_EQ(facets(1, 5, -2, 1.5), from_a_to_c);
  EXPECT_EQ(facets(1.5, 5, -2, 1), from_a_to_c);
  EXPECT_EQ(facets(1, 2.5, 2, 4), from_b_to_d);
  EXPECT_EQ(facets(4, 2, 2.5, -1), from_b_to_d);
  EXPECT_EQ(facets(1, -1, 2, 4), from_a_to_c) << "where both differ as much";
}

// Slow waves: the normal and the depth are those of the wave where the handle is, to the size of a cell.
TEST(a_height_field, is_felt_as_the_waves_that_it_samples) {
  ph::height_field_parameters p{101, 101, 1e-3, 1e-3, {}, {-0.05, -0.05, 0}};
  const auto wave = [](double x, double y) { return 5e-3 * std::sin(40 * x) * std::cos(40 * y); };
  for (int j = 0; j < 101; ++j)
    for (int i = 0; i < 101; ++i) p.heights.push_back(wave(1e-3 * i - 0.05, 1e-3 * j - 0.05));
  tracked::handle<3> h{ph::mesh_surface<3>(ph::triangle_mesh(ph::height_field(p)))};
  h.go({0, 0, 0.02});
  for (int k = 0; k < 1000; ++k) {  // 0.2 mm a cycle, 0.5 mm deep
    const double x = 0.04 * std::sin(4e-3 * k), y = 0.04 * std::sin(6e-3 * k), depth = 0.5e-3;
    const ph::point<3> up =
        ph::point<3>(-0.2 * std::cos(40 * x) * std::cos(40 * y), 0.2 * std::sin(40 * x) * std::sin(40 * y), 1)
            .normalized();
    h.go(ph::point<3>(x, y, wave(x, y)) - depth * up);
    ASSERT_EQ(h.felt.size(), 1u) << k;
    ASSERT_GT(h.felt[0].normal.dot(up), 0.999) << k;
    ASSERT_NEAR(h.felt[0].depth, depth, 3e-6) << k;
  }
}

}  // namespace
